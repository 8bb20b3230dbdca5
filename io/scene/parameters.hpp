// The table of all parameters of a scene. Everything that knows the format walks through it with a visitor: the
// reader, the writer of the resolved scene, the JSON Schema and the reference page.
//
// A visitor has one member: field(key, member, rule, meaning). Defaults are those of solver/scene.hpp. The order
// matters: a key that decides whether another one applies, and the grid's spacing, come first.
#pragma once

#include "io/scene/names.hpp"
#include "io/scene/parameters_objects.hpp"
#include "io/scene/rule.hpp"
#include "solver/grid_like.hpp"
#include "solver/scene.hpp"

namespace sandsim {

template <class V>
void describe(V& v, Grid& g) {
  GridLike from;  // which the reader turns into cells, spacing, origin and crs
  v.field("like", from.like, file().like("dem.tif"), "A raster whose cells, spacing, origin and CRS the grid takes.");
  const bool own = !from.like;
  const char* const without = "a grid without like";
  v.field("cells", g.cells, number().at_least(1).required().like("[160, 1]").only(own, without),
          "Number of cells along x and y. One row is a 1-D scene.");
  v.field("spacing", g.spacing, length().above(0).without_cells().like("1 cm").required_unless(!own, "like"),
          "Side of a cell, the same in x and y; beside `like` the raster is resampled.");
  v.field("origin", g.origin, length().only(own, without), "Corner of the grid; cell centres lie half a spacing in.");
  v.field("crs", g.crs, text().like("EPSG:32632").only(own, without),
          "Coordinate reference system of x and y, projected and in metres; it is written beside the results.");
  v.field("extent", from.extent,
          length()
              .without_cells()
              .components({"x_min", "y_min", "x_max", "y_max"})
              .only(!own, "like")
              .like("[600 km, 5100 km, 602 km, 5101 km]"),
          "The part of the raster that is taken.");
  v.field("margin", from.margin, length().at_least(0).without_cells().only(!own, "like"),
          "Left out along each side of the raster, or of the extent.");
  if constexpr (requires { v.take_grid(g, from); }) v.take_grid(g, from);
}

// ---- terrain --------------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, FlatTerrain& t) {
  v.field("elevation", t.elevation, length(), "Height of the bed.");
}

template <class V>
void describe(V& v, PlaneTerrain& t) {
  v.field("inclination", t.inclination, angle().above(-89).below(89).required().like("20 deg"),
          "Angle between the bed and the horizontal.");
  v.field("direction", t.direction, angle(), "Direction in which the bed falls; 0 deg is +x, 90 deg is +y.");
  v.field("elevation", t.elevation, length(), "Height of the bed at the grid's origin.");
}

/// What a raster's file is asked for.
template <class V>
void describe_request(V& v, RasterFile& file) {
  v.field("band", file.band, number().at_least(1), "Band of a file that GDAL reads, counted from 1.");
  v.field("variable", file.variable, text().like("elevation"), "Variable of a file that holds several (NetCDF).");
  v.field("first_row", file.first_row, choice(),
          "Which side the first row (row 0) of a .npy file is: south, the smallest y, unless north is given, as "
          "programs for maps have it. Not for files that know where their rows lie.");
}

/// That, and the file itself.
template <class V>
void describe_raster(V& v, RasterFile& file, const Rule& rule) {
  describe_request(v, file);
  v.field("file", file, rule,
          "GeoTIFF or what else GDAL reads, ESRI ASCII grid, or .npy (row 0 in the south, see first_row); a relative "
          "name is relative to the scene file.");
}

template <class V>
void describe(V& v, RasterTerrain& t) {
  describe_raster(v, t.file, file().required().like("dem.tif"));
  v.field("scale", t.scale, number(), "Factor on the values of the raster.");
  v.field("offset", t.offset, length(), "Height added after scaling.");
  v.field("nodata", t.nodata, choice(),
          "Cells where the raster has no data. error: the scene is refused. wall: no sand goes there; their bed in the "
          "output is a level above all that sand can reach. nearest: they take the nearest value of the raster.");
}

// ---- sand -----------------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, Fill& f) {
  v.field("depth", f.depth, length().at_least(0), "Depth of sand. Exactly one of depth and surface is given.");
  v.field("surface", f.surface, length(), "Level up to which sand is filled.");
}

template <class V>
void describe_velocity(V& v, SandVelocity& velocity) {
  v.field("velocity", velocity, speed().like("[2 m/s, 0 m/s]"), "Velocity of the sand at the start.");
}

