// Objects in whole runs: what they move, and that they lose nothing.
#include <cmath>
#include <numbers>

#include "tests/solver/support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

/// A bed of `depth` in the middle of which something may happen; 31 deg.
Scene bed(int cells, double spacing, double depth) {
  Scene scene;
  scene.title = "bed";
  scene.grid.cells = {cells, cells};
  scene.grid.spacing = spacing;
  scene.sand.friction_angle = 31.0 * std::numbers::pi / 180.0;
  SandLayer layer;
  layer.fill.depth = depth;
  scene.sand.initial = {layer};
  scene.output.fields = {OutputField::depth, OutputField::momentum};
  return scene;
}

/// Volume above and below a level. [m^3]
double above(const Scene& scene, const Frame& frame, double level, double sign) {
  double volume = 0.0;
  std::visit(
      [&](const auto& h) {
        for (const auto value : h) volume += std::max(0.0, sign * (static_cast<double>(value) - level));
      },
      field_of(frame, "depth"));
  return volume * scene.grid.spacing * scene.grid.spacing;
}

/// A plate of 16 cm x 16 cm that sinks 5 cm into a bed at 3 cm/s.
Scene stamp(double spacing, Precision precision) {
  Scene scene = bed(static_cast<int>(std::lround(0.6 / spacing)), spacing, 0.15);
  KinematicObject plate;
  plate.name = "plate";
  plate.shape = BoxShape{{0.16, 0.16, 0.2}, {}};
  plate.motion = Keyframes{objects::Interpolation::linear,
                           {{0.0, {0.3, 0.3, 0.26}, {}}, {2.0, {0.3, 0.3, 0.2}, {}}, {3.0, {0.3, 0.3, 0.5}, {}}}};
  scene.objects = {plate};
  scene.time.end = 5.0, scene.time.frame_interval = 1.0;
  scene.time.stop_at_rest = true;
  scene.numerics.precision = precision;
  return scene;
}

TEST_CASE("A stamped plate throws up a berm of the volume that it displaces, and the slopes come to rest") {
  for (const double spacing : {0.02, 0.01}) {
    const Scene scene = stamp(spacing, Precision::float64);
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    const double displaced = 0.16 * 0.16 * 0.05;
    REQUIRE(sink.frames.size() >= 3);
    // At its lowest: the berm lies on a bed that is otherwise as it was. A grid of whole cells meets the plate's sides.
    CHECK_THAT(above(scene, sink.frames[2], 0.15, 1.0), WithinRel(displaced, 1e-3));
    CHECK_THAT(above(scene, sink.frames[2], 0.15, -1.0), WithinRel(displaced, 1e-3));
    CHECK(report.status == "at rest");
    CHECK(report.max_slope_violation <= 1e-5);         // as without objects
    CHECK(std::fabs(report.ledger.error()) <= 1e-12);  // likewise
    REQUIRE(report.objects.size() == 1);
    // What runs in under the rising plate and is pushed back counts as well.
    CHECK(report.objects[0].displaced_volume >= (1.0 - 1e-12) * displaced);
    CHECK(report.objects[0].displaced_volume <= 2.0 * displaced);
  }
}

TEST_CASE("Sand beside an object that stays in it comes to rest") {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Scene scene = bed(60, 0.01, 0.12);
    KinematicObject ball;
    ball.name = "ball";
    ball.shape = SphereShape{0.06, {}};
    ball.motion = Keyframes{objects::Interpolation::linear, {{0.0, {0.3, 0.3, 0.2}, {}}, {0.08, {0.3, 0.3, 0.12}, {}}}};
    scene.objects = {ball};
    scene.time.end = 3.0, scene.time.frame_interval = 1.0;
    scene.time.stop_at_rest = true;
    scene.numerics.precision = precision;
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    CHECK(report.status == "at rest");
    CHECK(report.stop_time < 1.0);
    CHECK(report.max_slope_violation <= 1e-5);  // as without objects
    // The crater has the sphere's shape: cells' centres meet it half a diagonal off its lowest point at most.
    CHECK_THAT(above(scene, sink.frames.back(), 0.12, -1.0), WithinRel(2.0 / 3.0 * std::numbers::pi * 2.16e-4, 0.02));
  }
}

