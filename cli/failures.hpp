// Exceptions into messages and exit codes.
#pragma once

#include <iosfwd>
#include <string>

namespace sandsim::cli {

struct Failure {
  int exit_code = 0;
  std::string message;  // may have several lines; indented ones continue the line before
};

/// What the exception that is being handled means to the user. Call it in a catch block.
Failure current_failure();

/// Writes "sandsim: error: ..." for each line of the message.
void print_error(std::ostream& err, const std::string& message);

}  // namespace sandsim::cli
