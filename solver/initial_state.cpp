#include "solver/initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/coverage.hpp"
#include "solver/grid_problems.hpp"
#include "solver/resample.hpp"
#include "solver/solid_objects.hpp"

namespace sandsim {
namespace {

constexpr double no_cap = 1e30;  // [m] as initial_state.hpp promises

/// "terrain", or "terrain.2" where it is a list.
std::string entry_key(const std::string& list, std::size_t index, std::size_t size) {
  return size == 1 ? list : list + "." + std::to_string(index);
}

/// The file's values on the grid; empty, and a problem, if it does not fit.
std::vector<double> values_on_grid(const RasterFile& file, const Grid& grid, const std::string& key,
                                   GridProblems& problems) {
  const Raster& raster = *file.data;
  if (!fits(raster, grid)) {
    const auto size = [](std::size_t nx, std::size_t ny) { return std::to_string(nx) + " x " + std::to_string(ny); };
    problems.add(
        key + " = " + file.file,
        "the raster has " + size(raster.nx, raster.ny) + " values, the grid " + std::to_string(grid.cells[0]) + " x " +
            std::to_string(grid.cells[1]) +
            " cells (a file that carries no position must have the grid's size). Use an ESRI ASCII grid, which "
            "is resampled, or change grid.cells");
    return {};
  }
  return resample(raster, grid);
}

// ---- terrain --------------------------------------------------------------------------------------------------------

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

void add_terrain(const FlatTerrain& flat, const Grid&, const std::string&, GridProblems&, std::vector<double>& bed) {
  for (double& b : bed) {
    b += flat.elevation;
  }
}

void add_terrain(const PlaneTerrain& plane, const Grid& grid, const std::string&, GridProblems&,
                 std::vector<double>& bed) {
  const double slope = std::tan(plane.inclination);
  const auto [along_x, along_y] = unit_vector(plane.direction);
  std::size_t cell = 0;
  for (int j = 0; j < grid.cells[1]; ++j) {
    const double y = (j + 0.5) * grid.spacing;
    for (int i = 0; i < grid.cells[0]; ++i) {
      const double x = (i + 0.5) * grid.spacing;
      bed[cell++] += plane.elevation - slope * (x * along_x + y * along_y);
    }
  }
}

void add_terrain(const RasterTerrain& terrain, const Grid& grid, const std::string& key, GridProblems& problems,
                 std::vector<double>& bed) {
  const std::string file_key = key + ".file";
  const std::vector<double> values = values_on_grid(terrain.file, grid, file_key, problems);
  const bool has_gaps = problems.add_cells(
      file_key + " = " + terrain.file.file, values, [](double value) { return !std::isfinite(value); },
      "the raster has no data (outside its edges, or NODATA)");
  for (std::size_t cell = 0; cell < values.size() && !has_gaps; ++cell) {
    bed[cell] += values[cell] * terrain.scale + terrain.offset;
  }
}

std::vector<double> build_bed(const Scene& scene, GridProblems& problems) {
  const auto leaves_bed_at_zero = [](const TerrainPart& part) {
    const auto* flat = std::get_if<FlatTerrain>(&part);
    return flat != nullptr && flat->elevation == 0.0;
  };
  if (std::all_of(scene.terrain.begin(), scene.terrain.end(), leaves_bed_at_zero)) {
    return {};
  }
  std::vector<double> bed(scene.grid.cell_count(), 0.0);
  for (std::size_t k = 0; k < scene.terrain.size(); ++k) {
    const std::string key = entry_key("terrain", k, scene.terrain.size());
    std::visit([&](const auto& part) { add_terrain(part, scene.grid, key, problems, bed); }, scene.terrain[k]);
  }
  if (scene.numerics.precision == Precision::float32) {
    // As the run will hold it: sand that is filled up to a level is level there.
    std::transform(bed.begin(), bed.end(), bed.begin(),
                   [](double b) { return static_cast<double>(static_cast<float>(b)); });
  }
  problems.add_cells(
      "terrain", bed, [](double b) { return !std::isfinite(b); }, "the bed is not finite");
  return bed;
}

// ---- sand -----------------------------------------------------------------------------------------------------------

/// Adds sand part by part onto a bed, with the momentum that it brings along.
class SandBuilder {
 public:
  SandBuilder(const Grid& grid, const std::vector<double>& bed, GridProblems& problems)
      : grid_(grid), bed_(bed), problems_(problems), depth_(grid.cell_count(), 0.0) {}

