// Axes and samples into cases.
#include "io/sweep/plan.hpp"

#include <limits>
#include <set>

#include "tests/support/catch.hpp"

using namespace sandsim;
using Strings = std::vector<std::string>;

namespace {

SweepPlan plan_of(const Strings& vary, const Samples& samples = {}) {
  SweepPlan plan;
  plan.samples = samples;
  for (const std::string& text : vary) {
    const std::optional<Complaint> complaint = add_vary(plan, text);
    INFO(text);
    REQUIRE_FALSE(complaint);
  }
  return plan;
}

std::string problem(const Strings& vary, const Samples& samples = {}, const Strings& overrides = {}) {
  SweepPlan plan;
  plan.samples = samples;
  plan.overrides = overrides;
  for (const std::string& text : vary) {
    if (const std::optional<Complaint> complaint = add_vary(plan, text)) return complaint->problem;
  }
  const std::optional<Complaint> complaint = check_plan(plan);
  return complaint ? complaint->problem : "";
}

}  // namespace

TEST_CASE("cases are all combinations, the last axis fastest") {
  const SweepPlan plan = plan_of({"a=1,2", "b.c=x,y,z"});
  CHECK(plan.keys() == Strings{"a", "b.c"});
  CHECK(plan.count() == 6);
  const std::vector<Strings> expected{{"1", "x"}, {"1", "y"}, {"1", "z"}, {"2", "x"}, {"2", "y"}, {"2", "z"}};
  CHECK(plan.cases() == expected);
}

TEST_CASE("keys of one --vary vary together") {
  const SweepPlan plan = plan_of({"a=1,2; b=3:4:2 cm", "c=5,6"});
  CHECK(plan.count() == 4);
  const std::vector<Strings> expected{{"1", "3 cm", "5"}, {"1", "3 cm", "6"}, {"2", "4 cm", "5"}, {"2", "4 cm", "6"}};
  CHECK(plan.cases() == expected);
}

TEST_CASE("a Latin hypercube hits every part of every interval once") {
  const SweepPlan plan = plan_of({"a=0..1", "b=10..20 cm"}, {10, Sampling::latin, 7});
  std::set<int> parts_of_a, parts_of_b;
  for (const Strings& values : plan.cases()) {
    const double a = number_with_unit(values[0])->number, b = number_with_unit(values[1])->number;
    CHECK(number_with_unit(values[1])->unit == "cm");
    parts_of_a.insert(static_cast<int>(10.0 * a));
    parts_of_b.insert(static_cast<int>(b - 10.0));
  }
  const std::set<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  CHECK(parts_of_a == all);
  CHECK(parts_of_b == all);
}

TEST_CASE("the same seed gives the same samples, wherever it is") {
  const Samples samples{3, Sampling::random, 42};
  const SweepPlan plan = plan_of({"a=0..1"}, samples);
  CHECK(plan.cases() == plan_of({"a=0..1"}, samples).cases());
  CHECK(plan.cases() != plan_of({"a=0..1"}, {3, Sampling::random, 43}).cases());
  // Another key draws numbers of its own, and leaves those of the first as they are.
  const std::vector<Strings> two = plan_of({"a=0..1", "b=0..1"}, samples).cases();
  for (std::size_t k = 0; k < two.size(); ++k) {
    CHECK(two[k][0] == plan.cases()[k][0]);
    CHECK(two[k][0] != two[k][1]);
  }
  // Written down once: mt19937_64 and seed_seq are the same in every library.
  CHECK(plan.cases() == std::vector<Strings>{{"0.377684678894"}, {"0.502275943652"}, {"0.533984161518"}});
}

TEST_CASE("samples and lists multiply") {
  const SweepPlan plan = plan_of({"a=0..1", "b=x,y"}, {5, Sampling::latin, 1});
  CHECK(plan.keys() == Strings{"b", "a"});
  CHECK(plan.count() == 10);
  CHECK(plan.cases()[0][1] == plan.cases()[5][1]);
}

TEST_CASE("numbers of cases beyond counting are the largest number") {
  const SweepPlan plan = plan_of({"a=1:2:1000000", "b=1:2:1000000", "c=1:2:1000000", "d=1:2:1000000"});
  CHECK(plan.count() == std::numeric_limits<std::uint64_t>::max());
}

TEST_CASE("plans that make no sense say why") {
  CHECK(problem({}) == "nothing varies");
  CHECK(problem({"a"}) == "not of the form key=values");
  CHECK(problem({"=3"}) == "not of the form key=values");
  CHECK(problem({"a=1,2", "a=3,4"}) == "'a' varies twice");
  CHECK(problem({"a=1,2;a=3,4"}) == "'a' varies twice");
  CHECK(problem({"a=1,2;b=1,2,3"}) == "'a' has 2 values and 'b' has 3");
  CHECK(problem({"a=1..2"}) == "no number of samples");
  CHECK(problem({"a=1,2"}, {5, Sampling::latin, 1}) == "nothing to draw samples from");
  CHECK(problem({"a=1,2"}, {}, {"a=3"}) == "'a' is both set and varied");
}
