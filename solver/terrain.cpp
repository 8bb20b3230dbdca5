#include "solver/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "solver/backend_config.hpp"
#include "solver/resample.hpp"

namespace sandsim {
namespace {

/// Cosine and sine, exact along the axes and equal in size along the diagonals, so that turned and transposed planes
/// are turned and transposed to the last bit.
std::array<double, 2> unit_vector(double angle) {
  constexpr double rounding = 1e-15;
  const auto cleaned = [](double value) {
    if (std::abs(value) < rounding) {
      return 0.0;
    }
    constexpr double diagonal = 0.5 * std::numbers::sqrt2;
    return std::abs(std::abs(value) - diagonal) < rounding ? std::copysign(diagonal, value) : value;
  };
  return {cleaned(std::cos(angle)), cleaned(std::sin(angle))};
}

void add_terrain(const FlatTerrain& flat, const Grid&, const std::string&, GridProblems&, Ground& ground) {
  for (double& b : ground.bed) {
    b += flat.elevation;
  }
}

void add_terrain(const PlaneTerrain& plane, const Grid& grid, const std::string&, GridProblems&, Ground& ground) {
  const double slope = std::tan(plane.inclination);
  const auto [along_x, along_y] = unit_vector(plane.direction);
  std::size_t cell = 0;
  for (int j = 0; j < grid.cells[1]; ++j) {
    const double y = (j + 0.5) * grid.spacing;
    for (int i = 0; i < grid.cells[0]; ++i) {
      const double x = (i + 0.5) * grid.spacing;
      ground.bed[cell++] += plane.elevation - slope * (x * along_x + y * along_y);
    }
  }
}

/// Replaces cells without data by the nearest value of the raster, which has data somewhere.
void take_nearest(const Raster& raster, const Grid& grid, std::vector<double>& values) {
  Raster placed = raster;
  if (!raster.has_georeference) {
    placed.origin_x = grid.x(0), placed.origin_y = grid.y(0);
    placed.spacing_x = placed.spacing_y = grid.spacing;
  }
  const NearestValue nearest(placed);
  std::size_t cell = 0;
  for (int j = 0; j < grid.cells[1]; ++j) {
    for (int i = 0; i < grid.cells[0]; ++i, ++cell) {
      if (std::isnan(values[cell])) {
        values[cell] = nearest.at(grid.x(i), grid.y(j));
      }
    }
  }
}

/// Walls are marked, and their values made 0.
void make_walls(std::vector<double>& values, Ground& ground) {
  ground.is_wall.resize(values.size(), 0);
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    if (std::isnan(values[cell])) {
      ground.is_wall[cell] = 1;
      values[cell] = 0.0;
    }
  }
}

void add_terrain(const RasterTerrain& terrain, const Grid& grid, const std::string& key, GridProblems& problems,
                 Ground& ground) {
  const std::string subject = file_subject(terrain.file, key + ".file");
  if (!problems.check_fit(terrain.file, key + ".file")) {
    return;
  }
  std::vector<double> values = resample(*terrain.file.data, grid);
  const auto is_missing = [](double value) { return std::isnan(value); };
  if (std::all_of(values.begin(), values.end(), is_missing)) {
    problems.add(subject, "the raster has no data in any cell of the grid");
    return;
  }
  if (terrain.nodata == Nodata::error) {
    problems.add_cells(
        subject, values, is_missing, "the raster has no data (outside its edges, or NODATA)",
        "Keep the grid to the data (grid.cells, grid.origin), or write \"nodata: wall\" to keep the sand "
        "out there, or \"nodata: nearest\" to take the nearest value");
  } else if (std::any_of(values.begin(), values.end(), is_missing)) {
    if (terrain.nodata == Nodata::nearest) {
      take_nearest(*terrain.file.data, grid, values);
    } else {
      make_walls(values, ground);
    }
  }
  problems.add_cells(
      subject, values, [](double value) { return std::isinf(value); }, "the raster is infinite");
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    ground.bed[cell] += values[cell] * terrain.scale + terrain.offset;
  }
}

void check_sources(const Scene& scene, const Ground& ground, GridProblems& problems) {
  if (ground.is_wall.empty()) {
    return;
  }
  const std::vector<SandRain> rains = sand_rains(scene);
  for (std::size_t k = 0; k < rains.size(); ++k) {
    const auto& cells = rains[k].cells;
    const auto on_walls = std::count_if(
        cells.begin(), cells.end(), [&](std::int64_t cell) { return ground.wall_at(static_cast<std::size_t>(cell)); });
    if (on_walls > 0) {
      problems.add(entry_key("sand.sources", k, rains.size()),
                   std::to_string(on_walls) + " of its " + std::to_string(cells.size()) +
                       " cells are walls, since the terrain has no data there. Move the source");
    }
  }
}

