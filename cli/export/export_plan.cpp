#include "cli/export/export_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cli/option_value.hpp"
#include "io/scene/problems.hpp"
#include "solver/errors.hpp"
#include "solver/particles.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

struct SubjectKind {
  Subject what;
  const char* name;
  std::vector<std::string> formats;  // the first is the default
};

const std::array<SubjectKind, 5>& kinds() {
  static const std::array<SubjectKind, 5> all{{{Subject::surface, "surface", {"ply", "obj", "vtp", "vtk"}},
                                               {Subject::terrain, "terrain", {"ply", "obj", "vtp", "vtk"}},
                                               {Subject::particles, "particles", {"ply", "vtp"}},
                                               {Subject::level_set, "level-set", {"h5", "npy"}},
                                               {Subject::rasters, "rasters", {"tif", "asc"}}}};
  return all;
}

[[noreturn]] void fail(const std::string& message) {
  throw Error(ExitCode::usage, message);
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "ply" of "sand.PLY"; empty if there is none.
std::string extension_of(const fs::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
  return text.empty() ? text : text.substr(1);
}

void require_options(const ExportArguments& arguments, Subject what) {
  const bool clips = what == Subject::surface || what == Subject::level_set;
  const auto refuse = [&](bool given, bool fits, const char* option, const char* reason) {
    if (given && !fits) fail(fmt::format("{} does not go with --what {}: {}", option, arguments.what, reason));
  };
  refuse(arguments.iso.has_value(), clips, "--iso", "it clips the sand of a surface or level-set");
  refuse(arguments.closed, what == Subject::surface, "--closed", "it is for surfaces; a level-set is closed anyway");
  refuse(arguments.cell.has_value(), what == Subject::level_set, "--cell", "it is the spacing of a level-set");
  refuse(arguments.band.has_value(), what == Subject::level_set, "--band", "it is that of a level-set");
  refuse(!arguments.fields.empty(), what == Subject::rasters, "--field", "it chooses among rasters");
  const bool chooses_frame = arguments.frame || arguments.time || arguments.all;
  refuse(chooses_frame, what != Subject::terrain,
         arguments.frame  ? "--frame"
         : arguments.time ? "--time"
                          : "--all",
         "the bed is the same in all frames");
}

std::string format_of(const ExportArguments& arguments, const SubjectKind& kind) {
  const std::string extension = extension_of(arguments.output);
  const bool names_format = contains(all_formats(), extension);
  if (arguments.all && names_format) {
    fail(fmt::format("-o {}: with --all it names the folder for the files; their format goes to --format",
                     arguments.output));
  }
  if (arguments.format && names_format && extension != *arguments.format) {
    fail(fmt::format("-o {} with --format {}: leave one of them out", arguments.output, *arguments.format));
  }
  const std::string format = arguments.format ? *arguments.format : names_format ? extension : kind.formats.front();
  if (!contains(kind.formats, format)) {
    fail(fmt::format("format {} does not go with --what {}; that has {}", format, kind.name,
                     alternatives(kind.formats)));
  }
  if (!arguments.all && !names_format && !extension.empty()) {
    fail(fmt::format("-o {}: no format is called '{}'; {} has {}", arguments.output, extension, kind.name,
                     alternatives(kind.formats)));
  }
  return format;
}

std::size_t frame_at(const std::string& text, const std::vector<double>& times) {
  const double time = quantity_option("--time", text, Dimension::time, 0.0);
  if (time < times.front() || time > times.back()) {
    fail(fmt::format("--time {}: the frames go from {:.6g} s to {:.6g} s", text, times.front(), times.back()));
  }
  const auto nearest = std::min_element(times.begin(), times.end(),
                                        [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  return static_cast<std::size_t>(nearest - times.begin());
}

std::vector<std::size_t> frames_of(const ExportArguments& arguments, const std::vector<double>& times) {
  const auto count = static_cast<long long>(times.size());
  if (arguments.time) return {frame_at(*arguments.time, times)};
  if (arguments.all) {
    std::vector<std::size_t> frames(times.size());
    for (std::size_t k = 0; k < frames.size(); ++k) frames[k] = k;
    return frames;
  }
  const long long frame = arguments.frame.value_or(-1);
  if (frame < -count || frame >= count) {
    fail(fmt::format("--frame {}: there {}, or from the end -1 to -{}", frame,
                     count == 1 ? "is one frame, 0" : fmt::format("are frames 0 to {}", count - 1), count));
  }
  return {static_cast<std::size_t>(frame < 0 ? frame + count : frame)};
}

/// A single file: the one that is named, in the folder that is named, or in that of the result.
fs::path single_file(const ExportArguments& arguments, const ExportPlan& plan, const fs::path& folder) {
  const std::string name = plan.what_name + '.' + plan.format;
  if (arguments.output.empty()) return folder / name;
  fs::path file = arguments.output;
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return file / name;
  if (file.extension().empty()) file += '.' + plan.format;
  return file;
}

std::string numbered_name(const std::string& stem, const std::string& format, std::size_t frame) {
  return fmt::format("{}_{:04}.{}", stem, frame, format);
}

void require_data(const ExportPlan& plan, const SeriesFrames& series) {
  const auto require = [&](const char* name, const std::string& remedy) {
    if (series.has(name)) return;
    throw InputError(fmt::format("{}: it holds no {}; {}", series.path().string(), name, remedy));
  };
  if (plan.what == Subject::rasters) return;  // there are just those that the series has
  if (plan.what == Subject::particles) {
    require("particle_position", "run the scene with 'particles: {spacing: 0.5 cells}'");
    return;
  }
  require("bed", "run the scene with 'output: {frames: true}'");
  if (plan.what != Subject::terrain) require("depth", "run the scene with 'output: {fields: [depth]}'");
}

/// The maps and fields that become rasters: those that --field names, else all.
std::vector<ExportTarget> chosen_rasters(const ExportArguments& arguments, const SeriesFrames& series) {
  std::vector<ExportTarget> all;
  for (const std::string& name : series.maps()) all.push_back({0, {}, name, true});
  for (const std::string& name : series.fields()) all.push_back({0, {}, name, false});
  std::vector<std::string> names;
  for (const ExportTarget& one : all) names.push_back(one.field);
  if (all.empty()) {
    throw InputError(
        fmt::format("{}: it holds no maps and no fields; run the scene with 'output: {{maxima: true}}', or "
                    "with frames",
                    series.path().string()));
  }
  if (arguments.fields.empty()) return all;
  std::vector<ExportTarget> chosen;
  for (const std::string& name : arguments.fields) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) fail(fmt::format("--field {}: the series holds {}", name, listed(names)));
    chosen.push_back(all[static_cast<std::size_t>(found - names.begin())]);
  }
  return chosen;
}

/// A file a map, and one a field and frame, in a folder; or the only one by its own name.
void plan_rasters(const ExportArguments& arguments, const SeriesFrames& series, const std::vector<std::size_t>& frames,
                  ExportPlan& plan) {
  const std::vector<ExportTarget> rasters = chosen_rasters(arguments, series);
  const bool names_file = extension_of(arguments.output) == plan.format;
  if (names_file && rasters.size() > 1) {
    fail(fmt::format(
        "-o {}: these are {} rasters, and -o names the folder for them. Choose one by --field, or leave out "
        "the extension",
        arguments.output, rasters.size()));
  }
  const fs::path folder =
      arguments.output.empty() ? series.path().parent_path() / plan.what_name : fs::path(arguments.output);
  for (ExportTarget target : rasters) {
    plan.stems.push_back(target.field);
    const bool numbered = arguments.all && !target.is_map;
    for (const std::size_t frame : target.is_map ? std::vector<std::size_t>{0} : frames) {
      target.frame = frame;
      target.file = names_file ? fs::path(arguments.output)
                    : numbered ? folder / numbered_name(target.field, plan.format, frame)
                               : folder / (target.field + '.' + plan.format);
      plan.targets.push_back(target);
    }
  }
}

}  // namespace