template <class V>
void describe(V& v, SandBox& s) {
  v.field("from", s.from, length().required().like("[0 m, 0 m]"), "Corner with the smallest x and y.");
  v.field("to", s.to, length().required().like("[40 cm, 1 cm]"), "Opposite corner.");
  describe(v, s.fill);
  describe_velocity(v, s.velocity);
}

template <class V>
void describe(V& v, SandColumn& s) {
  v.field("center", s.center, length().required().like("[50 cm, 50 cm]"), "Centre of the disc.");
  v.field("radius", s.radius, length().above(0).required().like("10 cm"), "Radius of the disc.");
  describe(v, s.fill);
  describe_velocity(v, s.velocity);
}

template <class V>
void describe(V& v, SandCone& s) {
  v.field("center", s.center, length().required().like("[50 cm, 50 cm]"), "Centre of the cone.");
  v.field("radius", s.radius, length().above(0).required().like("10 cm"), "Radius at the foot.");
  v.field("height", s.height, length().at_least(0).required().like("5 cm"), "Depth of sand at the centre.");
  describe_velocity(v, s.velocity);
}

template <class V>
void describe(V& v, SandLayer& s) {
  describe(v, s.fill);
  describe_velocity(v, s.velocity);
}

template <class V>
void describe(V& v, SandRaster& s) {
  describe_raster(v, s.file, file().at_least(0).required().like("depth.tif"));
  v.field("scale", s.scale, number().at_least(0), "Factor on the values of the raster.");
  describe_velocity(v, s.velocity);
}

template <class V>
void describe(V& v, SandPolygon& s) {
  v.field("layer", s.file.layer, text(), "Layer of the file; without it, its only one.");
  v.field("attribute", s.file.attribute, text().like("thickness"),
          "Numeric field of each polygon that holds its depth. Exactly one of attribute and depth is given.");
  v.field("file", s.file, file().required().like("release.geojson"),
          "Vector file; a relative name is relative to the scene file.");
  v.field("depth", s.depth, length().at_least(0).like("2 m"), "Depth of sand in all polygons.");
  v.field("unit", s.unit, choice(), "Of the attribute.");
  v.field(
      "normal_to_slope", s.normal_to_slope, choice(),
      "The depth is measured normal to the bed: divided by the cosine of the bed's slope, from central differences.");
  describe_velocity(v, s.velocity);
}

template <class V>
void describe(V& v, SandSource& s) {
  v.field("center", s.center, length().required().like("[50 cm, 50 cm]"), "Centre of the disc.");
  v.field("radius", s.radius, length().above(0).required().like("2 cm"), "Radius of the disc.");
  v.field("rate", s.rate, volume_rate().at_least(0).required(),
          "Volume of sand per time, spread evenly over the disc. With one row, the row is one spacing wide.");
  v.field("start", s.start, time_span().at_least(0), "When it begins to flow.");
  v.field("end", s.end, time_span().above(0).required().like("10 s"), "When it ends.");
}

template <class V>
void describe(V& v, Hbar& h) {
  v.field("policy", h.policy, choice().required().like("truncated"),
          "full: hbar = h. constant: min(h, depth). scaled: scale h. truncated: min(scale h, cap).");
  v.field("depth", h.depth,
          length().above(0).required().like("10 cells").only(h.policy == HbarPolicy::constant, "policy: constant"),
          "The constant depth.");
  const bool truncated = h.policy == HbarPolicy::truncated;
  v.field("scale", h.scale,
          number().above(0).at_most(1).required().like("0.8").only(truncated || h.policy == HbarPolicy::scaled,
                                                                   "policy: scaled or truncated"),
          "Factor on the depth of the sand; a number, {raster: FILE} or zones {polygons: FILE, attribute: NAME, "
          "elsewhere: 0.8}.");
  v.field("cap", h.cap, length().above(0).required().like("5 cm").only(truncated, "policy: truncated"),
          "Largest depth of the dilute layer; a length, {raster: FILE, unit: m} or zones {polygons: FILE, attribute: "
          "NAME, unit: m, elsewhere: 5 cm}.");
}

