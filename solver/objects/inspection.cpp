#include "solver/objects/inspection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "solver/grid_problems.hpp"
#include "solver/objects/bake.hpp"
#include "solver/objects/mesh.hpp"
#include "solver/objects/object.hpp"

namespace sandsim::objects {

namespace {

/// The cells of one axis whose centres lie in [low, high]: from first to last, none if first > last.
struct Range {
  int first = 0;
  int last = -1;
};

Range centers(double low, double high, double origin, double spacing, int cells) {
  const double first = std::ceil((low - origin) / spacing - 0.5);
  const double last = std::floor((high - origin) / spacing - 0.5);
  return {static_cast<int>(std::clamp(first, 0.0, static_cast<double>(cells))),
          static_cast<int>(std::clamp(last, -1.0, cells - 1.0))};
}

/// Calls visit(i, j) for the cells whose centres lie in the box, until it returns false.
template <class Visit>
void visit_cells(const Bounds& box, const Grid& grid, Visit visit) {
  const Range columns = centers(box.low.x, box.high.x, grid.origin[0], grid.spacing, grid.cells[0]);
  const Range rows = centers(box.low.y, box.high.y, grid.origin[1], grid.spacing, grid.cells[1]);
  for (int j = rows.first; j <= rows.last; ++j) {
    for (int i = columns.first; i <= columns.last; ++i) {
      if (!visit(i, j)) return;
    }
  }
}

Pose start_pose(const KinematicObject& object) {
  return at(make_motion(object), object.start).pose;
}

Pose placement_of(const ObjectShape& shape) {
  return std::visit(
      [](const auto& s) {
        return Pose{vector(s.placement.position), orientation(s.placement.rotation)};
      },
      shape);
}

/// The box around a shape in its own frame, before it is placed.
Bounds own_box(const ObjectShape& shape) {
  return std::visit(
      [](auto s) {
        s.placement = {};
        return bounds(ObjectShape(s), Pose{});
      },
      shape);
}

/// Whether (x, y) lies in the triangle as seen from above, its edges included.
bool is_over(const std::array<Vec3, 3>& corners, double x, double y) {
  bool has_left = false;
  bool has_right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = corners[k];
    const Vec3 side = corners[(k + 1) % 3] - a;
    const double turn = side.x * (y - a.y) - side.y * (x - a.x);
    has_left = has_left || turn > 0.0;
    has_right = has_right || turn < 0.0;
  }
  return !(has_left && has_right);
}

std::size_t covered_by_mesh(const MeshShape& shape, const Pose& pose, const Grid& grid, std::size_t most) {
  const TriangleMesh& mesh = *shape.file.mesh;
  const Pose place = pose * placement_of(shape);
  std::vector<bool> is_covered(most == 1 ? 0 : grid.cell_count(), false);
  std::size_t count = 0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> corners;
    Bounds box;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = to_outer(place, factor(shape) * mesh.vertices[triangle[k]]);
      box.include(corners[k]);
    }
    visit_cells(box, grid, [&](int i, int j) {
      if (!is_over(corners, grid.x(i), grid.y(j))) return true;
      if (most > 1) {
        const std::size_t cell =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.cells[0]) + static_cast<std::size_t>(i);
        if (is_covered[cell]) return true;
        is_covered[cell] = true;
      }
      return ++count < most;
    });
    if (count >= most) break;
  }
  return count;
}

/// The thickness of a plate that has the mesh's volume and surface: two thirds of the radius of a sphere. [m]
std::optional<double> mean_thickness(const MeshShape& shape) {
  const TriangleMesh& mesh = *shape.file.mesh;
  if (!repair(mesh).defects.is_closed()) return std::nullopt;
  return factor(shape) * 2.0 * signed_volume(mesh) / surface_area(mesh);
}

/// A mesh or a sampled distance whose inside is thinner than its samples are apart.
void add_thinner_than_samples(const ObjectShape& shape, const std::string& key, std::vector<Issue>& issues) {
  const std::string problem = "thinner than its samples are apart: parts of it, or all, may not be there";
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    const std::optional<double> thickness = mean_thickness(*mesh);
    const double spacing = factor(*mesh) * sample_spacing(*mesh->file.mesh, mesh->resolution);
    if (!thickness || *thickness >= spacing) return;
    issues.push_back({key + ".shape.file",
                      problem,
                      "it is about " + number_text(*thickness) + " m thick, and the samples are " +
                          number_text(spacing) + " m apart",
                      "Set a finer resolution (at most " + std::to_string(most_resolution) +
                          "), make it thicker, or take a shape of type box.",
                      {}});
  } else if (const auto* sdf = std::get_if<SdfShape>(&shape)) {
    const DistanceGrid& grid = *sdf->file.distance;
    const double deepest = -static_cast<double>(*std::min_element(grid.values.begin(), grid.values.end()));
    const double spacing = sdf->spacing.value_or(grid.spacing);
    if (deepest >= 0.5 * spacing) return;
    issues.push_back({key + ".shape.file",
                      problem,
                      "no sample lies deeper inside than " + number_text(sdf->scale * deepest) + " m, and they are " +
                          number_text(sdf->scale * spacing) + " m apart",
                      "Take finer samples, or make it thicker.",
                      {}});
  }
}

}  // namespace

