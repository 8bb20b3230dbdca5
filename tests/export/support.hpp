// What the tests of exported files share.
#pragma once

#include <cstring>
#include <string>

#include "solver/surface/surface_mesh.hpp"

namespace sandsim::test {

/// Two cells by two of 0.5 m at (500000.25, 0) m on a slope, one of them dry: coordinates that float32 would blur.
inline surface::SurfaceMesh sample_mesh() {
  Grid grid;
  grid.cells = {2, 2};
  grid.spacing = 0.5;
  grid.origin = {500000.25, 0.0};
  const double bed[] = {1.0, 1.5, 1.0, 1.5};
  const double depth[] = {0.5, 0.25, 0.0, 0.75};
  return surface::sand_mesh(surface::height_field(grid, bed, depth), 0.1);
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t place) {
  Number value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

/// Where the text after `mark` starts; fails by std::out_of_range further on if it is not there.
inline std::size_t behind(const std::string& bytes, const std::string& mark, std::size_t from = 0) {
  const std::size_t place = bytes.find(mark, from);
  return place == std::string::npos ? place : place + mark.size();
}

inline bool same_shape(const objects::TriangleMesh& a, const objects::TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

}  // namespace sandsim::test
