#include "solver/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandsim {
namespace {

/// Integrals over the part of a cell that lies in a disc about the origin.
struct DiscIntegrals {
  double area = 0.0;      // of 1
  double distance = 0.0;  // of the distance from the origin
};

/// The sector of the disc between two directions.
DiscIntegrals sector(double angle, double radius) {
  const double square = radius * radius;
  return {0.5 * square * angle, square * radius * angle / 3.0};
}

/// The triangle between the origin and the part [0, t] of a line at distance c from it. With x = c tan a:
/// area = c^2/2 tan a; distance = c^3/3 times the integral of sec^3 = (sec a tan a + asinh(tan a)) / 2.
DiscIntegrals triangle(double c, double t) {
  const double slope = t / c;
  return {0.5 * c * t, c * c * c / 6.0 * (slope * std::sqrt(1.0 + slope * slope) + std::asinh(slope))};
}

/// What lies in the disc between the origin and the part [0, t] of a line at distance c; odd in c and in t. What the
/// line has outside the disc is replaced by the arc.
DiscIntegrals fan(double c, double t, double radius) {
  const double distance = std::abs(c);
  const double length = std::abs(t);
  if (distance == 0.0 || length == 0.0) {
    return {};
  }
  const double chord = distance < radius ? std::sqrt((radius - distance) * (radius + distance)) : 0.0;
  DiscIntegrals result = triangle(distance, std::min(length, chord));
  if (length > chord) {
    const DiscIntegrals arc = sector(std::atan2(length, distance) - std::atan2(chord, distance), radius);
    result.area += arc.area, result.distance += arc.distance;
  }
  const double sign = (c < 0.0) == (t < 0.0) ? 1.0 : -1.0;
  return {sign * result.area, sign * result.distance};
}

/// By Green's theorem in polar coordinates: the sum over the edges, counter-clockwise, of what lies between them and
/// the origin. The offset is that of the cell's centre.
DiscIntegrals integrate(double x, double y, double radius) {
  const std::array<double, 2> along_x{x - 0.5, x + 0.5};
  const std::array<double, 2> along_y{y - 0.5, y + 0.5};
  DiscIntegrals sum;
  const auto add_edge = [&](double c, double from, double to) {
    const DiscIntegrals end = fan(c, to, radius);
    const DiscIntegrals begin = fan(c, from, radius);
    sum.area += end.area - begin.area, sum.distance += end.distance - begin.distance;
  };
  add_edge(along_x[1], along_y[0], along_y[1]);
  add_edge(along_y[1], along_x[0], along_x[1]);
  add_edge(-along_x[0], along_y[0], along_y[1]);
  add_edge(-along_y[0], along_x[0], along_x[1]);
  return sum;
}

/// A cell against a disc: one of the eight cells that are mirrored and transposed images of each other stands for all.
struct Placement {
  double x, y;  // of the cell's centre, x >= y >= 0
  bool is_outside, is_inside;
};

Placement place(const std::array<double, 2>& offset, double radius) {
  const double x = std::max(std::abs(offset[0]), std::abs(offset[1]));
  const double y = std::min(std::abs(offset[0]), std::abs(offset[1]));
  const auto square = [](double a, double b) { return a * a + b * b; };
  const double nearest = square(std::max(0.0, x - 0.5), std::max(0.0, y - 0.5));
  return {x, y, nearest >= radius * radius, square(x + 0.5, y + 0.5) <= radius * radius};
}

}  // namespace

double in_cells(double length, double spacing) {
  constexpr double resolution = 1073741824.0;  // 2^30
  return std::round(length / spacing * resolution) / resolution;
}

double covered_length(double from, double to, int index) {
  const double lower = index;
  return std::max(0.0, std::min(to, lower + 1.0) - std::max(from, lower));
}

double covered_by_disc(std::array<double, 2> offset, double radius) {
  const Placement cell = place(offset, radius);
  if (cell.is_outside || cell.is_inside) {
    return cell.is_inside ? 1.0 : 0.0;
  }
  return std::clamp(integrate(cell.x, cell.y, radius).area, 0.0, 1.0);
}

double covered_by_cone(std::array<double, 2> offset, double radius) {
  const Placement cell = place(offset, radius);
  if (cell.is_outside) {
    return 0.0;
  }
  const DiscIntegrals inside = integrate(cell.x, cell.y, radius);
  return std::clamp(inside.area - inside.distance / radius, 0.0, 1.0);
}

double covered_by_cone(double offset, double radius) {
  // The integral of 1 - x/radius from 0 to x, odd.
  const auto integral = [radius](double x) {
    const double length = std::min(std::abs(x), radius);
    return std::copysign(length * (1.0 - 0.5 * length / radius), x);
  };
  const double centre = std::abs(offset);
  return std::max(0.0, integral(centre + 0.5) - integral(centre - 0.5));
}

}  // namespace sandsim