TEST_CASE("An object above the sand changes nothing, and needs no bed") {
  std::vector<FieldValues> depth;
  std::vector<std::int64_t> memory;
  for (const double height : {0.5, 2.0, 0.2}) {
    Scene scene = bed(40, 0.02, 0.1);
    SandColumn heap;
    heap.center = {0.4, 0.4}, heap.radius = 0.2, heap.fill.depth = 0.2;
    scene.sand.initial.push_back(heap);
    KinematicObject ball;
    ball.name = "ball";
    ball.shape = SphereShape{0.1, {}};
    ball.position = {0.3, 0.4, height};
    ball.motion = ConstantMotion{{0.5, 0.0, 0.0}, {}};
    scene.objects = {ball};
    scene.time.end = 0.3, scene.time.frame_interval = 0.3;
    MemorySink sink;
    memory.push_back(run(scene, {}, sink).memory_bytes);
    depth.push_back(field_of(sink.frames.back(), "depth"));
  }
  CHECK(depth[0] == depth[1]);
  CHECK(depth[0] != depth[2]);
  CHECK(memory[0] == memory[1]);
  CHECK(memory[0] < memory[2]);
}

TEST_CASE("Sand runs over a low object and not over a high one") {
  double over[2] = {};
  for (const bool high : {false, true}) {
    Scene scene = bed(0, 0.02, 0.0);
    scene.grid.cells = {80, 1};
    scene.sand.initial.clear();
    SandBox heap;
    heap.from = {0.0, 0.0}, heap.to = {0.4, 0.02};
    heap.fill.depth = 0.4;
    scene.sand.initial = {heap};
    KinematicObject sill;
    sill.name = "sill";
    sill.shape = BoxShape{{0.1, 0.2, high ? 1.0 : 0.1}, {}};
    sill.position = {0.7, 0.01, high ? 0.5 : 0.05};
    sill.motion = ConstantMotion{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    scene.objects = {sill};
    scene.time.end = 10.0, scene.time.frame_interval = 10.0;
    scene.numerics.precision = Precision::float64;
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    const auto& h = std::get<std::vector<double>>(field_of(sink.frames.back(), "depth"));
    for (std::size_t i = 38; i < h.size(); ++i) over[high ? 1 : 0] += h[i] * 0.02;
    CHECK(report.at_rest);
    CHECK(std::fabs(report.ledger.error()) <= 1e-12);  // as without objects
  }
  CHECK(over[0] > 0.0);
  CHECK(over[1] == 0.0);
}

TEST_CASE("An object at rest in sand at rest changes nothing") {
  for (const Coupling coupling : {Coupling::displace, Coupling::drag}) {
    Scene scene = bed(24, 0.02, 0.15);
    KinematicObject ball;
    ball.name = "ball";
    ball.shape = SphereShape{0.1, {}};
    ball.position = {0.24, 0.2, 0.15};
    ball.coupling = coupling;
    scene.objects = {ball};
    scene.time.end = 0.5, scene.time.frame_interval = 0.5;
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    CHECK(report.at_rest);
    CHECK(field_of(sink.frames.front(), "depth") == field_of(sink.frames.back(), "depth"));
    CHECK(field_of(sink.frames.front(), "momentum_x") == field_of(sink.frames.back(), "momentum_x"));
  }
}

/// A box that ploughs 4 cm deep along `angle` for 10 cm.
Scene push(double angle) {
  Scene scene = bed(120, 0.005, 0.1);
  const double c = std::cos(angle), s = std::sin(angle);
  KinematicObject box;
  box.name = "box";
  box.shape = BoxShape{{0.04, 0.16, 0.2}, {}};
  Rotation turned;
  turned.axis = {0.0, 0.0, 1.0}, turned.angle = angle;
  box.rotation = turned;
  box.position = {0.3 - 0.05 * c, 0.3 - 0.05 * s, 0.16};
  box.motion = ConstantMotion{{0.2 * c, 0.2 * s, 0.0}, {}};
  scene.objects = {box};
  scene.time.end = 0.5, scene.time.frame_interval = 0.5;
  scene.numerics.precision = Precision::float64;
  return scene;
}

TEST_CASE("A pushed box does the same along x and y, and nearly the same between") {
  MemorySink along_x, along_y, between;
  run(push(0.0), {}, along_x);
  Scene turned = push(0.0);
  std::get<BoxShape>(turned.objects[0].shape).size = {0.16, 0.04, 0.2};  // no rounding of a quarter turn
  turned.objects[0].position = {0.3, 0.25, 0.16};
  std::get<ConstantMotion>(turned.objects[0].motion).velocity = {0.0, 0.2, 0.0};
  run(turned, {}, along_y);
  const auto& a = std::get<std::vector<double>>(field_of(along_x.frames.back(), "depth"));
  const auto& b = std::get<std::vector<double>>(field_of(along_y.frames.back(), "depth"));
  bool same = true;
  for (std::size_t j = 0; j < 120; ++j) {
    for (std::size_t i = 0; i < 120; ++i) same = same && a[j * 120 + i] == b[i * 120 + j];
  }
  CHECK(same);
  const Scene scene = push(std::numbers::pi / 4.0);
  run(scene, {}, between);
  // 3.7 % apart here, 6.5 % at twice the spacing.
  const double straight = above(scene, along_x.frames.back(), 0.1, 1.0);
  CHECK_THAT(above(scene, between.frames.back(), 0.1, 1.0), WithinRel(straight, 0.05));
}

TEST_CASE("A ridge in a channel grows by what is swept") {
  for (const double spacing : {0.01, 0.005}) {
    Scene scene = bed(0, spacing, 0.1);
    scene.grid.cells = {static_cast<int>(std::lround(1.6 / spacing)), static_cast<int>(std::lround(0.1 / spacing))};
    KinematicObject box;
    box.name = "box";
    box.shape = BoxShape{{0.2, 1.0, 0.4}, {}};
    box.position = {0.3, 0.05, 0.26};
    box.motion = ConstantMotion{{0.1, 0.0, 0.0}, {}};
    scene.objects = {box};
    scene.time.end = 4.0, scene.time.frame_interval = 1.0;
    scene.numerics.precision = Precision::float64;
    MemorySink sink;
    run(scene, {}, sink);
    for (const std::size_t k : {1u, 2u, 3u}) {
      const double grown = above(scene, sink.frames[k + 1], 0.1, 1.0) - above(scene, sink.frames[k], 0.1, 1.0);
      CHECK_THAT(grown, WithinRel(0.1 * 0.1 * 0.04, 0.02));
    }
  }
}

TEST_CASE("A solid object holds no sand, moving or standing") {
  for (const double speed : {0.0, 0.1}) {
    Scene scene = bed(40, 0.02, 0.1);
    KinematicObject wall;
    wall.name = "wall";
    wall.shape = BoxShape{{0.1, 0.3, 1.0}, {}};
    wall.position = {0.3, 0.4, 0.5};
    wall.coupling = Coupling::solid;
    if (speed > 0.0) wall.motion = ConstantMotion{{speed, 0.0, 0.0}, {}};
    scene.objects = {wall};
    scene.time.end = 1.0, scene.time.frame_interval = 1.0;
    scene.numerics.precision = Precision::float64;
    MemorySink sink;
    const RunReport report = run(scene, {}, sink);
    const auto& h = std::get<std::vector<double>>(field_of(sink.frames.back(), "depth"));
    const double left = wall.position[0] - 0.05 + speed, right = left + 0.1;
    double inside = 0.0;
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 40; ++i) {
        const double x = scene.grid.x(i), y = scene.grid.y(j);
        if (x > left && x < right && y > 0.25 && y < 0.55) inside += h[static_cast<std::size_t>(j * 40 + i)];
      }
    }
    CHECK(inside == 0.0);
    CHECK(std::fabs(report.ledger.error()) <= 1e-12);  // as without objects
    CHECK(report.objects.size() == (speed > 0.0 ? 1 : 0));
  }
}

TEST_CASE("Whatever an object does, the sand stays") {
  for (const Coupling coupling : {Coupling::displace, Coupling::drag}) {
    for (const double speed : {0.1, 20.0}) {
      Scene scene = bed(20, 0.05, 0.2);
      KinematicObject object;
      object.name = "object";
      object.shape = BoxShape{{0.3, 0.2, 0.3}, {}};
      object.position = {0.1, 0.5, 0.2};
      object.motion = ConstantMotion{{speed, 0.3 * speed, -0.1 * speed}, {5.0, 3.0, 8.0}};
      object.coupling = coupling;
      KinematicObject huge = object;
      huge.name = "huge";
      huge.shape = SphereShape{5.0, {}};
      huge.position = {0.5, 0.5, 5.1};
      huge.motion = ConstantMotion{{0.0, 0.0, -0.2}, {}};
      scene.objects = {object, huge};
      scene.time.end = 0.4, scene.time.frame_interval = 0.1;
      scene.numerics.precision = Precision::float64;
      MemorySink sink;
      const RunReport report = run(scene, {}, sink);
      CHECK(report.status == "done");
      CHECK(std::fabs(report.ledger.error()) <= 1e-12);  // as without objects
    }
  }
}

}  // namespace
}  // namespace sandsim::test
