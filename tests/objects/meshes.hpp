// Meshes of known surfaces.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "solver/objects/mesh.hpp"

namespace sandsim::test {

using objects::TriangleMesh;

/// A surface over (u, v) in [0, 1)^2 that closes in u, and in v too if `closes_in_v`.
inline TriangleMesh surface(int nu, int nv, bool closes_in_v, const std::function<objects::Vec3(double, double)>& at) {
  TriangleMesh mesh;
  const int rows = closes_in_v ? nv : nv + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < nu; ++i) mesh.vertices.push_back(at(1.0 * i / nu, 1.0 * j / nv));
  }
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>((j % rows) * nu + i % nu); };
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

/// About 2 n^2 triangles; the vertices of its poles lie at one place exactly.
inline TriangleMesh sphere_mesh(double radius, int n, const objects::Vec3& center = {}) {
  return surface(n, n, false, [=](double u, double v) {
    const double phi = 2 * std::numbers::pi * u;
    const double theta = std::numbers::pi * (v - 0.5);
    const double rho = v == 0.0 || v == 1.0 ? 0.0 : radius * std::cos(theta);
    return center + objects::Vec3{rho * std::cos(phi), rho * std::sin(phi), radius * std::sin(theta)};
  });
}

/// About the origin; the last two triangles are the lid.
inline TriangleMesh box_mesh(const objects::Vec3& size) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.push_back({(k % 2 - 0.5) * size.x, (k / 2 % 2 - 0.5) * size.y, (k / 4 - 0.5) * size.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                    {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

inline TriangleMesh torus_mesh(double large, double small, int n) {
  return surface(n, n, true, [=](double u, double v) {
    const double phi = 2 * std::numbers::pi * u;
    const double psi = 2 * std::numbers::pi * v;
    const double rho = large + small * std::cos(psi);
    return objects::Vec3{rho * std::cos(phi), rho * std::sin(phi), small * std::sin(psi)};
  });
}

inline double sphere_distance(double radius, const objects::Vec3& p) {
  return length(p) - radius;
}

inline double torus_distance(double large, double small, const objects::Vec3& p) {
  return std::hypot(std::hypot(p.x, p.y) - large, p.z) - small;
}

}  // namespace sandsim::test
