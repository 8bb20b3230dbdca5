// Particles in given flows, without a solver.
#include "solver/backends/particles/stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "solver/backends/particles/threaded.hpp"
#include "solver/backends/tiles/host_machine.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::particles {
namespace {

constexpr BoundaryKind wall = BoundaryKind::wall, open = BoundaryKind::open, periodic = BoundaryKind::periodic;

Grid grid_of(int nx, int ny) {
  Grid grid;
  grid.cells = {nx, ny};
  grid.spacing = 0.1;
  return grid;
}

Particles particles_of(int refinement, int layers = 1, int seed = 0) {
  Particles particles;
  particles.spacing = 0.1 / refinement;
  particles.layers = layers;
  particles.seed = seed;
  return particles;
}

/// A stage on `Machine` in a flow u(x, y), v(x, y) [m/s] of sand of the depth 1 m.
template <class Machine = ThreadedMachine>
struct Setup {
  Grid grid;
  ParticleStage<Machine> stage;

  template <class... MachineArguments>
  Setup(const Grid& of, const Particles& particles, const Boundaries& sides, MachineArguments... arguments)
      : grid(of), stage(std::make_shared<Machine>(arguments...), particles, of, sides) {
    flow([](double, double) { return 0.0; }, [](double, double) { return 0.0; });
    const std::size_t cells = grid.cell_count();
    std::fill_n(stage.sand().depth, cells, 1.0f);
    std::fill_n(stage.sand().surface, cells, 2.0);
    stage.move(0.0);
  }
  template <class U, class V>
  void flow(U u, V v) {
    for (int j = 0; j < grid.cells[1]; ++j) {
      for (int i = 0; i < grid.cells[0]; ++i) {
        const int cell = j * grid.cells[0] + i;
        stage.sand().velocity_x[cell] = static_cast<float>(u(grid.x(i), grid.y(j)));
        stage.sand().velocity_y[cell] = static_cast<float>(v(grid.x(i), grid.y(j)));
      }
    }
  }
  ParticleFrame frame() {
    stage.begin_capture();
    return stage.end_capture();
  }
};

/// The vortex of the stream function sin(pi x) sin(pi y) on a unit square: along the walls, never across.
double vortex_u(double x, double y) {
  return std::sin(M_PI * x) * std::cos(M_PI * y);
}
double vortex_v(double x, double y) {
  return -std::cos(M_PI * x) * std::sin(M_PI * y);
}

std::map<std::int64_t, std::size_t> by_id(const ParticleFrame& frame) {
  std::map<std::int64_t, std::size_t> index;
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    index[frame.id[k]] = k;
  }
  return index;
}

bool same(const ParticleFrame& a, const ParticleFrame& b) {
  return a.id == b.id && a.visible == b.visible && a.position.size() == b.position.size() &&
         std::memcmp(a.position.data(), b.position.data(), a.position.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("At first every cell of the particles' grid holds one, somewhere within") {
  Setup place(grid_of(3, 2), particles_of(2, 3), {}, 1);
  const ParticleFrame frame = place.frame();
  REQUIRE(frame.id.size() == 6 * 4 * 3);
  CHECK(by_id(frame).size() == frame.id.size());
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    const int column = static_cast<int>(k) % 6, row = static_cast<int>(k) / 6 % 4, layer = static_cast<int>(k) / 24;
    CHECK(static_cast<int>(frame.position[3 * k] / 0.05) == column);
    CHECK(static_cast<int>(frame.position[3 * k + 1] / 0.05) == row);
    const double below = 2.0 - frame.position[3 * k + 2];  // the surface
    CHECK(below >= 0.05 * layer - 1e-15);                  // rounding of a height of 2
    CHECK(below <= 0.05 * (layer + 1) + 1e-15);
  }
  Setup other(grid_of(3, 2), particles_of(2, 3, 1), {}, 1);
  CHECK(other.frame().position != frame.position);  // another seed
}

TEST_CASE("Far from the origin particles lie in their cells as near it") {
  for (const double spacing : {0.01, 1.0, 10.0}) {
    Grid near = grid_of(5, 4);
    near.spacing = spacing;
    Grid far = near;
    far.origin = {4567000.3, 5234000.7};  // UTM, and no floats, as the elevation
    Particles particles = particles_of(2, 3);
    particles.spacing = spacing / 2;
    Setup here(near, particles, {}, 1), there(far, particles, {}, 1);
    const double elevation = 2345.678;
    std::fill_n(there.stage.sand().surface, far.cell_count(), 2.0 + elevation);
    for (int move = 0; move < 3; ++move) {
      for (auto* place : {&here, &there}) {
        place->flow([&](double, double) { return 0.3 * spacing; }, [&](double, double) { return -0.2 * spacing; });
        place->stage.move(1.0);
      }
      const ParticleFrame a = here.frame(), b = there.frame();
      REQUIRE(a.id == b.id);
      REQUIRE(a.visible == b.visible);
      double largest = 0.0;
      for (std::size_t k = 0; k < a.id.size(); ++k) {
        const double shift[] = {far.origin[0], far.origin[1], elevation};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          largest = std::max(largest, std::fabs(b.position[3 * k + axis] - shift[axis] - a.position[3 * k + axis]));
        }
      }
      CHECK(largest < 1e-6 * spacing);  // doubles are 1e-9 m apart at these coordinates, a tenth of this
    }
  }
}

