// A block of threads on a device, with the members of tiles::HostBlock: phases, shared memory, atomics.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

namespace sandsim::cuda {

extern __shared__ __align__(16) unsigned char block_memory[];

class DeviceBlock {
 public:
  /// A value of each thread: registers.
  template <class T>
  class PerThread {
   public:
    __device__ __forceinline__ explicit PerThread(const DeviceBlock&) {}
    __device__ __forceinline__ T& operator()(int, int) { return value_; }

   private:
    T value_{};
  };

  /// `loop` is the handle of the loop that the launch is in, or 0.
  __device__ __forceinline__ explicit DeviceBlock(cudaGraphConditionalHandle loop) : loop_(loop) {}

  __device__ __forceinline__ int x() const { return static_cast<int>(blockIdx.x); }
  __device__ __forceinline__ int y() const { return static_cast<int>(blockIdx.y); }
  __device__ __forceinline__ int width() const { return static_cast<int>(blockDim.x); }
  __device__ __forceinline__ int strips() const { return static_cast<int>(blockDim.y); }
  __device__ __forceinline__ int blocks() const { return static_cast<int>(gridDim.x * gridDim.y); }

  template <class Phase>
  __device__ __forceinline__ void each(const Phase& phase) {
    phase(static_cast<int>(threadIdx.x), static_cast<int>(threadIdx.y));
    __syncthreads();
  }
  template <class T>
  __device__ __forceinline__ T* shared() {
    return reinterpret_cast<T*>(block_memory);
  }

  /// Numbers that are not negative are ordered as their bits are.
  __device__ __forceinline__ void raise(float* target, float value) {
    atomicMax(reinterpret_cast<int*>(target), __float_as_int(value));
  }
  __device__ __forceinline__ void raise(double* target, double value) {
    atomicMax(reinterpret_cast<long long*>(target), __double_as_longlong(value));
  }
  __device__ __forceinline__ void set_bits(int* target, int bits) {
    if (bits != 0) {
      atomicOr(target, bits);
    }
  }
  __device__ __forceinline__ void lower(std::int64_t* target, std::int64_t value) {
    static_assert(sizeof(long long) == sizeof(std::int64_t));
    atomicMin(reinterpret_cast<long long*>(target), static_cast<long long>(value));
  }
  __device__ __forceinline__ void add(std::int64_t* target, std::int64_t value) {
    atomicAdd(reinterpret_cast<unsigned long long*>(target), static_cast<unsigned long long>(value));
  }
  /// Past the cache of this processor, which does not see what others write.
  template <class T>
  __device__ __forceinline__ T read(const T* source) {
    return *static_cast<const volatile T*>(source);
  }

  __device__ __forceinline__ bool last(unsigned* arrived) {
    __shared__ bool is_last;
    __threadfence();  // what this thread has written is there for all before its block is counted
    __syncthreads();
    if (threadIdx.x == 0 && threadIdx.y == 0) {
      is_last = atomicAdd(arrived, 1u) == gridDim.x * gridDim.y - 1u;
      if (is_last) {
        *arrived = 0;
      }
    }
    __syncthreads();
    __threadfence();
    return is_last;
  }
  __device__ __forceinline__ void repeat(bool again) {
    if (loop_ != 0) {
      cudaGraphSetConditional(loop_, again ? 1u : 0u);
    }
  }

 private:
  cudaGraphConditionalHandle loop_;
};

/// Runs a kernel object of tiles/kernels.hpp.
template <class Kernel>
__global__ void __launch_bounds__(Kernel::most_threads)
    run_kernel(const __grid_constant__ Kernel kernel, cudaGraphConditionalHandle loop) {
  DeviceBlock block(loop);
  kernel(block);
}

}  // namespace sandsim::cuda
