// A backend for flat ground with objects that are bed where they cover sand: it steps without a bed until one of them
// reaches the sand for the first time.
#pragma once

#include <functional>
#include <memory>

#include "solver/backend.hpp"

namespace sandsim {

using MakeBackend = std::function<std::unique_ptr<Backend>(const BackendConfig&)>;

/// `make` makes the backend that does the work, with config.covers off and, when the time has come, on.
std::unique_ptr<Backend> make_bed_on_demand(const BackendConfig& config, const MakeBackend& make);

}  // namespace sandsim
