#include "solver/grid_problems.hpp"

#include <locale>
#include <sstream>

#include "solver/errors.hpp"

namespace sandsim {

std::string number_text(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(9);
  text << value;
  return text.str();
}

std::string grid_text(const Grid& grid) {
  const auto span = [&](std::size_t k) {
    return std::string(k == 0 ? "x" : "y") + " from " + number_text(grid.origin[k]) + " m to " +
           number_text(grid.origin[k] + grid.cells[k] * grid.spacing) + " m";
  };
  return "the grid spans " + span(0) + (grid.one_dimensional() ? "" : " and " + span(1));
}

void GridProblems::add(const std::string& key, const std::string& problem) {
  lines_ += (lines_.empty() ? "" : "\n") + key + ": " + problem;
}

void GridProblems::describe_cells(const std::string& key, const std::vector<double>& values, std::size_t count,
                                  std::size_t first, const std::string& problem) {
  if (values.size() == 1 && grid_.cell_count() != 1) {
    add(key + " = " + number_text(values[0]), problem);
    return;
  }
  const auto nx = static_cast<std::size_t>(grid_.cells[0]);
  const int i = static_cast<int>(first % nx);
  const int j = static_cast<int>(first / nx);
  add(key, problem + " in " + std::to_string(count) + " of " + std::to_string(values.size()) +
               " cells, the first is cell (" + std::to_string(i) + ", " + std::to_string(j) +
               ") at x = " + number_text(grid_.x(i)) + " m, y = " + number_text(grid_.y(j)) + " m with " +
               number_text(values[first]));
}

void GridProblems::throw_if_any() const {
  if (!lines_.empty()) {
    throw SceneError(lines_);
  }
}

}  // namespace sandsim
