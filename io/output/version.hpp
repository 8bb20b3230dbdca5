// Which sandsim this is: for file headers and reports.
#pragma once

#include <string>

namespace sandsim {

/// Version of the source, e.g. "0.1.0".
std::string version();

/// Short hash of the commit that was built, or "unknown".
std::string commit();

/// Both in one line, as the attribute `source` of series.h5: "sandsim 0.1.0 (commit 0123456789ab)".
std::string source_line();

}  // namespace sandsim
