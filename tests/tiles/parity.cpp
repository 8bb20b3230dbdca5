#include "tests/tiles/parity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "solver/numerics.hpp"
#include "solver/objects/object.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

enum class Ground { flat, terrain, maps };

struct Variant {
  int nx, ny;
  Boundaries sides;
  Ground ground;
  int tile_columns = 0, block_rows = 0;
};

/// Sand of uneven depth with dry holes, partly at rest, partly fast.
struct Setting {
  BackendConfig config;
  InitialState initial;
  StateArrays state;
};

FieldValues in_precision(const std::vector<double>& values, Precision precision) {
  if (precision == Precision::float64) {
    return values;
  }
  return std::vector<float>(values.begin(), values.end());
}

Setting make_setting(const Variant& variant, const Numerics& numerics, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Setting s;
  s.config.grid.cells = {variant.nx, variant.ny};
  s.config.grid.spacing = 0.1;
  s.config.boundaries = variant.sides;
  s.config.numerics = numerics;
  s.config.courant = default_courant(numerics);
  s.config.tile_columns = variant.tile_columns, s.config.block_rows = variant.block_rows;
  s.config.threads = 1;
  s.config.maxima = true;
  s.config.above = 0.05, s.config.drained = 0.3;
  const std::size_t cells = s.config.grid.cell_count();
  std::vector<double> hu, hv;
  for (std::size_t k = 0; k < cells; ++k) {
    const double h = next() < 0.2 ? 0.0 : 0.3 * next();
    const bool moves = h > 0.0 && next() < 0.6;
    s.initial.depth.push_back(h);
    hu.push_back(moves ? h * (2.0 * next() - 1.0) : 0.0);
    hv.push_back(moves ? h * (2.0 * next() - 1.0) : 0.0);
  }
  const auto map = [&](double low, double high) {
    std::vector<double> values(variant.ground == Ground::maps ? cells : 1);
    std::generate(values.begin(), values.end(), [&] { return low + (high - low) * next(); });
    return values;
  };
  if (variant.ground != Ground::flat) {
    s.initial.bed.resize(cells);
    std::generate(s.initial.bed.begin(), s.initial.bed.end(), [&] { return 0.2 * next(); });
  }
  s.initial.friction_coefficient = map(0.2, 0.7);
  s.initial.hbar_scale = map(0.5, 1.0);
  s.initial.hbar_cap = map(0.03, 0.3);
  s.state = {in_precision(s.initial.depth, numerics.precision), in_precision(hu, numerics.precision),
             in_precision(hv, numerics.precision)};
  return s;
}

bool same_bits(const FieldValues& a, const FieldValues& b) {
  return std::visit(
      [&](const auto& left) {
        const auto& right = std::get<std::decay_t<decltype(left)>>(b);
        return left.size() == right.size() &&
               std::memcmp(left.data(), right.data(), left.size() * sizeof(left.front())) == 0;
      },
      a);
}

std::vector<Numerics> all_numerics() {
  std::vector<Numerics> all;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Numerics order2, order1, paper, printed;
    order1.order = 1;
    paper.scheme = printed.scheme = Scheme::paper;
    paper.velocity = VelocityForm::quotient;
    printed.momentum_flux = MomentumFlux::printed, printed.rest_gate = false;
    for (Numerics n : {order2, order1, paper, printed}) {
      n.precision = precision;
      all.push_back(n);
    }
  }
  return all;
}

constexpr BoundaryKind wall = BoundaryKind::wall, open = BoundaryKind::open, periodic = BoundaryKind::periodic;

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = {
      {31, 17, {wall, wall, wall, wall}, Ground::flat, 0, 0},
      {31, 17, {periodic, periodic, periodic, periodic}, Ground::terrain, 26, 5},
      {70, 23, {open, open, open, open}, Ground::terrain, 20, 4},
      {53, 9, {open, wall, periodic, periodic}, Ground::maps, 13, 1},
      {40, 40, {periodic, periodic, wall, open}, Ground::maps, 1, 7},
      {5, 3, {periodic, periodic, periodic, periodic}, Ground::terrain, 2, 1},
      {1, 6, {wall, open, wall, wall}, Ground::flat, 0, 0},
      {2, 2, {open, open, open, open}, Ground::flat, 0, 0},
      {2, 2, {periodic, periodic, periodic, periodic}, Ground::terrain, 1, 1},
      {97, 1, {open, wall, wall, wall}, Ground::flat, 0, 0},
      {97, 1, {periodic, periodic, wall, wall}, Ground::maps, 10, 1},
      {300, 1, {wall, open, wall, wall}, Ground::terrain, 0, 0},
      {1, 1, {wall, wall, wall, wall}, Ground::flat, 0, 0},
  };
  return all;
}

}  // namespace