TEST_CASE("In a cell that several enter the oldest stays, of those of one age the one from the first cell") {
  CHECK(claim_of(id_of(0, 9), 500) < claim_of(id_of(3, 2), 1));
  CHECK(claim_of(id_of(3, 700), 4) < claim_of(id_of(3, 2), 5));
  CHECK(claimant(claim_of(id_of(3, 2), 2147483647)) == 2147483647);
  CHECK(claim_of(id_of(2147483647, 2147483647), 2147483647) < no_claim);
}

TEST_CASE("Where the sand rests, particles keep their places and names") {
  Setup place(grid_of(8, 8), particles_of(4), {}, 1);
  const ParticleFrame before = place.frame();
  for (int n = 0; n < 10; ++n) {
    place.flow([](double, double) { return 0.0; }, [](double, double) { return 0.0; });
    place.stage.move(1.0);
  }
  CHECK(same(before, place.frame()));
  CHECK(place.stage.arrays().report.moves == 0);
}

TEST_CASE("In an even flow all particles move with it and none is lost") {
  const Boundaries sides{periodic, periodic, periodic, periodic};
  Setup place(grid_of(10, 10), particles_of(2), sides, 1);
  const ParticleFrame before = place.frame();
  for (int n = 0; n < 2; ++n) {  // the first move takes the mean of rest and flow
    place.flow([](double, double) { return 0.3; }, [](double, double) { return -0.2; });
    place.stage.move(1.0);
  }
  const ParticleFrame after = place.frame();
  const ParticleReport report = place.stage.arrays().report;
  CHECK((report.born == 0 && report.merged == 0 && report.left == 0));
  CHECK(report.moves == 2);
  const auto found = by_id(after);
  const auto apart = [](double a, double b) {  // the shorter way round a grid of 1 m
    const double way = std::fabs(a - b);
    return std::min(way, 1.0 - way);
  };
  for (std::size_t k = 0; k < before.id.size(); ++k) {
    const std::size_t now = found.at(before.id[k]);
    // An offset is rounded to 2^-24 cells a hop; positions of 1 m are given to 6e-8.
    CHECK(apart(after.position[3 * now], std::fmod(before.position[3 * k] + 0.45 + 1.0, 1.0)) < 1e-6);
    CHECK(apart(after.position[3 * now + 1], std::fmod(before.position[3 * k + 1] - 0.3 + 1.0, 1.0)) < 1e-6);
  }
}

TEST_CASE("A turning flow carries particles along circles") {
  // Rigid rotation about the middle, within which bilinear interpolation is exact; a quarter turn in one move.
  Setup place(grid_of(20, 20), particles_of(1), {}, 1);
  const auto u = [](double, double y) { return 1.0 - y; };
  const auto v = [](double x, double) { return x - 1.0; };
  place.flow(u, v);
  place.stage.move(0.0);
  const ParticleFrame before = place.frame();
  place.flow(u, v);
  place.stage.move(M_PI / 2);
  const ParticleFrame after = place.frame();
  const auto found = by_id(after);
  int looked_at = 0, kept = 0, on_circles = 0;
  for (std::size_t k = 0; k < before.id.size(); ++k) {
    const double x = before.position[3 * k] - 1.0, y = before.position[3 * k + 1] - 1.0, r = std::hypot(x, y);
    if (r < 0.4 || r > 0.8) continue;
    ++looked_at;
    const auto now = found.find(before.id[k]);
    if (now == found.end()) continue;
    ++kept;
    const double to_x = after.position[3 * now->second] - 1.0, to_y = after.position[3 * now->second + 1] - 1.0;
    // Midpoint rule: a hop is a cell of 0.1 m along an axis or less, 0.14 m in all, over the angle a = 0.14/r, of
    // which a^3/6 is lost.
    const double a = 0.1414 / r;
    on_circles += std::hypot(to_x + y, to_y - x) < M_PI / 2 * a * a / 6 * r + 1e-5 ? 1 : 0;
  }
  // The others were pushed aside or gave way, as a jittered grid that is turned has them.
  CHECK(on_circles > looked_at / 2);
  CHECK(kept > 8 * looked_at / 10);
}

