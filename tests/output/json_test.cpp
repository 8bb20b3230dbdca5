#include "io/output/json.hpp"

#include <yaml-cpp/yaml.h>

#include <cstdlib>
#include <limits>

#include "io/output/run_report.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

RunReport report_of_a_run() {
  RunReport report;
  report.status = "done";
  report.device = "cpu";
  report.scheme = "balanced";
  report.order = 2;
  report.cells = 160;
  report.steps = 1234;
  report.stages = {{"step", 0.5, 1234, 5.5e6}};
  report.ledger = {1.0, 1.5, 0.75, 0.25, 0.0};
  report.dt_min = 1e-4;
  report.smallest_step = Incident{3, 0, 0.1, 1e-4, "speed 2 m/s"};
  return report;
}

RunContext context_of_a_run() {
  RunContext context;
  context.scene_hash = "fnv1a64:0";
  context.grid.cells = {160, 1};
  context.grid.spacing = 0.5;
  return context;
}

}  // namespace

TEST_CASE("JSON numbers are short and read back the same or are null") {
  CHECK(json_number(0.1) == "0.1");
  CHECK(json_number(1.0 / 3.0) == "0.3333333333333333");
  CHECK(std::strtod(json_number(5e-324).c_str(), nullptr) == 5e-324);
  CHECK(json_number(infinity) == "null");
  CHECK(json_number(std::numeric_limits<double>::quiet_NaN()) == "null");
}

TEST_CASE("JSON strings are escaped and valid UTF-8") {
  CHECK(json_string("a \"b\" \\ \n\t\r") == R"("a \"b\" \\ \n\t\r")");
  CHECK(json_string(std::string("\x01\0\x7f", 3)) == R"("\u0001\u0000\u007f")");
  CHECK(json_string("B\u00f6schung \u2192 \U0001F3D6") == "\"B\u00f6schung \u2192 \U0001F3D6\"");
  // A lone byte, a surrogate, an overlong slash and a sequence that is cut short.
  CHECK(json_string("\xff") == R"("\ufffd")");
  CHECK(json_string("\xed\xa0\x80") == R"("\ufffd\ufffd\ufffd")");
  CHECK(json_string("\xc0\xaf") == R"("\ufffd\ufffd")");
  CHECK(json_string("\xe2\x82") == R"("\ufffd\ufffd")");
}

TEST_CASE("JSON documents nest and keep their order") {
  JsonWriter json;
  json.begin_object().member("b", 1).member("a", true);
  json.begin_array("list").value(0.5).value("x").null().end_array();
  json.begin_object("none").end_object().end_object();

  CHECK(json.text() ==
        "{\n  \"b\": 1,\n  \"a\": true,\n  \"list\": [\n    0.5,\n    \"x\",\n    null\n  ],\n"
        "  \"none\": {}\n}\n");
}

TEST_CASE("A JSON document that is not closed is an error of the caller") {
  JsonWriter json;
  json.begin_object();
  CHECK_THROWS_AS(json.text(), std::logic_error);
  json.end_object();
  CHECK_THROWS_AS(json.end_object(), std::logic_error);
}

TEST_CASE("The run report has the keys of the interface") {
  const YAML::Node run = YAML::Load(run_report_json(report_of_a_run(), context_of_a_run()));

  for (const char* key : {"status",         "exit_code",
                          "message",        "scene_hash",
                          "version",        "commit",
                          "device",         "threads",
                          "precision",      "scheme",
                          "order",          "cells",
                          "steps",          "simulated_time",
                          "wall_time",      "cell_steps_per_second",
                          "stages",         "memory_bytes",
                          "volume_initial", "volume_final",
                          "volume_in",      "volume_out",
                          "volume_clipped", "volume_error",
                          "dt_min",         "dt_max",
                          "smallest_step",  "at_rest",
                          "stop_time",      "max_slope_violation"}) {
    INFO(key);
    CHECK(run[key].IsDefined());
  }
  CHECK(run["volume_error"].as<double>() == 0.0);
  CHECK(run["stages"][0]["launches"].as<int>() == 1234);
  CHECK(run["smallest_step"]["x"].as<double>() == 1.75);
  CHECK(run["smallest_step"]["cause"].as<std::string>() == "speed 2 m/s");
  CHECK_FALSE(run["error"].IsDefined());
  CHECK_FALSE(run["failure"].IsDefined());
}

TEST_CASE("The run report names the first error and lists all of them") {
  RunReport report = report_of_a_run();
  report.errors.resize(2);
  report.errors[0].against = "dam_break";
  report.errors[0].l1 = 0.25;
  report.errors[0].fronts = {{0.01, 0.5, 0.625}, {0.02, infinity, {}}};
  report.errors[1].against = "measured";
  report.errors[1].note = "the file is missing";

  const YAML::Node run = YAML::Load(run_report_json(report, context_of_a_run()));

  CHECK(run["error"]["against"].as<std::string>() == "dam_break");
  CHECK(run["error"]["l1"].as<double>() == 0.25);
  CHECK_FALSE(run["error"]["l2"].IsDefined());
  CHECK(run["errors"].size() == 2);
  CHECK(run["errors"][0]["fronts"][0]["reference"].as<double>() == 0.625);
  CHECK(run["errors"][0]["fronts"][1]["computed"].IsNull());
  CHECK(run["errors"][1]["note"].as<std::string>() == "the file is missing");
}

}  // namespace sandsim::test