template <class V>
void describe(V& v, Sand& s) {
  v.field(
      "friction_angle", s.friction_angle, angle().at_least(0).at_most(89.99),
      "Angle of friction; an angle, {raster: FILE, unit: deg} or zones {polygons: FILE, attribute: NAME, unit: deg, "
      "elsewhere: 25 deg}; cells that zones share take the mean by covered area. Exactly one of this and the "
      "coefficient is given.");
  v.field("friction_coefficient", s.friction_coefficient, number().at_least(0),
          "Tangent of the angle of friction; a number, {raster: FILE} or zones {polygons: FILE, attribute: NAME, "
          "elsewhere: 0.5}.");
  v.field("density", s.density, density().above(0),
          "Mass of sand per volume, for maps of pressure; the motion of dry sand does not depend on it.");
  v.field("hbar", s.hbar, section(), "Depth of the dilute layer, which is the part that moves.");
  v.field("initial", s.initial, list().single_allowed(), "Sand at the start; the parts of a list are added up.");
  v.field("sources", s.sources, list(), "Sand that rains onto discs, without momentum.");
}

// ---- boundaries, time, numerics -------------------------------------------------------------------------------------
template <class V>
void describe(V& v, Boundaries& b) {
  v.field("x_min", b.x_min, choice(), "The side at the smallest x.");
  v.field("x_max", b.x_max, choice(), "The side at the largest x.");
  v.field("y_min", b.y_min, choice(), "The side at the smallest y.");
  v.field("y_max", b.y_max, choice(), "The side at the largest y.");
}

template <class V>
void describe(V& v, TimeControl& t) {
  const char* const adaptive = "mode: adaptive";
  const char* const fixed = "mode: fixed";
  v.field("mode", t.mode, choice(), "Steps as long as stability allows, or all of one length.");
  v.field("courant", t.courant, number().above(0).at_most(1).only(t.mode == TimeMode::adaptive, adaptive),
          "Fraction of the stability bound; without it, the scheme's own.");
  v.field("step", t.step, time_span().above(0).required().like("2 ms").only(t.mode == TimeMode::fixed, fixed),
          "Length of a step.");
  v.field("subcycle", t.subcycle, choice().only(t.mode == TimeMode::fixed, fixed),
          "Split a step that breaks the stability bound, rather than stop.");
  v.field("end", t.end, time_span().above(0).required().like("3 s"), "Simulated time at which the run ends.");
  v.field("frame_interval", t.frame_interval, time_span().above(0).required().like("20 ms"),
          "Simulated time between frames of the output.");
  v.field("stop_at_rest", t.stop_at_rest, choice(), "End as soon as nothing moves and no source will flow.");
  v.field("minimum_step", t.minimum_step, time_span().above(0),
          "A step shorter than this stops the run; without it, 1e-9 of the end or 1e-6 of the first stable step.");
}

template <class V>
void describe(V& v, Numerics& n) {
  const char* const paper = "scheme: paper";
  v.field("scheme", n.scheme, choice(), "The well-balanced scheme, or the one of the paper.");
  const bool is_paper = n.scheme == Scheme::paper;
  v.field("order", n.order, number().at_least(1).at_most(2).only(!is_paper, "scheme: balanced"), "Order of accuracy.");
  v.field("precision", n.precision, choice(), "Precision of the fields.");
  v.field("momentum_flux", n.momentum_flux, choice().only(is_paper, paper), "hu^2, or hu^2/2 as eq. 7 prints it.");
  v.field("rest_gate", n.rest_gate, choice().only(is_paper, paper),
          "Cells at rest stay so until the slope exceeds the friction.");
  v.field("velocity", n.velocity, choice().only(is_paper, paper), "hu/h, or the desingularised form of eq. 13.");
}

// ---- particles ------------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, Particles& p) {
  v.field("spacing", p.spacing, length().above(0).required().like("0.5 cells"),
          "Side of the cells that hold a particle each: the grid's spacing, or a whole part of it.");
  v.field("layers", p.layers, number().at_least(1), "Layers of such cells, downwards from the surface.");
  v.field("seed", p.seed, number().at_least(0), "Of the places of the particles in their cells.");
  v.field("velocity", p.velocity, choice(),
          "averaged: particles move with the mean velocity of the column. dilute: h/hbar times as fast, as the upper "
          "layer moves over sand that stands.");
  v.field("max_factor", p.max_factor,
          number().at_least(1).only(p.velocity == ParticleVelocity::dilute, "velocity: dilute"),
          "Bound on the factor h/hbar.");
  v.field("hide_below", p.hide_below, length().at_least(0),
          "Particles in thinner sand are hidden; without it, a tenth of the grid's spacing.");
}

// ---- output ---------------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, Probe& p) {
  v.field("name", p.name, text().required().like("gate"), "Name in the output.");
  v.field("at", p.at, length().required().like("[50 cm, 0 m]"), "A point; its cell is recorded.");
}

