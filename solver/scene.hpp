// The scene: everything a run needs to know, as plain values in SI units.
// Member names are the keys of the scene file and the names in the output.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/polygons.hpp"
#include "solver/raster.hpp"
#include "solver/scene_objects.hpp"

namespace sandsim {

enum class Precision { float32, float64 };
enum class Scheme { balanced, paper };
/// Momentum flux of the paper's scheme: hu^2, or hu^2/2 as eq. 7 prints it.
enum class MomentumFlux { full, printed };
/// Velocity of the paper's scheme: hu/h, or the desingularised form of eq. 13.
enum class VelocityForm { quotient, desingularised };
enum class BoundaryKind { wall, open, periodic };
enum class HbarPolicy { full, constant, scaled, truncated };
/// What becomes of cells where a raster of the terrain has no data.
enum class Nodata { error, wall, nearest };
/// Of the values of an attribute of polygons.
enum class LengthUnit { m, cm, mm };
enum class TimeMode { adaptive, fixed };
enum class OutputField { depth, velocity, surface, momentum };
enum class Compression { none, gzip };
/// What carries particles: the mean velocity of the column (eq. 31), or that of the dilute layer (section 6.2).
enum class ParticleVelocity { averaged, dilute };

/// Cell centres are at origin + (i + 1/2) spacing. One row (cells[1] == 1) is a 1-D scene.
struct Grid {
  std::array<int, 2> cells{0, 0};          // x, y
  double spacing = 0.0;                    // [m] same in x and y
  std::array<double, 2> origin{0.0, 0.0};  // [m] corner of the grid
  Crs crs{};                               // of the coordinates; unknown: they are the scene's own

  double x(int i) const { return origin[0] + (i + 0.5) * spacing; }
  double y(int j) const { return origin[1] + (j + 0.5) * spacing; }
  bool one_dimensional() const { return cells[1] == 1; }
  std::size_t cell_count() const { return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]); }
};

// ---- terrain: the parts are added up ------------------------------------------------------------------------------
struct FlatTerrain {
  double elevation = 0.0;  // [m]
};
/// Bed falling along `direction`: b = elevation - tan(inclination) ((x - origin_x) cos + (y - origin_y) sin).
struct PlaneTerrain {
  double inclination = 0.0;  // [rad]
  double direction = 0.0;    // [rad] 0 is +x
  double elevation = 0.0;    // [m] at the grid's origin
};
struct RasterTerrain {
  RasterFile file;
  double scale = 1.0;   // factor on the raster's values
  double offset = 0.0;  // [m] added after scaling
  Nodata nodata = Nodata::error;
};
using TerrainPart = std::variant<FlatTerrain, PlaneTerrain, RasterTerrain>;

// ---- sand -----------------------------------------------------------------------------------------------------------
/// Zones with a value each, and one for the rest of the grid. A cell takes the mean by covered area.
struct ZoneMap {
  PolygonFile polygons;  // values in the unit of `elsewhere`
  double elsewhere = 0.0;
};
/// One number for the whole grid, or a map.
using ScalarMap = std::variant<double, RasterFile, ZoneMap>;

/// hbar, the depth of the dilute layer (section 3.1 of the paper).
struct Hbar {
  HbarPolicy policy = HbarPolicy::full;
  double depth = 0.0;     // [m] constant: hbar = min(h, depth)
  ScalarMap scale = 1.0;  // [-] scaled, truncated: hbar = min(scale h, cap)
  ScalarMap cap = 0.0;    // [m] truncated
};

/// Exactly one of the two is set: a depth that is added, or a level up to which the sand is filled.
struct Fill {
  std::optional<double> depth;    // [m]
  std::optional<double> surface;  // [m]
};
// `place` is where the part is written, "scene.yaml:7:30", for messages; empty in scenes that were not read.

/// Sand brings the momentum of its velocity along; what other parts add to a cell mixes with it.
using SandVelocity = std::array<double, 2>;  // [m/s] x, y; y is 0 in a 1-D scene
/// Cells partly inside get the covered fraction of the depth. In a 1-D scene only x counts.
struct SandBox {
  std::array<double, 2> from{0.0, 0.0};  // [m]
  std::array<double, 2> to{0.0, 0.0};    // [m]
  Fill fill;
  SandVelocity velocity{0.0, 0.0};
  std::string place{};
};
struct SandColumn {
  std::array<double, 2> center{0.0, 0.0};  // [m]
  double radius = 0.0;                     // [m]
  Fill fill;
  SandVelocity velocity{0.0, 0.0};
  std::string place{};
};
struct SandCone {
  std::array<double, 2> center{0.0, 0.0};  // [m]
  double radius = 0.0;                     // [m]
  double height = 0.0;                     // [m] of sand at the centre
  SandVelocity velocity{0.0, 0.0};
  std::string place{};
};
struct SandLayer {
  Fill fill;
  SandVelocity velocity{0.0, 0.0};
  std::string place{};
};
/// Depths go onto the cells by covered area, NODATA is no sand.
struct SandRaster {
  RasterFile file;  // depth [m]
  double scale = 1.0;
  SandVelocity velocity{0.0, 0.0};
  std::string place{};
};
/// Overlapping features add up. Cells partly inside get the covered fraction.
struct SandPolygon {
  PolygonFile file;             // exactly one of its attribute and `depth` is given
  std::optional<double> depth;  // [m] of all features
  LengthUnit unit = LengthUnit::m;
  bool normal_to_slope = false;  // the depth is measured normal to the bed: made a vertical one
  SandVelocity velocity{0.0, 0.0};
  std::string place{};
};
using SandPart = std::variant<SandBox, SandColumn, SandCone, SandLayer, SandRaster, SandPolygon>;

