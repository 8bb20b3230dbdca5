#include "solver/release.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/coverage.hpp"
#include "solver/polygon_coverage.hpp"
#include "solver/resample.hpp"

namespace sandsim {
namespace {

/// What a part of the scene is, for messages.
std::string name_of(const SandBox&) {
  return "box";
}
std::string name_of(const SandColumn&) {
  return "column";
}
std::string name_of(const SandCone&) {
  return "cone";
}
std::string name_of(const SandLayer&) {
  return "layer";
}
std::string name_of(const SandRaster& raster) {
  return raster.file.file;
}
std::string name_of(const SandPolygon& polygon) {
  return polygon.file.file;
}

double metres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::m:
      return 1.0;
    case LengthUnit::cm:
      return 0.01;
    case LengthUnit::mm:
      break;
  }
  return 0.001;
}

/// Adds sand part by part onto the ground, with the momentum that it brings along.
class SandBuilder {
 public:
  SandBuilder(const Scene& scene, const Ground& ground, InitialState& state, GridProblems& problems)
      : grid_(scene.grid), ground_(ground), state_(state), problems_(problems) {
    state_.depth.assign(grid_.cell_count(), 0.0);
  }

  void add(const SandPart& part, const std::string& key) {
    const std::vector<double> before = state_.depth;
    outside_ = poured_ = blocked_ = 0.0;
    std::visit([&](const auto& shape) { add(shape, key); }, part);
    std::visit([&](const auto& shape) { account(at_place(shape.place, key) + " = " + name_of(shape)); }, part);
    const SandVelocity velocity = std::visit([](const auto& shape) { return shape.velocity; }, part);
    if (velocity == SandVelocity{}) {
      return;
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::vector<double>& momentum = axis == 0 ? state_.momentum_x : state_.momentum_y;
      momentum.resize(before.size(), 0.0);
      for (std::size_t cell = 0; cell < before.size(); ++cell) {
        momentum[cell] += (state_.depth[cell] - before[cell]) * velocity[axis];
      }
    }
  }

 private:
  void add(const SandBox& box, const std::string&) {
    const std::array<double, 2> from = corner_in_cells(box.from);
    const std::array<double, 2> to = corner_in_cells(box.to);
    const auto along_y = [&](int j) { return grid_.one_dimensional() ? 1.0 : covered_length(from[1], to[1], j); };
    fill(box.fill, [&](int i, int j) { return covered_length(from[0], to[0], i) * along_y(j); });
    if (reaches_out(from, to)) {
      const double width = grid_.one_dimensional() ? 1.0 : to[1] - from[1];
      lay_outside((to[0] - from[0]) * width * box.fill.depth.value_or(0.0));
    }
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
    if (disc_reaches_out(center, radius)) {
      const double area = grid_.one_dimensional() ? 2.0 * radius : std::numbers::pi * radius * radius;
      lay_outside(area * column.fill.depth.value_or(0.0));
    }
  }

  void add(const SandCone& cone, const std::string&) {
    const std::array<double, 2> center = corner_in_cells(cone.center);
    const double radius = in_cells(cone.radius, grid_.spacing);
    fill({cone.height, {}}, [&](int i, int j) {
      const std::array<double, 2> offset = offset_from(center, i, j);
      return grid_.one_dimensional() ? covered_by_cone(offset[0], radius) : covered_by_cone(offset, radius);
    });
    if (disc_reaches_out(center, radius)) {
      const double volume = grid_.one_dimensional() ? radius : std::numbers::pi * radius * radius / 3.0;
      lay_outside(volume * cone.height);
    }
  }

  /// Sand wherever there is ground: none is lost on walls.
  void add(const SandLayer& layer, const std::string&) {
    fill(layer.fill, [](int, int) { return 1.0; });
    blocked_ = 0.0;
  }

  void add(const SandRaster& raster, const std::string& key) {
    const std::string file_key = key + ".file";
    if (!problems_.check_fit(raster.file, file_key)) {
      return;
    }
    const SpreadRaster sand = spread(*raster.file.data, grid_);
    const bool negative = problems_.add_cells(
        file_subject(raster.file, file_key), sand.depth, [&](double depth) { return depth * raster.scale < 0.0; },
        "the raster has negative depths");
    for (std::size_t cell = 0; cell < sand.depth.size() && !negative; ++cell) {
      pour(cell, sand.depth[cell] * raster.scale);
    }
    outside_ = sand.outside * raster.scale;
  }

