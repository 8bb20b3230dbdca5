// Frictionless sand in a paraboloid, after Thacker (1981), J. Fluid Mech. 107, 499-508.
// Bed -h0 (1 - r^2/a^2); hbar = alpha h and G = alpha g.
#pragma once

#include <algorithm>
#include <cmath>

namespace sandsim {

/// A plane surface that circles: the sand is a disc of radius a about (eta cos wt, eta sin wt), w^2 = 2 G h0/a^2.
class PlanarThacker {
 public:
  PlanarThacker(double height, double radius, double offset, double effective_gravity)
      : height_(height),
        radius_(radius),
        offset_(offset),
        frequency_(std::sqrt(2.0 * effective_gravity * height) / radius) {}

  /// [m] elevation of the bed.
  double bed(double x, double y) const { return height_ * ((x * x + y * y) / (radius_ * radius_) - 1.0); }

  /// [m] depth at (x, y) [m] and t [s].
  double depth(double x, double y, double t) const {
    const double dx = x - offset_ * std::cos(frequency_ * t), dy = y - offset_ * std::sin(frequency_ * t);
    return std::max(0.0, height_ * (1.0 - (dx * dx + dy * dy) / (radius_ * radius_)));
  }

  /// [m/s] velocity, the same everywhere in the sand.
  double velocity_x(double t) const { return -offset_ * frequency_ * std::sin(frequency_ * t); }
  double velocity_y(double t) const { return offset_ * frequency_ * std::cos(frequency_ * t); }

  double period() const { return 2.0 * std::acos(-1.0) / frequency_; }  // [s]

 private:
  double height_;     // [m] h0
  double radius_;     // [m] a
  double offset_;     // [m] eta
  double frequency_;  // [1/s]
};

/// A paraboloid of sand that breathes: its radius is r0 at t = 0, w^2 = 8 G h0/a^2, A = (a^4 - r0^4)/(a^4 + r0^4).
/// (A with squares instead of fourth powers, as it is often printed, starts with the radius sqrt(a r0).)
class RadialThacker {
 public:
  RadialThacker(double height, double radius, double start_radius, double effective_gravity)
      : height_(height),
        radius_(radius),
        amplitude_(amplitude(radius, start_radius)),
        frequency_(std::sqrt(8.0 * effective_gravity * height) / radius) {}

  /// [m] elevation of the bed at the distance r [m] from the axis.
  double bed(double r) const { return height_ * (r * r / (radius_ * radius_) - 1.0); }

  /// [m] depth: the two terms of the surface and the bed together are a paraboloid of height k h0 and radius a/sqrt(k),
  /// k = sqrt(1 - A^2)/(1 - A cos wt).
  double depth(double r, double t) const {
    const double k = std::sqrt(1.0 - amplitude_ * amplitude_) / squeeze(t);
    return std::max(0.0, height_ * k * (1.0 - k * r * r / (radius_ * radius_)));
  }

  /// [m/s] outward velocity at the distance r [m].
  double velocity(double r, double t) const {
    return 0.5 * r * frequency_ * amplitude_ * std::sin(frequency_ * t) / squeeze(t);
  }

  double period() const { return 2.0 * std::acos(-1.0) / frequency_; }  // [s]

 private:
  static double amplitude(double radius, double start_radius) {
    const double a4 = std::pow(radius, 4), r4 = std::pow(start_radius, 4);
    return (a4 - r4) / (a4 + r4);
  }
  double squeeze(double t) const { return 1.0 - amplitude_ * std::cos(frequency_ * t); }

  double height_;     // [m] h0
  double radius_;     // [m] a
  double amplitude_;  // [-] A
  double frequency_;  // [1/s]
};

}  // namespace sandsim