  void add(const SandPart& part, const std::string& key) {
    const std::vector<double> before = depth_;
    const SandVelocity velocity = std::visit([](const auto& shape) { return shape.velocity; }, part);
    std::visit([&](const auto& shape) { add(shape, key); }, part);
    if (velocity == SandVelocity{}) {
      return;
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      momentum_[axis].resize(depth_.size(), 0.0);
      for (std::size_t cell = 0; cell < depth_.size(); ++cell) {
        momentum_[axis][cell] += (depth_[cell] - before[cell]) * velocity[axis];
      }
    }
  }

  const std::vector<double>& depth() const { return depth_; }
  /// Along x (0) or y (1); empty if all sand is at rest.
  const std::vector<double>& momentum(std::size_t axis) const { return momentum_.at(axis); }

 private:
  void add(const SandBox& box, const std::string&) {
    const std::array<double, 2> from = corner_in_cells(box.from);
    const std::array<double, 2> to = corner_in_cells(box.to);
    fill(box.fill, [&](int i, int j) {
      const double along_y = grid_.one_dimensional() ? 1.0 : covered_length(from[1], to[1], j);
      return covered_length(from[0], to[0], i) * along_y;
    });
  }

  void add(const SandColumn& column, const std::string&) {
    const std::array<double, 2> center = corner_in_cells(column.center);
    const double radius = in_cells(column.radius, grid_.spacing);
    fill(column.fill, [&](int i, int j) {
      const std::array<double, 2> offset = offset_from(center, i, j);
      // Seen from the centre, so that both sides of a column are covered alike.
      return grid_.one_dimensional()
                 ? std::max(0.0, std::min(offset[0] + 0.5, radius) - std::max(offset[0] - 0.5, -radius))
                 : covered_by_disc(offset, radius);
    });
  }

  void add(const SandCone& cone, const std::string&) {
    const std::array<double, 2> center = corner_in_cells(cone.center);
    const double radius = in_cells(cone.radius, grid_.spacing);
    for_each_cell([&](std::size_t cell, int i, int j) {
      const std::array<double, 2> offset = offset_from(center, i, j);
      const double distance = std::sqrt(offset[0] * offset[0] + offset[1] * offset[1]);
      if (distance < radius) {
        depth_[cell] += cone.height * (1.0 - distance / radius);
      }
    });
  }

  void add(const SandLayer& layer, const std::string&) {
    fill(layer.fill, [](int, int) { return 1.0; });
  }

  void add(const SandRaster& raster, const std::string& key) {
    const std::string file_key = key + ".file";
    const std::vector<double> values = values_on_grid(raster.file, grid_, file_key, problems_);
    const bool negative = problems_.add_cells(
        file_key + " = " + raster.file.file, values, [&](double value) { return value * raster.scale < 0.0; },
        "the raster has negative depths");
    for (std::size_t cell = 0; cell < values.size() && !negative; ++cell) {
      depth_[cell] += std::isnan(values[cell]) ? 0.0 : values[cell] * raster.scale;
    }
  }

  std::array<double, 2> corner_in_cells(const std::array<double, 2>& point) const {
    return {in_cells(point[0] - grid_.origin[0], grid_.spacing), in_cells(point[1] - grid_.origin[1], grid_.spacing)};
  }

  /// From the point to the cell's centre, in cells. In a 1-D scene only x counts.
  std::array<double, 2> offset_from(const std::array<double, 2>& point, int i, int j) const {
    return {(i + 0.5) - point[0], grid_.one_dimensional() ? 0.0 : (j + 0.5) - point[1]};
  }

  template <typename Action>
  void for_each_cell(Action action) const {
    std::size_t cell = 0;
    for (int j = 0; j < grid_.cells[1]; ++j) {
      for (int i = 0; i < grid_.cells[0]; ++i) {
        action(cell++, i, j);
      }
    }
  }

  /// Adds sand to the covered part of every cell: a depth, or what lacks to a level.
  template <typename Covered>
  void fill(const Fill& fill, Covered covered) {
    for_each_cell([&](std::size_t cell, int i, int j) {
      if (const double part = covered(i, j); part > 0.0) {
        const double surface = (bed_.empty() ? 0.0 : bed_[cell]) + depth_[cell];
        depth_[cell] += part * (fill.surface ? std::max(0.0, *fill.surface - surface) : fill.depth.value_or(0.0));
      }
    });
  }

