// What the bench measures on: the processor or a CUDA device, behind the same few questions.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "cli/arithmetic_rate.hpp"
#include "cli/bench_step.hpp"
#include "cli/measurement.hpp"

namespace sandsim::cli {

struct BenchDevice {
  Device device = Device::cpu;  // cpu or cuda
  std::string name;             // of the processor or the card
  std::string details;          // for the head of the table
  std::string copies;           // how the copies are done
  int threads = 1;              // of the host
  double steps_at_once = 0.0;   // [cell-steps] that make a measurement of some tenths of a second
  std::function<Measurement(std::size_t array_bytes, int repeats)> copy_bandwidth;  // [B/s] read + written
  std::function<ArithmeticRate(Precision precision, int repeats)> arithmetic;
  MakeBackend make;
  MakeEnsemble make_ensemble;  // empty where runs do not go side by side in a launch
};

BenchDevice cpu_bench_device(int threads);
/// Throws DeviceError if no device can be used.
BenchDevice cuda_bench_device();

}  // namespace sandsim::cli
