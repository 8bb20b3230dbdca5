// A tree of boxes over a mesh's triangles: nearest distances and winding numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/objects/mesh.hpp"

namespace sandsim::objects {

class TriangleTree {
 public:
  /// The mesh has a triangle at least.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// The distance [m] from `p` to the surface, at most 5e-4 of itself too large: among triangles that are nearly as
  /// near, as seen from the centre of a sphere, no nearest one is searched for. `nearest` is a triangle to start with
  /// and becomes the one that was found; from one point to a neighbouring one it is the best guess. A distance of
  /// `most` or more comes out as `most`, which takes less time.
  double distance(const Vec3& p, std::uint32_t& nearest, double most = endless) const;

  /// How often the surface winds around `p`: 1 inside a closed surface, 0 outside, in between near its holes. Far
  /// parts count as dipoles (Barill et al. 2018, "Fast winding numbers for soups and clouds", section 3, order 1).
  double winding_number(const Vec3& p) const;

 private:
  struct Corners {
    Vec3 a;
    Vec3 b;
    Vec3 c;
  };
  /// Children of an inner node are the next node and `second`; a leaf has the triangles first to first + count.
  struct Node {
    Bounds box;
    // A layer across the mean normal holds the triangles, too: patches that lie askew to the axes fill little of their
    // box, and are a thin layer.
    Vec3 normal;          // unit, or 0 without one
    double low = 0.0;     // [m] of normal . x
    double high = 0.0;    // [m]
    Vec3 center;          // [m] of area
    Vec3 area_normal;     // [m^2] sum of the triangles' normals times their areas
    double radius = 0.0;  // [m] of all corners about the centre
    std::uint32_t first = 0;
    std::uint32_t count = 0;  // 0: inner node
    std::uint32_t second = 0;
  };

  void build(std::uint32_t first, std::uint32_t end);
  static double squared_distance(const Vec3& p, const Node& node);
  void summarize(Node& node, std::uint32_t first, std::uint32_t end) const;
  static double squared_distance(const Vec3& p, const Corners& t);
  static double solid_angle(const Vec3& p, const Corners& t);

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace sandsim::objects