void check_steps(const MakeBackend& make) {
  unsigned seed = 0;
  for (const Variant& variant : variants()) {
    for (const Numerics& numerics : all_numerics()) {
      CAPTURE(variant.nx, variant.ny, numerics.order, static_cast<int>(numerics.scheme),
              static_cast<int>(numerics.precision), static_cast<int>(variant.ground));
      const Setting s = make_setting(variant, numerics, ++seed);
      const auto cpu = make_cpu_backend(s.config, s.initial);
      const auto tiles = make(s.config, s.initial);
      cpu->set_state(s.state), tiles->set_state(s.state);
      for (int n = 0; n < 12; ++n) {
        REQUIRE(tiles->stable_step() == cpu->stable_step());
        REQUIRE(tiles->speed_limit().i == cpu->speed_limit().i);
        REQUIRE(tiles->speed_limit().j == cpu->speed_limit().j);
        const double dt = std::min(n == 5 ? 3.0 * cpu->stable_step() : cpu->stable_step(), 0.05);
        const StepOutcome a = cpu->step(dt), b = tiles->step(dt);
        REQUIRE((a.moving == b.moving && a.changed == b.changed && a.broken == b.broken));
        REQUIRE(a.volume_out == b.volume_out);
        for (const char* name : {"depth", "momentum_x", "momentum_y", "velocity_x", "surface"}) {
          REQUIRE(same_bits(cpu->field(name), tiles->field(name)));
        }
      }
      CHECK(cpu->slope_violation() == tiles->slope_violation());
      const GridStatistics a = cpu->statistics(), b = tiles->statistics();
      CHECK((a.volume == b.volume && a.kinetic_energy == b.kinetic_energy));
      CHECK((a.max_speed == b.max_speed && a.moving_cells == b.moving_cells));
      CHECK((a.max_depth == b.max_depth && a.max_speed_above == b.max_speed_above));
    }
  }
}

namespace {

/// A loop to `due` as a run has it, in pieces of `most` steps.
StepLoop run_loop(Backend& backend, const StepRules& rules, std::int64_t most) {
  StageReport step{"step", 0.0, 0, 0.0}, sources{"sources", 0.0, 0, 0.0}, maxima{"maxima", 0.0, 0, 0.0};
  StepLoop loop;
  loop.plan(rules, backend.stable_step());
  while (loop.halt == Halt::none || loop.halt == Halt::smallest_step) {
    loop.halt = Halt::none;
    backend.advance(loop, rules, most, {&step, &sources, &maxima}, [] {});
  }
  CHECK(step.launches == loop.steps);
  return loop;
}

}  // namespace

