// Areas from a vector file: releases of sand, zones of friction.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace sandsim {

/// The corners of a closed line, the first one not repeated. [m] in the grid's coordinates
using Ring = std::vector<std::array<double, 2>>;

/// One feature of a vector file: one or more polygons, with holes. Outer rings run counter-clockwise, holes clockwise,
/// so that the signed areas of the rings add up to the area of the feature.
struct PolygonFeature {
  std::vector<Ring> rings;
  double value = std::numeric_limits<double>::quiet_NaN();  // of the attribute that was asked for, as in the file
};

/// The features of a layer. None has an empty area.
struct PolygonLayer {
  std::vector<PolygonFeature> features;
};

/// A layer together with the names under which the scene refers to it.
struct PolygonFile {
  std::string file;                          // as written in the scene
  std::string layer;                         // empty: the only one of the file
  std::string attribute;                     // empty: none was asked for
  std::shared_ptr<const PolygonLayer> data;  // never null in a scene that was read
  std::string place;                         // "scene.yaml:7:30", for messages; empty in scenes that were not read
};

}  // namespace sandsim
