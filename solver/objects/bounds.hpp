// Boxes around things.
#pragma once

#include "solver/objects/primitive.hpp"

namespace sandsim::objects {

/// A box with sides along the axes; empty unless low <= high in all of them. +-`endless` where there is no end. [m]
struct Bounds {
  Vec3 low{endless, endless, endless};
  Vec3 high{-endless, -endless, -endless};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  void include(const Vec3& p) {
    low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z)};
    high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z)};
  }
};

Bounds unite(const Bounds& a, const Bounds& b);
Bounds intersect(const Bounds& a, const Bounds& b);

/// Around a box that lies at `pose`. Endless in every axis if the box is endless in one.
Bounds around(const Bounds& box, const Pose& pose);
/// Around a primitive (the primitive's own pose counts too); the tightest there is, but for a half-space.
Bounds around(const Primitive& primitive, const Pose& pose);

/// The largest distance of a point of the box from the origin; infinite boxes give `endless`. [m]
double reach(const Bounds& box);

}  // namespace sandsim::objects
