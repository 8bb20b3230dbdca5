#include <ostream>

#include "cli/commands.hpp"
#include "io/scene/format_reference.hpp"
#include "io/scene/json_schema.hpp"

namespace sandsim::cli {

ExitCode schema_command(const SchemaArguments& arguments, Console& console) {
  console.out << (arguments.reference ? format_reference() : json_schema());
  return ExitCode::done;
}

}  // namespace sandsim::cli
