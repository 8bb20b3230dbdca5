// The words that scenes use for enumerators and for the kinds of terrain, sand and references.
#pragma once

#include <array>

#include "io/scene/type_name.hpp"
#include "solver/scene.hpp"

namespace sandsim {

template <>
struct EnumNames<Precision> {
  static constexpr std::array names{"float32", "float64"};
};
template <>
struct EnumNames<Scheme> {
  static constexpr std::array names{"balanced", "paper"};
};
template <>
struct EnumNames<MomentumFlux> {
  static constexpr std::array names{"full", "printed"};
};
template <>
struct EnumNames<VelocityForm> {
  static constexpr std::array names{"quotient", "desingularised"};
};
template <>
struct EnumNames<BoundaryKind> {
  static constexpr std::array names{"wall", "open", "periodic"};
};
template <>
struct EnumNames<HbarPolicy> {
  static constexpr std::array names{"full", "constant", "scaled", "truncated"};
};
template <>
struct EnumNames<Nodata> {
  static constexpr std::array names{"error", "wall", "nearest"};
};
template <>
struct EnumNames<LengthUnit> {
  static constexpr std::array names{"m", "cm", "mm"};
};
template <>
struct EnumNames<TimeMode> {
  static constexpr std::array names{"adaptive", "fixed"};
};
template <>
struct EnumNames<OutputField> {
  static constexpr std::array names{"depth", "velocity", "surface", "momentum"};
};
template <>
struct EnumNames<FirstRow> {
  static constexpr std::array names{"south", "north"};
};
template <>
struct EnumNames<ParticleVelocity> {
  static constexpr std::array names{"averaged", "dilute"};
};
template <>
struct EnumNames<Compression> {
  static constexpr std::array names{"none", "gzip"};
};

template <>
struct TypeName<FlatTerrain> {
  static constexpr const char* name = "flat";
  static constexpr const char* purpose = "A level bed.";
};
template <>
struct TypeName<PlaneTerrain> {
  static constexpr const char* name = "plane";
  static constexpr const char* purpose = "A bed that falls evenly along a direction.";
};
template <>
struct TypeName<RasterTerrain> {
  static constexpr const char* name = "raster";
  static constexpr const char* purpose =
      "A bed read from a file, in metres: bilinear at the cell centres where the raster is coarser than the cells, the "
      "mean over the cell where it is finer.";
};
template <>
struct TypeName<SandBox> {
  static constexpr const char* name = "box";
  static constexpr const char* purpose =
      "A rectangle; cells partly inside get the covered fraction. With one row only x counts.";
};
template <>
struct TypeName<SandColumn> {
  static constexpr const char* name = "column";
  static constexpr const char* purpose = "A disc.";
};
template <>
struct TypeName<SandCone> {
  static constexpr const char* name = "cone";
  static constexpr const char* purpose = "A cone of sand whose depth falls evenly from the centre to the rim.";
};
template <>
struct TypeName<SandLayer> {
  static constexpr const char* name = "layer";
  static constexpr const char* purpose = "Sand everywhere.";
};
template <>
struct TypeName<SandRaster> {
  static constexpr const char* name = "raster";
  static constexpr const char* purpose =
      "Depths read from a file, in metres. They go onto the cells by covered area, so that the volume stays; NODATA is "
      "no sand.";
};
template <>
struct TypeName<SandPolygon> {
  static constexpr const char* name = "polygon";
  static constexpr const char* purpose =
      "The polygons of a vector file (GeoJSON, shapefile, GeoPackage); cells partly inside get the covered fraction, "
      "and overlapping polygons add up.";
};
template <>
struct TypeName<DamBreakReference> {
  static constexpr const char* name = "dam_break";
  static constexpr const char* purpose =
      "Dam break on a uniform slope with friction, hbar = scale h (Ritter; Mangeney et al. 2000). Sand at smaller x.";
};
template <>
struct TypeName<StokerReference> {
  static constexpr const char* name = "stoker";
  static constexpr const char* purpose = "Stoker's dam break onto a layer, without friction, hbar = h.";
};
template <>
struct TypeName<TwoLayerDamBreakReference> {
  static constexpr const char* name = "two_layer_dam_break";
  static constexpr const char* purpose =
      "Dam break of the two-layer model, hbar = min(scale h, cap); with friction only the tip.";
};

}  // namespace sandsim
