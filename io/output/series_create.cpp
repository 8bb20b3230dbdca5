#include "io/output/series_create.hpp"

#include <fmt/format.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <limits>

#include "io/output/run_report.hpp"
#include "io/output/version.hpp"
#include "solver/particles.hpp"

namespace sandsim {
namespace {

using hdf5::Handle;
using hdf5::require;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

hsize_t length_of(Dimension dimension, const Scene& scene) {
  switch (dimension) {
    case Dimension::time:
      return 0;
    case Dimension::y:
      return static_cast<hsize_t>(scene.grid.cells[1]);
    case Dimension::x:
      return static_cast<hsize_t>(scene.grid.cells[0]);
    case Dimension::probe:
      return scene.output.probes.size();
    case Dimension::front_depth:
      return scene.reference ? scene.reference->front_depths.size() : 0;
    case Dimension::object:
      return coupled_object_count(scene);
    case Dimension::particle:
      return static_cast<hsize_t>(particle_count(scene.grid, scene.particles));
    case Dimension::axis:
      return 3;
    case Dimension::quaternion:
      return 4;
  }
  return 0;
}

/// Numbers that were never written read as NaN or -1, so that a hole in the file does not look like dry ground.
void set_fill_value(hid_t properties, const Variable& variable) {
  const std::string tried = "set the fill value of " + variable.name;
  if (variable.type == NumberType::int64 || variable.type == NumberType::int8) {
    const std::int64_t none = -1;
    require(H5Pset_fill_value(properties, H5T_NATIVE_INT64, &none), tried);
  } else if (variable.type != NumberType::text && variable.type != NumberType::nothing) {
    // A flat bed is never written: it reads as zero and costs nothing.
    const double fill = variable.name == "bed" ? 0.0 : not_a_number;
    require(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &fill), tried);
  }
}

Handle creation_properties(const Variable& variable, const Scene& scene) {
  const std::string tried = "set up " + variable.name;
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, tried);
  set_fill_value(properties.id(), variable);
  if (!variable.over_time() && !variable.in_chunks()) return properties;
  const std::vector<hsize_t> chunk = chunk_extent(variable, scene);
  require(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()), tried);
  if (scene.output.compression == Compression::gzip && variable.in_chunks()) {
    require(H5Pset_shuffle(properties.id()), tried);
    // Higher levels take many times longer and gain a few percent.
    require(H5Pset_deflate(properties.id(), 1), tried);
  }
  return properties;
}

Handle variable_text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type");
  require(H5Tset_size(type.id(), H5T_VARIABLE), "size a text type");
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text type UTF-8");
  return type;
}

Handle create_dataset(hid_t file, const Variable& variable, const Scene& scene) {
  const std::string tried = "create " + variable.name;
  const std::vector<hsize_t> size = initial_extent(variable, scene);
  std::vector<hsize_t> largest = size;
  if (variable.over_time()) largest.front() = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), largest.data()), H5Sclose, tried);
  const Handle properties = creation_properties(variable, scene);
  const Handle text = variable_text_type();
  const hid_t type = variable.type == NumberType::text ? text.id() : stored_type(variable, scene.numerics.precision);
  return Handle(H5Dcreate2(file, variable.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                H5Dclose, tried);
}

/// The CRS for readers of CF and, as spatial_ref with the corner of the grid, for GDAL.
void describe_crs(hid_t dataset, const Grid& grid) {
  hdf5::write_attribute(dataset, "crs_wkt", grid.crs.wkt);
  hdf5::write_attribute(dataset, "spatial_ref", grid.crs.wkt);
  const double north = grid.origin[1] + grid.cells[1] * grid.spacing;
  hdf5::write_attribute(dataset, "GeoTransform",
                        fmt::format("{} {} 0 {} 0 {}", grid.origin[0], grid.spacing, north, -grid.spacing));
}

