#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "cli/commands.hpp"
#include "cli/machine.hpp"
#include "cli/memory.hpp"
#include "cli/object_lines.hpp"
#include "cli/run_paths.hpp"
#include "cli/text.hpp"
#include "io/scene/resolved_scene.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/simulation.hpp"

namespace sandsim::cli {

namespace {

std::string plan_lines(const Scene& scene, const Plan& plan) {
  std::string text = fmt::format("cells    {} x {} = {}\n", scene.grid.cells[0], scene.grid.cells[1],
                                 format_count(static_cast<std::int64_t>(scene.grid.cell_count())));
  text += fmt::format("stages   {}\n", join(", ", plan.stages));
  text += fmt::format("memory   {}\n", format_bytes(static_cast<double>(plan.memory_bytes)));
  const std::string first = std::isfinite(plan.first_step)
                                ? fmt::format("the first one {}", format_duration(plan.first_step))
                                : std::string("nothing can move at the start");
  text += fmt::format("steps    about {}; {}\n", format_count(plan.predicted_steps), first);
  text += fmt::format("output   {} frames, {}{}\n", format_count(plan.frames),
                      format_bytes(static_cast<double>(plan.output_bytes)),
                      scene.output.compression == Compression::none ? "" : " before compression");
  return text;
}

}  // namespace

ExitCode check_command(const CheckArguments& arguments, Console& console) {
  std::vector<std::string> warnings;
  const Scene scene = read_scene(scene_file(arguments.scene), arguments.overrides, &warnings);
  for (const std::string& warning : warnings) {
    console.err << "sandsim: warning: " << warning << '\n';
  }
  require_memory(scene);  // The plan sets up the run, all but its steps.
  const Plan needs = plan(scene);
  console.out << resolved_scene(scene) << '\n' << plan_lines(scene, needs) << object_lines(scene);
  const double available = available_memory();
  if (available > 0.0 && static_cast<double>(needs.memory_bytes) > available) {
    console.err << "sandsim: warning: only " << format_bytes(available) << " of memory are available here\n";
  }
  console.out << "scene is valid\n";
  return ExitCode::done;
}

}  // namespace sandsim::cli