void check_loops(const MakeBackend& make) {
  unsigned seed = 100;
  for (const Variant& variant : variants()) {
    for (const Numerics& numerics : all_numerics()) {
      CAPTURE(variant.nx, variant.ny, numerics.order, static_cast<int>(numerics.scheme),
              static_cast<int>(numerics.precision));
      Setting s = make_setting(variant, numerics, ++seed);
      const auto cells = static_cast<std::int64_t>(s.config.grid.cell_count());
      s.config.rains = {{{0, cells / 2, cells - 1}, 0.5, 0.01, 0.06}, {{cells / 3}, 2.0, 0.0, 0.03}};
      StepRules rules;
      rules.due = 0.08, rules.minimum_step = 1e-9, rules.rain_step = 0.01, rules.rain_end = 0.06;
      const auto cpu = make_cpu_backend(s.config, s.initial);
      const auto tiles = make(s.config, s.initial);
      cpu->set_state(s.state), tiles->set_state(s.state);
      const StepLoop a = run_loop(*cpu, rules, 1), b = run_loop(*tiles, rules, 7);
      CHECK(a.steps == b.steps);
      CHECK(a.time == b.time);
      CHECK(a.halt == b.halt);
      CHECK((a.volume_in == b.volume_in && a.volume_out == b.volume_out));
      CHECK((a.extremes.min == b.extremes.min && a.extremes.max == b.extremes.max));
      CHECK(a.last_motion == b.last_motion);
      cpu->begin_capture({{"depth", "velocity_y"}, {cells / 2, 0}});
      tiles->begin_capture({{"depth", "velocity_y"}, {cells / 2, 0}});
      const Capture from_cpu = cpu->end_capture(), from_tiles = tiles->end_capture();
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(same_bits(from_cpu.fields[k], from_tiles.fields[k]));
        CHECK(from_cpu.probes[k].depth == from_tiles.probes[k].depth);
        CHECK(from_cpu.probes[k].velocity_x == from_tiles.probes[k].velocity_x);
      }
      CHECK(from_cpu.statistics.volume == from_tiles.statistics.volume);
      CHECK(same_bits(cpu->maxima().max_depth, tiles->maxima().max_depth));
      CHECK(same_bits(cpu->maxima().max_speed, tiles->maxima().max_speed));
      CHECK(same_bits(cpu->maxima().arrival_time, tiles->maxima().arrival_time));
    }
  }
}

void check_bounds(const MakeBackend& make) {
  unsigned seed = 900;
  for (const Variant& variant : variants()) {
    for (const Numerics& numerics : all_numerics()) {
      CAPTURE(variant.nx, variant.ny, numerics.order, static_cast<int>(numerics.scheme),
              static_cast<int>(numerics.precision));
      Setting s = make_setting(variant, numerics, ++seed);
      // Rain without momentum onto every other cell: it slows the fastest ones.
      SandRain rain{{}, 5.0, 0.0, 1.0};
      for (std::int64_t cell = 0; cell < static_cast<std::int64_t>(s.config.grid.cell_count()); cell += 2) {
        rain.cells.push_back(cell);
      }
      s.config.rains = {rain};
      StepRules rules;
      rules.due = 1.0, rules.minimum_step = 1e-12, rules.rain_step = 0.01, rules.rain_end = 1.0;
      for (const MakeBackend& make_one : {MakeBackend(make_cpu_backend), make}) {
        const auto backend = make_one(s.config, s.initial), judge = make_one(s.config, s.initial);
        backend->set_state(s.state);
        StageReport step{"step", 0.0, 0, 0.0}, sources{"sources", 0.0, 0, 0.0}, maxima{"maxima", 0.0, 0, 0.0};
        StepLoop loop;
        loop.plan(rules, backend->stable_step());
        for (int n = 0; n < 5; ++n) {
          loop.halt = Halt::none;
          backend->advance(loop, rules, 1, {&step, &sources, &maxima}, [] {});
          judge->set_state(backend->state());
          REQUIRE(backend->stable_step() == judge->stable_step());
        }
        backend->rain(rain, 0.01);
        judge->set_state(backend->state());
        REQUIRE(backend->stable_step() == judge->stable_step());
      }
    }
  }
}

void check_particles_on(const MakeBackend& make) {
  unsigned seed = 700;
  for (const Variant& variant : variants()) {
    for (const Numerics& numerics : all_numerics()) {
      for (const ParticleVelocity velocity : {ParticleVelocity::averaged, ParticleVelocity::dilute}) {
        CAPTURE(variant.nx, variant.ny, numerics.order, static_cast<int>(numerics.scheme),
                static_cast<int>(numerics.precision), static_cast<int>(velocity));
        Setting s = make_setting(variant, numerics, ++seed);
        s.config.particles = Particles{};
        s.config.particles->spacing = 0.5 * s.config.grid.spacing, s.config.particles->layers = 2;
        s.config.particles->velocity = velocity;
        const auto cpu = make_cpu_backend(s.config, s.initial);
        const auto tiles = make(s.config, s.initial);
        cpu->set_state(s.state), tiles->set_state(s.state);
        for (int n = 0; n < 4; ++n) {
          const double dt = std::min(cpu->stable_step(), 0.05);
          cpu->step(dt), tiles->step(dt);
          cpu->move_particles(3.0 * dt), tiles->move_particles(3.0 * dt);
          cpu->begin_capture({}), tiles->begin_capture({});
          const ParticleFrame a = cpu->end_capture().particles, b = tiles->end_capture().particles;
          REQUIRE((a.position == b.position && a.id == b.id && a.visible == b.visible));
        }
        const ParticleReport a = cpu->particles().report, b = tiles->particles().report;
        CHECK((a.moves == b.moves && a.born == b.born && a.merged == b.merged && a.left == b.left));
        CHECK(a.born == a.merged + a.left);
      }
    }
  }
}

