// The copy bandwidth of the machine: the floor that the step is judged by.
#pragma once

#include <cstddef>

#include "cli/measurement.hpp"

namespace sandsim::cli {

/// Bytes of each of the two arrays: at least four times the last-level cache, so that little of a pass is still in it
/// at the next one, and at most 1 GiB.
std::size_t copy_array_bytes(bool quick);

/// [B/s] read + written, copying one array of `array_bytes` to another with `threads` threads and ordinary stores.
/// (Lines that are written are read first by the hardware; that read is not counted. It is the same for the solver.)
Measurement measure_copy_bandwidth(std::size_t array_bytes, int threads, int repeats);

}  // namespace sandsim::cli
