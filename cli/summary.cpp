#include "cli/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "cli/text.hpp"

namespace sandsim::cli {

namespace {

std::string line(const std::string& name, const std::string& value) {
  return fmt::format("  {:<11} {}\n", name, value);
}

std::string status_line(const Scene& scene, const RunReport& report) {
  std::string text = report.status;
  if (report.at_rest) {
    text +=
        fmt::format("{}everything still since {:.6g} s", report.status == "at rest" ? ": " : ", ", report.stop_time);
  } else if (report.exit_code == ExitCode::done) {
    text += ", still moving";
  } else if (report.exit_code == ExitCode::interrupted || report.exit_code == ExitCode::wall_clock_limit) {
    text += ", to be resumed";
  } else if (!report.message.empty()) {
    text += ": " + report.message;
  }
  if (scene.time.stop_at_rest && report.exit_code == ExitCode::done && !report.at_rest) {
    text += " at the end of the time given";
  }
  return line("status", text);
}

std::string time_lines(const Scene& scene, const RunReport& report) {
  std::string text = line("simulated", fmt::format("{:.6g} s of {:.6g} s in {} steps of {} to {}; {} frame{}",
                                                   report.simulated_time, scene.time.end, format_count(report.steps),
                                                   format_duration(report.dt_min), format_duration(report.dt_max),
                                                   format_count(report.frames), report.frames == 1 ? "" : "s"));
  const std::string order = scene.numerics.scheme == Scheme::balanced ? fmt::format(" order {}", report.order) : "";
  text += line("run", fmt::format("{}, {}; {} with {} thread{}, {}, {}{}", format_duration(report.wall_time),
                                  format_rate(report.cell_steps_per_second), report.device, report.threads,
                                  report.threads == 1 ? "" : "s", report.precision, report.scheme, order));
  std::vector<std::string> stages;
  for (const StageReport& stage : report.stages) {
    stages.push_back(fmt::format("{} {}", stage.name, format_duration(stage.seconds)));
  }
  if (!stages.empty()) {
    text += line("stages", join(", ", stages));
  }
  return text;
}

std::string volume_line(const Ledger& ledger) {
  std::string text = fmt::format("{:.6g} m^3, relative error {:.1e}", ledger.final, ledger.error());
  if (ledger.in != 0.0 || ledger.out != 0.0) {
    text += fmt::format("; in {:.4g}, out {:.4g} m^3", ledger.in, ledger.out);
  }
  text += ledger.clipped == 0.0 ? "; nothing clipped" : fmt::format("; clipped {:.3g} m^3", ledger.clipped);
  return line("volume", text);
}

std::string descent_text(const std::string& what, const Descent& descent) {
  const double degrees = descent.travel_angle() * 180.0 / std::numbers::pi;
  return fmt::format("{} {:.4g} m away and {:.4g} m down{}", what, descent.distance, descent.drop,
                     std::isfinite(degrees) ? fmt::format(" ({:.1f} deg)", degrees) : "");
}

std::string runout_lines(const RunoutReport& runout) {
  std::vector<std::string> parts;
  if (runout.front.distance > 0.0) {
    parts.push_back(descent_text("front", runout.front));
  } else {
    parts.push_back("no new ground reached");
  }
  if (std::isfinite(runout.center_of_mass.distance)) {
    parts.push_back(descent_text("centre of mass", runout.center_of_mass));
  }
  return line("runout", join("; ", parts)) +
         line("reached", fmt::format("{:.4g} m^2, up to {:.4g} m deep and {:.4g} m/s fast, where deeper than {:.3g} m",
                                     runout.area, runout.max_depth, runout.max_speed, runout.above));
}

std::string front_name(const ErrorReport::Front& front) {
  return front.depth == 0.0 ? std::string("tip") : fmt::format("{:.4g} m deep", front.depth);
}

/// Every reference repeats the computed fronts: they are shown once.
std::string front_line(const std::vector<ErrorReport>& errors) {
  std::map<double, std::string> fronts;
  for (const ErrorReport& error : errors) {
    for (const ErrorReport::Front& front : error.fronts) {
      const std::string where = std::isfinite(front.computed) ? fmt::format("{:.5g} m", front.computed) : "nowhere";
      fronts.emplace(front.depth, fmt::format("{} at {}", front_name(front), where));
    }
  }
  std::vector<std::string> parts;
  for (const auto& [depth, text] : fronts) {
    parts.push_back(text);
  }
  return parts.empty() ? "" : line("fronts", join(", ", parts));
}

std::string error_line(const ErrorReport& error) {
  std::vector<std::string> parts;
  if (error.l1_relative) {
    parts.push_back(fmt::format("L1 {:.3g} %", 100.0 * *error.l1_relative));
  } else if (error.l1) {
    parts.push_back(fmt::format("L1 {:.3g} m^2", *error.l1));
  }
  if (error.linf) {
    parts.push_back(fmt::format("largest {:.3g} m", *error.linf));
  }
  for (const ErrorReport::Front& front : error.fronts) {
    if (front.reference) {
      const double difference = front.computed - *front.reference;
      parts.push_back(fmt::format("{} {:+.3g} m off {:.5g} m", front_name(front), difference, *front.reference));
    }
  }
  if (!error.note.empty()) {
    parts.push_back(error.note);
  }
  return parts.empty() ? "" : line("error", fmt::format("against {}: {}", error.against, join("; ", parts)));
}

}  // namespace

std::string release_text(const ReleaseReport& release) {
  std::string text = fmt::format("{:.6g} m^3 of sand at the start", release.file_volume);
  // Rounding of the sums is no part of it.
  const double rounding = 1e-9 * release.file_volume;
  if (release.outside_volume <= rounding && release.blocked_volume <= rounding) {
    return text + ", all on the grid";
  }
  text += fmt::format(", {:.6g} m^3 of it on the grid", release.grid_volume);
  if (release.outside_volume > rounding) {
    text += fmt::format(", {:.6g} m^3 outside", release.outside_volume);
  }
  if (release.blocked_volume > rounding) {
    text += fmt::format(", {:.6g} m^3 where solid objects or walls are", release.blocked_volume);
  }
  return text;
}

std::string run_summary(const Scene& scene, const RunReport& report, const std::string& files) {
  const std::string cells = fmt::format("{} x {} cells", scene.grid.cells[0], scene.grid.cells[1]);
  std::string text = scene.title.empty() ? cells + "\n" : fmt::format("{} ({})\n", scene.title, cells);
  text += status_line(scene, report);
  text += time_lines(scene, report);
  text += line("release", release_text(report.release));
  text += volume_line(report.ledger);
  if (report.runout) {
    text += runout_lines(*report.runout);
  }
  for (const ObjectReport& object : report.objects) {
    text += line("object",
                 fmt::format("{}: moved {:.4g} m^3 of sand out of its way, at most {:.3g} m below the sand beside it",
                             object.name, object.displaced_volume, object.deepest));
  }
  if (report.particles) {
    const ParticleReport& particles = *report.particles;
    text += line("particles", fmt::format("{} in every frame; {} gone where there were others, {} out of the grid, "
                                          "as many new ones",
                                          format_count(particles.count), format_count(particles.merged),
                                          format_count(particles.left)));
  }
  if (report.at_rest) {
    text +=
        line("slopes", report.max_slope_violation > 0.0
                           ? fmt::format("steepest face {:.1e} above what friction holds", report.max_slope_violation)
                           : std::string("no face is steeper than friction holds"));
  }
  text += front_line(report.errors);
  for (const ErrorReport& error : report.errors) {
    text += error_line(error);
  }
  text += line("files", files);
  return text;
}

}  // namespace sandsim::cli