namespace {

/// Small grids fit a block's shared memory; with a large one the states stay where they are.
enum class Group { small_planes, planes, rows };

/// Runs of one scheme with sources.
std::vector<EnsembleMember> make_members(const Numerics& numerics, Group group, std::vector<StateArrays>& states) {
  std::vector<EnsembleMember> members;
  unsigned seed = 300;
  std::vector<Variant> all = variants();
  if (group == Group::planes) {
    all.push_back({120, 90, {wall, open, periodic, periodic}, Ground::terrain, 0, 0});
  }
  for (const Variant& variant : all) {
    if ((variant.ny == 1) == (group == Group::rows) && variant.nx <= ensemble_columns) {
      Setting s = make_setting(variant, numerics, ++seed);
      s.config.rains = {{{0}, 0.1 * seed, 0.01, 0.05}};
      members.push_back({s.config, s.initial});
      states.push_back(s.state);
    }
  }
  return members;
}

}  // namespace

void check_ensemble(const MakeEnsemble& make) {
  StepRules rules;
  rules.due = 0.06, rules.minimum_step = 1e-9, rules.rain_step = 0.01, rules.rain_end = 0.05;
  for (const Numerics& numerics : all_numerics()) {
    for (const Group group : {Group::small_planes, Group::planes, Group::rows}) {
      std::vector<StateArrays> states;
      const std::vector<EnsembleMember> members = make_members(numerics, group, states);
      const auto ensemble = make(members);
      REQUIRE(ensemble->size() == members.size());
      std::vector<StepLoop> loops(members.size());
      std::vector<StepRules> all_rules(members.size(), rules);
      for (std::size_t k = 0; k < members.size(); ++k) {
        all_rules[k].due += 0.001 * static_cast<double>(k);
        ensemble->member(k).set_state(states[k]);
        loops[k].plan(all_rules[k], ensemble->member(k).stable_step());
      }
      const auto runs = [](StepLoop& loop) {
        loop.halt = loop.halt == Halt::smallest_step ? Halt::none : loop.halt;
        return loop.halt == Halt::none;
      };
      while (std::count_if(loops.begin(), loops.end(), runs) > 0) {
        ensemble->advance(loops, all_rules, 5);
      }
      for (std::size_t k = 0; k < members.size(); ++k) {
        CAPTURE(k, static_cast<int>(group), numerics.order, static_cast<int>(numerics.scheme),
                static_cast<int>(numerics.precision));
        const auto cpu = make_cpu_backend(members[k].config, members[k].initial);
        cpu->set_state(states[k]);
        const StepLoop expected = run_loop(*cpu, all_rules[k], 1000);
        CHECK(loops[k].steps == expected.steps);
        CHECK(loops[k].time == expected.time);
        CHECK(loops[k].volume_in == expected.volume_in);
        CHECK(same_bits(ensemble->member(k).field("depth"), cpu->field("depth")));
        CHECK(same_bits(ensemble->member(k).field("momentum_y"), cpu->field("momentum_y")));
        CHECK(same_bits(ensemble->member(k).maxima().arrival_time, cpu->maxima().arrival_time));
      }
    }
  }
}

