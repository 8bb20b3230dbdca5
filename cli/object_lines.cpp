#include "cli/object_lines.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/text.hpp"
#include "solver/objects/inspection.hpp"
#include "solver/objects/object.hpp"

namespace sandsim::cli {

namespace {

std::string span(const char* axis, double low, double high) {
  const auto end = [](double value) {
    return std::abs(value) >= objects::endless ? "endless" : fmt::format("{:.6g} m", value);
  };
  return fmt::format("{} {} to {}, ", axis, end(low), end(high));
}

}  // namespace

std::string object_lines(const Scene& scene) {
  std::string text;
  for (const KinematicObject& object : scene.objects) {
    const objects::Bounds box =
        objects::bounds(object.shape, objects::at(objects::make_motion(object), object.start).pose);
    const std::optional<double> volume = objects::volume(object.shape);
    text += fmt::format("object   {}: {}{}{}", object.name, span("x", box.low.x, box.high.x),
                        span("y", box.low.y, box.high.y), span("z", box.low.z, box.high.z));
    text += volume ? fmt::format("volume {:.4g} m^3, ", *volume) : "volume unknown, ";
    text += fmt::format("covers {} cells at its start\n",
                        format_count(static_cast<std::int64_t>(objects::covered_cells(object, scene.grid))));
  }
  return text;
}

}  // namespace sandsim::cli
