// The report of a run on one screen.
#pragma once

#include <string>

#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// "1000 m^3 of sand, 500 m^3 of them on the grid, ...": where the initial sand of the scene is.
std::string release_text(const ReleaseReport& release);

/// Lines of "name  value", the last of them the files.
std::string run_summary(const Scene& scene, const RunReport& report, const std::string& files);

}  // namespace sandsim::cli
