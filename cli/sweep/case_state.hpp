// How far the cases of a sweep are, from what lies in their folders.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/cases/case_pool.hpp"
#include "cli/cases/case_report.hpp"
#include "cli/sweep/sweep.hpp"

namespace sandsim::cli {

struct CaseState {
  enum class Kind { not_run, done, interrupted, failed };

  Kind kind = Kind::not_run;
  int exit_code = 0;                 // of the case; 0 if it has not run
  std::string status;                // "at rest", "done", "failed", "interrupted", "not run", ...
  std::string message;               // why it failed
  std::optional<CaseReport> report;  // none if it did not come as far as to write one
};

/// The state of a case as its folder has it. A finished case whose report has another scene hash than the sweep's was
/// run while its files changed: it counts as failed.
CaseState read_case_state(const Sweep& sweep, std::size_t index, const std::filesystem::path& directory);

/// The same after the pool has run it: the outcome knows of crashes and full disks that left no report.
CaseState case_state(const Sweep& sweep, std::size_t index, const std::filesystem::path& directory,
                     const CaseOutcome& outcome);

/// True if running the case once more could change its state: it has not run, or was interrupted, or failed for
/// reasons that lie outside of it (files, memory, disk, a kill). A scene that is invalid or breaks down numerically
/// would do so again, unless the program has changed: `retry` says so.
bool is_to_be_run(const CaseState& state, bool retry);

/// What the sweep's exit code is: 0 if all cases are done, else that of the first that failed, else 130 if one was
/// interrupted, else 3 (a result is missing).
ExitCode exit_code_of(const std::vector<CaseState>& states);

}  // namespace sandsim::cli
