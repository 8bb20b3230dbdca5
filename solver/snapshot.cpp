#include "solver/snapshot.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "solver/backend_config.hpp"
#include "solver/reference/compare.hpp"

namespace sandsim {

std::vector<double> as_double(const FieldValues& values) {
  return std::visit([](const auto& v) { return std::vector<double>(v.begin(), v.end()); }, values);
}

namespace {

ObjectPose pose_of(const objects::Object& object, double time) {
  const objects::Pose pose = object.at(time).pose;
  const objects::Vec3& p = pose.position;
  const objects::Quaternion& q = pose.orientation;
  return {{p.x, p.y, p.z}, {q.w, q.x, q.y, q.z}, object.is_present(time)};
}

}  // namespace

Snapshots::Snapshots(const Scene& scene, const InitialState& initial, const SharedObjects& objects)
    : scene_(scene),
      initial_(initial),
      objects_(objects),
      fields_(output_field_names(scene)),
      needs_depth_(!scene.output.maxima || (scene.reference && !scene.reference->front_depths.empty())),
      probes_(probe_cells(scene)) {}

double Snapshots::field_bytes() const {
  const double word = scene_.numerics.precision == Precision::float32 ? 4.0 : 8.0;
  return static_cast<double>(scene_.grid.cell_count()) * word * static_cast<double>(fields_.size());
}

CaptureRequest Snapshots::request() const {
  CaptureRequest request{fields_, probes_};
  if (needs_depth_ && std::find(fields_.begin(), fields_.end(), "depth") == fields_.end()) {
    request.fields.push_back("depth");
  }
  return request;
}

const FieldValues* Snapshots::depth(const Capture& capture) const {
  const auto at = static_cast<std::size_t>(std::find(fields_.begin(), fields_.end(), "depth") - fields_.begin());
  return at < capture.fields.size() ? &capture.fields[at] : nullptr;
}

Frame Snapshots::frame(Capture capture, std::int64_t index, const FrameStatistics& statistics) const {
  Frame frame;
  frame.index = index;
  frame.statistics = statistics;
  frame.probes = std::move(capture.probes);
  frame.particles = std::move(capture.particles);
  for (const auto& object : objects_) {
    frame.objects.push_back(pose_of(*object, statistics.time));
  }
  frame.reference_tip = std::numeric_limits<double>::quiet_NaN();
  if (scene_.reference && !scene_.reference->front_depths.empty()) {
    const std::vector<double> depth = as_double(*this->depth(capture));
    for (const double threshold : scene_.reference->front_depths) {
      frame.fronts.push_back(front(scene_.grid, depth, threshold));
    }
  }
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    frame.fields.push_back({fields_[k], std::move(capture.fields[k])});
  }
  if (scene_.reference && scene_.reference->exact) {
    ReferenceFrame exact = reference_at(scene_, initial_, statistics.time);
    frame.reference_depth = std::move(exact.depth);
    frame.reference_tip = exact.tip;
  }
  return frame;
}

}  // namespace sandsim
