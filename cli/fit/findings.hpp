// What a fit found, in words and tables.
#pragma once

#include <string>
#include <vector>

#include "cli/fit/search.hpp"
#include "io/output/table_file.hpp"

namespace sandsim::cli {

/// What a range says of its parameter.
enum class Knowledge {
  known,           // both ends lie between the bounds
  at_least,        // everything up to the upper bound fits
  at_most,         // everything down to the lower bound fits
  nothing,         // everything between the bounds fits
  on_lower_bound,  // the best value is the bound, and the fit gets worse away from it: it may lie beyond
  on_upper_bound,
};
Knowledge knowledge_of(const FitResult& result, std::size_t parameter);

/// What the fit is about: enough for every text about it.
struct FitReport {
  const std::vector<FitParameter>& parameters;
  const FitReference& reference;
  const FitResult& result;
  std::string scene;
  std::string command_line;
  std::string tolerance_reason;  // "1 % of the travel of the front"
  double seconds = 0.0;          // [s] of wall clock
};

/// What the data tell, and what they do not, one sentence an entry.
std::vector<std::string> fit_words(const FitReport& report);

/// The table for a terminal, with the words.
std::string fit_summary(const FitReport& report);

/// fit.yaml.
std::string fit_yaml(const FitReport& report);

/// fit.csv or map.csv: a row an evaluation.
Table fit_table(const std::vector<FitParameter>& parameters, const std::vector<Evaluation>& evaluations,
                const FitReference& reference);

}  // namespace sandsim::cli
