#include "cli/option_value.hpp"

#include <fmt/format.h>

#include "solver/errors.hpp"

namespace sandsim::cli {

double quantity_option(const std::string& option, const std::string& text, Dimension dimension, double cell) {
  const Parsed<double> parsed = parse_quantity(text, dimension, cell, example(dimension));
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) {
    throw Error(ExitCode::usage, fmt::format("{} {}: {}. {}", option, text, complaint->problem, complaint->suggestion));
  }
  return std::get<double>(parsed);
}

double positive_option(const std::string& option, const std::string& text, Dimension dimension, double cell) {
  const double value = quantity_option(option, text, dimension, cell);
  if (!(value > 0.0)) {
    throw Error(ExitCode::usage, fmt::format("{} {}: not above 0", option, text));
  }
  return value;
}

}  // namespace sandsim::cli
