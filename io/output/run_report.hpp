// run.json: the report of a run as one JSON document.
#pragma once

#include <string>

#include "solver/report.hpp"
#include "solver/scene.hpp"

namespace sandsim {

/// What the solver does not know about its run. Empty entries are left out.
struct RunContext {
  std::string title;
  std::string scene_file;  // as given by the user
  std::string scene_hash;  // see scene_hash.hpp
  std::string command_line;
  std::string started;  // wall clock, ISO 8601
  std::string output;   // the output directory
  Grid grid;            // gives x and y of the cells that are named
};

/// The keys are those of interface.md. Numbers that are not finite are null. `error` is the first reference's error,
/// `errors` the list of all; both are left out when the scene has no reference.
std::string run_report_json(const RunReport& report, const RunContext& context);

/// The moment now in UTC, e.g. "2026-01-31T23:59:59Z".
std::string time_stamp();

}  // namespace sandsim