  void add(const SandPolygon& polygon, const std::string&) {
    const double cell_area = grid_.spacing * grid_.spacing;
    const auto nx = static_cast<std::size_t>(grid_.cells[0]);
    for (const PolygonFeature& feature : polygon.file.data->features) {
      const double depth = polygon.depth ? *polygon.depth : feature.value * metres(polygon.unit);
      double covered = 0.0;
      for_each_covered_cell(feature, grid_, [&](std::size_t cell, double part) {
        const double secant = polygon.normal_to_slope ? slope_secant(ground_, grid_, static_cast<int>(cell % nx),
                                                                     static_cast<int>(cell / nx))
                                                      : 1.0;
        pour(cell, part * depth * secant);
        covered += part;
      });
      outside_ += std::max(0.0, area_of(feature, grid_) - covered * cell_area) * depth;
    }
  }

  std::array<double, 2> corner_in_cells(const std::array<double, 2>& point) const {
    return {in_cells(point[0] - grid_.origin[0], grid_.spacing), in_cells(point[1] - grid_.origin[1], grid_.spacing)};
  }

  /// From the point to the cell's centre, in cells. In a 1-D scene only x counts.
  std::array<double, 2> offset_from(const std::array<double, 2>& point, int i, int j) const {
    return {(i + 0.5) - point[0], grid_.one_dimensional() ? 0.0 : (j + 0.5) - point[1]};
  }

  /// Whether a rectangle, in cells, leaves the grid. In a 1-D scene only x counts.
  bool reaches_out(const std::array<double, 2>& from, const std::array<double, 2>& to) const {
    const bool along_x = from[0] < 0.0 || to[0] > grid_.cells[0];
    return along_x || (!grid_.one_dimensional() && (from[1] < 0.0 || to[1] > grid_.cells[1]));
  }

  bool disc_reaches_out(const std::array<double, 2>& center, double radius) const {
    return reaches_out({center[0] - radius, center[1] - radius}, {center[0] + radius, center[1] + radius});
  }

  /// Adds sand to the covered part of every cell: a depth, or what lacks to a level.
  template <typename Covered>
  void fill(const Fill& fill, Covered covered) {
    std::size_t cell = 0;
    for (int j = 0; j < grid_.cells[1]; ++j) {
      for (int i = 0; i < grid_.cells[0]; ++i, ++cell) {
        const double part = covered(i, j);
        if (part > 0.0 && fill.depth) {
          pour(cell, part * *fill.depth);
        } else if (part > 0.0 && !ground_.wall_at(cell)) {
          const double surface = ground_.bed_at(cell) + state_.depth[cell];
          pour(cell, part * std::max(0.0, fill.surface.value_or(surface) - surface));
        }
      }
    }
  }

  void pour(std::size_t cell, double depth) {
    (ground_.wall_at(cell) ? blocked_ : poured_) += depth * grid_.spacing * grid_.spacing;
    state_.depth[cell] += ground_.wall_at(cell) ? 0.0 : depth;
  }

  /// Of a shape that reaches beyond the grid: what is not on it. `volume` is in cubes of area in cells and depth in
  /// metres; 0 for shapes that are filled up to a level, which have no depth where there is no ground.
  void lay_outside(double volume) {
    outside_ = std::max(0.0, volume * grid_.spacing * grid_.spacing - poured_ - blocked_);
  }

  /// Enters a part into the release, and warns of what the run does not start with.
  void account(const std::string& subject) {
    const double volume = poured_ + outside_ + blocked_;
    state_.release.file_volume += volume;
    state_.release.outside_volume += outside_;
    state_.release.blocked_volume += blocked_;
    // Less is the rounding of edges to 2^-30 of a cell.
    const double rounding = 1e-6 * volume;
    const auto part_of = [&](double part) {
      return number_text(part) + " m^3 of " + number_text(volume) + " m^3 of sand lie ";
    };
    if (outside_ > rounding) {
      state_.warnings.push_back(subject + ": " + part_of(outside_) + "outside the grid and are left out (" +
                                grid_text(grid_) + "). Make the grid larger, or the part smaller.");
    }
    if (blocked_ > rounding) {
      state_.warnings.push_back(subject + ": " + part_of(blocked_) +
                                "where the terrain has no data and are left out (nodata: wall). Write \"nodata: "
                                "nearest\", or make the part smaller.");
    }
  }

  const Grid& grid_;
  const Ground& ground_;
  InitialState& state_;
  GridProblems& problems_;
  double outside_ = 0.0;  // [m^3] of the part that is being added
  double poured_ = 0.0;   // [m^3] likewise, on the grid
  double blocked_ = 0.0;  // [m^3] likewise, on walls
};

}  // namespace

void build_sand(const Scene& scene, const Ground& ground, InitialState& state, GridProblems& problems) {
  SandBuilder builder(scene, ground, state, problems);
  const std::vector<SandPart>& parts = scene.sand.initial;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    builder.add(parts[k], entry_key("sand.initial", k, parts.size()));
  }
  problems.add_cells(
      "sand.initial", state.depth, [](double depth) { return !(depth >= 0.0 && std::isfinite(depth)); },
      "the depth is negative or not finite");
}

}  // namespace sandsim
