#include "solver/backends/cpu/instances.hpp"

template std::unique_ptr<sandsim::Backend> sandsim::cpu::make_balanced<double, 2>(const BackendConfig&,
                                                                                  const InitialState&);
