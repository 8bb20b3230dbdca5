// The command line as a function that tests call in-process.
#pragma once

#include <iosfwd>
#include <span>
#include <string>

namespace sandsim::cli {

/// Exit code of an error that no one foresaw: a bug in sandsim, not in what it was given (EX_SOFTWARE of sysexits.h).
inline constexpr int internal_error = 70;

/// Runs `sandsim ARGS...` and returns its exit code; throws nothing. Results go to `out`; errors, warnings and the
/// progress bar to `err`. The bar is drawn only if `err` is std::cerr and standard error is a terminal.
int run_app(std::span<const std::string> args, std::ostream& out, std::ostream& err);

}  // namespace sandsim::cli