void describe(hid_t dataset, const Variable& variable, const Scene& scene) {
  const Precision precision = scene.numerics.precision;
  if (variable.type == NumberType::nothing) return;
  hdf5::write_attribute(dataset, "long_name", variable.long_name);
  if (variable.name == grid_mapping_name) {
    describe_crs(dataset, scene.grid);
    return;
  }
  if (scene.grid.crs.known() && variable.over_grid()) {
    hdf5::write_attribute(dataset, "grid_mapping", std::string(grid_mapping_name));
  }
  if (!variable.units.empty()) hdf5::write_attribute(dataset, "units", variable.units);
  if (variable.name == "x") hdf5::write_attribute(dataset, "standard_name", std::string("projection_x_coordinate"));
  if (variable.name == "y") hdf5::write_attribute(dataset, "standard_name", std::string("projection_y_coordinate"));
  if (variable.name == "time") hdf5::write_attribute(dataset, "axis", std::string("T"));
  if (variable.name == "x") hdf5::write_attribute(dataset, "axis", std::string("X"));
  if (variable.name == "y") hdf5::write_attribute(dataset, "axis", std::string("Y"));
  if (variable.dimensions.back() == Dimension::probe && variable.over_time()) {
    hdf5::write_attribute(dataset, "coordinates", std::string("probe_name probe_x probe_y"));
  }
  // CF allows no missing values in coordinates. A bed has none; counts keep their integer type without one.
  if (variable.coordinate() || variable.name == "bed") return;
  if (variable.type == NumberType::real && precision == Precision::float32) {
    hdf5::write_attribute(dataset, "_FillValue", static_cast<float>(not_a_number));
  } else if (variable.type == NumberType::real || variable.type == NumberType::float64) {
    hdf5::write_attribute(dataset, "_FillValue", not_a_number);
  }
}

void attach_dimensions(hid_t file, hid_t dataset, const Variable& variable, const Scene& scene) {
  if (variable.coordinate()) {
    const bool bare = variable.type == NumberType::nothing;
    const std::string name =
        bare ? fmt::format("{}{:>10}", bare_dimension_name, length_of(variable.dimensions[0], scene)) : variable.name;
    require(H5DSset_scale(dataset, name.c_str()), "make " + variable.name + " a dimension");
    return;
  }
  for (std::size_t axis = 0; axis < variable.dimensions.size(); ++axis) {
    const Handle scale = hdf5::open_dataset(file, name_of(variable.dimensions[axis]));
    require(H5DSattach_scale(dataset, scale.id(), static_cast<unsigned>(axis)),
            "attach the dimensions of " + variable.name);
  }
}

void write_doubles(hid_t file, const std::string& name, const std::vector<double>& values) {
  hdf5::write(hdf5::open_dataset(file, name).id(), H5T_NATIVE_DOUBLE, values.data());
}

/// Numbers the items of a dimension, and names them.
void write_names(hid_t file, const std::string& dimension, const std::vector<std::string>& names) {
  std::vector<std::int64_t> numbers;
  std::vector<const char*> texts;
  for (const std::string& name : names) {
    numbers.push_back(static_cast<std::int64_t>(numbers.size()));
    texts.push_back(name.c_str());
  }
  hdf5::write(hdf5::open_dataset(file, dimension).id(), H5T_NATIVE_INT64, numbers.data());
  hdf5::write(hdf5::open_dataset(file, dimension + "_name").id(), variable_text_type().id(), texts.data());
}

void write_object_names(hid_t file, const std::vector<KinematicObject>& objects) {
  std::vector<std::string> names;
  for (const KinematicObject& object : objects) {
    if (!object.is_terrain()) names.push_back(object.name);
  }
  write_names(file, "object", names);
}

void write_probe_coordinates(hid_t file, const std::vector<Probe>& probes) {
  std::vector<std::string> names;
  std::vector<double> x, y;
  for (const Probe& probe : probes) {
    names.push_back(probe.name);
    x.push_back(probe.at[0]);
    y.push_back(probe.at[1]);
  }
  write_names(file, "probe", names);
  write_doubles(file, "probe_x", x);
  write_doubles(file, "probe_y", y);
}

}  // namespace

hid_t stored_type(const Variable& variable, Precision precision) {
  if (variable.type == NumberType::int64) return H5T_STD_I64LE;
  if (variable.type == NumberType::int8) return H5T_STD_I8LE;
  const bool single =
      variable.type == NumberType::nothing || (variable.type == NumberType::real && precision == Precision::float32);
  return single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
}

