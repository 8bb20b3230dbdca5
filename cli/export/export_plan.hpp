// What an export writes where, worked out before anything is written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "io/output/series_frames.hpp"

namespace sandsim::cli {

enum class Subject { surface, terrain, particles, level_set, rasters };

/// The words of --what and of --format.
std::vector<std::string> subject_names();
std::vector<std::string> all_formats();

/// One file of an export.
struct ExportTarget {
  std::size_t frame = 0;  // unused for the terrain and maps
  std::filesystem::path file;
  std::string field{};  // of a raster
  bool is_map = false;  // the raster is the same in all frames
};

struct ExportPlan {
  Subject what = Subject::surface;
  std::string what_name;
  std::vector<std::string> stems;  // numbered files are called STEM_0000
  std::string format;              // also the extension of the files
  std::vector<ExportTarget> targets;
  double contour = 0.0;  // [m] depth below which sand is left out
  bool closed = false;
  bool stored_elevation = false;  // the series' own `surface` is the height of the mesh, not bed + depth
  double spacing = 0.0;           // [m] of a level set
  double band = 0.0;              // [m]
};

/// Throws Error (usage) for options that do not go together or with the series, InputError if the series lacks what
/// they ask for.
ExportPlan plan_export(const ExportArguments& arguments, const SeriesFrames& series);

/// Makes the folders; refuses files that are there unless `overwrite` is set, which removes the numbered files of an
/// earlier export. Throws OutputError.
void prepare_targets(const ExportPlan& plan, bool overwrite);

}  // namespace sandsim::cli
