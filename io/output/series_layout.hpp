// The variables of series.h5: the one place that names them. Internal to io/output; interface.md is the public form.
#pragma once

#include <string>
#include <vector>

#include "solver/scene.hpp"

namespace sandsim {

enum class Dimension { time, y, x, probe, front_depth, object, particle, axis, quaternion };

/// `real` is the run's precision; `nothing` marks a dimension without coordinates.
enum class NumberType { real, float64, int64, int8, text, nothing };

struct Variable {
  std::string name;                   // of the data set
  std::vector<Dimension> dimensions;  // slowest first
  std::string units;                  // CF (UDUNITS); empty for names
  std::string long_name;
  NumberType type = NumberType::float64;

  bool over_time() const { return !dimensions.empty() && dimensions.front() == Dimension::time; }
  bool over_grid() const { return !dimensions.empty() && dimensions.back() == Dimension::x && dimensions.size() > 1; }
  /// A frame of it fills chunks of its own.
  bool in_chunks() const { return over_grid() || over_particles(); }
  bool over_particles() const { return dimensions.size() > 1 && dimensions[1] == Dimension::particle; }
  /// A variable of the name of its only dimension gives that dimension's coordinates.
  bool coordinate() const;
};

std::string name_of(Dimension dimension);

/// By this name the NetCDF library knows a dimension scale without coordinates.
inline constexpr const char* bare_dimension_name = "This is a netCDF dimension but not a netCDF variable.";

/// The variable without values that carries the CRS; only where the grid has one.
inline constexpr const char* grid_mapping_name = "crs";

/// Objects that have a place in every frame: all but those that are terrain.
std::size_t coupled_object_count(const Scene& scene);

/// All variables of a scene's series, coordinates first and `time` before those over time.
/// The map of the largest speed is `max_speed_over_time`, since `max_speed` is the largest speed of each frame.
std::vector<Variable> series_layout(const Scene& scene);

}  // namespace sandsim