/// Sand that rains onto a disc without momentum, evenly over the cells whose centres lie inside (at least one).
struct SandSource {
  std::array<double, 2> center{0.0, 0.0};  // [m]
  double radius = 0.0;                     // [m]
  double rate = 0.0;                       // [m^3/s]; in a 1-D scene the row is one spacing wide
  double start = 0.0;                      // [s]
  double end = 0.0;                        // [s]
};

struct Sand {
  std::optional<ScalarMap> friction_angle;        // [rad]; exactly one of the two is set
  std::optional<ScalarMap> friction_coefficient;  // [-]
  std::optional<double> density;                  // [kg/m^3] for maps of pressure; the motion does not depend on it
  Hbar hbar;
  std::vector<SandPart> initial;
  std::vector<SandSource> sources;
};

struct Boundaries {
  BoundaryKind x_min = BoundaryKind::wall;
  BoundaryKind x_max = BoundaryKind::wall;
  BoundaryKind y_min = BoundaryKind::wall;
  BoundaryKind y_max = BoundaryKind::wall;
};

struct TimeControl {
  TimeMode mode = TimeMode::adaptive;
  std::optional<double> courant;  // [-] absent: the scheme's own (numerics.hpp)
  double step = 0.0;              // [s] fixed
  bool subcycle = false;          // fixed: split a step that breaks the stability bound
  double end = 0.0;               // [s]
  double frame_interval = 0.0;    // [s]
  bool stop_at_rest = false;
  std::optional<double> minimum_step;  // [s] below this the run stops; absent: 1e-9 of `end`, at most 1e-6 of the first
};

struct Numerics {
  Scheme scheme = Scheme::balanced;
  int order = 2;  // balanced: 1 or 2
  Precision precision = Precision::float32;
  MomentumFlux momentum_flux = MomentumFlux::full;       // paper only
  bool rest_gate = true;                                 // paper only
  VelocityForm velocity = VelocityForm::desingularised;  // paper only
};

struct Probe {
  std::string name;
  std::array<double, 2> at{0.0, 0.0};  // [m] the cell that holds the point
};

/// Maps of the largest values over the run: max_depth, max_speed, arrival_time.
struct MaximaOutput {
  std::optional<double> above;  // [m] speed and arrival count in deeper sand only; absent: see runout.hpp
  bool pressure = false;        // also max_pressure; needs sand.density
};

struct Output {
  std::vector<OutputField> fields{OutputField::depth, OutputField::velocity};
  bool frames = true;  // false: no series of fields, only the per-frame numbers and probes
  std::optional<MaximaOutput> maxima;
  std::vector<Probe> probes;
  Compression compression = Compression::none;
  double checkpoint_interval = 600.0;  // [s] of wall clock between checkpoints
};

/// Particles that follow the sand, for pictures (section 6). They do not act on the sand.
struct Particles {
  double spacing = 0.0;  // [m] of their grid J; the grid's spacing over a whole number
  int layers = 1;        // of the grid J, downwards from the surface
  int seed = 0;          // of their positions within the cells of J
  ParticleVelocity velocity = ParticleVelocity::averaged;
  double max_factor = 10.0;          // [-] dilute: bound on h/hbar
  std::optional<double> hide_below;  // [m] particles in thinner sand are hidden; absent: a tenth of the grid's spacing
};

// ---- references: what the run's error is taken against ----------------------------------------------------------
/// Dam break on a uniform slope with friction, hbar = alpha h (reference: Ritter; Mangeney et al. 2000). The dam is
/// at `dam`, sand of depth `depth` at smaller x. Valid until the fan meets a wall; the tip until it stops.
struct DamBreakReference {
  double dam = 0.0;    // [m]
  double depth = 0.0;  // [m]
};
/// Stoker's dam break onto a layer of depth `downstream_depth`, no friction, hbar = h.
struct StokerReference {
  double dam = 0.0;               // [m]
  double depth = 0.0;             // [m]
  double downstream_depth = 0.0;  // [m]
};
/// Dam break of the two-layer model, hbar = min(scale h, cap); with friction the tip only.
struct TwoLayerDamBreakReference {
  double dam = 0.0;    // [m]
  double depth = 0.0;  // [m]
};
using ExactReference = std::variant<DamBreakReference, StokerReference, TwoLayerDamBreakReference>;

/// A table of (x, depth), ascending in x, piecewise linear, for the profile at the end of the run (1-D scenes).
struct Profile {
  std::string file;           // as written in the scene
  std::vector<double> x;      // [m]
  std::vector<double> depth;  // [m]
};
/// A table of (time, front position).
struct FrontCurve {
  std::string file;
  std::vector<double> time;   // [s]
  std::vector<double> front;  // [m]
};

struct Reference {
  std::vector<double> front_depths;  // [m] thresholds of depth that define the front
  std::optional<ExactReference> exact;
  std::optional<Profile> profile;            // a converged or otherwise known deposit
  std::optional<Profile> measured_profile;   // measured; may be named before the file is there: then x is empty
  std::optional<FrontCurve> measured_front;  // likewise
};

/// The script that writes the files which a scene names: for messages, nothing runs it here.
struct ScriptFile {
  std::string file;  // as written in the scene
};

struct Scene {
  std::string title;
  std::optional<ScriptFile> made_by;
  Grid grid;
  double gravity = 9.8;  // [m/s^2]
  std::vector<TerrainPart> terrain{FlatTerrain{}};
  Sand sand;
  Boundaries boundaries;
  TimeControl time;
  Numerics numerics;
  std::vector<KinematicObject> objects;
  std::optional<Particles> particles;
  Output output;
  std::optional<Reference> reference;
};

}  // namespace sandsim
