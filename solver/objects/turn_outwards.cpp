#include "solver/objects/turn_outwards.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "solver/objects/triangle_tree.hpp"

namespace sandsim::objects {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A closed piece, or all pieces together that are not closed.
struct Part {
  std::vector<std::uint32_t> triangles;
  Bounds box;
  double volume = 0.0;  // [m^3] 0 if it closes in next to nothing
  std::unique_ptr<TriangleTree> tree;
};

/// A side of a triangle of a piece, with the smaller vertex first.
struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t piece = 0;
  int sense = 0;  // +1 from low to high, -1 back

  auto edge() const { return std::tie(low, high, piece); }
};

/// The edges along which a piece does not run as often in one direction as in the other, as a closed one does.
std::vector<Side> open_sides(const std::vector<Triangle>& triangles, const std::vector<std::uint32_t>& pieces) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k];
      const std::uint32_t b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), pieces[t], a < b ? 1 : -1});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge() < b.edge(); });
  std::vector<Side> result;
  for (std::size_t first = 0; first < sides.size();) {
    int sum = 0;
    std::size_t end = first;
    for (; end < sides.size() && sides[end].edge() == sides[first].edge(); ++end) sum += sides[end].sense;
    if (sum != 0) result.push_back(sides[first]);
    first = end;
  }
  return result;
}

/// The volume between the part and cones from `apex` to its open edges; 0 if it is at most `least` of what its area
/// could close in.
double volume(const TriangleMesh& mesh, const Part& part, const Vec3& apex, double least) {
  double sum = 0.0;
  double area = 0.0;
  for (const std::uint32_t t : part.triangles) {
    const Vec3 a = mesh.vertices[mesh.triangles[t][0]] - apex;
    const Vec3 b = mesh.vertices[mesh.triangles[t][1]] - apex;
    const Vec3 c = mesh.vertices[mesh.triangles[t][2]] - apex;
    sum += dot(a, cross(b, c)) / 6.0;
    area += 0.5 * length(cross(b - a, c - a));
  }
  return std::abs(sum) > least * area * std::sqrt(area) ? sum : 0.0;
}

/// The parts of the mesh with their volumes; the one that is not closed comes last.
std::vector<Part> parts_of(const TriangleMesh& mesh, const std::vector<std::uint32_t>& pieces) {
  const std::vector<Side> open = open_sides(mesh.triangles, pieces);
  const std::uint32_t count = pieces.empty() ? 0 : 1 + *std::max_element(pieces.begin(), pieces.end());
  std::vector<std::uint32_t> part_of(count);
  for (std::uint32_t piece = 0; piece < count; ++piece) part_of[piece] = piece;
  Vec3 rim;
  for (const Side& side : open) {
    part_of[side.piece] = count;
    rim = rim + (0.5 / static_cast<double>(open.size())) * (mesh.vertices[side.low] + mesh.vertices[side.high]);
  }
  std::vector<Part> parts(count + 1);
  for (std::uint32_t t = 0; t < pieces.size(); ++t) {
    Part& part = parts[part_of[pieces[t]]];
    part.triangles.push_back(t);
    for (const std::uint32_t v : mesh.triangles[t]) part.box.include(mesh.vertices[v]);
  }
  for (std::uint32_t k = 0; k <= count; ++k) {
    // Rounding decides below 1e-12. A sheet with a slight bend has no inside, a cube without a face 0.09.
    parts[k].volume = k < count ? volume(mesh, parts[k], parts[k].box.low, 1e-12) : volume(mesh, parts[k], rim, 1e-3);
  }
  std::erase_if(parts, [](const Part& part) { return part.volume == 0.0; });
  return parts;
}

bool is_within(const Bounds& inner, const Bounds& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.low.z >= outer.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y && inner.high.z <= outer.high.z;
}

bool is_inside(const TriangleMesh& mesh, const Part& inner, Part& outer) {
  if (!is_within(inner.box, outer.box)) return false;
  if (!outer.tree) {
    TriangleMesh own{mesh.vertices, {}};
    for (const std::uint32_t t : outer.triangles) own.triangles.push_back(mesh.triangles[t]);
    outer.tree = std::make_unique<TriangleTree>(own);
  }
  return std::abs(outer.tree->winding_number(mesh.vertices[mesh.triangles[inner.triangles[0]][0]])) > 0.5;
}

}  // namespace

void turn_outwards(TriangleMesh& mesh, const std::vector<std::uint32_t>& pieces) {
  std::vector<Part> parts = parts_of(mesh, pieces);
  if (std::none_of(parts.begin(), parts.end(), [](const Part& part) { return part.volume < 0.0; })) return;
  // What encloses a part is larger: the first that does is the outermost one.
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return std::abs(a.volume) > std::abs(b.volume); });
  std::vector<std::uint32_t> to_turn;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::size_t outermost = 0;
    while (outermost < k && !is_inside(mesh, parts[k], parts[outermost])) ++outermost;
    if (parts[outermost].volume > 0.0) continue;
    to_turn.insert(to_turn.end(), parts[k].triangles.begin(), parts[k].triangles.end());
  }
  for (const std::uint32_t t : to_turn) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

}  // namespace sandsim::objects
