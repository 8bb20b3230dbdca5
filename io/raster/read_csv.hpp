// Measured or reference curves, and the paths of objects, from CSV files.
//
// The format: one line of column names, then one line a point. Columns are found by their names, in any order; every
// name below must be there once and no other. Fields are separated by commas and may have blanks around them; numbers
// have a decimal point and are finite. `#` starts a comment that runs to the end of the line; empty lines are skipped.
// The first column below ascends strictly; there are at least two points.
//
//   profile: x_m,depth_m         deposit or profile: position [m], depth of the sand normal to the bed [m]
//   front:   time_s,front_m      position of the front [m] over time [s]
//   path:    time_s,x_m,y_m,z_m  position of an object [m] over time [s]
//
// An example:
//   # Deposit, test 3, read off the laser scan
//   x_m,depth_m
//   0.00,0.153
//   0.10,0.121
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/scene.hpp"

namespace sandsim {

/// Reads a profile (columns x_m, depth_m); `file` of the result is the path. Throws InputError (file:line:col).
Profile read_profile_csv(const std::filesystem::path& path);
/// The same from memory; `name` stands for the file.
Profile read_profile_csv(std::string_view text, const std::string& name);

/// Reads a front curve (columns time_s, front_m); `file` of the result is the path. Throws InputError (file:line:col).
FrontCurve read_front_csv(const std::filesystem::path& path);
/// The same from memory; `name` stands for the file.
FrontCurve read_front_csv(std::string_view text, const std::string& name);

/// Reads a path (columns time_s, x_m, y_m, z_m); `file` of the result is the path. Throws InputError (file:line:col).
PathTable read_path_csv(const std::filesystem::path& path);
/// The same from memory; `name` stands for the file.
PathTable read_path_csv(std::string_view text, const std::string& name);

}  // namespace sandsim
