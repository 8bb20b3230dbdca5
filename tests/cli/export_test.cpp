// sandsim export, called in-process on results of small runs.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

#include "io/mesh/read_mesh.hpp"
#include "io/mesh/read_sdf.hpp"
#include "solver/objects/mesh.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;
using Catch::Matchers::WithinRel;
namespace fs = std::filesystem;

namespace {

/// A column on 24 x 24 cells of 1 cm, three frames: 0, 20 and 40 ms.
std::string column(const std::string& output = "{fields: [depth]}") {
  return R"(title: Small column
grid: {cells: [24, 24], spacing: 1 cm}
sand:
  friction_angle: 30 deg
  hbar: {policy: full}
  initial: {type: column, center: [12 cm, 12 cm], radius: 6 cm, depth: 8 cm}
time: {end: 40 ms, frame_interval: 20 ms}
output: )" +
         output + '\n';
}

/// A folder with the result of a run.
struct Result {
  explicit Result(const std::string& scene = column()) {
    write_text(folder / "scene.yaml", scene);
    REQUIRE(call({"run", (folder / "scene.yaml").string(), "-o", path.string(), "-q"}).code == 0);
  }

  Outcome exported(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"export", path.string()});
    return call(more);
  }
  std::string to(const std::string& name) const { return (folder / name).string(); }

  TemporaryDirectory folder;
  fs::path path = folder / "results";
};

/// The number of the first member of that name in a JSON document.
double number_of(const std::string& json, const std::string& name) {
  const std::size_t place = json.find('"' + name + "\": ");
  REQUIRE(place != std::string::npos);
  return std::strtod(json.c_str() + place + name.size() + 4, nullptr);
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// x, y, z and id of all particles of a point cloud.
std::vector<std::array<double, 4>> points_of(const fs::path& file) {
  const std::string bytes = read_text(file), end = "end_header\n";
  const std::size_t data = bytes.find(end) + end.size();
  std::vector<std::array<double, 4>> points((bytes.size() - data) / sizeof(std::array<double, 4>));
  std::memcpy(points.data(), bytes.data() + data, points.size() * sizeof points[0]);
  return points;
}

}  // namespace

TEST_CASE("export writes the sand of the last frame beside the result") {
  const Result result;
  const Outcome outcome = result.exported();
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.starts_with((result.path / "surface.ply").string() + ": surface of frame 2 at 0.04 s\n"));
  const objects::TriangleMesh mesh = read_mesh(result.path / "surface.ply");
  CHECK(mesh.triangles.size() > 100);
  CHECK_FALSE(objects::repair(mesh).defects.is_closed());
}

TEST_CASE("the numbers of an export are those of its file") {
  const Result result;
  const Outcome outcome = result.exported({"--closed", "--json", "-o", result.to("sand.obj")});
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.starts_with("{"));
  CHECK(contains(outcome.out, "\"format\": \"obj\""));
  CHECK(contains(outcome.out, "\"elevation\": \"bed + depth\""));
  const objects::TriangleMesh mesh = read_mesh(result.to("sand.obj"));
  CHECK(objects::repair(mesh).defects.is_closed());
  CHECK(number_of(outcome.out, "triangles") == static_cast<double>(mesh.triangles.size()));
  CHECK(number_of(outcome.out, "vertices") == static_cast<double>(mesh.vertices.size()));
  CHECK(number_of(outcome.out, "bytes") == static_cast<double>(fs::file_size(result.to("sand.obj"))));
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
  }
  // Sums in another order.
  CHECK_THAT(number_of(outcome.out, "volume_mesh"), WithinRel(volume, 1e-12));
  // On so coarse a grid 1 % lies outside of the contour.
  CHECK_THAT(volume, WithinRel(number_of(outcome.out, "volume_sand"), 0.01));
}

TEST_CASE("a smaller iso leaves less sand out") {
  const Result result;
  const auto left_out = [&](const std::string& iso) {
    const std::string json = result.exported({"--iso", iso, "--json", "--overwrite"}).out;
    return 1.0 - number_of(json, "volume_mesh") / number_of(json, "volume_sand");
  };
  CHECK(left_out("1 mm") == left_out("0.1 cells"));
  CHECK(std::abs(left_out("0.01 cells")) < std::abs(left_out("0.1 cells")));
  CHECK(left_out("2 cm") > 0.1);
}

