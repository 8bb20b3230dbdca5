// What the machine is, as far as `devices` and `bench` say it.
#pragma once

#include <cstddef>
#include <string>

#include "solver/backends/cuda/cuda.hpp"

namespace sandsim::cli {

/// Model name of the processor, or "unknown processor".
std::string processor_name();

/// Threads at most of a run that is not told how many: one a processor.
int default_threads();

/// Processors that are there.
int processor_count();

/// Processes that run or want to, mean over the last minute; 0 if the system does not tell.
double load_average();

/// Widest vectors that sandsim was compiled for, e.g. "AVX-512 (512 bit)".
std::string vector_instructions();

/// [B] Size of the last-level cache, or 32 MiB if the system does not tell.
std::size_t last_level_cache();

/// [B] Memory that can be had without swapping, within the limits of control groups (containers, batch jobs) and of
/// `ulimit -v`; 0 if the system does not tell.
double available_memory();

/// The CUDA device in one line, or why there is none.
std::string cuda_line(const CudaSurvey& survey);

}  // namespace sandsim::cli
