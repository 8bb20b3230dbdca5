// A CUDA device as a machine for tiles: memory, copies, launches, and loops of launches without the host. The same
// members as tiles::HostMachine has.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "solver/backends/cuda/check.cuh"
#include "solver/backends/cuda/device_block.cuh"
#include "solver/backends/tiles/block.hpp"

namespace sandsim::cuda {

class CudaMachine {
 public:
  /// Memory of the device, zero at first. Throws DeviceError with the size if there is too little.
  template <class T>
  class Array {
   public:
    Array() = default;
    Array(CudaMachine& machine, std::size_t count)
        : values_(static_cast<T*>(machine.allocate(count * sizeof(T))), &free_device), size_(count) {}
    T* data() const { return values_.get(); }
    std::size_t size() const { return size_; }

   private:
    std::unique_ptr<T, void (*)(void*)> values_{nullptr, &free_device};
    std::size_t size_ = 0;
  };
  /// Memory of the host that the device copies to and from by itself.
  template <class T>
  class HostArray {
   public:
    HostArray() = default;
    HostArray(CudaMachine& machine, std::size_t count)
        : values_(static_cast<T*>(machine.allocate_on_host(count * sizeof(T))), &free_host) {}
    T* data() const { return values_.get(); }

   private:
    std::unique_ptr<T, void (*)(void*)> values_{nullptr, &free_host};
  };
  /// A recorded loop of launches.
  class Loop {
   public:
    Loop() = default;
    ~Loop();
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

   private:
    friend class CudaMachine;
    cudaGraph_t graph_ = nullptr;
    cudaGraphExec_t executable_ = nullptr;
    bool repeats_itself_ = false;  // else the host looks after every launch of the graph
  };

  /// The first device. Throws DeviceError if there is none that can be used.
  CudaMachine();
  ~CudaMachine();
  CudaMachine(const CudaMachine&) = delete;
  CudaMachine& operator=(const CudaMachine&) = delete;

  std::string name() const { return name_; }
  int processors() const { return processors_; }
  std::size_t shared_bytes_a_block() const { return shared_bytes_a_block_; }
  std::size_t free_bytes() const;
  cudaStream_t stream() const { return stream_; }

  template <class T>
  void upload(T* to, const T* from, std::size_t count) {
    check(cudaMemcpyAsync(to, from, count * sizeof(T), cudaMemcpyHostToDevice, stream_), "copy to the device");
  }
  template <class T>
  void download(T* to, const T* from, std::size_t count) {
    check(cudaMemcpyAsync(to, from, count * sizeof(T), cudaMemcpyDeviceToHost, stream_), "copy from the device");
    check(cudaStreamSynchronize(stream_), "finish its work");
  }
  template <class T>
  void begin_copy(T* to, const T* from, std::size_t count) {
    if (count == 0) {
      return;
    }
    check(cudaEventRecord(made_, stream_), "note what was made");
    check(cudaStreamWaitEvent(copies_, made_), "wait for what was made");
    check(cudaMemcpyAsync(to, from, count * sizeof(T), cudaMemcpyDeviceToHost, copies_), "copy a frame");
  }
  void finish_copies() { check(cudaStreamSynchronize(copies_), "finish the copies of a frame"); }

  template <class Kernel>
  void launch(const Kernel& kernel, tiles::GridShape grid, tiles::BlockShape shape, std::size_t shared_bytes) {
    constexpr std::size_t without_asking = 48 << 10;  // of shared memory [B]
    if (shared_bytes > without_asking) {
      check(cudaFuncSetAttribute(run_kernel<Kernel>, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                 static_cast<int>(shared_bytes)),
            "reserve shared memory");
    }
    run_kernel<<<dim3(static_cast<unsigned>(grid.x), static_cast<unsigned>(grid.y)),
                 dim3(static_cast<unsigned>(shape.width), static_cast<unsigned>(shape.strips)), shared_bytes,
                 stream_>>>(kernel, recording_);
    check(cudaGetLastError(), Kernel::doing);
  }

  /// Launches what `body` launches, again and again, as long as *go is not 0; waits for the end. `body` is recorded
  /// once and has to launch the same each time.
  template <class Body, class Meanwhile>
  void repeat(Loop& loop, const Body& body, const int* go, const Meanwhile& meanwhile) {
    if (loop.executable_ == nullptr && !(drivers_loops_ && record_loop(loop, body))) {
      record_batch(loop, body);
    }
    launch_loop(loop);
    meanwhile();
    while (!loop.repeats_itself_ && read(go) != 0) {
      launch_loop(loop);
    }
  }

 private:
  static void free_device(void* memory) { cudaFree(memory); }
  static void free_host(void* memory) { cudaFreeHost(memory); }
  void* allocate(std::size_t bytes);
  void* allocate_on_host(std::size_t bytes);
  int read(const int* value);
  void launch_loop(const Loop& loop) { check(cudaGraphLaunch(loop.executable_, stream_), "start a loop of steps"); }

  /// A graph whose only node repeats the body. False if this driver cannot do it.
  template <class Body>
  bool record_loop(Loop& loop, const Body& body) {
    constexpr int bodies = 4;  // a turn of the loop; launches behind the last step find nothing to do
    cudaGraph_t turn = begin_loop(loop);
    if (turn == nullptr) {
      return false;
    }
    check(cudaStreamBeginCaptureToGraph(stream_, turn, nullptr, nullptr, 0, cudaStreamCaptureModeThreadLocal),
          "record a step");
    for (int k = 0; k < bodies; ++k) {
      body();
    }
    return end_loop(loop);
  }
  template <class Body>
  void record_batch(Loop& loop, const Body& body) {
    constexpr int bodies = 16;
    check(cudaStreamBeginCapture(stream_, cudaStreamCaptureModeThreadLocal), "record a step");
    for (int k = 0; k < bodies; ++k) {
      body();
    }
    end_batch(loop);
  }
  cudaGraph_t begin_loop(Loop& loop);
  bool end_loop(Loop& loop);
  void end_batch(Loop& loop);

  std::string name_;
  int processors_ = 1;
  std::size_t shared_bytes_a_block_ = 0;
  bool drivers_loops_ = false;  // whether the driver repeats graphs by itself
  cudaStream_t stream_ = nullptr, copies_ = nullptr;
  cudaEvent_t made_ = nullptr;
  cudaGraphConditionalHandle recording_ = 0;  // of the loop that is being recorded
};

}  // namespace sandsim::cuda
