// A machine for the particles of the CPU backend: the host, with the blocks of a launch on several threads. What
// threads do to one number at a time does not depend on their order.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "solver/backends/tiles/host_machine.hpp"

namespace sandsim::particles {

/// A block of threads that is carried out in turn by one thread of the host, beside other blocks.
class ThreadedBlock {
 public:
  /// `alone`: no other block runs meanwhile.
  ThreadedBlock(int width, int x, int y, bool alone) : width_(width), x_(x), y_(y), alone_(alone) {}

  int x() const { return x_; }
  int y() const { return y_; }
  int width() const { return width_; }

  template <class Phase>
  void each(const Phase& phase) {
    for (int x = 0; x < width_; ++x) {
      phase(x, 0);
    }
  }
  void raise(float* target, float value) {
    replace(target, value, [](float now, float better) { return now < better; });
  }
  void lower(std::int64_t* target, std::int64_t value) {
    replace(target, value, [](std::int64_t now, std::int64_t better) { return better < now; });
  }
  /// Reads what other blocks of the launch may have written.
  template <class T>
  T read(T* source) const {
    return std::atomic_ref(*source).load(std::memory_order_relaxed);
  }
  void add(std::int64_t* target, std::int64_t value) {
    if (alone_) {
      *target += value;
    } else {
      std::atomic_ref(*target).fetch_add(value, std::memory_order_relaxed);
    }
  }

 private:
  template <class T, class Better>
  void replace(T* target, T value, const Better& is_better) const {
    if (alone_) {
      *target = is_better(*target, value) ? value : *target;
      return;
    }
    const std::atomic_ref<T> shared(*target);
    T now = shared.load(std::memory_order_relaxed);
    while (is_better(now, value) && !shared.compare_exchange_weak(now, value, std::memory_order_relaxed)) {
    }
  }

  int width_, x_, y_;
  bool alone_;
};

class ThreadedMachine : public tiles::HostMachine {
 public:
  explicit ThreadedMachine(int threads) : threads_(threads) {}
  /// The number of threads from now on.
  void use(int threads) { threads_ = threads; }

  template <class Kernel>
  void launch(const Kernel& kernel, tiles::GridShape grid, tiles::BlockShape shape, std::size_t) {
#pragma omp parallel for num_threads(threads_) schedule(static) if (threads_ > 1)
    for (int x = 0; x < grid.x; ++x) {
      for (int y = 0; y < grid.y; ++y) {
        ThreadedBlock block(shape.width, x, y, threads_ == 1);
        kernel(block);
      }
    }
  }

 private:
  int threads_;
};

}  // namespace sandsim::particles
