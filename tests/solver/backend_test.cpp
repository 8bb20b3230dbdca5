#include "solver/backend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "solver/backends/expected_bytes.hpp"
#include "solver/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

using Values = std::vector<double>;

BackendConfig config(int nx, int ny, BoundaryKind kind) {
  BackendConfig c;
  c.grid.cells = {nx, ny};
  c.grid.spacing = 0.1;
  c.boundaries = {kind, kind, kind, kind};
  c.numerics.precision = Precision::float64;
  return c;
}

/// Smooth depths and a rough bed that repeat over the grid.
InitialState waves(int nx, int ny, bool bed) {
  InitialState s;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      s.depth.push_back(0.3 + 0.1 * std::sin(6.283 * i / nx) + 0.05 * std::cos(6.283 * j / ny));
      if (bed) {
        s.bed.push_back(0.01 * ((7 * i + 13 * j) % 5));
      }
    }
  }
  s.friction_coefficient = {0.1};
  s.hbar_scale = {1.0};
  s.hbar_cap = {1e30};
  return s;
}

Values shifted(const Values& from, int nx, int ny, int di, int dj) {
  Values to(from.size());
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      to[static_cast<std::size_t>(((j + dj) % ny) * nx + (i + di) % nx)] = from[static_cast<std::size_t>(j * nx + i)];
    }
  }
  return to;
}

/// Steps of the stable length; all schemes and orders.
std::vector<Numerics> all_numerics() {
  Numerics order2, order1, paper;
  order1.order = 1;
  paper.scheme = Scheme::paper;
  std::vector<Numerics> all{order2, order1, paper};
  for (Numerics& n : all) {
    n.precision = Precision::float64;
  }
  return all;
}

Values depth_after(const BackendConfig& c, const InitialState& s, int steps) {
  const auto backend = make_cpu_backend(c, s);
  for (int k = 0; k < steps; ++k) {
    backend->step(backend->stable_step());
  }
  return std::get<Values>(backend->state().depth);
}

TEST_CASE("The slope violation is that of what friction has to hold") {
  InitialState s{{}, {0.3, 0.2}, {0.5}, {1.0}, {1e30}};
  const BackendConfig two = config(2, 1, BoundaryKind::wall);
  CHECK_THAT(make_cpu_backend(two, s)->slope_violation(), WithinAbs(1.0, 1e-14));  // 0.1 m over 0.1 m, mu 0.5
  // At the edge of a drop only the upper cell's own depth counts, twice: 0.02 m.
  s.bed = {1.0, 0.0};
  s.depth = {0.01, 0.2};
  CHECK(make_cpu_backend(two, s)->slope_violation() == 0.0);
}

TEST_CASE("On a periodic grid a shifted state gives the shifted result") {
  const int nx = 23, ny = 17;
  for (const Numerics& numerics : all_numerics()) {
    BackendConfig c = config(nx, ny, BoundaryKind::periodic);
    c.numerics = numerics;
    c.courant = 0.25;
    const InitialState here = waves(nx, ny, true);
    InitialState there = here;
    there.depth = shifted(here.depth, nx, ny, 9, 5);
    there.bed = shifted(here.bed, nx, ny, 9, 5);
    CHECK(depth_after(c, there, 20) == shifted(depth_after(c, here, 20), nx, ny, 9, 5));
  }
}

TEST_CASE("A bed of zeros and maps of one value give the bits of a flat and uniform scene") {
  for (const int ny : {1, 19}) {
    for (const Numerics& numerics : all_numerics()) {
      BackendConfig c = config(21, ny, BoundaryKind::wall);
      c.numerics = numerics;
      c.courant = 0.25;
      const InitialState plain = waves(21, ny, false);
      InitialState maps = plain;
      const std::size_t cells = plain.depth.size();
      maps.bed.assign(cells, 0.0);
      const Values expected = depth_after(c, plain, 30);
      CHECK(depth_after(c, maps, 30) == expected);
      maps.friction_coefficient.assign(cells, 0.1);
      maps.hbar_scale.assign(cells, 1.0);
      maps.hbar_cap.assign(cells, 1e30);
      CHECK(depth_after(c, maps, 30) == expected);
    }
  }
}

TEST_CASE("What leaves through open sides is missing inside and none comes back") {
  for (const int ny : {1, 15}) {
    for (const Numerics& numerics : all_numerics()) {
      BackendConfig c = config(15, ny, BoundaryKind::open);
      c.numerics = numerics;
      c.courant = 0.25;
      InitialState s = waves(15, ny, true);
      s.friction_coefficient = {0.01};
      const auto backend = make_cpu_backend(c, s);
      const double before = backend->statistics().volume;
      double out = 0.0, least = 0.0;
      for (int k = 0; k < 200; ++k) {
        const StepOutcome outcome = backend->step(backend->stable_step());
        out += outcome.volume_out;
        least = std::min(least, outcome.volume_out);
      }
      CHECK(out > 0.2 * before);
      CHECK(least >= 0.0);
      CHECK(std::fabs(backend->statistics().volume + out - before) <= 1e-14 * before * 200.0);  // one rounding a step
    }
  }
}

