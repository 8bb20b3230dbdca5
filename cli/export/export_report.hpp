// What an export has written, in words and as JSON.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/export/export_plan.hpp"

namespace sandsim::cli {

struct MeshCounts {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t contour_edges = 0;
};
struct SandVolumes {
  double mesh = 0.0;  // [m^3] between the mesh and the ground
  double sand = 0.0;  // [m^3] of all sand of the frame
  /// Cells whose surface is not bed + depth: sand lies on an object there, and the gap below it counts in `mesh`.
  std::size_t cells_on_objects = 0;
};
struct LevelSetCounts {
  std::array<int, 3> points{0, 0, 0};
  std::array<double, 3> origin{0.0, 0.0, 0.0};  // [m]
  std::size_t inside = 0;                       // samples
};
struct ParticleCounts {
  std::size_t written = 0;
  std::size_t hidden = 0;
};

struct RasterCounts {
  std::size_t columns = 0, rows = 0;
  std::size_t without_value = 0;         // NODATA
  double smallest = 0.0, largest = 0.0;  // of the others
};

/// One file. What does not apply is absent.
struct ExportedFile {
  ExportTarget target;
  std::optional<double> time;  // [s] of the frame
  std::optional<MeshCounts> mesh;
  std::optional<SandVolumes> volumes;
  std::optional<LevelSetCounts> level_set;
  std::optional<ParticleCounts> particles;
  std::optional<RasterCounts> raster;
  double bytes = 0.0;
  double read_seconds = 0.0;   // from the series
  double build_seconds = 0.0;  // mesh or level set in memory
  double write_seconds = 0.0;  // into the form of the file, and to the disk
};

/// A few lines on one file; one line, where it is one of many.
std::string describe(const ExportPlan& plan, const ExportedFile& file);

std::string export_json(const ExportPlan& plan, const SeriesFrames& series, const std::vector<ExportedFile>& files);

}  // namespace sandsim::cli
