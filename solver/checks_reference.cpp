#include "solver/checks_reference.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "solver/grid_problems.hpp"

namespace sandsim {

namespace {

/// Collects issues of `reference.exact`.
class ExactChecks {
 public:
  ExactChecks(const Scene& scene, std::vector<Issue>& issues) : scene_(scene), issues_(issues) {}

  void operator()(const DamBreakReference& r) {
    check_dam("dam_break", r.dam);
    const HbarPolicy policy = scene_.sand.hbar.policy;
    if (policy != HbarPolicy::full && policy != HbarPolicy::scaled) {
      add("dam_break is the solution for hbar = scale h",
          "Set sand.hbar.policy to full or scaled, or use two_layer_dam_break.", {"sand.hbar"});
    }
  }

  void operator()(const StokerReference& r) {
    check_dam("stoker", r.dam);
    if (r.downstream_depth >= r.depth) {
      issues_.push_back({"reference.exact.downstream_depth",
                         "not below the depth behind the dam",
                         "that is " + number_text(r.depth) + " m",
                         "",
                         {"reference.exact.depth"}});
    }
    if (scene_.sand.hbar.policy != HbarPolicy::full) {
      add("stoker is the solution for hbar = h", "Set sand.hbar.policy to full.", {"sand.hbar"});
    }
    if (!without_friction()) {
      add("stoker is a solution without friction", "Set the friction to 0.",
          {"sand.friction_angle", "sand.friction_coefficient"});
    }
    for (const TerrainPart& part : scene_.terrain) {
      const PlaneTerrain* plane = std::get_if<PlaneTerrain>(&part);
      if (plane == nullptr || plane->inclination == 0.0) continue;
      add("stoker is the solution on a level bed", "Use {type: flat} as terrain.", {"terrain"});
      break;
    }
  }

  void operator()(const TwoLayerDamBreakReference& r) {
    check_dam("two_layer_dam_break", r.dam);
    const Hbar& hbar = scene_.sand.hbar;
    if (hbar.policy != HbarPolicy::truncated) {
      add("two_layer_dam_break is the solution for hbar = min(scale h, cap)",
          "Set sand.hbar.policy to truncated, or use dam_break.", {"sand.hbar"});
      return;
    }
    const double* scale = std::get_if<double>(&hbar.scale);
    const double* cap = std::get_if<double>(&hbar.cap);
    if (scale != nullptr && cap != nullptr && *cap >= *scale * r.depth) {
      add("the cap of " + number_text(*cap) + " m never acts on sand " + number_text(r.depth) + " m deep",
          "Use dam_break.", {"sand.hbar", "reference.exact.depth"});
    }
  }

 private:
  void add(const std::string& why, const std::string& suggestion, std::vector<std::string> uses) {
    uses.emplace_back("reference.exact.type");
    issues_.push_back({"reference.exact.type", "does not fit the scene", why, suggestion, std::move(uses)});
  }

  bool without_friction() const {
    const Sand& sand = scene_.sand;
    const auto is_zero = [](const std::optional<ScalarMap>& map) {
      return !map || (std::holds_alternative<double>(*map) && std::get<double>(*map) == 0.0);
    };
    return is_zero(sand.friction_angle) && is_zero(sand.friction_coefficient);
  }

  /// What all dam breaks have in common.
  void check_dam(const std::string& name, double dam) {
    const Grid& grid = scene_.grid;
    if (dam <= grid.origin[0] || dam >= grid.origin[0] + grid.cells[0] * grid.spacing) {
      issues_.push_back({"reference.exact.dam", "lies outside the grid", "", "", {"grid"}});
    }
    const auto is_map = [](const std::optional<ScalarMap>& map) {
      return map && !std::holds_alternative<double>(*map);
    };
    const Sand& sand = scene_.sand;
    if (is_map(sand.friction_angle) || is_map(sand.friction_coefficient) || is_map(sand.hbar.scale) ||
        is_map(sand.hbar.cap)) {
      add(name + " is a solution for uniform sand, and the scene has maps", "Use numbers.", {"sand"});
    }
    for (const TerrainPart& part : scene_.terrain) {
      const PlaneTerrain* plane = std::get_if<PlaneTerrain>(&part);
      const bool across = plane != nullptr && plane->inclination != 0.0 && std::abs(std::sin(plane->direction)) > 1e-12;
      if (!across && !std::holds_alternative<RasterTerrain>(part)) continue;
      add(name + " is a solution on a plane that falls along x", "Use flat terrain, or a plane with direction 0 deg.",
          {"terrain"});
      break;
    }
    if (!sand.sources.empty()) {
      add(name + " is a solution without sources", "Remove sand.sources.", {"sand.sources"});
    }
    const bool periodic = scene_.boundaries.x_min == BoundaryKind::periodic;
    if (periodic) add(name + " is a solution between walls or open ends", "", {"boundaries"});
  }

  const Scene& scene_;
  std::vector<Issue>& issues_;
};

/// A profile goes on beyond its table with its end values: without any overlap it would say nothing but these.
void check_overlap(const Grid& grid, const std::optional<Profile>& profile, const char* key,
                   std::vector<Issue>& issues) {
  if (!profile || profile->x.empty()) return;
  const double left = grid.origin[0], right = left + grid.cells[0] * grid.spacing;
  if (profile->x.back() > left && profile->x.front() < right) return;
  issues.push_back({key,
                    "does not overlap with the grid",
                    "its x is from " + number_text(profile->x.front()) + " m to " + number_text(profile->x.back()) +
                        " m; " + grid_text(grid),
                    "",
                    {"grid"}});
}

}  // namespace

void check_reference(const Scene& scene, std::vector<Issue>& issues) {
  const Reference& reference = *scene.reference;
  if (scene.grid.one_dimensional()) {
    check_overlap(scene.grid, reference.profile, "reference.profile", issues);
    check_overlap(scene.grid, reference.measured_profile, "reference.measured_profile", issues);
    if (reference.exact) {
      ExactChecks checks(scene, issues);
      std::visit(checks, *reference.exact);
    }
    return;
  }
  const auto add = [&](const char* key) {
    issues.push_back({std::string("reference.") + key,
                      "needs a 1-D scene",
                      "it is a curve over x, and the grid has " + std::to_string(scene.grid.cells[1]) + " rows",
                      "Remove it, or give the grid one row.",
                      {"grid.cells"}});
  };
  if (reference.exact) add("exact");
  if (reference.profile) add("profile");
  if (reference.measured_profile) add("measured_profile");
}

}  // namespace sandsim
