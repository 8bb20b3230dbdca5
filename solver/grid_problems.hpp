// Problems of values on the grid, collected so that a scene reports all of them at once.
#pragma once

#include <string>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

/// A number for a message: up to 9 digits.
std::string number_text(double value);

/// Where the grid lies, for a message: "the grid spans x from 0 m to 1 m", and y with more than one row.
std::string grid_text(const Grid& grid);

/// "terrain", or "terrain.2" where it is a list.
std::string entry_key(const std::string& list, std::size_t index, std::size_t size);

/// "scene.yaml:7:30: terrain"; without the place where none is known.
std::string at_place(const std::string& place, const std::string& key);

/// "scene.yaml:7:30: terrain.file = dem.asc" likewise.
std::string file_subject(const RasterFile& file, const std::string& key);
std::string file_subject(const PolygonFile& file, const std::string& key);

class GridProblems {
 public:
  explicit GridProblems(const Grid& grid) : grid_(grid) {}

  /// One problem of the entry `key` of the scene.
  void add(const std::string& key, const std::string& problem);

  /// Whether the raster can be put onto the grid; else there is a problem.
  bool check_fit(const RasterFile& file, const std::string& key);

  bool empty() const { return lines_.empty(); }

  /// One problem for all cells at which `bad` holds: how many they are, the first one and its value. `values` has
  /// ny * nx entries, or one for the whole grid. Returns whether there are such cells.
  template <typename Predicate>
  bool add_cells(const std::string& key, const std::vector<double>& values, Predicate bad, const std::string& problem,
                 const std::string& suggestion = "") {
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t cell = values.size(); cell-- > 0;) {
      if (bad(values[cell])) {
        ++count;
        first = cell;
      }
    }
    if (count > 0) {
      describe_cells(key, values, count, first, problem, suggestion);
    }
    return count > 0;
  }

  /// Throws SceneError with all problems, one a line, if there are any.
  void throw_if_any() const;

 private:
  void describe_cells(const std::string& key, const std::vector<double>& values, std::size_t count, std::size_t first,
                      const std::string& problem, const std::string& suggestion);

  Grid grid_;
  std::string lines_;
};

}  // namespace sandsim
