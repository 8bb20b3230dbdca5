#include <fmt/format.h>

#include "cli/stress/case_raster.hpp"
#include "cli/stress/matrix.hpp"

namespace sandsim::cli {

namespace {

/// Sand pours onto a dry grid for half of the run.
StressCase pour(const std::string& name, const std::string& meaning, const char* cells, const std::string& source,
                double end) {
  StressCase made{name, meaning, {}};
  made.scene.grid = fmt::format("{{cells: {}, spacing: 1 cm}}", cells);
  made.scene.initial = "";
  made.scene.end = end;
  made.scene.sources = fmt::format("[{{{}, end: {} s}}]", source, 0.5 * end);
  // Sand is brought in a little at a time: each step rounds the depths of the source's cells by half a unit in the last
  // place, always the same way while they stay in one binade. 1e-5 are some hundred such steps in float32.
  made.criteria.volume_float32 = 1e-5;
  made.criteria.volume_float64 = 1e-13;
  made.criteria.step = 0.0;  // bounded by the source: it may fill a tenth of a spacing a step
  return made;
}

/// The poured sand's height in a heap that has not run off: the volume over the disc. [m]
double poured_depth(double rate, double seconds, double area) {
  return rate * seconds / area;
}

}  // namespace

std::vector<StressCase> source_cases() {
  std::vector<StressCase> cases;
  const double end = 0.5, half = 0.5 * end, one_cell = 1e-4;
  cases.push_back(pour("source_corner", "10 l/s into the corner of a grid", "[32, 32]",
                       "center: [0 m, 0 m], radius: 3 cells, rate: 10 l/s", end));
  cases.back().criteria.rise = poured_depth(0.01, half, 7.0 * one_cell);  // a quarter of the disc
  cases.push_back(pour("source_one_cell", "1 l/s into one cell in the corner", "[16, 16]",
                       "center: [0 m, 0 m], radius: 1 mm, rate: 1 l/s", end));
  cases.back().criteria.rise = poured_depth(1e-3, half, one_cell);
  cases.push_back(pour("source_row", "1 l/s into the end of a single row", "[64, 1]",
                       "center: [0 m, 0 m], radius: 1 mm, rate: 1 l/s", end));
  cases.back().criteria.rise = poured_depth(1e-3, half, one_cell);
  cases.push_back(pour("source_violent", "1 m^3/s into one cell of 1 cm for 1 ms", "[16, 16]",
                       "center: [8 cells, 8 cells], radius: 1 mm, rate: 1 m^3/s", 2e-3));
  cases.back().criteria.rise = poured_depth(1.0, 1e-3, one_cell);
  cases.push_back(pour("source_minute", "1e-9 m^3/s onto a disc", "[16, 16]",
                       "center: [8 cells, 8 cells], radius: 3 cells, rate: 0.001 cm^3/s", end));
  cases.back().criteria.rise = 0.01;  // any sand stands on less than a cell
  cases.push_back(pour("source_weightless", "1 l/s without gravity", "[16, 16]",
                       "center: [8 cells, 8 cells], radius: 3 cells, rate: 1 l/s", end));
  cases.back().scene.gravity = "0 m/s^2";
  cases.push_back(pour("source_frictionless", "1 l/s without friction", "[16, 16]",
                       "center: [8 cells, 8 cells], radius: 3 cells, rate: 1 l/s", end));
  cases.back().scene.friction = "friction_angle: 0 deg";
  cases.back().criteria.rise = poured_depth(1e-3, half, 29.0 * one_cell);
  cases.push_back(pour("source_single_cell_grid", "1 l/s into a grid of one cell", "[1, 1]",
                       "center: [0 m, 0 m], radius: 1 mm, rate: 1 l/s", end));
  cases.back().criteria.rise = poured_depth(1e-3, half, one_cell);
  cases.push_back(pour("source_cliff", "1 l/s onto the edge of a cliff of 100 cells", "[32, 32]",
                       "center: [16 cells, 16 cells], radius: 2 cells, rate: 1 l/s", end));
  cases.back().scene.terrain = "{type: raster, file: source_cliff.npy}";
  cases.back().rasters = {make_raster("source_cliff.npy", 32, 32, [](int i, int) { return i < 16 ? 1.0 : 0.0; })};
  cases.back().criteria.rise = 1.0 + poured_depth(1e-3, half, 12.0 * one_cell);
  cases.push_back(pour("source_hbar", "1 l/s with hbar of 1e-6 m", "[16, 16]",
                       "center: [8 cells, 8 cells], radius: 3 cells, rate: 1 l/s", end));
  cases.back().scene.hbar = "{policy: constant, depth: 1e-6 m}";
  cases.back().criteria.rise = poured_depth(1e-3, half, 29.0 * one_cell);
  return cases;
}

}  // namespace sandsim::cli
