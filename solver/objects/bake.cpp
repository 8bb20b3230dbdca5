#include "solver/objects/bake.hpp"

#include <algorithm>
#include <stdexcept>

#include "solver/objects/triangle_tree.hpp"

namespace sandsim::objects {

namespace {

/// Spacings between the mesh and the grid's sides: gradients near the surface have samples on both sides.
constexpr int margin = 2;

double spacing_of(const Vec3& size, int resolution) {
  return std::max({size.x, size.y, size.z}) / (resolution - 1 - 2 * margin);
}

DistanceGrid empty_grid(const Bounds& box, int resolution) {
  const Vec3 size = box.high - box.low;
  DistanceGrid grid;
  grid.spacing = spacing_of(size, resolution);
  const auto points = [&](double side) {
    // A side that is a whole number of spacings, to rounding, needs no sample more.
    return static_cast<int>(std::ceil(side / grid.spacing - 1e-9)) + 1 + 2 * margin;
  };
  grid.points = {points(size.x), points(size.y), points(size.z)};
  grid.origin = box.low - grid.spacing * Vec3{margin, margin, margin};
  grid.values.resize(static_cast<std::size_t>(grid.points[0]) * grid.points[1] * grid.points[2]);
  return grid;
}

Vec3 point(const DistanceGrid& grid, int i, int j, int k) {
  return grid.origin + grid.spacing * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
}

std::size_t index_of(const DistanceGrid& grid, int i, int j, int k) {
  return (static_cast<std::size_t>(k) * grid.points[1] + j) * grid.points[0] + i;
}

void fill_distances(DistanceGrid& grid, const TriangleTree& tree, const std::function<void(double)>& progress) {
  // The distances are by far the longest part of the work.
  constexpr double share = 0.8;
  for (int k = 0; k < grid.points[2]; ++k) {
#pragma omp parallel for schedule(dynamic, 4)
    for (int j = 0; j < grid.points[1]; ++j) {
      std::uint32_t nearest = 0;
      for (int i = 0; i < grid.points[0]; ++i) {
        grid.values[index_of(grid, i, j, k)] = static_cast<float>(tree.distance(point(grid, i, j, k), nearest));
      }
    }
    if (progress) progress(share * (k + 1) / grid.points[2]);
  }
}

/// Gives every sample its sign.
class Signs {
 public:
  Signs(DistanceGrid& grid, const TriangleTree& tree)
      : grid_(grid), tree_(tree), near_(static_cast<float>(grid.spacing)), is_done_(grid.values.size(), false) {}

  void apply() {
    std::vector<std::size_t> near;
    for (std::size_t sample = 0; sample < is_done_.size(); ++sample) {
      if (grid_.values[sample] <= near_) near.push_back(sample);
    }
    sign_each(near);
    for (std::size_t sample = 0; sample < is_done_.size(); ++sample) {
      if (!is_done_[sample]) sign_region(sample);
    }
  }

 private:
  Vec3 position(std::size_t sample) const {
    const auto nx = static_cast<std::size_t>(grid_.points[0]);
    const auto ny = static_cast<std::size_t>(grid_.points[1]);
    return point(grid_, static_cast<int>(sample % nx), static_cast<int>(sample / nx % ny),
                 static_cast<int>(sample / (nx * ny)));
  }

  bool is_inside(std::size_t sample) const { return tree_.winding_number(position(sample)) > 0.5; }

  void sign_each(const std::vector<std::size_t>& samples) {
#pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (is_inside(samples[k])) grid_.values[samples[k]] *= -1.0F;
    }
    for (const std::size_t sample : samples) is_done_[sample] = true;
  }

  /// Samples farther than a spacing from the surface have the sign of their neighbours that are so, too: a region's
  /// sign is found once. It is looked at in more places, since a hole that is wider than two spacings joins the inside
  /// to the outside; then every sample has to speak for itself.
  void sign_region(std::size_t seed) {
    constexpr std::size_t stride = 61;  // prime, so that no column or row is favoured
    const std::vector<std::size_t> region = region_of(seed);
    std::size_t inside = 0;
    std::size_t asked = 0;
    for (std::size_t k = 0; k < region.size(); k += stride, ++asked) inside += is_inside(region[k]) ? 1 : 0;
    if (inside != 0 && inside != asked) {
      sign_each(region);
    } else if (inside != 0) {
      for (const std::size_t sample : region) grid_.values[sample] *= -1.0F;
    }
  }

  /// All samples that hang together with the seed; marks them as done.
  std::vector<std::size_t> region_of(std::size_t seed) {
    const auto nx = static_cast<std::size_t>(grid_.points[0]);
    const auto slab = nx * static_cast<std::size_t>(grid_.points[1]);
    std::vector<std::size_t> region{seed};
    is_done_[seed] = true;
    for (std::size_t next = 0; next < region.size(); ++next) {
      const std::size_t sample = region[next];
      const auto visit = [&](bool is_there, std::size_t neighbour) {
        if (!is_there || is_done_[neighbour]) return;
        is_done_[neighbour] = true;
        region.push_back(neighbour);
      };
      visit(sample % nx > 0, sample - 1);
      visit(sample % nx + 1 < nx, sample + 1);
      visit(sample % slab >= nx, sample - nx);
      visit(sample % slab + nx < slab, sample + nx);
      visit(sample >= slab, sample - slab);
      visit(sample + slab < is_done_.size(), sample + slab);
    }
    return region;
  }

  DistanceGrid& grid_;
  const TriangleTree& tree_;
  float near_;  // [m]
  std::vector<bool> is_done_;
};

}  // namespace

double sample_spacing(const TriangleMesh& mesh, int resolution) {
  const Bounds box = bounds(mesh);
  return spacing_of(box.high - box.low, resolution);
}

BakedMesh bake(const TriangleMesh& mesh, int resolution, const std::function<void(double)>& progress) {
  if (resolution < least_resolution || resolution > most_resolution) {
    throw std::invalid_argument("the resolution of a mesh is out of bounds");
  }
  const RepairedMesh repaired = repair(mesh);
  if (!has_area(repaired.mesh)) throw std::invalid_argument("a mesh without a triangle that has an area");
  const TriangleTree tree(repaired.mesh);
  BakedMesh result{empty_grid(bounds(repaired.mesh), resolution), repaired.defects};
  fill_distances(result.grid, tree, progress);
  Signs(result.grid, tree).apply();
  if (progress) progress(1.0);
  return result;
}

}  // namespace sandsim::objects
