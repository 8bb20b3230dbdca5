#include "io/output/series_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "io/output/atomic_file.hpp"
#include "io/output/series_create.hpp"
#include "solver/errors.hpp"
#include "solver/particles.hpp"

namespace sandsim {
namespace {

using hdf5::require;

std::size_t value_count(const FieldValues& values) {
  return std::visit([](const auto& numbers) { return numbers.size(); }, values);
}

const void* data_of(const FieldValues& values) {
  return std::visit([](const auto& numbers) -> const void* { return numbers.data(); }, values);
}

hid_t memory_type(const FieldValues& values) {
  return std::holds_alternative<std::vector<float>>(values) ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
}

/// density times speed squared. [Pa]
FieldValues pressure_of(FieldValues speed, double density) {
  std::visit(
      [density]<class R>(std::vector<R>& values) {
        for (R& value : values) value = static_cast<R>(density) * value * value;
      },
      speed);
  return speed;
}

int descriptor_of(hid_t file) {
  void* descriptor = nullptr;
  require(H5Fget_vfd_handle(file, H5P_DEFAULT, &descriptor), "get the file's descriptor");
  return *static_cast<int*>(descriptor);
}

}  // namespace

SeriesFile::SeriesFile(const std::filesystem::path& path, const Scene& scene, hdf5::Handle file)
    : path_(path),
      output_(scene.output),
      density_(scene.sand.density.value_or(0.0)),
      exact_reference_(scene.reference && scene.reference->exact),
      front_count_(scene.reference ? scene.reference->front_depths.size() : 0),
      object_count_(coupled_object_count(scene)),
      particle_count_(static_cast<std::size_t>(particle_count(scene.grid, scene.particles))),
      grid_{static_cast<hsize_t>(scene.grid.cells[1]), static_cast<hsize_t>(scene.grid.cells[0])},
      file_(std::move(file)) {
  const std::vector<Variable> layout = series_layout(scene);
  for (const Variable& variable : layout) {
    variables_.push_back({variable, hdf5::open_dataset(file_.id(), variable.name)});
  }
  space_.emplace(descriptor_of(file_.id()), path);
  reserve_.emplace(file_.id(), growth_of(scene));
}

SeriesFile SeriesFile::create(const std::filesystem::path& path, const Scene& scene, const SeriesSettings& settings) {
  hdf5::Handle file = hdf5::create_file(path);
  DiskSpace(descriptor_of(file.id()), path).claim(1 << 20);
  write_global_attributes(file.id(), scene, settings);
  create_variables(file.id(), scene);
  write_coordinates(file.id(), scene);
  SeriesFile series(path, scene, std::move(file));
  series.flush();
  return series;
}

void SeriesFile::write_bed(const FieldValues& bed) {
  if (value_count(bed) == 0 || !output_.frames) return;
  space_->claim(static_cast<std::int64_t>(grid_[0] * grid_[1] * 8 + 65536));
  write_map("bed", bed);
  flush();
}

const OpenVariable& SeriesFile::find(const std::string& name) const {
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [&name](const OpenVariable& open) { return open.variable.name == name; });
  if (found == variables_.end()) throw OutputError(fmt::format("{}: the series has no {}", path_.string(), name));
  return *found;
}

void SeriesFile::write_map(const std::string& name, const FieldValues& values) {
  if (value_count(values) != grid_[0] * grid_[1]) {
    throw OutputError(fmt::format("{}: {} has {} values for {} x {} cells", path_.string(), name, value_count(values),
                                  grid_[1], grid_[0]));
  }
  hdf5::write(find(name).dataset.id(), memory_type(values), data_of(values));
}

void SeriesFile::check(const Frame& frame) const {
  const auto refuse = [this, &frame](const std::string& problem) {
    throw OutputError(fmt::format("{}: frame {}: {}", path_.string(), frame.index, problem));
  };
  if (frame.index != frames_) refuse(fmt::format("{} frames have been written", frames_));
  std::size_t expected = 0;
  for (const OpenVariable& open : variables_) {
    expected += open.variable.over_time() && open.variable.over_grid() && open.variable.type == NumberType::real;
  }
  if (frame.fields.size() != expected) refuse(fmt::format("{} fields, not {}", frame.fields.size(), expected));
  for (const NamedField& field : frame.fields) {
    find(field.name);
    const std::size_t count = value_count(field.values);
    if (count != grid_[0] * grid_[1]) refuse(fmt::format("{} has {} values", field.name, count));
  }
  if (frame.probes.size() != output_.probes.size()) refuse(fmt::format("{} probes", frame.probes.size()));
  if (frame.fronts.size() != front_count_) refuse(fmt::format("{} fronts, not {}", frame.fronts.size(), front_count_));
  if (frame.objects.size() != object_count_) refuse(fmt::format("{} objects", frame.objects.size()));
  const ParticleFrame& particles = frame.particles;
  if (particles.id.size() != particle_count_ || particles.visible.size() != particle_count_ ||
      particles.position.size() != 3 * particle_count_) {
    refuse(fmt::format("{} particles, not {}", particles.id.size(), particle_count_));
  }
  const std::size_t row = frame.reference_depth.size();
  if (exact_reference_ && row != 0 && row != grid_[1]) refuse(fmt::format("reference_depth has {} values", row));
}

void SeriesFile::extend(const OpenVariable& open, hsize_t frames) const {
  std::vector<hsize_t> size = hdf5::extent(open.dataset.id());
  if (size.front() == frames) return;
  size.front() = frames;
  require(H5Dset_extent(open.dataset.id(), size.data()), "extend " + open.variable.name);
}

