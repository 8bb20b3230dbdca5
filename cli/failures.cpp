#include "cli/failures.hpp"

#include <filesystem>
#include <new>
#include <ostream>
#include <sstream>

#include "cli/app.hpp"
#include "io/output/version.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

Failure current_failure() {
  try {
    throw;
  } catch (const Error& error) {
    return {static_cast<int>(error.code()), error.what()};
  } catch (const std::bad_alloc&) {
    return {static_cast<int>(ExitCode::device),
            "out of memory: make the grid smaller, or run on a machine with more memory"};
  } catch (const std::filesystem::filesystem_error& error) {
    return {static_cast<int>(ExitCode::output), error.what()};
  } catch (const std::exception& error) {
    return {internal_error, std::string("internal error: ") + error.what() + "\n  This is a bug in " + source_line() +
                                ": please report it with the scene and log.txt"};
  }
}

void print_error(std::ostream& err, const std::string& message) {
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    err << (line.starts_with(' ') ? "" : "sandsim: error: ") << line << '\n';
  }
  err << std::flush;
}

}  // namespace sandsim::cli
