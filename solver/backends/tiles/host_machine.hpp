// A machine for tiles that is this very host, one block after the other: what runs on a device can be tested without
// one. The same members as cuda/cuda_machine.cuh has.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "solver/backends/tiles/block.hpp"

namespace sandsim::tiles {

class HostMachine {
 public:
  /// Memory of the machine, zero at first.
  template <class T>
  class Array {
   public:
    Array() = default;
    Array(HostMachine&, std::size_t count) : values_(std::make_unique<T[]>(count)), size_(count) {}
    T* data() const { return values_.get(); }
    std::size_t size() const { return size_; }

   private:
    std::unique_ptr<T[]> values_;
    std::size_t size_ = 0;
  };
  /// Memory of the host that the machine copies to.
  template <class T>
  using HostArray = Array<T>;

  /// Nothing is recorded.
  struct Loop {};

  std::string name() const { return "tiles on the host"; }
  int processors() const { return 1; }
  /// As a block of a large device has.
  std::size_t shared_bytes_a_block() const { return 227 << 10; }
  std::size_t free_bytes() const { return std::numeric_limits<std::size_t>::max(); }

  template <class T>
  void upload(T* to, const T* from, std::size_t count) {
    std::copy_n(from, count, to);
  }
  template <class T>
  void download(T* to, const T* from, std::size_t count) {
    std::copy_n(from, count, to);
  }
  /// Copies to the host what the launches so far make, while later launches run; finish_copies() waits for it.
  template <class T>
  void begin_copy(T* to, const T* from, std::size_t count) {
    std::copy_n(from, count, to);
  }
  void finish_copies() {}

  template <class Kernel>
  void launch(const Kernel& kernel, GridShape grid, BlockShape shape, std::size_t shared_bytes) {
    // Whatever was there before: a kernel must not rely on it.
    std::vector<std::max_align_t> shared(shared_bytes / sizeof(std::max_align_t) + 1);
    std::memset(shared.data(), 0xff, shared.size() * sizeof(std::max_align_t));
    for (int y = 0; y < grid.y; ++y) {
      for (int x = 0; x < grid.x; ++x) {
        HostBlock block(shape, grid, x, y, reinterpret_cast<std::byte*>(shared.data()));
        kernel(block);
      }
    }
  }
  /// Launches what `body` launches, again and again, as long as *go is not 0. `body` must launch the same each time.
  template <class Body, class Meanwhile>
  void repeat(Loop&, const Body& body, const int* go, const Meanwhile& meanwhile) {
    meanwhile();
    while (*go != 0) {
      body();
    }
  }
};

}  // namespace sandsim::tiles
