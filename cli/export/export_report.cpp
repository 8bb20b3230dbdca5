#include "cli/export/export_report.hpp"

#include <fmt/format.h>

#include "cli/text.hpp"
#include "io/output/json.hpp"
#include "io/scene/quantity.hpp"

namespace sandsim::cli {

namespace {

std::string count(std::size_t number) {
  return format_count(static_cast<std::int64_t>(number));
}

std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<11}{}\n", name, value);
}

std::string percent(const SandVolumes& volumes) {
  return volumes.sand > 0.0 ? fmt::format("{:+.2g} %", 100.0 * (volumes.mesh / volumes.sand - 1.0)) : "no sand";
}

std::string volume_text(const SandVolumes& volumes) {
  std::string text = fmt::format("{:.6g} m^3 over the ground; all sand is {:.6g} m^3 ({})", volumes.mesh, volumes.sand,
                                 percent(volumes));
  if (volumes.cells_on_objects > 0) {
    text += fmt::format("\n{:13}the gaps under sand on an object, in {} cells, count; --closed leaves them out", "",
                        count(volumes.cells_on_objects));
  }
  return text;
}

/// What a scene says to use a level set as an object; .npy knows no place.
std::string shape_text(const ExportPlan& plan, const ExportedFile& file) {
  const std::array<double, 3>& origin = file.level_set->origin;
  const auto metres = [](double value) { return quantity_text(value, Dimension::length); };
  const std::string place = plan.format != "npy"
                                ? ""
                                : fmt::format(", spacing: {}, origin: [{}, {}, {}]", metres(plan.spacing),
                                              metres(origin[0]), metres(origin[1]), metres(origin[2]));
  return fmt::format("shape: {{type: sdf, file: {}{}}}", file.target.file.filename().string(), place);
}

std::string times_text(const ExportedFile& file) {
  const auto part = [](double seconds, const char* doing) {
    return seconds > 0.0 ? fmt::format("{} to {}, ", format_duration(seconds), doing) : std::string();
  };
  return part(file.read_seconds, "read") + part(file.build_seconds, "build") +
         fmt::format("{} to write {}", format_duration(file.write_seconds), format_bytes(file.bytes));
}

std::string raster_text(const RasterCounts& raster) {
  std::string text = fmt::format("{} x {} values", raster.columns, raster.rows);
  if (raster.smallest <= raster.largest) text += fmt::format(" from {:.6g} to {:.6g}", raster.smallest, raster.largest);
  return text + (raster.without_value > 0 ? fmt::format(", {} NODATA", count(raster.without_value)) : "");
}

std::string describe_one(const ExportPlan& plan, const ExportedFile& file) {
  const std::string frame =
      file.time ? fmt::format(" of frame {} at {:.6g} s", file.target.frame, *file.time) : std::string();
  std::string text = fmt::format("{}: {}{}{}\n", file.target.file.string(), plan.closed ? "closed " : "",
                                 file.target.field.empty() ? plan.what_name : file.target.field, frame);
  if (file.mesh) {
    const std::string contour =
        file.mesh->contour_edges > 0 ? fmt::format(", a contour of {} edges", count(file.mesh->contour_edges)) : "";
    text += line("mesh", fmt::format("{} vertices, {} triangles{}", count(file.mesh->vertices),
                                     count(file.mesh->triangles), contour));
  }
  if (file.level_set) {
    const std::array<int, 3>& points = file.level_set->points;
    text += line("samples", fmt::format("{} x {} x {} along x, y, z, every {:.6g} m; {} inside", points[0], points[1],
                                        points[2], plan.spacing, count(file.level_set->inside)));
    text += line("in a scene", shape_text(plan, file));
  }
  if (file.particles) {
    text += line("particles", fmt::format("{}; {} hidden ones left out", count(file.particles->written),
                                          count(file.particles->hidden)));
  }
  if (file.raster) text += line("raster", raster_text(*file.raster));
  if (file.volumes) text += line("volume", volume_text(*file.volumes));
  return text + line("time", times_text(file));
}

std::string describe_of_many(const ExportedFile& file) {
  std::string text = file.target.file.string();
  if (file.time) text += fmt::format("  {:.6g} s", *file.time);
  if (file.mesh) text += fmt::format("  {} triangles", count(file.mesh->triangles));
  if (file.level_set) text += fmt::format("  {} samples inside", count(file.level_set->inside));
  if (file.particles) text += fmt::format("  {} particles", count(file.particles->written));
  if (file.raster) text += "  " + raster_text(*file.raster);
  if (file.volumes) text += fmt::format("  {:.6g} m^3 ({})", file.volumes->mesh, percent(*file.volumes));
  return text + '\n';
}

void add_triple(JsonWriter& json, const char* key, const auto& values) {
  json.begin_array(key);
  for (const auto value : values) json.value(value);
  json.end_array();
}

void add_counts(JsonWriter& json, const ExportPlan& plan, const ExportedFile& file) {
  if (file.mesh) {
    json.member("vertices", file.mesh->vertices).member("triangles", file.mesh->triangles);
    json.member("contour_edges", file.mesh->contour_edges);
  }
  if (file.level_set) {
    add_triple(json, "samples", file.level_set->points);
    add_triple(json, "origin", file.level_set->origin);
    json.member("spacing", plan.spacing).member("band", plan.band).member("samples_inside", file.level_set->inside);
  }
  if (file.particles) {
    json.member("particles", file.particles->written).member("particles_hidden", file.particles->hidden);
  }
  if (file.raster) {
    json.member("field", file.target.field).member("columns", file.raster->columns).member("rows", file.raster->rows);
    json.member("without_value", file.raster->without_value);
  }
  if (file.volumes) {
    json.member("volume_mesh", file.volumes->mesh).member("volume_sand", file.volumes->sand);
    json.member("cells_on_objects", file.volumes->cells_on_objects);
  }
}

}  // namespace

std::string describe(const ExportPlan& plan, const ExportedFile& file) {
  return plan.targets.size() > 1 ? describe_of_many(file) : describe_one(plan, file);
}

std::string export_json(const ExportPlan& plan, const SeriesFrames& series, const std::vector<ExportedFile>& files) {
  JsonWriter json;
  json.begin_object().member("series", series.path().string()).member("title", series.title());
  json.member("what", plan.what_name).member("format", plan.format);
  if (plan.what == Subject::surface || plan.what == Subject::level_set) {
    json.member("iso", plan.contour).member("closed", plan.closed || plan.what == Subject::level_set);
    json.member("elevation", plan.stored_elevation ? "surface" : "bed + depth");
  }
  json.begin_array("files");
  for (const ExportedFile& file : files) {
    json.begin_object().member("file", file.target.file.string());
    if (file.time) json.member("frame", file.target.frame).member("time", *file.time);
    add_counts(json, plan, file);
    json.member("bytes", file.bytes).member("read_seconds", file.read_seconds);
    json.member("build_seconds", file.build_seconds).member("write_seconds", file.write_seconds).end_object();
  }
  return json.end_array().end_object().text();
}

}  // namespace sandsim::cli
