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

class GridProblems {
 public:
  explicit GridProblems(const Grid& grid) : grid_(grid) {}

  /// One problem of the entry `key` of the scene.
  void add(const std::string& key, const std::string& problem);

  /// One problem for all cells at which `bad` holds: how many they are, the first one and its value. `values` has
  /// ny * nx entries, or one for the whole grid. Returns whether there are such cells.
  template <typename Predicate>
  bool add_cells(const std::string& key, const std::vector<double>& values, Predicate bad, const std::string& problem) {
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t cell = values.size(); cell-- > 0;) {
      if (bad(values[cell])) {
        ++count;
        first = cell;
      }
    }
    if (count > 0) {
      describe_cells(key, values, count, first, problem);
    }
    return count > 0;
  }

  /// Throws SceneError with all problems, one a line, if there are any.
  void throw_if_any() const;

 private:
  void describe_cells(const std::string& key, const std::vector<double>& values, std::size_t count, std::size_t first,
                      const std::string& problem);

  Grid grid_;
  std::string lines_;
};

}  // namespace sandsim
