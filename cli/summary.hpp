// The report of a run on one screen.
#pragma once

#include <string>

#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim::cli {

/// Lines of "name  value", the last of them the files.
std::string run_summary(const Scene& scene, const RunReport& report, const std::string& files);

}  // namespace sandsim::cli
