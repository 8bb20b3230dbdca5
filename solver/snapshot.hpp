// What a frame holds, taken from a backend: the requested fields only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/backend.hpp"
#include "solver/initial_state.hpp"
#include "solver/object_stage.hpp"
#include "solver/scene.hpp"
#include "solver/sink.hpp"

namespace sandsim {

/// The depth as float64, whatever the run's precision.
std::vector<double> as_double(const FieldValues& values);

/// Takes snapshots of one run. All that it is made from must outlive it.
class Snapshots {
 public:
  Snapshots(const Scene& scene, const InitialState& initial, const SharedObjects& objects);

  /// What a frame needs of a state.
  CaptureRequest request() const;
  /// A frame with its fields, particles, objects, probes, fronts and references; `statistics` as they are.
  Frame frame(Capture capture, std::int64_t index, const FrameStatistics& statistics) const;
  /// The depth of a capture by request(); null if it has none.
  const FieldValues* depth(const Capture& capture) const;
  /// Bytes of the fields of one frame.
  double field_bytes() const;

 private:
  const Scene& scene_;
  const InitialState& initial_;
  const SharedObjects& objects_;
  std::vector<std::string> fields_;
  bool needs_depth_ = false;  // for fronts and the runout, besides the fields if it is not among them
  std::vector<std::int64_t> probes_;
};

}  // namespace sandsim
