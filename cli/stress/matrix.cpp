#include "cli/stress/matrix.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace sandsim::cli {

std::vector<StressCase> stress_matrix(int randoms) {
  const std::pair<const char*, std::vector<StressCase> (*)()> themes[] = {
      {"friction", friction_cases}, {"hbar", hbar_cases},         {"depth", depth_cases},      {"scale", scale_cases},
      {"terrain", terrain_cases},   {"velocity", velocity_cases}, {"step", step_cases},        {"grid", grid_cases},
      {"source", source_cases},     {"object", object_cases},     {"stopping", stopping_cases}};
  std::vector<StressCase> all;
  for (const auto& [theme, make] : themes) {
    for (StressCase& made : make()) {
      made.theme = theme;
      all.push_back(std::move(made));
    }
  }
  for (StressCase& made : random_cases(randoms)) {
    made.theme = "random";
    all.push_back(std::move(made));
  }
  return all;
}

std::vector<StressCase> quick_part(std::vector<StressCase> cases) {
  constexpr std::size_t every = 8;
  std::map<std::string, std::size_t> seen;
  std::map<std::string, std::pair<std::set<double>, std::set<double>>> places;
  for (const StressCase& each : cases) {
    if (each.place) {
      places[each.place->map].first.insert(each.place->x);
      places[each.place->map].second.insert(each.place->y);
    }
  }
  const auto is_landmark = [](const std::set<double>& values, double value) {
    return value == *values.begin() || value == *values.rbegin() ||
           value == *std::next(values.begin(), static_cast<std::ptrdiff_t>(values.size() / 2));
  };
  std::erase_if(cases, [&](const StressCase& each) {
    if (each.place) {
      const auto& [xs, ys] = places[each.place->map];
      return !is_landmark(xs, each.place->x) || !is_landmark(ys, each.place->y);
    }
    return seen[each.theme]++ % every != 0;
  });
  return cases;
}

}  // namespace sandsim::cli
