#include "solver/snapshot.hpp"

#include <limits>
#include <utility>
#include <variant>

#include "solver/backend_config.hpp"
#include "solver/reference/compare.hpp"

namespace sandsim {

std::vector<double> as_double(const FieldValues& values) {
  return std::visit([](const auto& v) { return std::vector<double>(v.begin(), v.end()); }, values);
}

Snapshots::Snapshots(const Scene& scene, const InitialState& initial)
    : scene_(scene), initial_(initial), fields_(output_field_names(scene)), probes_(probe_cells(scene)) {}

double Snapshots::field_bytes() const {
  const double word = scene_.numerics.precision == Precision::float32 ? 4.0 : 8.0;
  return static_cast<double>(scene_.grid.cell_count()) * word * static_cast<double>(fields_.size());
}

Frame Snapshots::take(const Backend& backend, std::int64_t index, const FrameStatistics& statistics) const {
  Frame frame;
  frame.index = index;
  frame.statistics = statistics;
  for (const std::string& name : fields_) {
    frame.fields.push_back({name, backend.field(name)});
  }
  frame.probes = backend.sample(probes_);
  frame.reference_tip = std::numeric_limits<double>::quiet_NaN();
  if (!scene_.reference) {
    return frame;
  }
  if (!scene_.reference->front_depths.empty()) {
    const std::vector<double> depth = as_double(backend.field("depth"));
    for (const double threshold : scene_.reference->front_depths) {
      frame.fronts.push_back(front(scene_.grid, depth, threshold));
    }
  }
  if (scene_.reference->exact) {
    ReferenceFrame exact = reference_at(scene_, initial_, statistics.time);
    frame.reference_depth = std::move(exact.depth);
    frame.reference_tip = exact.tip;
  }
  return frame;
}

}  // namespace sandsim
