#include "solver/grid_problems.hpp"

#include <locale>
#include <sstream>

#include "solver/errors.hpp"
#include "solver/resample.hpp"

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

std::string entry_key(const std::string& list, std::size_t index, std::size_t size) {
  return size == 1 ? list : list + "." + std::to_string(index);
}

std::string at_place(const std::string& place, const std::string& key) {
  return (place.empty() ? "" : place + ": ") + key;
}

std::string file_subject(const RasterFile& file, const std::string& key) {
  return at_place(file.place, key) + " = " + file.file;
}

std::string file_subject(const PolygonFile& file, const std::string& key) {
  return at_place(file.place, key) + " = " + file.file;
}

void GridProblems::add(const std::string& key, const std::string& problem) {
  lines_ += (lines_.empty() ? "" : "\n") + key + ": " + problem;
}

bool GridProblems::check_fit(const RasterFile& file, const std::string& key) {
  const Raster& raster = *file.data;
  if (fits(raster, grid_)) {
    return true;
  }
  const auto size = [](auto nx, auto ny) { return std::to_string(nx) + " x " + std::to_string(ny); };
  add(file_subject(file, key), "the raster has " + size(raster.nx, raster.ny) + " values, the grid " +
                                   size(grid_.cells[0], grid_.cells[1]) +
                                   " cells (a file that carries no position must have the grid's size). Use an ESRI "
                                   "ASCII grid, which is resampled, or change grid.cells");
  return false;
}

void GridProblems::describe_cells(const std::string& key, const std::vector<double>& values, std::size_t count,
                                  std::size_t first, const std::string& problem, const std::string& suggestion) {
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
               number_text(values[first]) + (suggestion.empty() ? "" : ". " + suggestion));
}

void GridProblems::throw_if_any() const {
  if (!lines_.empty()) {
    throw SceneError(lines_);
  }
}

}  // namespace sandsim