TEST_CASE("frames are chosen by number and by time") {
  const Result result;
  const auto frame = [&](const std::vector<std::string>& choice) {
    std::vector<std::string> args{"--json", "--overwrite"};
    args.insert(args.end(), choice.begin(), choice.end());
    return number_of(result.exported(args).out, "frame");
  };
  CHECK(frame({}) == 2);
  CHECK(frame({"--frame", "0"}) == 0);
  CHECK(frame({"--frame", "-3"}) == 0);
  CHECK(frame({"--time", "0 s"}) == 0);
  CHECK(frame({"--time", "22 ms"}) == 1);
}

TEST_CASE("all frames go to numbered files of which none stays from an earlier export") {
  const Result result;
  REQUIRE(result.exported({"--all", "--format", "vtp"}).code == 0);
  const fs::path folder = result.path / "surface";
  CHECK(files_in(folder) == 3);
  CHECK(fs::exists(folder / "surface_0002.vtp"));
  write_text(folder / "surface_0007.vtp", "from a longer run");
  write_text(folder / "notes.txt", "mine");
  const Outcome refused = result.exported({"--all", "--format", "vtp"});
  CHECK(refused.code == 6);
  CHECK(contains(refused.err, "--overwrite"));
  REQUIRE(result.exported({"--all", "--format", "vtp", "--overwrite", "-q"}).out.empty());
  CHECK_FALSE(fs::exists(folder / "surface_0007.vtp"));
  CHECK(read_text(folder / "notes.txt") == "mine");
  CHECK(files_in(folder) == 4);
}

TEST_CASE("a file that is there is kept unless it may be overwritten") {
  const Result result;
  write_text(result.to("mine.ply"), "mine");
  const Outcome refused = result.exported({"-o", result.to("mine.ply")});
  CHECK(refused.code == 6);
  CHECK(contains(refused.err, result.to("mine.ply") + ": is there"));
  CHECK(read_text(result.to("mine.ply")) == "mine");
  CHECK(result.exported({"-o", result.to("mine.ply"), "--overwrite"}).code == 0);
  CHECK(read_text(result.to("mine.ply")).starts_with("ply\n"));
}

TEST_CASE("the name of the output tells the format and an existing folder takes the file") {
  const Result result;
  CHECK(result.exported({"-o", result.to("deep/down/sand.vtk")}).code == 0);
  CHECK(read_text(result.to("deep/down/sand.vtk")).starts_with("# vtk DataFile"));
  CHECK(result.exported({"-o", result.to("deep")}).code == 0);
  CHECK(fs::exists(result.to("deep/surface.ply")));
  CHECK(result.exported({"-o", result.to("plain")}).code == 0);
  CHECK(fs::exists(result.to("plain.ply")));
}

TEST_CASE("the terrain is a mesh of all cells to the sides") {
  const Result result;
  const Outcome outcome = result.exported({"--what", "terrain", "--json"});
  REQUIRE(outcome.code == 0);
  CHECK_FALSE(contains(outcome.out, "\"time\""));
  const objects::TriangleMesh mesh = read_mesh(result.path / "terrain.ply");
  CHECK(mesh.triangles.size() == 2 * 25 * 25);
  // 24 cells of 1 cm, to rounding.
  CHECK_THAT(objects::bounds(mesh).high.x, WithinRel(0.24, 1e-14));
}

TEST_CASE("a scene of one row becomes a band") {
  const Result result(small_scene());
  REQUIRE(result.exported().code == 0);
  const objects::Bounds box = objects::bounds(read_mesh(result.path / "surface.ply"));
  CHECK(box.low.y == 0.0);
  CHECK_THAT(box.high.y, WithinRel(0.01, 1e-14));
}

