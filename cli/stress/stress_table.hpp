// What the runs of the stress matrix gave, as tables.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/stress/criteria.hpp"
#include "cli/stress/measure.hpp"
#include "cli/stress/stress_case.hpp"

namespace sandsim::cli {

/// One case in one scheme and precision.
struct StressRow {
  std::size_t index = 0;  // of the case
  Variant variant;
  Measurement measured;
  std::vector<Finding> findings;  // empty: it passed
  bool is_known = false;          // failed, and the case says why

  bool passed() const { return findings.empty(); }
  /// "pass", "known" or "FAIL".
  const char* verdict() const { return passed() ? "pass" : is_known ? "known" : "FAIL"; }
  /// "volume, speed".
  std::string failed_criteria() const;
};

/// All rows of some cases. Rows follow the cases, and all_variants() within each.
struct StressTable {
  std::vector<StressCase> cases;
  std::vector<StressRow> rows;
  std::string device;

  bool passed() const;
};

/// One line a row, with a header. Columns: theme, case, scheme, order, precision, device, verdict, failed, steps,
/// volume_error, max_speed [m/s], relative_speed [E], dt_min [s], relative_step [dx/E], wall_time [s], exit_code,
/// message; for the cells of maps `map,x,y` instead of `theme,case`.
std::string stress_csv(const StressTable& table);
std::string maps_csv(const StressTable& table);

/// One line a case with a column a variant, then the reasons of the failures that are known.
std::string stress_markdown(const StressTable& table);

/// How many passed, by theme and variant, as lines of a Markdown table.
std::string count_markdown(const StressTable& table);

/// The counts and every failure, for people.
void print_counts(std::ostream& out, const StressTable& table, const std::string& name);
void print_failures(std::ostream& out, const StressTable& table);

}  // namespace sandsim::cli