namespace {

/// A box that turns, half in the sand; a sphere that is buried and one that stands at the edge.
std::vector<std::shared_ptr<const objects::Object>> make_objects(Coupling coupling, VerticalTransfer vertical) {
  KinematicObject box, buried, edge;
  box.shape = BoxShape{{0.5, 0.3, 0.4}, {}};
  box.position = {0.8, 0.5, 0.25};
  box.motion = ConstantMotion{{1.0, -0.6, -0.5}, {0.3, 0.0, 2.0}};
  buried.shape = SphereShape{0.06, {}};
  buried.position = {0.5, 0.2, 0.12};
  buried.motion = ConstantMotion{{0.5, 0.8, 0.0}, {}};
  edge.shape = SphereShape{0.3, {}};
  edge.position = {0.0, 0.0, 0.2};
  std::vector<std::shared_ptr<const objects::Object>> made;
  for (KinematicObject* object : {&box, &buried, &edge}) {
    object->coupling = coupling, object->vertical = vertical;
    made.push_back(std::make_shared<objects::Object>(*object, 0.1));
  }
  return made;
}

/// The objects in a step that ends at `now`, in the last of which one has left.
std::vector<ObjectStep> steps_at(const std::vector<std::shared_ptr<const objects::Object>>& all, double now) {
  std::vector<ObjectStep> steps;
  for (std::size_t k = 0; k < all.size(); ++k) {
    steps.push_back({k, all[k]->at(now - 0.02), all[k]->at(now), k == 0 && now > 0.03});
  }
  return steps;
}

void check_same_state(const Backend& a, const Backend& b) {
  for (const char* name : {"depth", "momentum_x", "momentum_y", "flowing_depth", "flow_bed"}) {
    REQUIRE(same_bits(a.field(name), b.field(name)));
  }
}

}  // namespace

void check_objects_on(const MakeBackend& make) {
  unsigned seed = 500;
  for (const Variant& variant : variants()) {
    for (const Numerics& numerics : all_numerics()) {
      for (const auto& [coupling, vertical] :
           {std::pair(Coupling::displace, VerticalTransfer::none), std::pair(Coupling::drag, VerticalTransfer::derived),
            std::pair(Coupling::drag, VerticalTransfer::printed)}) {
        CAPTURE(variant.nx, variant.ny, numerics.order, static_cast<int>(numerics.scheme),
                static_cast<int>(numerics.precision), static_cast<int>(coupling));
        Setting s = make_setting(variant, numerics, ++seed);
        s.config.objects = make_objects(coupling, vertical);
        s.config.covers = coupling != Coupling::drag;
        const auto cpu = make_cpu_backend(s.config, s.initial);
        const auto tiles = make(s.config, s.initial);
        const auto judge = make_cpu_backend(s.config, s.initial);
        cpu->set_state(s.state), tiles->set_state(s.state);
        // Twice: what was covered in the first round stays so, or is left, in the second.
        // Each of the cells rounds once a round: half an epsilon of the deepest.
        const double epsilon = numerics.precision == Precision::float32 ? 1.2e-7 : 2.3e-16;
        for (const double now : {0.02, 0.04}) {
          const double before = cpu->statistics().volume;
          for (const ObjectStep& step : steps_at(s.config.objects, now)) {
            const ObjectEffect a = cpu->couple(step, steps_at(s.config.objects, now));
            const ObjectEffect b = tiles->couple(step, steps_at(s.config.objects, now));
            CHECK((a.displaced_volume == b.displaced_volume && a.overlapped_volume == b.overlapped_volume));
            CHECK((a.momentum == b.momentum && a.work == b.work && a.deepest == b.deepest && a.changed == b.changed));
            CHECK(cpu->stable_step() == tiles->stable_step());
            judge->set_state(cpu->state());
            CHECK(cpu->stable_step() == judge->stable_step());
            check_same_state(*cpu, *tiles);
          }
          CHECK(std::fabs(cpu->statistics().volume - before) <= 3.0 * epsilon * before);
          cpu->step(1e-4), tiles->step(1e-4);
          check_same_state(*cpu, *tiles);
        }
        CHECK(same_bits(cpu->field("surface"), tiles->field("surface")));
        CHECK(cpu->slope_violation() == tiles->slope_violation());
        const auto again = make(s.config, s.initial);  // what a run goes on from is all there is
        again->set_state(tiles->state());
        cpu->step(1e-4), again->step(1e-4);
        check_same_state(*cpu, *again);
        CHECK(cpu->find_broken().i == -1);
      }
    }
  }
}

}  // namespace sandsim::test