TEST_CASE("a level set is an object that another scene reads") {
  const Result result;
  const Outcome h5 = result.exported({"--what", "level-set", "-o", result.to("sand.h5")});
  INFO(h5.err);
  REQUIRE(h5.code == 0);
  CHECK(contains(h5.out, "shape: {type: sdf, file: sand.h5}"));
  const Outcome npy = result.exported({"--what", "level-set", "-o", result.to("sand.npy")});
  const std::size_t shape = npy.out.find("shape: {");
  REQUIRE(shape != std::string::npos);
  const std::string in_scene = npy.out.substr(shape, npy.out.find('\n', shape) - shape);
  for (const std::string& text : {std::string("shape: {type: sdf, file: sand.h5}"), in_scene}) {
    write_text(result.to("other.yaml"), column() + "objects:\n  - name: cast\n    " + text +
                                            "\n    position: [0 m, 0 m, 20 cm]\n    coupling: drag\n");
    const Outcome checked = call({"check", result.to("other.yaml")});
    INFO(text << '\n' << checked.err);
    CHECK(checked.code == 0);
  }
  const objects::DistanceGrid grid = read_sdf(result.to("sand.h5"));
  CHECK(grid.spacing == 0.005);
  const auto [least, most] = std::minmax_element(grid.values.begin(), grid.values.end());
  // Four spacings, cut off.
  CHECK(*most == 0.02F);
  CHECK(*least < -0.005F);
}

TEST_CASE("only visible particles are written") {
  CHECK(contains(Result().exported({"--what", "particles"}).err,
                 "holds no particle_position; run the scene with 'particles: {spacing"));
  const Result result(column() + "particles: {spacing: 1 cells}\n");
  const Outcome all = result.exported({"--what", "particles", "--all", "--json"});
  INFO(all.err);
  REQUIRE(all.code == 0);
  const double written = number_of(all.out, "particles");
  // One a cell; those outside of the column, which covers 113 cells, are hidden.
  CHECK(written + number_of(all.out, "particles_hidden") == 24 * 24);
  CHECK(written > 80);
  CHECK(written < 150);
  const std::string ply = read_text(result.path / "particles/particles_0000.ply");
  CHECK(contains(ply, "element vertex " + std::to_string(static_cast<int>(written)) + "\n"));
  const Outcome last = result.exported({"--what", "particles", "--format", "vtp", "--json"});
  CHECK(number_of(last.out, "particles") > written);  // the sand has spread
}

TEST_CASE("particles and surface in UTM coordinates are those near the origin, shifted") {
  const auto exported = [](const std::string& origin, const std::string& from, const std::string& to) {
    return Result(R"(grid: {cells: [24, 12], spacing: 1 cm, origin: )" + origin + R"(}
sand: {friction_angle: 30 deg, initial: {type: box, from: )" +
                  from + ", to: " + to + R"(, depth: 8 cm}}
time: {end: 40 ms, frame_interval: 20 ms}
output: {fields: [depth]}
particles: {spacing: 1 cells}
)");
  };
  const Result near = exported("[0 m, 0 m]", "[6 cm, 0 cm]", "[12 cm, 12 cm]");
  const Result far = exported("[4567000 m, 5234000 m]", "[4567000.06 m, 5234000 m]", "[4567000.12 m, 5234000.12 m]");
  for (const char* frame : {"0", "-1"}) {
    for (const Result* result : {&near, &far}) {
      REQUIRE(result->exported({"--what", "particles", "--frame", frame, "--overwrite"}).code == 0);
      REQUIRE(result->exported({"--frame", frame, "--overwrite"}).code == 0);
    }
    const auto a = points_of(near.path / "particles.ply"), b = points_of(far.path / "particles.ply");
    REQUIRE(a.size() == b.size());
    REQUIRE(a.size() > 60);
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      REQUIRE(a[k][3] == b[k][3]);
      largest = std::max({largest, std::fabs(b[k][0] - 4567000.0 - a[k][0]), std::fabs(b[k][1] - 5234000.0 - a[k][1]),
                          std::fabs(b[k][2] - a[k][2])});
    }
    CHECK(largest < 1e-6 * 0.01);  // of a cell; doubles are 1e-9 m apart at these coordinates
    if (std::string(frame) == "0") {
      std::set<std::pair<double, double>> cells;
      for (const auto& point : b) {
        cells.insert({std::floor((point[0] - 4567000.0) / 0.01), std::floor((point[1] - 5234000.0) / 0.01)});
      }
      CHECK(cells.size() == 6 * 12);  // one in each of the cells with sand
    }
    // No particle lies outside of the mesh.
    const objects::TriangleMesh mesh = read_mesh(far.path / "surface.ply");
    const auto [west, east] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                  [](const auto& p, const auto& q) { return p.x < q.x; });
    for (const auto& point : b) {
      REQUIRE((point[0] >= west->x - 0.005 && point[0] <= east->x + 0.005));  // which ends at centres of cells
    }
  }
}