std::vector<hsize_t> initial_extent(const Variable& variable, const Scene& scene) {
  std::vector<hsize_t> lengths;
  for (const Dimension dimension : variable.dimensions) lengths.push_back(length_of(dimension, scene));
  return lengths;
}

std::vector<hsize_t> chunk_extent(const Variable& variable, const Scene& scene) {
  constexpr hsize_t side = 256;
  const std::vector<hsize_t> size = initial_extent(variable, scene);
  std::vector<hsize_t> chunk(size.size());
  hsize_t room = side * side;
  for (std::size_t axis = 0; axis < size.size(); ++axis) {
    const bool last = axis + 1 == size.size();
    if (variable.dimensions[axis] == Dimension::time) {
      // Numbers per frame are gathered; a field has a chunk of its own in every frame.
      chunk[axis] = variable.in_chunks() ? 1 : side;
    } else if (variable.dimensions[axis] == Dimension::particle) {
      chunk[axis] = std::min(size[axis], side * side);
    } else {
      // What a thin grid leaves free along y is given to x, or a long row would be cut into many small chunks.
      chunk[axis] = std::min(size[axis], last ? std::max(side, room) : side);
    }
    room /= chunk[axis];
  }
  return chunk;
}

SeriesGrowth growth_of(const Scene& scene) {
  SeriesGrowth growth;
  for (const Variable& variable : series_layout(scene)) {
    if (!variable.over_time()) continue;
    const std::vector<hsize_t> size = initial_extent(variable, scene);
    const std::vector<hsize_t> chunk = chunk_extent(variable, scene);
    auto bytes = static_cast<std::int64_t>(H5Tget_size(stored_type(variable, scene.numerics.precision)));
    std::int64_t chunks = 1;
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
      bytes *= static_cast<std::int64_t>(chunk[axis]);
      if (axis > 0) chunks *= static_cast<std::int64_t>((size[axis] + chunk[axis] - 1) / chunk[axis]);
    }
    if (chunk.front() == 1) {
      growth.field_bytes += chunks * bytes;
      growth.field_chunks += chunks;
      ++growth.field_count;
    } else {
      growth.number_bytes += chunks * bytes;
      ++growth.number_count;
    }
  }
  return growth;
}

void create_variables(hid_t file, const Scene& scene) {
  for (const Variable& variable : series_layout(scene)) {
    const Handle dataset = create_dataset(file, variable, scene);
    describe(dataset.id(), variable, scene);
    attach_dimensions(file, dataset.id(), variable, scene);
  }
}

void write_coordinates(hid_t file, const Scene& scene) {
  std::vector<double> x, y;
  for (int i = 0; i < scene.grid.cells[0]; ++i) x.push_back(scene.grid.x(i));
  for (int j = 0; j < scene.grid.cells[1]; ++j) y.push_back(scene.grid.y(j));
  write_doubles(file, "x", x);
  write_doubles(file, "y", y);
  if (!scene.output.probes.empty()) write_probe_coordinates(file, scene.output.probes);
  if (coupled_object_count(scene) > 0) write_object_names(file, scene.objects);
  if (scene.reference && !scene.reference->front_depths.empty()) {
    write_doubles(file, "front_depth", scene.reference->front_depths);
  }
}

void write_global_attributes(hid_t file, const Scene& scene, const SeriesSettings& settings) {
  hdf5::write_attribute(file, "Conventions", std::string("CF-1.10"));
  hdf5::write_attribute(file, "title", scene.title);
  hdf5::write_attribute(file, "source", source_line());
  hdf5::write_attribute(file, "history", time_stamp() + " " + settings.history);
  hdf5::write_attribute(file, "scene", settings.resolved_scene);
  hdf5::write_attribute(file, "device", settings.device);
  hdf5::write_attribute(file, "version", version());
  hdf5::write_attribute(file, "commit", commit());
  const bool single = scene.numerics.precision == Precision::float32;
  hdf5::write_attribute(file, "precision", std::string(single ? "float32" : "float64"));
}

}  // namespace sandsim
