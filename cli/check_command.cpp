#include <fmt/format.h>

#include <array>
#include <cmath>
#include <ostream>

#include "cli/commands.hpp"
#include "cli/memory.hpp"
#include "cli/object_lines.hpp"
#include "cli/run_paths.hpp"
#include "cli/summary.hpp"
#include "cli/text.hpp"
#include "io/scene/resolved_scene.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/needs.hpp"
#include "solver/simulation.hpp"

namespace sandsim::cli {

namespace {

/// A scene that takes more is judged by its sizes: a check does not fill the memory of a machine.
constexpr double most_bytes_to_build = 1e9;

std::string size_lines(const Scene& scene, const Needs& needs) {
  const double cells = static_cast<double>(scene.grid.cells[0]) * scene.grid.cells[1];
  std::string text = fmt::format("cells    {} x {} = {}\n", scene.grid.cells[0], scene.grid.cells[1],
                                 format_count(static_cast<std::int64_t>(cells)));
  text += fmt::format("stages   {}\n", join(", ", stage_names(scene)));
  text += fmt::format("memory   {}\n", format_bytes(needs.memory_bytes()));
  text += fmt::format("output   {} frames, {}{}\n", format_count(needs.frames), format_bytes(needs.output_bytes),
                      scene.output.compression == Compression::none ? "" : " before compression");
  return text;
}

std::string step_line(const Plan& plan) {
  const std::string first = std::isfinite(plan.first_step)
                                ? fmt::format("the first one {}", format_duration(plan.first_step))
                                : std::string("nothing can move at the start");
  return fmt::format("steps    about {}; {}\n", format_count(plan.predicted_steps), first);
}

/// The bed at the centres of the cells in the corners, so that a raster that lies upside down is seen.
std::string bed_lines(const Grid& grid, const std::array<double, 4>& beds) {
  const auto corner = [&](const char* name, std::size_t k) {
    const double x = grid.x(k % 2 == 0 ? 0 : grid.cells[0] - 1), y = grid.y(k < 2 ? 0 : grid.cells[1] - 1);
    return fmt::format("{} {:.6g} m at ({:.10g}, {:.10g})", name, beds[k], x, y);
  };
  const std::string south = fmt::format("bed      {}; {}\n", corner("south-west", 0), corner("south-east", 1));
  return grid.one_dimensional()
             ? fmt::format("bed      {}; {}\n", corner("west", 0), corner("east", 1))
             : south + fmt::format("         {}; {}\n", corner("north-west", 2), corner("north-east", 3));
}

}  // namespace

ExitCode check_command(const CheckArguments& arguments, Console& console) {
  std::vector<std::string> warnings;
  const Scene scene = read_scene(scene_file(arguments.scene), arguments.overrides, &warnings);
  for (const std::string& warning : warnings) {
    console.err << "sandsim: warning: " << warning << '\n';
  }
  const Needs needs = needs_of(scene);
  console.out << resolved_scene(scene) << '\n' << size_lines(scene, needs) << std::flush;
  require_memory(scene);
  if (needs.memory_bytes() > most_bytes_to_build) {
    console.out << "scene is valid; what it puts on its grid was not looked at, since that takes more than "
                << format_bytes(most_bytes_to_build) << '\n';
    return ExitCode::done;
  }
  const Plan built = plan(scene);  // sets up the run, all but its steps
  for (const std::string& warning : built.warnings) {
    console.err << "sandsim: warning: " << warning << '\n';
  }
  console.out << fmt::format("release  {}\n", release_text(built.release)) << step_line(built)
              << bed_lines(scene.grid, built.corner_beds) << object_lines(scene) << "scene is valid\n";
  return ExitCode::done;
}

}  // namespace sandsim::cli