template <class V>
void describe(V& v, MaximaOutput& m) {
  v.field(
      "above", m.above, length().at_least(0),
      "Speed and arrival count in sand deeper than this, and so do the numbers of the runout. Without it, 1 % of the "
      "largest depth at the start, or 1 % of the spacing where all sand comes from sources; and speed then counts "
      "only until a cell has drained to 37 % of its largest depth so far: what is left is faster than its fall.");
  v.field("pressure", m.pressure, choice(),
          "Also max_pressure, the largest dynamic pressure: density times the square of the speed.");
}

template <class V>
void describe(V& v, Output& o) {
  v.field("fields", o.fields, list().not_empty(), "Fields of every frame.");
  v.field("frames", o.frames, choice(), "false: no fields, only the numbers and probes of every frame.");
  v.field("maxima", o.maxima, section().or_switch().like("{above: 5 cm}"),
          "Maps of the largest depth and speed over the run and of the time of arrival.");
  v.field("probes", o.probes, list(), "Points where depth and velocity are recorded at every frame.");
  v.field("compression", o.compression, choice(), "Of the fields in series.h5.");
  v.field("checkpoint_interval", o.checkpoint_interval, time_span().above(0), "Wall-clock time between checkpoints.");
}

// ---- references -----------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, DamBreakReference& r) {
  v.field("dam", r.dam, length().required().like("40 cm"), "Where the dam stood.");
  v.field("depth", r.depth, length().above(0).required(), "Depth of the sand behind it.");
}

template <class V>
void describe(V& v, StokerReference& r) {
  v.field("dam", r.dam, length().required().like("40 cm"), "Where the dam stood.");
  v.field("depth", r.depth, length().above(0).required(), "Depth of the sand behind it.");
  v.field("downstream_depth", r.downstream_depth, length().above(0).required().like("5 cm"),
          "Depth of the sand in front of it.");
}

template <class V>
void describe(V& v, TwoLayerDamBreakReference& r) {
  v.field("dam", r.dam, length().required().like("40 cm"), "Where the dam stood.");
  v.field("depth", r.depth, length().above(0).required(), "Depth of the sand behind it.");
}

template <class V>
void describe(V& v, Reference& r) {
  v.field("front_depths", r.front_depths, length().at_least(0).single_allowed().like("[5 mm, 5 cm]"),
          "Depths of sand that define the front; its position is recorded for each.");
  v.field("exact", r.exact, section(), "An exact solution. 1-D scenes only.");
  v.field("profile", r.profile, file().like("deposit.csv"),
          "CSV of x and depth [m]: the deposit at the end. 1-D scenes only.");
  v.field("measured_profile", r.measured_profile, file().optional_file().like("measured_profile.csv"),
          "The same, measured; may be named before the file is there.");
  v.field("measured_front", r.measured_front, file().optional_file().like("measured_front.csv"),
          "CSV of time [s] and front position [m], measured; may be named before the file is there.");
}

// ---- the scene ------------------------------------------------------------------------------------------------------
template <class V>
void describe(V& v, Scene& s) {
  v.field("title", s.title, text(), "What the scene is, in a few words.");
  v.field("made_by", s.made_by, file().like("../../scripts/make_gis.py"),
          "The script that writes the files of this scene: named where one is missing. scripts/run calls it then.");
  v.field("grid", s.grid, section().required().like("{cells: [160, 1], spacing: 1 cm}"), "The cells.");
  v.field("gravity", s.gravity, acceleration().at_least(0), "Acceleration of gravity.");
  v.field("terrain", s.terrain, list().single_allowed().not_empty(), "The bed; the parts of a list are added up.");
  v.field("sand", s.sand, section().required().like("{friction_angle: 30 deg, initial: ...}"), "The sand.");
  v.field("boundaries", s.boundaries, section(), "What happens at the four sides.");
  v.field("time", s.time, section().required().like("{end: 3 s, frame_interval: 20 ms}"), "Steps and frames.");
  v.field("numerics", s.numerics, section(), "Scheme and precision.");
  v.field("objects", s.objects, list(), "Bodies that move as they are told and push the sand.");
  v.field("particles", s.particles, section(), "Particles that follow the sand, for pictures; they do not act on it.");
  v.field("output", s.output, section(), "What is written.");
  v.field("reference", s.reference, section(), "What the error of the run is taken against.");
}

}  // namespace sandsim
