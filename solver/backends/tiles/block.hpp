// A block of threads as the tile kernels see it, carried out on the host. A kernel is written once, in phases: each(f)
// calls f for every thread of the block and then waits for all of them. On a device (cuda/device_block.cuh) the
// threads run side by side; here they run one after the other, with the same results as long as no thread reads in a
// phase what another one writes in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sandsim::tiles {

/// Threads of a block: `width` along a row of cells, `strips` of them side by side.
struct BlockShape {
  int width = 1;
  int strips = 1;

  int threads() const { return width * strips; }
};

/// Blocks of a launch.
struct GridShape {
  int x = 1;
  int y = 1;
};

class HostBlock {
 public:
  /// A value of each thread that lives from phase to phase.
  template <class T>
  class PerThread {
   public:
    explicit PerThread(const HostBlock& block)
        : width_(block.width()), values_(static_cast<std::size_t>(block.shape_.threads())) {}
    T& operator()(int x, int strip) { return values_[static_cast<std::size_t>(strip * width_ + x)]; }

   private:
    int width_;
    std::vector<T> values_;
  };

  /// The block at (x, y) of `grid`; `shared` is aligned for any number.
  HostBlock(BlockShape shape, GridShape grid, int x, int y, std::byte* shared)
      : shape_(shape), grid_(grid), x_(x), y_(y), shared_(shared) {}

  int x() const { return x_; }
  int y() const { return y_; }
  int width() const { return shape_.width; }
  int strips() const { return shape_.strips; }
  int blocks() const { return grid_.x * grid_.y; }

  template <class Phase>
  void each(Phase phase) {
    for (int strip = 0; strip < shape_.strips; ++strip) {
      for (int x = 0; x < shape_.width; ++x) {
        phase(x, strip);
      }
    }
  }
  /// Memory that the threads of the block share.
  template <class T>
  T* shared() {
    return reinterpret_cast<T*>(shared_);
  }

  /// To be called in a phase, by any thread: *target = max(*target, value), the values not negative.
  template <class R>
  void raise(R* target, R value) {
    *target = *target < value ? value : *target;
  }
  void set_bits(int* target, int bits) { *target |= bits; }
  void lower(std::int64_t* target, std::int64_t value) { *target = value < *target ? value : *target; }
  void add(std::int64_t* target, std::int64_t value) { *target += value; }
  /// Reads what other blocks of the launch may have written.
  template <class T>
  T read(const T* source) {
    return *source;
  }

  /// To be called between phases: whether all other blocks of the launch have come this far. True for one block.
  bool last(unsigned* arrived) {
    *arrived += 1;
    if (*arrived < static_cast<unsigned>(blocks())) {
      return false;
    }
    *arrived = 0;
    return true;
  }
  /// Whether the launches around this one are to be repeated: the host's loop looks for itself.
  void repeat(bool) {}

 private:
  BlockShape shape_;
  GridShape grid_;
  int x_, y_;
  std::byte* shared_;
};

}  // namespace sandsim::tiles