TEST_CASE("After a thousand moves of a spinning flow the particles are even, and every one is accounted for") {
  Setup place(grid_of(10, 10), particles_of(6), {}, 1);
  std::set<std::int64_t> ever;
  for (const std::int64_t id : place.frame().id) {
    ever.insert(id);
  }
  for (int n = 0; n < 1000; ++n) {
    place.flow(vortex_u, vortex_v);
    place.stage.move(0.02);
  }
  const ParticleFrame frame = place.frame();
  const ParticleReport report = place.stage.arrays().report;
  CHECK(report.count == 3600);
  CHECK(report.moves == 1000);
  CHECK(report.born == report.merged);
  CHECK(report.born > 3600);
  // Most of those that lose their cell are pushed aside: a twelfth or less is replaced in a move, without it a fifth.
  CHECK(report.born < 3600 * 1000 / 12);
  CHECK(report.left == 0);
  CHECK(by_id(frame).size() == 3600);  // none twice
  // Chi-squared over blocks that do not fit the cells: 7 x 7 of 1/7 m. Places drawn at random would give 48.
  std::vector<double> blocks(49);
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    REQUIRE((frame.position[3 * k] >= 0.0 && frame.position[3 * k] <= 1.0));
    REQUIRE((frame.position[3 * k + 1] >= 0.0 && frame.position[3 * k + 1] <= 1.0));
    const int i = std::min(6, static_cast<int>(7 * frame.position[3 * k]));
    const int j = std::min(6, static_cast<int>(7 * frame.position[3 * k + 1]));
    blocks[static_cast<std::size_t>(7 * j + i)] += 1.0;
  }
  double chi_squared = 0.0;
  for (const double n : blocks) {
    chi_squared += (n - 3600.0 / 49.0) * (n - 3600.0 / 49.0) / (3600.0 / 49.0);
  }
  CHECK(chi_squared < 48.0);
}

TEST_CASE("Particles are the same for any number of threads, and on tiles") {
  const Boundaries sides{wall, open, periodic, periodic};
  const auto frames = [&](auto& place) {
    std::vector<ParticleFrame> taken;
    for (int n = 0; n < 20; ++n) {
      place.flow([](double x, double y) { return std::sin(9 * x + 5 * y); },
                 [n](double x, double y) { return std::cos(7 * x - y + n); });
      place.stage.move(0.07);
      taken.push_back(place.frame());
    }
    return taken;
  };
  Setup one(grid_of(13, 7), particles_of(4, 2), sides, 1);
  const auto expected = frames(one);
  for (const int threads : {2, 5}) {
    Setup many(grid_of(13, 7), particles_of(4, 2), sides, threads);
    const auto found = frames(many);
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(same(found[k], expected[k]));
    }
  }
  Setup<tiles::HostMachine> tiled(grid_of(13, 7), particles_of(4, 2), sides);
  const auto found = frames(tiled);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CHECK(same(found[k], expected[k]));
  }
  const ParticleReport report = one.stage.arrays().report;
  CHECK(report.left > 0);
  CHECK(report.born == report.merged + report.left);
  CHECK(tiled.stage.arrays().report.born == report.born);
}

TEST_CASE("What is taken from a stage goes on in another one with the same bits") {
  Setup place(grid_of(6, 6), particles_of(3), {}, 1), other(grid_of(6, 6), particles_of(3), {}, 1);
  const auto go = [](auto& at) {
    at.flow([](double x, double y) { return x - y; }, [](double x, double y) { return x * y; });
    at.stage.move(0.3);
  };
  go(place), go(place);
  other.stage.set(place.stage.arrays());
  go(place), go(other);
  CHECK(same(place.frame(), other.frame()));
  CHECK(place.stage.arrays().report.born == other.stage.arrays().report.born);
}

TEST_CASE("In thin sand and below the ground particles are hidden") {
  Grid grid = grid_of(3, 1);
  Particles particles = particles_of(1, 4);
  particles.hide_below = 0.06;
  Setup place(grid, particles, {}, 1);
  for (int i = 0; i < 3; ++i) {
    place.stage.sand().depth[i] = std::vector<float>{0.05f, 0.2f, 0.2f}[static_cast<std::size_t>(i)];
  }
  const ParticleFrame frame = place.frame();
  for (std::size_t k = 0; k < 12; ++k) {
    if (k % 3 == 0) CHECK(frame.visible[k] == 0);        // thinner than hide_below
    if (k % 3 == 2) CHECK(frame.visible[k] == (k < 6));  // layers of 0.1 m in 0.2 m of sand
  }
}

TEST_CASE("Particles that follow the dilute layer are h/hbar times as fast, up to a bound") {
  const physics::Material<float> material{0.5f, 1.0f, 0.2f};
  const auto velocity = [&](float h, ParticleVelocity kind) {
    return carrying_velocity(0.3f * h, h, material, 1e-4f, kind, 5.0f);
  };
  CHECK_THAT(velocity(0.1f, ParticleVelocity::averaged), WithinRel(0.3f, 1e-6f));
  CHECK_THAT(velocity(0.1f, ParticleVelocity::dilute), WithinRel(0.3f, 1e-6f));
  CHECK_THAT(velocity(0.8f, ParticleVelocity::dilute), WithinRel(1.2f, 1e-6f));
  CHECK_THAT(velocity(8.0f, ParticleVelocity::dilute), WithinRel(1.5f, 1e-6f));
  CHECK(velocity(0.0f, ParticleVelocity::dilute) == 0.0f);
}

}  // namespace sandsim::particles