std::vector<std::string> subject_names() {
  std::vector<std::string> names;
  for (const SubjectKind& kind : kinds()) names.push_back(kind.name);
  return names;
}

std::vector<std::string> all_formats() {
  std::vector<std::string> formats;
  for (const SubjectKind& kind : kinds()) {
    for (const std::string& format : kind.formats) {
      if (!contains(formats, format)) formats.push_back(format);
    }
  }
  return formats;
}

ExportPlan plan_export(const ExportArguments& arguments, const SeriesFrames& series) {
  const SubjectKind& kind =
      *std::find_if(kinds().begin(), kinds().end(), [&](const auto& one) { return arguments.what == one.name; });
  require_options(arguments, kind.what);
  ExportPlan plan;
  plan.what = kind.what;
  plan.what_name = kind.name;
  plan.format = format_of(arguments, kind);
  const double cell = series.grid().spacing;
  const auto length = [cell](const char* option, const std::optional<std::string>& text, double otherwise) {
    return text ? positive_option(option, *text, Dimension::length, cell) : otherwise;
  };
  plan.contour = length("--iso", arguments.iso, thinnest_shown * cell);
  plan.spacing = length("--cell", arguments.cell, 0.5 * cell);
  plan.band = length("--band", arguments.band, 4.0 * plan.spacing);
  plan.closed = arguments.closed;
  plan.stored_elevation = plan.what == Subject::surface && !plan.closed && series.has("surface");
  require_data(plan, series);
  const std::vector<std::size_t> frames = frames_of(arguments, series.times());
  if (plan.what == Subject::rasters) {
    plan_rasters(arguments, series, frames, plan);
    return plan;
  }
  plan.stems = {plan.what_name};
  const fs::path folder = series.path().parent_path();
  if (!arguments.all) {
    plan.targets = {{frames.front(), single_file(arguments, plan, folder)}};
    return plan;
  }
  const fs::path all_files = arguments.output.empty() ? folder / plan.what_name : fs::path(arguments.output);
  for (const std::size_t frame : frames)
    plan.targets.push_back({frame, all_files / numbered_name(plan.what_name, plan.format, frame)});
  return plan;
}

