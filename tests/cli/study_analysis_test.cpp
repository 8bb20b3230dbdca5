// What a study makes of errors and times, on numbers that can be checked by hand.
#include <cmath>

#include "cli/study/analysis.hpp"
#include "cli/study/text_table.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::cli {
namespace {

/// Two methods on two spacings of one scene; errors against an exact solution.
struct Example {
  StudyPlan plan;
  std::vector<TimedResult> results;

  Example() {
    plan.study.scenes.push_back({"one", "scene.yaml", {}});
    plan.study.methods = {{"cheap", {}}, {"good", {}}};
  }
  void add(const std::string& method, double spacing, double error, std::vector<double> seconds) {
    StudyCase setting;
    setting.method = method;
    setting.setup.grid = {{static_cast<int>(std::lround(1.0 / spacing)), 1}, spacing, {0.0, 0.0}};
    plan.cases.push_back(setting);
    TimedResult result;
    result.report.status = "done";
    result.report.cells = setting.setup.grid.cells[0];
    result.report.steps = 10;
    ErrorReport report;
    report.against = "exact dam break";
    report.l1_relative = error;
    result.report.errors.push_back(report);
    result.solving = std::move(seconds);
    results.push_back(std::move(result));
  }
};

}  // namespace

TEST_CASE("orders, the frontier and costs follow from errors and times") {
  Example example;
  example.add("cheap", 0.02, 0.08, {1.0, 1.0, 4.0});
  example.add("cheap", 0.01, 0.04, {4.0, 3.0, 5.0});
  example.add("good", 0.02, 0.0805, {2.0, 2.0, 2.0});
  example.add("good", 0.01, 0.02, {5.0, 5.0, 5.0});
  const StudyFindings findings = analyse(example.plan, example.results, {});
  REQUIRE(findings.points.size() == 4);
  REQUIRE(findings.curves.size() == 2);
  CHECK(findings.curves[1].label == "good");
  CHECK(findings.points[1].seconds == 4.0);
  CHECK(findings.points[1].times.least == 3.0);
  CHECK_FALSE(findings.points[0].order);
  CHECK_THAT(*findings.points[1].order, WithinRel(1.0, 1e-12));
  CHECK_THAT(*findings.points[3].order, WithinRel(std::log2(0.0805 / 0.02), 1e-12));
  CHECK(findings.points[0].on_frontier);
  CHECK(findings.points[1].on_frontier);
  CHECK_FALSE(findings.points[2].on_frontier);  // slower than the first, and no better
  CHECK(findings.points[3].on_frontier);
  CHECK(cheapest(findings, 0, 0.05) == &findings.points[1]);
  CHECK(cheapest(findings, 0, 0.01) == nullptr);
  // Half-way in logarithms between errors of 0.08 and 0.04: half-way between 1 s and 4 s, 500 and 1000 cell-steps.
  const auto cost = cost_to_error(findings, findings.curves[0], std::sqrt(0.08 * 0.04));
  REQUIRE(cost);
  CHECK_THAT(cost->seconds, WithinRel(2.0, 1e-12));
  CHECK_THAT(cost->cell_steps, WithinRel(std::sqrt(500.0 * 1000.0), 1e-12));
  CHECK_FALSE(cost_to_error(findings, findings.curves[0], 0.01));
}

TEST_CASE("the shortest repeat stands for all if the study says so") {
  Example example;
  example.add("cheap", 0.01, 0.04, {4.0, 3.0, 9.0});
  example.plan.study.times = TimeChoice::shortest;
  CHECK(analyse(example.plan, example.results, {}).points[0].seconds == 3.0);
}

TEST_CASE("an error that differs by less than one per cent puts no slower setting on the frontier") {
  Example example;
  example.add("cheap", 0.01, 0.0400, {1.0});
  example.add("good", 0.01, 0.0397, {2.0});
  const StudyFindings findings = analyse(example.plan, example.results, {});
  CHECK(findings.points[0].on_frontier);
  CHECK_FALSE(findings.points[1].on_frontier);
}

TEST_CASE("a setting without an error says why and is on no frontier") {
  Example example;
  example.add("cheap", 0.01, 0.04, {1.0});
  example.results[0].report.errors[0].l1_relative.reset();
  example.results[0].report.errors[0].note = "only the tip is known";
  const StudyFindings findings = analyse(example.plan, example.results, {});
  CHECK(std::isnan(findings.points[0].error));
  CHECK(findings.points[0].note == "exact dam break: only the tip is known");
  CHECK_FALSE(findings.points[0].on_frontier);
}

TEST_CASE("the front and the height are compared when the study asks for them") {
  Example example;
  example.add("cheap", 0.01, 0.04, {1.0});
  ErrorReport& report = example.results[0].report.errors[0];
  report.fronts = {{0.0, 0.9, std::nullopt}, {0.005, 0.7, 0.75}};
  report.height = {0.2, 0.25};
  example.plan.study.error.measure = ErrorMeasure::front;
  CHECK_THAT(analyse(example.plan, example.results, {}).points[0].error, WithinAbs(0.05, 1e-15));
  example.plan.study.error.measure = ErrorMeasure::height;
  CHECK_THAT(analyse(example.plan, example.results, {}).points[0].error, WithinAbs(0.05, 1e-15));
}

TEST_CASE("tables align as Markdown and quote as CSV") {
  const TextTable table{{"a", "name"}, {{"1", "x, y"}, {"22", "say \"z\""}, {"3", "a|b"}}};
  CHECK(markdown(table) ==
        "| a   | name    |\n| --- | ------- |\n| 1   | x, y    |\n| 22  | say \"z\" |\n| 3   | a\\|b    |\n");
  CHECK(csv(table) == "a,name\n1,\"x, y\"\n22,\"say \"\"z\"\"\"\n3,a|b\n");
}

}  // namespace sandsim::cli
