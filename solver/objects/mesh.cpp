#include "solver/objects/mesh.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "solver/objects/turn_outwards.hpp"

namespace sandsim::objects {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Every vertex once, sorted by its coordinates; triangles that then have two equal corners are counted and left out.
TriangleMesh welded(const TriangleMesh& mesh, std::size_t& degenerate) {
  const auto key = [&](std::uint32_t v) {
    const Vec3& p = mesh.vertices[v];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  TriangleMesh result;
  std::vector<std::uint32_t> new_index(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || key(order[k]) != key(order[k - 1])) result.vertices.push_back(mesh.vertices[order[k]]);
    new_index[order[k]] = static_cast<std::uint32_t>(result.vertices.size() - 1);
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle w{new_index[t[0]], new_index[t[1]], new_index[t[2]]};
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) {
      ++degenerate;
    } else {
      result.triangles.push_back(w);
    }
  }
  return result;
}

/// A side of a triangle, with the smaller vertex first.
struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  bool is_rising = false;  // the triangle runs from low to high
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k];
      const std::uint32_t b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

/// Two triangles that share an edge which no third one has.
struct Neighbour {
  std::uint32_t triangle = 0;
  bool agrees = false;  // they run along the edge in opposite directions, as neighbours should
};

/// Neighbours of every triangle, at most three; counts the edges that have one triangle, or more than two.
std::vector<std::vector<Neighbour>> neighbours(const std::vector<Triangle>& triangles, MeshDefects& defects) {
  std::vector<std::vector<Neighbour>> result(triangles.size());
  const std::vector<Side> sides = sorted_sides(triangles);
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t end = first + 1;
    while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
    if (end - first == 1) ++defects.open_edges;
    if (end - first > 2) ++defects.non_manifold_edges;
    if (end - first == 2) {
      const Side& a = sides[first];
      const Side& b = sides[first + 1];
      result[a.triangle].push_back({b.triangle, a.is_rising != b.is_rising});
      result[b.triangle].push_back({a.triangle, a.is_rising != b.is_rising});
    }
    first = end;
  }
  return result;
}

double area(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.vertices[t[0]];
  return 0.5 * length(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a));
}

/// Turns the triangles of every connected piece to agree, the way that turns the smaller part of its area. Returns the
/// piece that each triangle belongs to.
std::vector<std::uint32_t> align(TriangleMesh& mesh, const std::vector<std::vector<Neighbour>>& joined) {
  enum class Turn : char { unknown, keep, flip };
  std::vector<Turn> turns(mesh.triangles.size(), Turn::unknown);
  std::vector<std::uint32_t> pieces(mesh.triangles.size());
  std::uint32_t count = 0;
  for (std::uint32_t seed = 0; seed < turns.size(); ++seed) {
    if (turns[seed] != Turn::unknown) continue;
    std::vector<std::uint32_t> piece{seed};
    turns[seed] = Turn::keep;
    double kept = 0.0;
    double flipped = 0.0;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const std::uint32_t t = piece[next];
      (turns[t] == Turn::keep ? kept : flipped) += area(mesh, mesh.triangles[t]);
      for (const Neighbour& n : joined[t]) {
        if (turns[n.triangle] != Turn::unknown) continue;
        turns[n.triangle] = n.agrees == (turns[t] == Turn::keep) ? Turn::keep : Turn::flip;
        piece.push_back(n.triangle);
      }
    }
    const Turn to_flip = flipped > kept ? Turn::keep : Turn::flip;
    for (const std::uint32_t t : piece) {
      pieces[t] = count;
      if (turns[t] == to_flip) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    ++count;
  }
  return pieces;
}

}  // namespace

Bounds bounds(const TriangleMesh& mesh) {
  Bounds box;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) box.include(mesh.vertices[v]);
  }
  return box;
}

bool has_area(const TriangleMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const Triangle& t) { return area(mesh, t) > 0.0; });
}

double signed_volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  const Vec3 from = bounds(mesh).low;  // near the mesh, so that far from the origin no digits cancel
  for (const Triangle& t : mesh.triangles) {
    sum += dot(mesh.vertices[t[0]] - from, cross(mesh.vertices[t[1]] - from, mesh.vertices[t[2]] - from)) / 6.0;
  }
  return sum;
}

double surface_area(const TriangleMesh& mesh) {
  return std::accumulate(mesh.triangles.begin(), mesh.triangles.end(), 0.0,
                         [&](double sum, const Triangle& t) { return sum + area(mesh, t); });
}

RepairedMesh repair(const TriangleMesh& mesh) {
  RepairedMesh result;
  result.mesh = welded(mesh, result.defects.degenerate_triangles);
  const std::vector<Triangle> given = result.mesh.triangles;
  const std::vector<std::uint32_t> pieces = align(result.mesh, neighbours(given, result.defects));
  turn_outwards(result.mesh, pieces);
  for (std::size_t t = 0; t < given.size(); ++t) {
    result.defects.flipped_triangles += given[t] == result.mesh.triangles[t] ? 0 : 1;
  }
  return result;
}

}  // namespace sandsim::objects