TEST_CASE("A stream leaves through an open side undisturbed") {
  // Uniform flow down a uniform slope with mu = tan(slope): nothing changes, at the open sides neither.
  BackendConfig c = config(40, 1, BoundaryKind::periodic);
  c.boundaries.x_min = c.boundaries.x_max = BoundaryKind::open;
  InitialState s;
  s.depth.assign(40, 0.05);
  for (int i = 0; i < 40; ++i) {
    s.bed.push_back(-0.02 * i);
  }
  s.friction_coefficient = {0.2}, s.hbar_scale = {1.0}, s.hbar_cap = {1e30};
  const auto backend = make_cpu_backend(c, s);
  backend->set_state({s.depth, Values(40, 0.05 * 1.5), Values(40, 0.0)});
  for (int k = 0; k < 5; ++k) {
    backend->step(backend->stable_step());
  }
  const Values depth = std::get<Values>(backend->state().depth);
  // Ten cells from the inflow side (a wall to a stream that comes from it) the stream is as it was, up to rounding.
  CHECK(std::all_of(depth.begin() + 12, depth.end(), [](double h) { return std::fabs(h - 0.05) < 1e-14; }));
}

TEST_CASE("The same bits for any number of threads and any tile") {
  for (const Numerics& numerics : all_numerics()) {
    BackendConfig c = config(53, 37, BoundaryKind::wall);
    c.numerics = numerics;
    c.courant = 0.25;
    const InitialState s = waves(53, 37, true);
    c.threads = 1;
    const Values expected = depth_after(c, s, 25);
    for (const auto& [threads, tile, block] : {std::array{2, 0, 0}, {2, 7, 3}, {1, 16, 1}, {3, 53, 37}, {2, 1, 5}}) {
      c.threads = threads, c.tile_columns = tile, c.block_rows = block;
      CHECK(depth_after(c, s, 25) == expected);
    }
  }
}

TEST_CASE("A value that is not finite is noticed in the step that makes it") {
  BackendConfig c = config(12, 9, BoundaryKind::wall);
  const InitialState s = waves(12, 9, false);
  const auto backend = make_cpu_backend(c, s);
  StateArrays state = backend->state();
  CHECK(backend->find_broken().i == -1);
  CHECK_FALSE(backend->step(1e-3).broken);
  std::get<Values>(state.momentum_x)[4 * 12 + 7] = std::numeric_limits<double>::quiet_NaN();
  backend->set_state(state);
  const Incident found = backend->find_broken();
  CHECK(found.i == 7);
  CHECK(found.j == 4);
  CHECK(found.cause == "a value that is not finite");
  CHECK(backend->step(1e-3).broken);
}

TEST_CASE("The smallest grids run") {
  for (const auto& [nx, ny] : {std::array{1, 1}, {2, 2}, {1, 7}, {7, 1}, {2, 1}, {1, 2}}) {
    for (const BoundaryKind kind : {BoundaryKind::wall, BoundaryKind::open, BoundaryKind::periodic}) {
      for (const Numerics& numerics : all_numerics()) {
        BackendConfig c = config(nx, ny, kind);
        c.numerics = numerics;
        c.courant = 0.25;
        InitialState s = waves(nx, ny, true);
        s.depth[0] = 1.0;
        const auto backend = make_cpu_backend(c, s);
        const double before = backend->statistics().volume;
        double out = 0.0;
        for (int k = 0; k < 20; ++k) {
          const StepOutcome outcome = backend->step(std::min(backend->stable_step(), 0.01));
          REQUIRE_FALSE(outcome.broken);
          out += outcome.volume_out;
        }
        CHECK(std::fabs(backend->statistics().volume + out - before) <= 1e-13 * before);  // twenty steps' rounding
      }
    }
  }
}

TEST_CASE("A scene that is larger than the memory is refused, and what makes it large is named") {
  BackendConfig c = config(100, 100, BoundaryKind::wall);
  const InitialState s = waves(100, 100, false);
  const auto message = [&] {
    const double needed = expected_bytes(c, s);
    CHECK_NOTHROW(require_bytes(c, needed, needed, "this machine"));
    try {
      require_bytes(c, needed, needed - 1.0, "this machine");
    } catch (const DeviceError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(message().find("Use fewer cells") != std::string::npos);
  c.particles = Particles{};
  c.particles->spacing = 0.01, c.particles->layers = 20;  // 2e7 particles
  CHECK(expected_bytes(c, s) > 2e7 * 40);                 // at least where they are and where they go
  CHECK(message().find("of it for particles, and this machine") != std::string::npos);
  CHECK(message().find("fewer particles.layers") != std::string::npos);
}

TEST_CASE("Rain reports the volume that the cells gained") {
  BackendConfig c = config(6, 5, BoundaryKind::wall);
  c.numerics.precision = Precision::float32;
  const auto backend = make_cpu_backend(c, waves(6, 5, false));
  const double before = backend->statistics().volume;
  const double gained = backend->rain({{0, 7, 29}, 0.5}, 0.01);
  CHECK_THAT(gained, WithinRel(3 * 0.5 * 0.01 * 0.01, 1e-4));  // a float32 depth of 0.3 m has a quantum of 3e-8 m
  CHECK_THAT(backend->statistics().volume - before, WithinRel(gained, 1e-9));
}

}  // namespace
}  // namespace sandsim::test
