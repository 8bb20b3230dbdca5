#include "solver/backends/cpu/instances.hpp"

template std::unique_ptr<sandsim::Backend> sandsim::cpu::make_paper<float>(const BackendConfig&, const InitialState&);
