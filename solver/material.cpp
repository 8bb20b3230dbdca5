#include "solver/material.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "solver/polygon_coverage.hpp"
#include "solver/resample.hpp"

namespace sandsim {
namespace {

constexpr double no_cap = 1e30;  // [m] as initial_state.hpp promises

/// Makes ny * nx values, or one for the whole grid, of a map; problems where it has none, or they are not allowed.
class Maps {
 public:
  Maps(const Scene& scene, const Ground& ground, GridProblems& problems)
      : grid_(scene.grid), ground_(ground), problems_(problems) {}

  template <typename Predicate>
  std::vector<double> values(const ScalarMap& map, const std::string& key, Predicate allowed, const std::string& rule) {
    std::string subject = key;
    std::vector<double> values = std::visit([&](const auto& one) { return make(one, key, subject); }, map);
    problems_.add_cells(
        subject, values, [&](double value) { return !std::isnan(value) && !allowed(value); }, rule);
    return values;
  }

 private:
  std::vector<double> make(double number, const std::string&, std::string&) const { return {number}; }

  std::vector<double> make(const RasterFile& file, const std::string& key, std::string& subject) {
    subject = file_subject(file, key);
    if (!problems_.check_fit(file, key)) {
      return {};
    }
    std::vector<double> values = resample(*file.data, grid_);
    fill_walls(values);
    problems_.add_cells(
        subject, values, [](double value) { return std::isnan(value); },
        "the raster has no data (outside its edges, or NODATA)");
    return values;
  }

  /// A wall without data takes the largest value: faces take the lesser of their two cells, which is then the other's.
  void fill_walls(std::vector<double>& values) const {
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (const double value : values) {
      largest = std::fmax(largest, value);
    }
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      values[cell] = std::isnan(values[cell]) && ground_.wall_at(cell) ? largest : values[cell];
    }
  }

  std::vector<double> make(const ZoneMap& zones, const std::string& key, std::string& subject) {
    subject = file_subject(zones.polygons, key);
    std::vector<double> values(grid_.cell_count(), 0.0);
    std::vector<double> covered(grid_.cell_count(), 0.0);
    for (const PolygonFeature& zone : zones.polygons.data->features) {
      for_each_covered_cell(zone, grid_, [&](std::size_t cell, double part) {
        values[cell] += part * zone.value;
        covered[cell] += part;
      });
    }
    // Neighbours whose common border was drawn twice overlap in slivers, which change a value by as little.
    constexpr double sliver = 1e-3;
    problems_.add_cells(
        subject, covered, [](double part) { return part > 1.0 + sliver; },
        "zones overlap: together they cover more than the whole cell", "Cut them so that each point lies in one");
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      values[cell] =
          covered[cell] < 1.0 ? values[cell] + (1.0 - covered[cell]) * zones.elsewhere : values[cell] / covered[cell];
    }
    return values;
  }

  const Grid& grid_;
  const Ground& ground_;
  GridProblems& problems_;
};

std::vector<double> build_friction(const Sand& sand, Maps& maps, GridProblems& problems) {
  if (sand.friction_angle.has_value() == sand.friction_coefficient.has_value()) {
    problems.add("sand", "exactly one of friction_angle and friction_coefficient must be given");
    return {};
  }
  if (sand.friction_coefficient) {
    const auto allowed = [](double mu) { return mu >= 0.0 && std::isfinite(mu); };
    return maps.values(*sand.friction_coefficient, "sand.friction_coefficient", allowed,
                       "the friction coefficient is negative or not finite");
  }
  const auto allowed = [](double angle) { return angle >= 0.0 && angle < 0.5 * std::numbers::pi; };
  std::vector<double> values =
      maps.values(*sand.friction_angle, "sand.friction_angle", allowed, "the friction angle is not in [0, pi/2) rad");
  std::transform(values.begin(), values.end(), values.begin(), [](double angle) { return std::tan(angle); });
  return values;
}

void build_hbar(const Hbar& hbar, Maps& maps, InitialState& state) {
  const auto is_scale = [](double scale) { return scale > 0.0 && scale <= 1.0; };
  const auto is_cap = [](double cap) { return cap > 0.0 && std::isfinite(cap); };
  const std::string cap_rule = "the cap of hbar is not positive and finite [m]";
  state.hbar_scale = {1.0};
  state.hbar_cap = {no_cap};
  if (hbar.policy == HbarPolicy::scaled || hbar.policy == HbarPolicy::truncated) {
    state.hbar_scale = maps.values(hbar.scale, "sand.hbar.scale", is_scale, "the scale of hbar is not in (0, 1]");
  }
  if (hbar.policy == HbarPolicy::truncated) {
    state.hbar_cap = maps.values(hbar.cap, "sand.hbar.cap", is_cap, cap_rule);
  }
  if (hbar.policy == HbarPolicy::constant) {
    state.hbar_cap = maps.values(hbar.depth, "sand.hbar.depth", is_cap, cap_rule);
  }
}

}  // namespace

void build_material(const Scene& scene, const Ground& ground, InitialState& state, GridProblems& problems) {
  Maps maps(scene, ground, problems);
  state.friction_coefficient = build_friction(scene.sand, maps, problems);
  build_hbar(scene.sand.hbar, maps, state);
}

}  // namespace sandsim
