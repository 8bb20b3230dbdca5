// What the readers of meshes share.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/mesh/read_mesh.hpp"
#include "solver/objects/mesh.hpp"

namespace sandsim {

/// Indices of vertices are 32 bits wide.
inline constexpr std::size_t most_vertices = std::size_t{1} << 31;

/// Adds a polygon of three corners or more, cut into halves again and again: its triangles are then as wide as they can
/// be, and a face of many corners costs no more than many faces.
void add_polygon(objects::TriangleMesh& mesh, std::span<const std::uint32_t> corners);

/// Faces without an area and vertices that are no place: errors only where a surface hangs on them.
class OddParts {
 public:
  /// A face with fewer than three corners, which is left out.
  void add_face(std::string_view place) {
    if (faces_++ == 0) first_face_ = place;
  }
  /// A vertex that is not finite.
  void add_vertex(std::size_t vertex, std::string_view place) { vertices_.emplace_back(vertex, place); }

  /// Throws InputError for the first odd vertex that a triangle uses and puts the others to the origin. `describe`
  /// makes a message of a place and what is odd there.
  void settle(objects::TriangleMesh& mesh, Warnings* warnings,
              const std::function<std::string(std::string_view, const std::string&)>& describe) const;

 private:
  std::size_t faces_ = 0;
  std::string_view first_face_;
  std::vector<std::pair<std::size_t, std::string_view>> vertices_;
};

/// Adds to the warnings, if they are wanted.
inline void warn(Warnings* warnings, const std::string& message) {
  if (warnings != nullptr) warnings->push_back(message);
}

/// Throws InputError if there is no triangle.
void require_triangles(const objects::TriangleMesh& mesh, const std::string& name);

}  // namespace sandsim
