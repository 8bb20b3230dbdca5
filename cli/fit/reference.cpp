#include "cli/fit/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/option_value.hpp"
#include "io/output/run_curves.hpp"
#include "io/raster/read_csv.hpp"
#include "solver/errors.hpp"
#include "solver/initial_state.hpp"
#include "solver/reference/compare.hpp"

namespace sandsim::cli {

namespace {

using Kind = FitReference::Kind;

/// 1 % of the largest depth at the start, if neither the command nor the scene says what defines the front.
double front_depth_of(const FitArguments& arguments, const Scene& scene) {
  if (arguments.front_depth) {
    return positive_option("--front-depth", *arguments.front_depth, Dimension::length, scene.grid.spacing);
  }
  if (scene.reference) {
    for (const double depth : scene.reference->front_depths) {
      if (depth > 0.0) {
        return depth;
      }
    }
  }
  const std::vector<double> depth = build_initial_state(scene).depth;
  const double largest = depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
  if (!(largest > 0.0)) {
    throw Error(ExitCode::usage,
                "fit: the scene starts without sand; say what depth the front has: --front-depth '5 mm'");
  }
  return 0.01 * largest;
}

/// Leaves out the points that lie outside of [first, last].
void keep_within(FitReference& reference, double first, double last, const char* unit, const char* what) {
  if (reference.place.empty()) {
    throw InputError(reference.source + ": " +
                     (reference.kind == Kind::front
                          ? fmt::format("no front to compare with: nothing deeper than {:g} m", reference.front_depth)
                          : "no profile is known then to compare with"));
  }
  const std::size_t all = reference.place.size();
  const double lowest = reference.place.front(), highest = reference.place.back();
  std::vector<double> place, value;
  for (std::size_t k = 0; k < all; ++k) {
    if (reference.place[k] >= first && reference.place[k] <= last) {
      place.push_back(reference.place[k]);
      value.push_back(reference.value[k]);
    }
  }
  if (place.size() < 2) {
    throw InputError(fmt::format("{}: its points, {:g} to {:g} {}, do not overlap with {}, {:g} to {:g} {}",
                                 reference.source, lowest, highest, unit, what, first, last, unit));
  }
  if (place.size() < all) {
    reference.warnings.push_back(
        fmt::format("{}: {} of {} points are left out: they lie outside of {}, {:g} to {:g} {}", reference.source,
                    all - place.size(), all, what, first, last, unit));
  }
  reference.place = std::move(place);
  reference.value = std::move(value);
}

FitReference front_reference(FrontCurve curve, double front_depth, const Scene& scene) {
  FitReference reference{Kind::front, curve.file, std::move(curve.time), std::move(curve.front), front_depth, 0, 0, {}};
  keep_within(reference, 0.0, scene.time.end * (1.0 + 1e-9), "s", "the scene's time");
  const auto [least, most] = std::minmax_element(reference.value.begin(), reference.value.end());
  reference.signal = *most - *least;
  reference.time = std::min(reference.place.back(), scene.time.end);
  if (!(reference.signal > 0.0)) {
    throw InputError(reference.source + ": the front does not move, so that nothing can be told from it");
  }
  return reference;
}

FitReference profile_reference(Profile profile, double time, const Scene& scene) {
  if (!scene.grid.one_dimensional()) {
    throw SceneError("fit: the scene has more than one row of cells; profiles are of one row. Take a front instead.");
  }
  if (time > scene.time.end * (1.0 + 1e-9)) {
    throw InputError(
        fmt::format("{}: {:g} s is after the end of the scene, {:g} s", profile.file, time, scene.time.end));
  }
  FitReference reference{Kind::profile, profile.file, std::move(profile.x), std::move(profile.depth), 0, 0, 0, {}};
  const double left = scene.grid.origin[0];
  keep_within(reference, left, left + scene.grid.cells[0] * scene.grid.spacing, "m", "the grid");
  reference.time = std::min(time, scene.time.end);
  reference.signal = *std::max_element(reference.value.begin(), reference.value.end());
  if (!(reference.signal > 0.0)) {
    throw InputError(reference.source + ": there is no sand in the profile, so that nothing can be told from it");
  }
  return reference;
}

/// The exact solution at the scene's frames: its fronts as long as its profile is known, and its tip.
struct ExactFronts {
  FrontCurve of_depth{"the scene's exact solution", {}, {}};
  FrontCurve of_tip{"the tip of the scene's exact solution", {}, {}};
};

ExactFronts exact_fronts(const Scene& scene, double front_depth) {
  constexpr double most = 1000.0;  // frames: more tell no more
  const InitialState initial = build_initial_state(scene);
  const double step = std::max(scene.time.frame_interval, scene.time.end / most);
  ExactFronts fronts;
  const auto add = [](FrontCurve& curve, double time, double position) {
    if (!std::isnan(position)) {
      curve.time.push_back(time);
      curve.front.push_back(position);
    }
  };
  for (int k = 1; k * step <= scene.time.end * (1.0 + 1e-9); ++k) {
    const ReferenceFrame now = reference_at(scene, initial, k * step);
    add(fronts.of_tip, k * step, now.tip);
    if (!now.depth.empty()) {
      add(fronts.of_depth, k * step, front(scene.grid, now.depth, front_depth));
    }
  }
  return fronts;
}

/// Where only the tip is known, it is compared with the last wet cell, unless --front-depth says otherwise.
FitReference exact_front_reference(const FitArguments& arguments, const Scene& scene) {
  const double depth = front_depth_of(arguments, scene);
  ExactFronts fronts = exact_fronts(scene, depth);
  if (fronts.of_depth.time.size() >= 2) {
    return front_reference(std::move(fronts.of_depth), depth, scene);
  }
  FitReference reference = front_reference(std::move(fronts.of_tip), arguments.front_depth ? depth : 0.0, scene);
  reference.warnings.push_back(
      "of the scene's exact solution only the tip is known, which grids follow slowly: fit on finer grids as well, "
      "to see where the values go");
  return reference;
}

Profile exact_profile(const Scene& scene, double time) {
  const ReferenceFrame now = reference_at(scene, build_initial_state(scene), time);
  Profile profile{"the scene's exact solution", {}, {}};
  for (std::size_t i = 0; i < now.depth.size(); ++i) {
    if (!std::isnan(now.depth[i])) {
      profile.x.push_back(scene.grid.x(static_cast<int>(i)));
      profile.depth.push_back(now.depth[i]);
    }
  }
  return profile;
}

FitReference scene_reference(const FitArguments& arguments, const Scene& scene, double time) {
  const Reference known = scene.reference.value_or(Reference{});
  if (arguments.at) {
    if (known.exact) {
      return profile_reference(exact_profile(scene, time), time, scene);
    }
  } else if (known.measured_front && !known.measured_front->time.empty()) {
    return front_reference(*known.measured_front, front_depth_of(arguments, scene), scene);
  } else if (known.measured_profile && !known.measured_profile->x.empty()) {
    return profile_reference(*known.measured_profile, time, scene);
  } else if (known.exact) {
    return exact_front_reference(arguments, scene);
  } else if (known.profile && !known.profile->x.empty()) {
    return profile_reference(*known.profile, time, scene);
  }
  throw SceneError(
      "fit: the scene names no reference that is there, so that there is nothing to fit to\n"
      "  name one: --front FILE.csv, --profile FILE.csv or --run DIR");
}

}  // namespace

std::string FitReference::description() const {
  if (kind == Kind::front) {
    const std::string where =
        front_depth > 0.0 ? fmt::format("where the depth crosses {:g} m", front_depth) : "its last wet cell";
    return fmt::format("front of {} points from {} ({})", place.size(), source, where);
  }
  return fmt::format("profile of {} points from {} at {:g} s", place.size(), source, time);
}

const char* FitReference::signal_name() const {
  return kind == Kind::front ? "travel of the front" : "largest depth";
}

FitReference read_fit_reference(const FitArguments& arguments, const Scene& scene) {
  const double time = arguments.at ? positive_option("--at", *arguments.at, Dimension::time, 0.0) : scene.time.end;
  if (!arguments.front.empty()) {
    return front_reference(read_front_csv(arguments.front), front_depth_of(arguments, scene), scene);
  }
  if (!arguments.profile.empty()) {
    return profile_reference(read_profile_csv(arguments.profile), time, scene);
  }
  if (arguments.run.empty()) {
    return scene_reference(arguments, scene, time);
  }
  if (arguments.at) {
    return profile_reference(read_run_profile(arguments.run, time), time, scene);
  }
  const double depth = front_depth_of(arguments, scene);
  return front_reference(read_run_front(arguments.run, depth), depth, scene);
}

}  // namespace sandsim::cli
