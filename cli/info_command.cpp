#include <ostream>

#include "cli/commands.hpp"
#include "io/output/result_info.hpp"

namespace sandsim::cli {

ExitCode info_command(const InfoArguments& arguments, Console& console) {
  console.out << describe_result(arguments.result);
  return ExitCode::done;
}

}  // namespace sandsim::cli