namespace {

/// Whether an export of all frames has written a file of that name.
bool is_numbered(const std::string& name, const std::string& stem, const std::string& format) {
  const std::string start = stem + '_', end = '.' + format;
  return name.starts_with(start) && name.ends_with(end) && name.size() > start.size() + end.size() &&
         name.find_first_not_of("0123456789", start.size()) == name.size() - end.size();
}

void clear_folder(const ExportPlan& plan, const fs::path& folder, bool overwrite) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const auto belongs = [&](const std::string& stem) { return is_numbered(name, stem, plan.format); };
    if (std::none_of(plan.stems.begin(), plan.stems.end(), belongs)) continue;
    if (!overwrite) {
      throw OutputError(
          fmt::format("{}: holds the files of an earlier export. Replace them with --overwrite, or name "
                      "another folder with -o?",
                      folder.string()));
    }
    fs::remove(entry.path());
  }
}

}  // namespace

void prepare_targets(const ExportPlan& plan, bool overwrite) {
  const fs::path folder = plan.targets.front().file.parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("{}: could not be created ({})", folder.string(), error.message()));
  if (plan.targets.size() > 1) clear_folder(plan, folder, overwrite);
  for (const ExportTarget& target : plan.targets) {
    if (overwrite || !fs::exists(target.file, error)) continue;
    throw OutputError(
        fmt::format("{}: is there. Replace it with --overwrite, or name another with -o?", target.file.string()));
  }
}

}  // namespace sandsim::cli
