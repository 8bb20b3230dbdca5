#include "io/output/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/hdf5/hdf5.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/atomic_hdf5.hpp"
#include "io/output/version.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;
using hdf5::Handle;
using hdf5::require;

/// Format of the file; raised whenever its content changes its meaning.
constexpr std::int64_t format_version = 4;

/// The numbers of a checkpoint under their names; one list serves writing and reading.
template <class AnyCheckpoint, class Visitor>
void visit_numbers(AnyCheckpoint& checkpoint, Visitor&& visit) {
  visit("steps", checkpoint.steps);
  visit("frames", checkpoint.frames);
  visit("time", checkpoint.time);
  visit("frame_step_min", checkpoint.frame_step_min);
  visit("frame_step_max", checkpoint.frame_step_max);
  visit("wall_time", checkpoint.wall_time);
  visit("volume_initial", checkpoint.ledger.initial);
  visit("volume_final", checkpoint.ledger.final);
  visit("volume_in", checkpoint.ledger.in);
  visit("volume_out", checkpoint.ledger.out);
  visit("volume_clipped", checkpoint.ledger.clipped);
  visit("dt_min", checkpoint.dt_min);
  visit("dt_max", checkpoint.dt_max);
  visit("smallest_step_i", checkpoint.smallest_step.i);
  visit("smallest_step_j", checkpoint.smallest_step.j);
  visit("smallest_step_time", checkpoint.smallest_step.time);
  visit("smallest_step_step", checkpoint.smallest_step.step);
  visit("stop_time", checkpoint.stop_time);
  visit("runout_max_depth", checkpoint.runout.max_depth);
  visit("runout_max_speed", checkpoint.runout.max_speed);
  visit("particle_count", checkpoint.particles.report.count);
  visit("particle_moves", checkpoint.particles.report.moves);
  visit("particle_born", checkpoint.particles.report.born);
  visit("particle_merged", checkpoint.particles.report.merged);
  visit("particle_left", checkpoint.particles.report.left);
}

/// The other arrays, each of one type: where sand has been, empty with output.maxima; the particles', empty without.
template <class AnyCheckpoint, class Visitor>
void visit_arrays(AnyCheckpoint& checkpoint, Visitor&& visit) {
  visit("reached", checkpoint.runout.reached);
  visit("particle_offset_x", checkpoint.particles.offset_x);
  visit("particle_offset_y", checkpoint.particles.offset_y);
  visit("particle_id", checkpoint.particles.id);
  visit("particle_velocity_x", checkpoint.particles.velocity_x);
  visit("particle_velocity_y", checkpoint.particles.velocity_y);
}

template <class AnyCheckpoint, class Visitor>
void visit_fields(AnyCheckpoint& checkpoint, Visitor&& visit) {
  visit("depth", checkpoint.state.depth);
  visit("momentum_x", checkpoint.state.momentum_x);
  visit("momentum_y", checkpoint.state.momentum_y);
  visit("bed", checkpoint.state.bed);
  visit("buried", checkpoint.state.buried);
  visit("max_depth", checkpoint.max_depth);
  visit("max_speed", checkpoint.max_speed);
  visit("arrival_time", checkpoint.arrival_time);
}

template <class Number>
void write_field(hid_t file, const std::string& name, const std::vector<Number>& values) {
  if (values.empty()) return;
  const std::string tried = "write " + name;
  const hsize_t size = values.size();
  const hsize_t chunk = std::min<hsize_t>(size, 1 << 16);
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, tried);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, tried);
  require(H5Pset_chunk(properties.id(), 1, &chunk), tried);
  // A checksum on every chunk: a run must not go on from damaged numbers.
  require(H5Pset_fletcher32(properties.id()), tried);
  const hid_t type = hdf5::native_type<Number>();
  const Handle dataset(H5Dcreate2(file, name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                       H5Dclose, tried);
  hdf5::write(dataset.id(), type, values.data());
}

std::size_t bytes_of(const Checkpoint& checkpoint) {
  std::size_t bytes = 1 << 20;
  visit_fields(checkpoint, [&bytes](const char*, const FieldValues& field) {
    bytes += std::visit([](const auto& values) { return values.size() * sizeof values[0]; }, field);
  });
  visit_arrays(checkpoint, [&bytes](const char*, const auto& values) { bytes += values.size() * sizeof values[0]; });
  return bytes;
}

