#include "io/output/run_report.hpp"

#include <ctime>
#include <optional>

#include "io/output/json.hpp"
#include "io/output/version.hpp"

namespace sandsim {
namespace {

void add_text(JsonWriter& json, const char* key, const std::string& text) {
  if (!text.empty()) json.member(key, text);
}

void add_number(JsonWriter& json, const char* key, const std::optional<double>& number) {
  if (number) json.member(key, *number);
}

void add_run(JsonWriter& json, const RunReport& report, const RunContext& context) {
  json.member("status", report.status);
  json.member("exit_code", static_cast<int>(report.exit_code));
  json.member("message", report.message);
  add_text(json, "title", context.title);
  add_text(json, "scene_file", context.scene_file);
  json.member("scene_hash", context.scene_hash);
  json.member("version", version());
  json.member("commit", commit());
  add_text(json, "command_line", context.command_line);
  add_text(json, "started", context.started);
  add_text(json, "output", context.output);
  json.member("device", report.device);
  json.member("threads", report.threads);
  json.member("precision", report.precision);
  json.member("scheme", report.scheme);
  json.member("order", report.order);
}

void add_cost(JsonWriter& json, const RunReport& report) {
  json.member("cells", report.cells);
  json.member("steps", report.steps);
  json.member("frames", report.frames);
  json.member("simulated_time", report.simulated_time);
  json.member("wall_time", report.wall_time);
  json.member("first_step_time", report.first_step_time);
  json.member("cell_steps_per_second", report.cell_steps_per_second);
  json.begin_array("stages");
  for (const StageReport& stage : report.stages) {
    json.begin_object();
    json.member("name", stage.name).member("seconds", stage.seconds);
    json.member("launches", stage.launches).member("bytes", stage.bytes);
    json.end_object();
  }
  json.end_array();
  json.member("memory_bytes", report.memory_bytes);
}

void add_ledger(JsonWriter& json, const Ledger& ledger) {
  json.member("volume_initial", ledger.initial);
  json.member("volume_final", ledger.final);
  json.member("volume_in", ledger.in);
  json.member("volume_out", ledger.out);
  json.member("volume_clipped", ledger.clipped);
  json.member("volume_error", ledger.error());
}

void add_release(JsonWriter& json, const ReleaseReport& release) {
  json.begin_object("release");
  json.member("file_volume", release.file_volume).member("grid_volume", release.grid_volume);
  json.member("outside_volume", release.outside_volume).member("blocked_volume", release.blocked_volume);
  json.end_object();
}

/// Left out where no object is coupled.
void add_objects(JsonWriter& json, const std::vector<ObjectReport>& objects) {
  if (objects.empty()) return;
  json.begin_array("objects");
  for (const ObjectReport& object : objects) {
    json.begin_object().member("name", object.name);
    json.member("overlapped_volume", object.overlapped_volume).member("displaced_volume", object.displaced_volume);
    json.member("momentum_x", object.momentum[0]).member("momentum_y", object.momentum[1]);
    json.member("work", object.work).member("deepest", object.deepest).member("seconds", object.seconds);
    json.end_object();
  }
  json.end_array();
}

/// Left out without particles.
void add_particles(JsonWriter& json, const std::optional<ParticleReport>& particles) {
  if (!particles) return;
  json.begin_object("particles");
  json.member("count", particles->count).member("moves", particles->moves).member("born", particles->born);
  json.member("merged", particles->merged).member("left", particles->left);
  json.end_object();
}

void add_incident(JsonWriter& json, const char* key, const std::optional<Incident>& incident, const Grid& grid) {
  if (!incident) return;
  json.begin_object(key);
  json.member("i", incident->i).member("j", incident->j);
  if (incident->i >= 0 && incident->j >= 0 && grid.spacing > 0.0) {
    json.member("x", grid.x(incident->i)).member("y", grid.y(incident->j));
  }
  json.member("time", incident->time).member("step", incident->step);
  json.member("cause", incident->cause);
  json.end_object();
}

void add_error(JsonWriter& json, const ErrorReport& error) {
  json.begin_object();
  json.member("against", error.against);
  json.member("time", error.time);
  add_number(json, "l1", error.l1);
  add_number(json, "l2", error.l2);
  add_number(json, "linf", error.linf);
  add_number(json, "l1_relative", error.l1_relative);
  json.begin_array("fronts");
  for (const ErrorReport::Front& front : error.fronts) {
    json.begin_object();
    json.member("depth", front.depth).member("computed", front.computed);
    add_number(json, "reference", front.reference);
    json.end_object();
  }
  json.end_array();
  if (error.height) {
    json.begin_object("height").member("computed", error.height->computed);
    json.member("reference", error.height->reference).end_object();
  }
  add_text(json, "note", error.note);
  json.end_object();
}

void add_descent(JsonWriter& json, const Descent& descent) {
  json.member("distance", descent.distance).member("drop", descent.drop);
  json.member("travel_angle", descent.travel_angle());
}

/// Left out if the run failed.
void add_runout(JsonWriter& json, const std::optional<RunoutReport>& runout) {
  if (!runout) return;
  json.begin_object("runout").member("above", runout->above);
  add_descent(json, runout->front);
  json.begin_object("center_of_mass");
  add_descent(json, runout->center_of_mass);
  json.end_object();
  json.member("area", runout->area).member("max_depth", runout->max_depth).member("max_speed", runout->max_speed);
  json.member("deposit_front", runout->deposit_front).member("deposit_height", runout->deposit_height);
  json.end_object();
}

}  // namespace

std::string run_report_json(const RunReport& report, const RunContext& context) {
  JsonWriter json;
  json.begin_object();
  add_run(json, report, context);
  add_cost(json, report);
  add_ledger(json, report.ledger);
  add_release(json, report.release);
  add_objects(json, report.objects);
  add_particles(json, report.particles);
  json.member("dt_min", report.dt_min);
  json.member("dt_max", report.dt_max);
  add_incident(json, "smallest_step", report.smallest_step, context.grid);
  add_incident(json, "failure", report.failure, context.grid);
  json.member("at_rest", report.at_rest);
  json.member("stop_time", report.stop_time);
  json.member("max_slope_violation", report.max_slope_violation);
  add_runout(json, report.runout);
  if (!report.errors.empty()) {
    json.name("error");
    add_error(json, report.errors.front());
    json.begin_array("errors");
    for (const ErrorReport& error : report.errors) add_error(json, error);
    json.end_array();
  }
  json.end_object();
  return json.text();
}

std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32] = {};
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace sandsim
