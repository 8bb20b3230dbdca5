// What check and run say of the sand that a scene starts with, and of terrain without data.
#include <string>

#include "tests/cli/support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim::test;

namespace {

/// Half of the box lies outside the grid.
std::string half_outside() {
  return "grid: {cells: [50, 50], spacing: 10 m, origin: [1000 m, 2000 m]}\n"
         "terrain: {type: plane, inclination: 30 deg}\n"
         "sand:\n"
         "  friction_angle: 20 deg\n"
         "  initial: {type: box, from: [900 m, 2100 m], to: [1100 m, 2200 m], depth: 1 m}\n"
         "time: {end: 1 ms, frame_interval: 1 ms}\n";
}

/// A valley of 12 x 8 cells of 10 m whose corner is NODATA, with its raster.
std::string clipped_valley(const TemporaryDirectory& folder, const std::string& grid, const std::string& terrain) {
  std::string values;
  for (int j = 0; j < 8; ++j) {  // from the north
    for (int i = 0; i < 12; ++i) {
      values += (i + j < 3 ? "-9999" : std::to_string(500 - 4 * i + (j - 4) * (j - 4))) + (i == 11 ? "\n" : " ");
    }
  }
  write_text(folder / "dem.asc",
             "ncols 12\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n" + values);
  write_text(
      folder / "scene.yaml",
      "grid: " + grid + "\nterrain: {type: raster, file: dem.asc" + terrain +
          "}\n"
          "sand: {friction_angle: 20 deg, initial: {type: column, center: [60 m, 40 m], radius: 15 m, depth: 2 m}}\n"
          "boundaries: {x_max: open}\ntime: {end: 3 s, frame_interval: 1 s}\n");
  return (folder / "scene.yaml").string();
}

}  // namespace

TEST_CASE("check and run tell the volume on file, on the grid and outside, and warn with the line") {
  const TemporaryDirectory folder;
  write_text(folder / "scene.yaml", half_outside());
  const std::string scene = (folder / "scene.yaml").string();
  const std::string warning = "scene.yaml:5:3: sand.initial = box: 10000 m^3 of 20000 m^3 of sand lie outside the grid";

  const Outcome checked = call({"check", scene});
  CHECK(checked.code == 0);
  CHECK(contains(checked.err, warning));
  CHECK(contains(checked.out,
                 "release  20000 m^3 of sand at the start, 10000 m^3 of it on the grid, 10000 m^3 outside\n"));

  const Outcome run = call({"run", scene, "-o", (folder / "out").string()});
  CHECK(run.code == 0);
  CHECK(contains(run.err, warning));
  CHECK(contains(run.out, "20000 m^3 of sand at the start, 10000 m^3 of it on the grid"));
  CHECK(contains(read_text(folder / "out/log.txt"), warning));
  const std::string report = read_text(folder / "out/run.json");
  CHECK(contains(report, "\"file_volume\": 20000"));
  CHECK(contains(report, "\"grid_volume\": 10000"));
  CHECK(contains(report, "\"outside_volume\": 10000"));
  CHECK(contains(report, "\"blocked_volume\": 0"));

  CHECK(call({"run", scene, "-q", "-o", (folder / "quiet").string()}).err.empty());
}

TEST_CASE("a clipped terrain is refused with its line, and runs with a wall, the nearest value, or within its data") {
  const TemporaryDirectory folder;
  const std::string out = (folder / "out").string();
  const std::string grid = "{cells: [12, 8], spacing: 10 m}";
  const auto run = [&](const std::string& scene) { return call({"run", scene, "-o", out, "--overwrite"}); };

  const Outcome refused = run(clipped_valley(folder, grid, ""));
  CHECK(refused.code == 2);
  CHECK(contains(refused.err,
                 "scene.yaml:2:25: terrain.file = dem.asc: the raster has no data (outside its edges, or "
                 "NODATA) in 6 of 96 cells, the first is cell (0, 5) at x = 5 m, y = 55 m"));
  CHECK(contains(refused.err, "nodata: wall"));
  CHECK(run(clipped_valley(folder, grid, ", nodata: wall")).code == 0);
  CHECK(run(clipped_valley(folder, grid, ", nodata: nearest")).code == 0);

  // Columns 3 to 11 hold data only: also an origin 0.1 mm off, and cells of half the size.
  CHECK(run(clipped_valley(folder, "{cells: [9, 8], spacing: 10 m, origin: [30 m, 0 m]}", "")).code == 0);
  CHECK(run(clipped_valley(folder, "{cells: [9, 8], spacing: 10 m, origin: [29.9999 m, 0 m]}", "")).code == 0);
  CHECK(run(clipped_valley(folder, "{cells: [18, 16], spacing: 5 m, origin: [30 m, 0 m]}", "")).code == 0);
}