void write_content(hid_t file, const Checkpoint& checkpoint, const std::string& scene_hash) {
  hdf5::write_attribute(file, "format_version", format_version);
  hdf5::write_attribute(file, "source", source_line());
  hdf5::write_attribute(file, "scene_hash", scene_hash);
  hdf5::write_attribute(file, "smallest_step_cause", checkpoint.smallest_step.cause);
  visit_numbers(checkpoint, [file](const char* name, const auto& number) {
    if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(number)>>) {
      hdf5::write_attribute(file, name, number);
    } else {
      hdf5::write_attribute(file, name, std::int64_t{number});
    }
  });
  visit_fields(checkpoint, [file](const char* name, const FieldValues& field) {
    std::visit([&](const auto& values) { write_field(file, name, values); }, field);
  });
  visit_arrays(checkpoint, [file](const char* name, const auto& values) { write_field(file, name, values); });
}

/// The maxima are there only if the scene asks for them, the bed and what is buried only with objects that cover sand.
void read_field(hid_t file, const std::string& name, FieldValues& field) {
  if (!hdf5::exists(file, name)) {
    if (name == "depth" || name.starts_with("momentum")) throw hdf5::Failure("it has no " + name);
    return;
  }
  if (hdf5::element_size(hdf5::open_dataset(file, name).id()) == sizeof(float)) {
    field = hdf5::read_all<float>(file, name);
  } else {
    field = hdf5::read_all<double>(file, name);
  }
}

Checkpoint read_content(hid_t file) {
  Checkpoint checkpoint;
  checkpoint.smallest_step.cause = hdf5::read_text_attribute(file, "smallest_step_cause").value_or("");
  visit_numbers(checkpoint, [file](const char* name, auto& number) {
    using Number = std::remove_cvref_t<decltype(number)>;
    if constexpr (std::is_floating_point_v<Number>) {
      number = hdf5::read_double_attribute(file, name);
    } else {
      number = static_cast<Number>(hdf5::read_integer_attribute(file, name));
    }
  });
  visit_fields(checkpoint, [file](const char* name, FieldValues& field) { read_field(file, name, field); });
  visit_arrays(checkpoint, [file](const char* name, auto& values) {
    using Number = typename std::remove_cvref_t<decltype(values)>::value_type;
    if (hdf5::exists(file, name)) values = hdf5::read_all<Number>(file, name);
  });
  return checkpoint;
}

void require_same_scene(hid_t file, const std::string& scene_hash, const fs::path& path) {
  const std::int64_t format = hdf5::read_integer_attribute(file, "format_version");
  if (format != format_version) {
    throw InputError(fmt::format("{}: a checkpoint of format {}; this sandsim reads format {}", path.string(), format,
                                 format_version));
  }
  const std::string found = hdf5::read_text_attribute(file, "scene_hash").value_or("");
  if (found != scene_hash) {
    throw InputError(
        fmt::format("{}: the checkpoint of another scene ({}, this one is {}): the scene or one of its "
                    "input files has changed since. Run it anew with --overwrite?",
                    path.string(), found, scene_hash));
  }
}

}  // namespace

void write_checkpoint(const fs::path& path, const Checkpoint& checkpoint, const std::string& scene_hash) {
  const fs::path directory = path.has_parent_path() ? path.parent_path() : fs::path(".");
  require_free_space(directory, static_cast<double>(bytes_of(checkpoint)));
  write_hdf5_atomically(path, [&](hid_t file) { write_content(file, checkpoint, scene_hash); });
}

Checkpoint read_checkpoint(const fs::path& path, const std::string& scene_hash) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    throw InputError(fmt::format("{}: there is no checkpoint to resume from", path.string()));
  }
  const hdf5::Session session;
  try {
    const Handle file = hdf5::open_file(path, false);
    require_same_scene(file.id(), scene_hash, path);
    return read_content(file.id());
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: not a checkpoint, or damaged: {}", path.string(), failure.what()));
  }
}

}  // namespace sandsim