  const Grid& grid_;
  const std::vector<double>& bed_;
  GridProblems& problems_;
  std::vector<double> depth_;
  std::array<std::vector<double>, 2> momentum_;
};

void build_sand(const Scene& scene, InitialState& state, GridProblems& problems) {
  SandBuilder builder(scene.grid, state.bed, problems);
  const std::vector<SandPart>& parts = scene.sand.initial;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    builder.add(parts[k], entry_key("sand.initial", k, parts.size()));
  }
  problems.add_cells(
      "sand.initial", builder.depth(), [](double depth) { return !(depth >= 0.0 && std::isfinite(depth)); },
      "the depth is negative or not finite");
  state.depth = builder.depth();
  state.momentum_x = builder.momentum(0), state.momentum_y = builder.momentum(1);
}

// ---- material -------------------------------------------------------------------------------------------------------

/// A number as one value, a map as ny * nx values; `allowed` tells which are. Where a value is not, or has no data,
/// there is a problem.
template <typename Predicate>
std::vector<double> build_material(const ScalarMap& map, const Grid& grid, const std::string& key,
                                   GridProblems& problems, Predicate allowed, const std::string& rule) {
  std::vector<double> values;
  std::string name = key;
  if (const auto* file = std::get_if<RasterFile>(&map)) {
    values = values_on_grid(*file, grid, key, problems);
    name += " = " + file->file;
  } else {
    values.push_back(std::get<double>(map));
  }
  problems.add_cells(
      name, values, [](double value) { return std::isnan(value); },
      "the raster has no data (outside its edges, or NODATA)");
  problems.add_cells(
      name, values, [&](double value) { return !std::isnan(value) && !allowed(value); }, rule);
  return values;
}

std::vector<double> build_friction(const Scene& scene, GridProblems& problems) {
  const Sand& sand = scene.sand;
  if (sand.friction_angle.has_value() == sand.friction_coefficient.has_value()) {
    problems.add("sand", "exactly one of friction_angle and friction_coefficient must be given");
    return {};
  }
  if (sand.friction_coefficient) {
    const auto allowed = [](double mu) { return mu >= 0.0 && std::isfinite(mu); };
    return build_material(*sand.friction_coefficient, scene.grid, "sand.friction_coefficient", problems, allowed,
                          "the friction coefficient is negative or not finite");
  }
  const auto allowed = [](double angle) { return angle >= 0.0 && angle < 0.5 * std::numbers::pi; };
  std::vector<double> values = build_material(*sand.friction_angle, scene.grid, "sand.friction_angle", problems,
                                              allowed, "the friction angle is not in [0, pi/2) rad");
  std::transform(values.begin(), values.end(), values.begin(), [](double angle) { return std::tan(angle); });
  return values;
}

void build_hbar(const Scene& scene, InitialState& state, GridProblems& problems) {
  const Hbar& hbar = scene.sand.hbar;
  const auto is_scale = [](double scale) { return scale > 0.0 && scale <= 1.0; };
  const auto is_cap = [](double cap) { return cap > 0.0 && std::isfinite(cap); };
  const std::string cap_rule = "the cap of hbar is not positive and finite [m]";
  state.hbar_scale = {1.0};
  state.hbar_cap = {no_cap};
  if (hbar.policy == HbarPolicy::scaled || hbar.policy == HbarPolicy::truncated) {
    state.hbar_scale = build_material(hbar.scale, scene.grid, "sand.hbar.scale", problems, is_scale,
                                      "the scale of hbar is not in (0, 1]");
  }
  if (hbar.policy == HbarPolicy::truncated) {
    state.hbar_cap = build_material(hbar.cap, scene.grid, "sand.hbar.cap", problems, is_cap, cap_rule);
  }
  if (hbar.policy == HbarPolicy::constant) {
    state.hbar_cap = build_material(hbar.depth, scene.grid, "sand.hbar.depth", problems, is_cap, cap_rule);
  }
}

}  // namespace

InitialState build_initial_state(const Scene& scene) {
  GridProblems problems(scene.grid);
  InitialState state;
  state.bed = build_bed(scene, problems);
  build_sand(scene, state, problems);
  state.friction_coefficient = build_friction(scene, problems);
  build_hbar(scene, state, problems);
  problems.throw_if_any();
  raise_solid_objects(scene, state);
  for (std::vector<double>* momentum : {&state.momentum_x, &state.momentum_y}) {
    for (std::size_t cell = 0; cell < momentum->size(); ++cell) {
      (*momentum)[cell] = state.depth[cell] > 0.0 ? (*momentum)[cell] : 0.0;  // a solid object took its sand
    }
  }
  return state;
}

}  // namespace sandsim