std::size_t covered_cells(const KinematicObject& object, const Grid& grid, std::size_t most) {
  const Pose pose = start_pose(object);
  if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) return covered_by_mesh(*mesh, pose, grid, most);
  const Shape shape = make_shape(object.shape);
  std::size_t count = 0;
  visit_cells(shape.bounds(pose), grid, [&](int i, int j) {
    const Intervals inside = inside_column(shape.view(), pose, grid.x(i), grid.y(j), {-endless, endless},
                                           object.sample_spacing.value_or(grid.spacing));
    count += inside.count > 0 ? 1 : 0;
    return count < most;
  });
  return count;
}

double narrowest_width(const KinematicObject& object, const Grid& grid) {
  const Pose pose = start_pose(object) * placement_of(object.shape);
  const Bounds box = own_box(object.shape);
  if (reach(box) >= endless) return endless;
  // The sides of the box, as seen from above; the footprint is narrowest across one of them.
  const Vec3 size = box.high - box.low;
  const std::array<Vec3, 3> sides{rotate(pose.orientation, {size.x, 0, 0}), rotate(pose.orientation, {0, size.y, 0}),
                                  rotate(pose.orientation, {0, 0, size.z})};
  const auto width = [&](double x, double y) {
    double sum = 0.0;
    for (const Vec3& side : sides) sum += std::abs(side.x * x + side.y * y);
    return sum;
  };
  if (grid.one_dimensional()) return width(1.0, 0.0);
  double narrowest = endless;
  for (const Vec3& side : sides) {
    const double seen = std::hypot(side.x, side.y);
    if (seen > 1e-9 * length(size)) narrowest = std::min(narrowest, width(-side.y / seen, side.x / seen));
  }
  return narrowest;
}

std::optional<double> volume(const ObjectShape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    if (!mean_thickness(*mesh)) return std::nullopt;
    return std::pow(factor(*mesh), 3) * signed_volume(*mesh->file.mesh);
  }
  constexpr int columns = 100;  // along x and y: the rim of a disc then errs by less than 1 %
  const Shape made = make_shape(shape);
  // The shape as it is before it is placed: a box then has upright sides.
  const Pose placement = placement_of(shape);
  const Quaternion back = inverse(placement.orientation);
  const Pose upright{-rotate(back, placement.position), back};
  const Bounds box = made.bounds(upright);
  if (reach(box) >= endless) return std::nullopt;
  const double dx = (box.high.x - box.low.x) / columns;
  const double dy = (box.high.y - box.low.y) / columns;
  double sum = 0.0;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Intervals inside = inside_column(made.view(), upright, box.low.x + (i + 0.5) * dx,
                                             box.low.y + (j + 0.5) * dy, {-endless, endless}, 0.0);
      for (int k = 0; k < inside.count; ++k) sum += (inside.items[k].to - inside.items[k].from) * dx * dy;
    }
  }
  return sum;
}

std::vector<Issue> thin_objects(const Scene& scene) {
  std::vector<Issue> issues;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const KinematicObject& object = scene.objects[k];
    const std::string key = "objects." + std::to_string(k);
    const double width = narrowest_width(object, scene.grid);
    // To rounding: 4 cm of a plate and cells of 4 cm are the same.
    if (width < (1.0 - 1e-9) * scene.grid.spacing) {
      const std::size_t covered = covered_cells(object, scene.grid);
      issues.push_back({key + ".shape",
                        "narrower than a cell: sand does not meet it wherever no cell centre lies inside",
                        "it is " + number_text(width) + " m wide at its narrowest, the cells " +
                            number_text(scene.grid.spacing) + " m; at its start it covers " + std::to_string(covered) +
                            (covered == 1 ? " centre" : " centres"),
                        "Make it wider, or grid.spacing finer.",
                        {}});
    }
    add_thinner_than_samples(object.shape, key, issues);
  }
  return issues;
}

}  // namespace sandsim::objects
