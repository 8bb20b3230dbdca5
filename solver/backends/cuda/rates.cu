#include <memory>

#include "solver/backends/cuda/check.cuh"
#include "solver/backends/cuda/cuda.hpp"
#include "solver/backends/cuda/rates.hpp"

namespace sandsim {
namespace {

using cuda::check;

constexpr int block_threads = 256;

class Event {
 public:
  Event() { check(cudaEventCreate(&event_), "make an event"); }
  ~Event() { cudaEventDestroy(event_); }
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;
  cudaEvent_t get() const { return event_; }

 private:
  cudaEvent_t event_ = nullptr;
};

void free_device(void* memory) {
  cudaFree(memory);
}

template <class T>
using DeviceArray = std::unique_ptr<T, void (*)(void*)>;

template <class T>
DeviceArray<T> allocate(std::size_t count) {
  void* memory = nullptr;
  check(cudaMalloc(&memory, count * sizeof(T)), "allocate memory for a measurement");
  return {static_cast<T*>(memory), &free_device};
}

/// `work` per second of the device, one rate a repeat. `launch` starts it on the default stream; a first, untimed one
/// loads the code.
template <class Launch>
std::vector<double> measure(double work, int repeats, const Launch& launch) {
  const Event begin, end;
  launch();
  std::vector<double> rates;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    float milliseconds = 0;
    check(cudaEventRecord(begin.get()), "note the time");
    launch();
    check(cudaEventRecord(end.get()), "note the time");
    check(cudaEventSynchronize(end.get()), "finish a measurement");
    check(cudaEventElapsedTime(&milliseconds, begin.get(), end.get()), "tell the time");
    rates.push_back(work / (1e-3 * static_cast<double>(milliseconds)));
  }
  return rates;
}

int usable_processors() {
  const CudaSurvey survey = survey_cuda();
  if (!survey.problem.empty()) {
    throw DeviceError(survey.problem);
  }
  return survey.processors;
}

__global__ void copy_words(const uint4* from, uint4* to, std::size_t count) {
  const std::size_t k = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (k < count) {
    to[k] = from[k];
  }
}

constexpr int chains = 8;  // independent results: enough to hide the latency of an operation

struct AddAndMultiply {
  static constexpr int rounds = 65536;  // a few milliseconds
  template <class R>
  __device__ static void round(R (&values)[chains]) {
#pragma unroll
    for (int k = 0; k < chains; ++k) {
      values[k] = k % 2 == 0 ? values[k] + R(1e-3f) : values[k] * R(0.999f);
    }
  }
};

struct DivideAndRoot {
  static constexpr int rounds = 4096;
  template <class R>
  __device__ static void round(R (&values)[chains]) {
#pragma unroll
    for (int k = 0; k < chains; ++k) {
      values[k] = k % 2 == 0 ? R(2) / values[k] : sqrt(values[k]);
    }
  }
};

/// Every operation of a round depends on the round before only. The sums keep the compiler from dropping the work.
template <class R, class Kind>
__global__ void calculate(R* sums, int rounds) {
  const unsigned thread = blockIdx.x * blockDim.x + threadIdx.x;
  R values[chains];
  for (int k = 0; k < chains; ++k) {
    values[k] = R(1.5f) + R(1e-6f) * static_cast<R>(thread % 1024u + static_cast<unsigned>(k));
  }
#pragma unroll 8
  for (int n = 0; n < rounds; ++n) {
    Kind::round(values);
  }
  R sum = 0;
  for (int k = 0; k < chains; ++k) {
    sum = sum + values[k];
  }
  sums[thread] = sum;
}

template <class R, class Kind>
std::vector<double> measure_kind(int processors, int repeats) {
  const int blocks = processors * 8;  // 2048 threads a processor, as many as it holds
  const auto threads = static_cast<std::size_t>(blocks) * block_threads;
  const DeviceArray<R> sums = allocate<R>(threads);
  const double operations = static_cast<double>(threads) * chains * Kind::rounds;
  return measure(operations, repeats, [&] {
    calculate<R, Kind><<<blocks, block_threads>>>(sums.get(), Kind::rounds);
    check(cudaGetLastError(), "calculate");
  });
}

template <class R>
CudaArithmeticRates measure_in(int repeats) {
  const int processors = usable_processors();
  return {measure_kind<R, AddAndMultiply>(processors, repeats), measure_kind<R, DivideAndRoot>(processors, repeats)};
}

}  // namespace

CudaCopyRates measure_cuda_copies(std::size_t array_bytes, int repeats) {
  usable_processors();
  const std::size_t count = array_bytes / sizeof(uint4), bytes = count * sizeof(uint4);
  const DeviceArray<uint4> from = allocate<uint4>(count), to = allocate<uint4>(count);
  check(cudaMemset(from.get(), 0x3f, bytes), "fill memory");
  const double work = 2.0 * static_cast<double>(bytes);
  CudaCopyRates rates;
  rates.runtime = measure(work, repeats, [&] {
    check(cudaMemcpyAsync(to.get(), from.get(), bytes, cudaMemcpyDeviceToDevice), "copy its memory");
  });
  const auto blocks = static_cast<unsigned>((count + block_threads - 1) / block_threads);
  rates.kernel = measure(work, repeats, [&] {
    copy_words<<<blocks, block_threads>>>(from.get(), to.get(), count);
    check(cudaGetLastError(), "copy its memory");
  });
  return rates;
}

CudaArithmeticRates measure_cuda_arithmetic(Precision precision, int repeats) {
  return precision == Precision::float32 ? measure_in<float>(repeats) : measure_in<double>(repeats);
}

}  // namespace sandsim
