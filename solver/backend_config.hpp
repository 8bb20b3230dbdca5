// From a scene to what its backend has to know.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "solver/backend.hpp"
#include "solver/device.hpp"
#include "solver/initial_state.hpp"
#include "solver/scene.hpp"

namespace sandsim {

BackendConfig backend_config(const Scene& scene, int threads);

/// A backend on the CPU or a CUDA device that holds the initial state, its memory checked first. `initial` must live as
/// long as the backend. Throws DeviceError if there is too little, or no such device.
std::unique_ptr<Backend> make_backend(const BackendConfig& config, const InitialState& initial, Device device);

/// Names in series.h5 of the fields that the scene asks for.
std::vector<std::string> output_field_names(const Scene& scene);

/// The scene's sources as cells and growth rates.
std::vector<SandRain> sand_rains(const Scene& scene);

/// Cells that hold the probes' points (j * nx + i).
std::vector<std::int64_t> probe_cells(const Scene& scene);

/// The frames of a run: frame k is due at k frame_interval, the last one at `end`.
struct FrameSchedule {
  double interval, end;  // [s]

  explicit FrameSchedule(const TimeControl& time) : interval(time.frame_interval), end(time.end) {}
  std::int64_t count() const;
  double due(std::int64_t frame) const;
};

}  // namespace sandsim
