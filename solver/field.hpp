// Arrays on the grid with a halo: owning field and trivially copyable view.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#include "solver/physics/math.hpp"

namespace sandsim {

/// Two layers of cells around the grid: the second-order stencil reaches two cells far.
inline constexpr int halo = 2;

/// Row access to a field; row(j)[i] for -halo <= i < nx + halo and -halo <= j < ny + halo. A stride of 0 repeats one
/// row for all j: a uniform value costs a row that stays in cache.
template <class R>
struct FieldView {
  R* origin = nullptr;
  std::ptrdiff_t stride = 0;

  SANDSIM_HD R* row(std::ptrdiff_t j) const { return origin + j * stride; }
};

/// Owns nx * ny values and their halo; rows start on a cache line.
template <class R>
class Field {
 public:
  Field() = default;
  /// All values, the halo's too, are `value`. rows = 1 with repeat_row makes a field of one repeated row.
  Field(int nx, int ny, R value, bool repeat_row = false) {
    constexpr std::ptrdiff_t line = static_cast<std::ptrdiff_t>(64 / sizeof(R));
    // A full line before column 0, and two behind the halo: loops over packs of cells may read and write past the end.
    const std::ptrdiff_t width = (line + nx + halo + 2 * line + line - 1) / line * line;
    const std::ptrdiff_t rows = repeat_row ? 1 : ny + 2 * halo;
    size_ = static_cast<std::size_t>(width * rows);
    data_.reset(static_cast<R*>(std::aligned_alloc(64, size_ * sizeof(R))));
    if (!data_) {
      throw std::bad_alloc();
    }
    for (std::size_t k = 0; k < size_; ++k) {
      data_.get()[k] = value;
    }
    view_ = {data_.get() + (repeat_row ? 0 : halo * width) + line, repeat_row ? 0 : width};
  }

  const FieldView<R>& view() const { return view_; }
  R* row(std::ptrdiff_t j) const { return view_.row(j); }
  std::size_t bytes() const { return size_ * sizeof(R); }
  /// All that is allocated, the halo included.
  const R* data() const { return data_.get(); }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(R* p) const { std::free(p); }
  };
  std::unique_ptr<R, Free> data_;
  FieldView<R> view_;
  std::size_t size_ = 0;
};

}  // namespace sandsim