TEST_CASE("without sand above the contour the mesh is empty and that is said") {
  const Result result;
  const Outcome outcome = result.exported({"--iso", "1 m", "--closed"});
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "no sand is deeper than 1 m in frame 2: the file holds none"));
  CHECK(contains(read_text(result.path / "surface.ply"), "element vertex 0\n"));
}

TEST_CASE("the series has its own say on the height of the surface") {
  const Result result(column("{fields: [depth, surface]}"));
  CHECK(contains(result.exported({"--json"}).out, "\"elevation\": \"surface\""));
  CHECK(contains(result.exported({"--json", "--closed", "--overwrite"}).out, "\"elevation\": \"bed + depth\""));
}

TEST_CASE("sand that lies on an object is drawn there and told apart in the volume") {
  // A plate lies half in the sand, 3 cm above the ground, and sand is poured on it.
  const Result result(R"(title: Poured on a plate
grid: {cells: [16, 16], spacing: 1 cm}
sand:
  friction_angle: 30 deg
  hbar: {policy: full}
  initial: {type: layer, depth: 4 cm}
  sources: [{center: [8 cm, 8 cm], radius: 2 cm, rate: 500 cm^3/s, end: 1 s}]
objects:
  - name: plate
    shape: {type: box, size: [6 cm, 6 cm, 2 cm]}
    position: [8 cm, 8 cm, 4 cm]
    coupling: displace
time: {end: 40 ms, frame_interval: 20 ms}
output: {fields: [depth, surface]}
)");
  const Outcome first = result.exported();
  INFO(first.out << first.err);
  CHECK(contains(first.out, "the gaps under sand on an object, in "));
  const std::string closed = result.exported({"--closed", "--json", "--overwrite"}).out;
  CHECK(number_of(closed, "cells_on_objects") == 0);
}

TEST_CASE("a result without depth says what the run needs") {
  const Result result(column("{fields: [velocity]}"));
  const Outcome outcome = result.exported();
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "it holds no depth; run the scene with 'output: {fields: [depth]}'"));
  CHECK(result.exported({"--what", "terrain"}).code == 0);
  CHECK(call({"export", result.to("nothing")}).code == 3);
}

TEST_CASE("options of an export that do not go together are usage errors") {
  const Result result;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--what", "sand"}, "'sand' is none of surface, terrain, particles, level-set"},
      {{"--format", "stl"}, "'stl' is none of ply, obj, vtp, vtk, h5, npy"},
      {{"--format", "npy"}, "format npy does not go with --what surface; that has ply, obj, vtp or vtk"},
      {{"-o", "sand.stl"}, "no format is called 'stl'"},
      {{"-o", "sand.h5"}, "format h5 does not go with --what surface"},
      {{"-o", "sand.obj", "--format", "ply"}, "leave one of them out"},
      {{"-o", "sand.ply", "--all"}, "names the folder"},
      {{"--frame", "3"}, "--frame 3: there are frames 0 to 2, or from the end -1 to -3"},
      {{"--frame", "-4"}, "--frame -4"},
      {{"--time", "1 s"}, "--time 1 s: the frames go from 0 s to 0.04 s"},
      {{"--time", "1"}, "--time 1: "},
      {{"--frame", "1", "--all"}, "--all"},
      {{"--iso", "0 m"}, "--iso 0 m: not above 0"},
      {{"--iso", "0.1"}, "--iso 0.1: "},
      {{"--what", "terrain", "--iso", "1 mm"}, "--iso does not go with --what terrain"},
      {{"--what", "terrain", "--frame", "1"}, "--frame does not go with --what terrain"},
      {{"--what", "level-set", "--closed"}, "--closed does not go with --what level-set"},
      {{"--cell", "1 mm"}, "--cell does not go with --what surface"},
      {{"--what", "level-set", "--cell", "1 um"}, "--cell"},
      {{"--what", "level-set", "--cell", "0.0001 cells"}, "would do"},
  };
  for (const auto& [args, expected] : cases) {
    const Outcome outcome = result.exported(args);
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, expected));
  }
  CHECK(files_in(result.path) == 5);  // those of the run
}

TEST_CASE("an output that cannot be written is an output error") {
  const Result result;
  CHECK(result.exported({"-o", "/proc/no/such/place.ply"}).code == 6);
}
