#include "solver/backends/cpu/instances.hpp"

template std::unique_ptr<sandsim::Backend> sandsim::cpu::make_paper<double>(const BackendConfig&, const InitialState&);
