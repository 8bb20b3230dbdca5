// The options of sandsim export.
#pragma once

#include "cli/options.hpp"

namespace CLI {
class App;
}

namespace sandsim::cli {

/// Adds the command; what it is told goes to `arguments`, which must outlive `app`.
void add_export(CLI::App& app, ExportArguments& arguments);

}  // namespace sandsim::cli
