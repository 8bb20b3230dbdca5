#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>
#include <utility>

#include "cli/commands.hpp"
#include "cli/export/export_report.hpp"
#include "io/export/mesh_files.hpp"
#include "io/export/sdf_files.hpp"
#include "io/gis/gis.hpp"
#include "io/mesh/sdf_shape.hpp"
#include "io/output/atomic_file.hpp"
#include "io/raster/write_npy.hpp"
#include "solver/errors.hpp"
#include "solver/surface/level_set.hpp"

namespace sandsim::cli {

namespace {

using surface::SurfaceMesh;

/// Calls `work` and adds the time that it took.
template <class Work>
auto timed(double& seconds, Work work) {
  const auto begin = std::chrono::steady_clock::now();
  auto result = work();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

std::string mesh_bytes(const SurfaceMesh& mesh, const std::string& format) {
  return format == "obj"   ? obj_text(mesh)
         : format == "vtp" ? vtp_bytes(mesh)
         : format == "vtk" ? vtk_bytes(mesh)
                           : ply_bytes(mesh);
}

/// Throws Error (usage) for a level set that is too large to be read back.
void require_samples(const objects::DistanceGrid& grid) {
  const auto [nx, ny, nz] = grid.points;
  const std::string problem = shape_problem(nx, ny, nz);
  if (problem.empty()) return;
  const double excess = std::max(1.0 * nx * ny * nz / static_cast<double>(most_samples),
                                 std::pow(1.0 * std::max({nx, ny, nz}) / static_cast<double>(most_along_axis), 3.0));
  throw Error(ExitCode::usage, fmt::format("--cell: {}. A spacing of {:.2g} m or more would do", problem,
                                           1.1 * grid.spacing * std::cbrt(excess)));
}

Raster raster_on(const Grid& grid, std::vector<double> values) {
  Raster raster;
  raster.nx = static_cast<std::size_t>(grid.cells[0]), raster.ny = static_cast<std::size_t>(grid.cells[1]);
  raster.origin_x = grid.x(0), raster.origin_y = grid.y(0);
  raster.spacing_x = raster.spacing_y = grid.spacing;
  raster.has_georeference = true;
  raster.crs = grid.crs;
  raster.values = std::move(values);
  return raster;
}

RasterCounts counts_of(const Raster& raster) {
  RasterCounts counts{raster.nx, raster.ny, 0, std::numeric_limits<double>::infinity(), 0.0};
  counts.largest = -counts.smallest;
  for (const double value : raster.values) {
    if (std::isnan(value)) {
      ++counts.without_value;
    } else {
      counts.smallest = std::min(counts.smallest, value), counts.largest = std::max(counts.largest, value);
    }
  }
  return counts;
}

/// Writes the targets of a plan one by one.
class Exporter {
 public:
  Exporter(const SeriesFrames& series, const ExportPlan& plan)
      : series_(series), plan_(plan), bed_(needs_bed(plan.what) ? series.bed() : std::vector<double>{}) {}

  ExportedFile write(const ExportTarget& target) const {
    ExportedFile file;
    file.target = target;
    if (plan_.what != Subject::terrain && !target.is_map) file.time = series_.times()[target.frame];
    switch (plan_.what) {
      case Subject::surface:
        write_mesh(build_surface(file), file);
        break;
      case Subject::terrain:
        write_mesh(timed(file.build_seconds, [&] { return surface::terrain_mesh(series_.grid(), bed_); }), file);
        break;
      case Subject::particles:
        write_particles(file);
        break;
      case Subject::level_set:
        write_level_set(file);
        break;
      case Subject::rasters:
        write_raster(file);
        break;
    }
    file.bytes = static_cast<double>(std::filesystem::file_size(target.file));
    return file;
  }

 private:
  static bool needs_bed(Subject what) { return what != Subject::particles && what != Subject::rasters; }

  /// The sand's surface, not closed, and the volumes of `file`.
  SurfaceMesh open_surface(ExportedFile& file) const {
    std::vector<double> elevation;
    const std::vector<double> depth = timed(file.read_seconds, [&] {
      if (plan_.stored_elevation) elevation = series_.field("surface", file.target.frame);
      return series_.field("depth", file.target.frame);
    });
    SurfaceMesh mesh = timed(file.build_seconds, [&] {
      return surface::sand_mesh(surface::height_field(series_.grid(), bed_, depth, elevation), plan_.contour);
    });
    const double cell = series_.grid().spacing;
    file.volumes =
        SandVolumes{surface::volume_above_bed(mesh), std::accumulate(depth.begin(), depth.end(), 0.0) * cell * cell,
                    cells_on_objects(depth, elevation)};
    return mesh;
  }

  std::size_t cells_on_objects(const std::vector<double>& depth, const std::vector<double>& elevation) const {
    const double visible = 1e-3 * series_.grid().spacing;  // [m] far more than rounding, less than a mesh shows
    std::size_t cells = 0;
    for (std::size_t k = 0; k < elevation.size(); ++k) {
      cells += std::abs(elevation[k] - bed_[k] - depth[k]) > visible ? 1 : 0;
    }
    return cells;
  }

  SurfaceMesh build_surface(ExportedFile& file) const {
    SurfaceMesh mesh = open_surface(file);
    const std::size_t contour_edges = mesh.contour_edges;
    if (plan_.closed) {
      timed(file.build_seconds, [&] {
        surface::close(mesh);
        return 0;
      });
    }
    file.mesh = MeshCounts{0, 0, contour_edges};
    return mesh;
  }

  void write_mesh(const SurfaceMesh& mesh, ExportedFile& file) const {
    if (!file.mesh) file.mesh = MeshCounts{};
    file.mesh->vertices = mesh.shape.vertices.size();
    file.mesh->triangles = mesh.shape.triangles.size();
    write_bytes(file, [&] { return mesh_bytes(mesh, plan_.format); });
  }

  void write_particles(ExportedFile& file) const {
    const VisibleParticles particles = timed(file.read_seconds, [&] { return series_.particles(file.target.frame); });
    file.particles = {particles.ids.size(), particles.hidden};
    write_bytes(file, [&] { return plan_.format == "vtp" ? vtp_bytes(particles) : ply_bytes(particles); });
  }

  void write_level_set(ExportedFile& file) const {
    SurfaceMesh mesh = open_surface(file);
    const surface::LevelSetGrid sampling{plan_.spacing, plan_.band};
    require_samples(surface::level_set_grid(mesh, sampling));
    const objects::DistanceGrid grid =
        timed(file.build_seconds, [&] { return surface::level_set(std::move(mesh), sampling); });
    const auto inside = std::count_if(grid.values.begin(), grid.values.end(), [](float value) { return value < 0.0F; });
    file.level_set = {grid.points, {grid.origin.x, grid.origin.y, grid.origin.z}, static_cast<std::size_t>(inside)};
    if (plan_.format == "npy") {
      write_bytes(file, [&] { return npy_bytes(grid.values, grid.points); });
      return;
    }
    timed(file.write_seconds, [&] {
      write_hdf5_sdf(file.target.file, grid);
      return 0;
    });
  }

  void write_raster(ExportedFile& file) const {
    const ExportTarget& target = file.target;
    const Raster raster = timed(file.read_seconds, [&] {
      return raster_on(series_.grid(),
                       target.is_map ? series_.map(target.field) : series_.field(target.field, target.frame));
    });
    file.raster = counts_of(raster);
    const auto format = plan_.format == "tif" ? RasterFormat::geotiff : RasterFormat::esri_ascii;
    timed(file.write_seconds, [&] {
      const std::string name = target.file.string();
      const std::vector<EncodedFile> encoded =
          gis(name).encode_raster(target.file.stem().string(), format, raster, series_.single_precision(target.field));
      for (const EncodedFile& one : encoded) {
        write_file_atomically(target.file.parent_path() / one.name, one.bytes);
      }
      return 0;
    });
  }

  template <class Encode>
  void write_bytes(ExportedFile& file, Encode encode) const {
    timed(file.write_seconds, [&] {
      write_file_atomically(file.target.file, encode());
      return 0;
    });
  }

  const SeriesFrames& series_;
  const ExportPlan& plan_;
  std::vector<double> bed_;
};

/// Says what will surprise whoever opens the file.
std::string warning_of(const ExportPlan& plan, const ExportedFile& file) {
  const bool lacks_sand = file.volumes && file.volumes->mesh == 0.0;
  const bool lacks_particles = file.particles && file.particles->written == 0;
  if (!lacks_sand && !lacks_particles) return {};
  const std::string reason =
      lacks_sand ? fmt::format("no sand is deeper than {:g} m", plan.contour) : std::string("no particle is visible");
  return fmt::format("sandsim: warning: {}: {} in frame {}: the file holds none\n", file.target.file.string(), reason,
                     file.target.frame);
}

}  // namespace

ExitCode export_command(const ExportArguments& arguments, Console& console) {
  const SeriesFrames series(arguments.result);
  const ExportPlan plan = plan_export(arguments, series);
  const Exporter exporter(series, plan);
  prepare_targets(plan, arguments.overwrite);
  if (plan.what == Subject::rasters && !series.grid().crs.known() && !arguments.quiet) {
    console.err << fmt::format(
        "sandsim: warning: {}: the grid has no CRS, and neither have the rasters; "
        "state it in the scene as grid.crs\n",
        series.path().string());
  }
  std::vector<ExportedFile> files;
  for (const ExportTarget& target : plan.targets) {
    files.push_back(exporter.write(target));
    if (arguments.quiet) continue;
    console.err << warning_of(plan, files.back());
    if (!arguments.json) console.out << describe(plan, files.back()) << std::flush;
  }
  if (arguments.json) console.out << export_json(plan, series, files);
  return ExitCode::done;
}

}  // namespace sandsim::cli