void SeriesFile::write_values(const std::string& name, const FieldValues& values) const {
  const hdf5::Block block{{static_cast<hsize_t>(frames_), 0, 0}, {1, grid_[0], grid_[1]}};
  hdf5::write(find(name).dataset.id(), memory_type(values), data_of(values), block);
}

void SeriesFile::write_number(const std::string& name, double value) const {
  hdf5::write(find(name).dataset.id(), H5T_NATIVE_DOUBLE, &value, {{static_cast<hsize_t>(frames_)}, {1}});
}

void SeriesFile::write_count(const std::string& name, std::int64_t value) const {
  hdf5::write(find(name).dataset.id(), H5T_NATIVE_INT64, &value, {{static_cast<hsize_t>(frames_)}, {1}});
}

void SeriesFile::write_row(const std::string& name, const std::vector<double>& values) const {
  const hdf5::Block block{{static_cast<hsize_t>(frames_), 0}, {1, values.size()}};
  hdf5::write(find(name).dataset.id(), H5T_NATIVE_DOUBLE, values.data(), block);
}

void SeriesFile::write_statistics(const FrameStatistics& statistics) const {
  write_number("volume", statistics.volume);
  write_number("kinetic_energy", statistics.kinetic_energy);
  write_number("max_speed", statistics.max_speed);
  write_number("time_step_min", statistics.time_step_min);
  write_number("time_step_max", statistics.time_step_max);
  write_count("steps", statistics.steps);
  write_number("wall_time", statistics.wall_time);
  write_count("moving_cells", statistics.moving_cells);
}

void SeriesFile::write_objects(const std::vector<ObjectPose>& objects) const {
  std::vector<double> positions, rotations;
  std::vector<std::int64_t> present;
  for (const ObjectPose& object : objects) {
    positions.insert(positions.end(), object.position.begin(), object.position.end());
    rotations.insert(rotations.end(), object.rotation.begin(), object.rotation.end());
    present.push_back(object.present ? 1 : 0);
  }
  const auto frame = static_cast<hsize_t>(frames_);
  const hsize_t count = objects.size();
  hdf5::write(find("object_position").dataset.id(), H5T_NATIVE_DOUBLE, positions.data(),
              {{frame, 0, 0}, {1, count, 3}});
  hdf5::write(find("object_rotation").dataset.id(), H5T_NATIVE_DOUBLE, rotations.data(),
              {{frame, 0, 0}, {1, count, 4}});
  hdf5::write(find("object_present").dataset.id(), H5T_NATIVE_INT64, present.data(), {{frame, 0}, {1, count}});
}

void SeriesFile::write_particles(const ParticleFrame& particles) const {
  const auto frame = static_cast<hsize_t>(frames_);
  const hsize_t count = particles.id.size();
  const hdf5::Block numbers{{frame, 0}, {1, count}};
  hdf5::write(find("particle_position").dataset.id(), H5T_NATIVE_DOUBLE, particles.position.data(),
              {{frame, 0, 0}, {1, count, 3}});
  hdf5::write(find("particle_id").dataset.id(), H5T_NATIVE_INT64, particles.id.data(), numbers);
  hdf5::write(find("particle_visible").dataset.id(), H5T_NATIVE_UINT8, particles.visible.data(), numbers);
}

void SeriesFile::write_probes(const std::vector<ProbeSample>& probes) const {
  std::vector<double> depth, velocity_x, velocity_y;
  for (const ProbeSample& probe : probes) {
    depth.push_back(probe.depth);
    velocity_x.push_back(probe.velocity_x);
    velocity_y.push_back(probe.velocity_y);
  }
  write_row("probe_depth", depth);
  write_row("probe_velocity_x", velocity_x);
  write_row("probe_velocity_y", velocity_y);
}

void SeriesFile::flush() const {
  require(H5Fflush(file_.id(), H5F_SCOPE_LOCAL), "flush");
}

void SeriesFile::append(Frame frame) {
  check(frame);
  if (reserve_->bytes_to_add() > 0) space_->claim(reserve_->bytes_to_add());
  reserve_->prepare_frame();
  const auto frames = static_cast<hsize_t>(frames_ + 1);
  for (const OpenVariable& open : variables_) {
    if (open.variable.over_time() && open.variable.name != "time") extend(open, frames);
  }
  for (const NamedField& field : frame.fields) write_values(field.name, field.values);
  write_statistics(frame.statistics);
  if (!frame.probes.empty()) write_probes(frame.probes);
  if (!frame.objects.empty()) write_objects(frame.objects);
  if (particle_count_ > 0) write_particles(frame.particles);
  if (!frame.fronts.empty()) write_row("front", frame.fronts);
  if (exact_reference_) {
    if (!frame.reference_depth.empty()) write_row("reference_depth", frame.reference_depth);
    write_number("reference_tip", frame.reference_tip);
  }
  flush();
  // The frame counts from here on.
  extend(find("time"), frames);
  write_number("time", frame.statistics.time);
  flush();
  ++frames_;
  last_fields_ = std::move(frame.fields);
  space_->check_written();
}

void SeriesFile::write_maxima(const FinalFields& fields) {
  if (!output_.maxima) return;
  space_->claim(static_cast<std::int64_t>(4 * (grid_[0] * grid_[1] * 8 + 65536)));
  write_map("max_depth", fields.max_depth);
  write_map("max_speed_over_time", fields.max_speed);
  write_map("arrival_time", fields.arrival_time);
  if (output_.maxima->pressure) write_map("max_pressure", pressure_of(fields.max_speed, density_));
}

void SeriesFile::close() {
  flush();
  reserve_.reset();
  for (OpenVariable& open : variables_) open.dataset.close("close " + open.variable.name);
  file_.close("close the file");
  release_claimed_space(path_);
  sync_file(path_);
}

}  // namespace sandsim
