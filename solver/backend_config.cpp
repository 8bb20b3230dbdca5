#include "solver/backend_config.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "solver/backends/bed_on_demand.hpp"
#include "solver/backends/cuda/cuda.hpp"
#include "solver/backends/expected_bytes.hpp"
#include "solver/errors.hpp"
#include "solver/needs.hpp"
#include "solver/numerics.hpp"
#include "solver/object_stage.hpp"

namespace sandsim {
namespace {

std::unique_ptr<Backend> make_with_bed_or_without(const BackendConfig& config, const InitialState& initial,
                                                  Device device) {
  if (device == Device::cuda) {
    return make_cuda_backend(config, initial);
  }
  const double present = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  require_bytes(config, expected_bytes(config, initial), present, "this machine");
  return make_cpu_backend(config, initial);
}

FieldValues in_precision(const std::vector<double>& values, Precision precision) {
  if (precision == Precision::float64) {
    return values;
  }
  return std::vector<float>(values.begin(), values.end());
}

}  // namespace

BackendConfig backend_config(const Scene& scene, int threads) {
  BackendConfig config;
  config.grid = scene.grid;
  config.gravity = scene.gravity;
  config.boundaries = scene.boundaries;
  config.numerics = scene.numerics;
  config.courant = scene.time.courant.value_or(default_courant(scene.numerics));
  config.rains = sand_rains(scene);
  config.objects = coupled_objects(scene);
  config.covers = any_covers(config.objects);
  config.particles = scene.particles;
  config.maxima = scene.output.maxima.has_value();
  config.threads = threads;
  return config;
}

std::unique_ptr<Backend> make_backend(const BackendConfig& config, const InitialState& initial, Device device) {
  if (static_cast<double>(config.grid.cell_count()) > most_cells ||
      particle_number(config.grid, config.particles) >= most_cells) {
    throw DeviceError("more than 2^31 cells or particles: use a larger spacing");
  }
  const auto make = [&initial, device](const BackendConfig& part) {
    return make_with_bed_or_without(part, initial, device);
  };
  std::unique_ptr<Backend> backend =
      config.covers && initial.bed.empty() ? make_bed_on_demand(config, make) : make(config);
  if (!initial.momentum_x.empty()) {
    const Precision precision = config.numerics.precision;
    backend->set_state({in_precision(initial.depth, precision), in_precision(initial.momentum_x, precision),
                        in_precision(initial.momentum_y, precision)});
  }
  return backend;
}

std::vector<std::string> output_field_names(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.output.frames) {
    for (const OutputField field : scene.output.fields) {
      switch (field) {
        case OutputField::depth:
          names.insert(names.end(), {"depth"});
          break;
        case OutputField::velocity:
          names.insert(names.end(), {"velocity_x", "velocity_y"});
          break;
        case OutputField::surface:
          names.insert(names.end(), {"surface"});
          break;
        case OutputField::momentum:
          names.insert(names.end(), {"momentum_x", "momentum_y"});
          break;
      }
    }
  }
  return names;
}

std::vector<SandRain> sand_rains(const Scene& scene) {
  std::vector<SandRain> rains;
  const Grid& grid = scene.grid;
  for (const SandSource& source : scene.sand.sources) {
    SandRain rain;
    std::int64_t nearest = 0;
    double nearest_distance = HUGE_VAL;
    for (int j = 0; j < grid.cells[1]; ++j) {
      for (int i = 0; i < grid.cells[0]; ++i) {
        const double dx = grid.x(i) - source.center[0];
        const double dy = grid.one_dimensional() ? 0.0 : grid.y(j) - source.center[1];
        const double distance = std::hypot(dx, dy);
        const std::int64_t cell = static_cast<std::int64_t>(j) * grid.cells[0] + i;
        if (distance <= source.radius) {
          rain.cells.push_back(cell);
        }
        if (distance < nearest_distance) {
          nearest = cell, nearest_distance = distance;
        }
      }
    }
    if (rain.cells.empty()) {
      rain.cells.push_back(nearest);
    }
    rain.start = source.start, rain.end = source.end;
    rain.rate = source.rate / (static_cast<double>(rain.cells.size()) * grid.spacing * grid.spacing);
    rains.push_back(rain);
  }
  return rains;
}

std::vector<std::int64_t> probe_cells(const Scene& scene) {
  std::vector<std::int64_t> cells;
  const Grid& grid = scene.grid;
  const auto index = [&](double at, int axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double cell = std::floor((at - grid.origin[k]) / grid.spacing);
    return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(grid.cells[k] - 1)));
  };
  for (const Probe& probe : scene.output.probes) {
    cells.push_back(index(probe.at[1], 1) * grid.cells[0] + index(probe.at[0], 0));
  }
  return cells;
}

std::int64_t FrameSchedule::count() const {
  // A hair under the quotient: an end that is a multiple of the interval but for rounding has no extra frame.
  return static_cast<std::int64_t>(std::ceil(end / interval * (1.0 - 1e-12))) + 1;
}

double FrameSchedule::due(std::int64_t frame) const {
  return frame + 1 >= count() ? end : static_cast<double>(frame) * interval;
}

}  // namespace sandsim
