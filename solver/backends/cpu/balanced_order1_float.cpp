#include "solver/backends/cpu/instances.hpp"

template std::unique_ptr<sandsim::Backend> sandsim::cpu::make_balanced<float, 1>(const BackendConfig&,
                                                                                 const InitialState&);