/// Head of the fastest sand. [m]
double largest_velocity_head(const Scene& scene, const InitialState& state) {
  double largest = 0.0;
  for (std::size_t cell = 0; cell < state.momentum_x.size(); ++cell) {
    if (state.depth[cell] > 0.0) {
      largest = std::max(largest, std::hypot(state.momentum_x[cell], state.momentum_y[cell]) / state.depth[cell]);
    }
  }
  return scene.gravity > 0.0 ? 0.5 * largest * largest / scene.gravity : 0.0;
}

/// What sand that is poured or pushed can be heaped up to: all of it in one cell, or a slope at the angle of friction
/// through the whole grid. [m]
double largest_heap(const Scene& scene, const InitialState& state) {
  const auto is_pushed = [](const KinematicObject& object) { return !object.is_terrain(); };
  if (scene.sand.sources.empty() && std::none_of(scene.objects.begin(), scene.objects.end(), is_pushed)) {
    return 0.0;
  }
  const double area = scene.grid.spacing * scene.grid.spacing;
  double volume = state.release.grid_volume;
  for (const SandSource& source : scene.sand.sources) {
    volume += source.rate * (source.end - source.start);
  }
  const double steepest = *std::max_element(state.friction_coefficient.begin(), state.friction_coefficient.end());
  const double diagonal = scene.grid.spacing * std::hypot(scene.grid.cells[0], scene.grid.cells[1]);
  return std::min(volume / area, steepest * diagonal);
}

double in_run_precision(const Scene& scene, double b) {
  return scene.numerics.precision == Precision::float32 ? static_cast<double>(static_cast<float>(b)) : b;
}

}  // namespace

bool has_bed(const Scene& scene) {
  return std::any_of(scene.terrain.begin(), scene.terrain.end(), [](const TerrainPart& part) {
    const auto* flat = std::get_if<FlatTerrain>(&part);
    return flat == nullptr || flat->elevation != 0.0;
  });
}

Ground build_ground(const Scene& scene, GridProblems& problems) {
  if (!has_bed(scene)) {
    return {};
  }
  Ground ground;
  ground.bed.assign(scene.grid.cell_count(), 0.0);
  for (std::size_t k = 0; k < scene.terrain.size(); ++k) {
    const std::string key = entry_key("terrain", k, scene.terrain.size());
    std::visit([&](const auto& part) { add_terrain(part, scene.grid, key, problems, ground); }, scene.terrain[k]);
  }
  for (std::size_t cell = 0; cell < ground.bed.size(); ++cell) {
    // As the run will hold it: sand that is filled up to a level is level there.
    ground.bed[cell] = ground.wall_at(cell) ? 0.0 : in_run_precision(scene, ground.bed[cell]);
  }
  if (problems.empty()) {
    problems.add_cells(
        "terrain", ground.bed, [](double b) { return !std::isfinite(b); }, "the bed is not finite");
  }
  check_sources(scene, ground, problems);
  return ground;
}

void raise_walls(const Scene& scene, const Ground& ground, InitialState& state) {
  if (ground.is_wall.empty()) {
    return;
  }
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (std::size_t cell = 0; cell < state.bed.size(); ++cell) {
    if (!ground.wall_at(cell)) {
      lowest = std::min(lowest, state.bed[cell]);
      highest = std::max(highest, state.bed[cell] + state.depth[cell]);
    }
  }
  highest += largest_velocity_head(scene, state) + largest_heap(scene, state);
  const double top = in_run_precision(scene, highest + (highest - lowest) + scene.grid.spacing);
  for (std::size_t cell = 0; cell < state.bed.size(); ++cell) {
    state.bed[cell] = ground.wall_at(cell) ? top : state.bed[cell];
  }
}

double slope_secant(const Ground& ground, const Grid& grid, int i, int j) {
  if (ground.bed.empty()) {
    return 1.0;
  }
  const auto cell_at = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.cells[0]) + static_cast<std::size_t>(column);
  };
  const auto is_ground = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < grid.cells[0] && row < grid.cells[1] &&
           !ground.wall_at(cell_at(column, row));
  };
  const auto slope = [&](int step_x, int step_y) {
    const int ahead = is_ground(i + step_x, j + step_y) ? 1 : 0;
    const int behind = is_ground(i - step_x, j - step_y) ? 1 : 0;
    const double rise = ground.bed[cell_at(i + ahead * step_x, j + ahead * step_y)] -
                        ground.bed[cell_at(i - behind * step_x, j - behind * step_y)];
    return ahead + behind == 0 ? 0.0 : rise / ((ahead + behind) * grid.spacing);
  };
  const double along_x = slope(1, 0);
  const double along_y = slope(0, 1);
  return std::sqrt(1.0 + along_x * along_x + along_y * along_y);
}

}  // namespace sandsim
