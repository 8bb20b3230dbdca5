// Values, ranges and intervals of --vary.
#include "io/sweep/values.hpp"

#include "tests/support/catch.hpp"

using namespace sandsim;
using Strings = std::vector<std::string>;

namespace {

Strings list(const std::string& text) {
  const Parsed<SweepValues> parsed = parse_sweep_values(text);
  INFO(text);
  REQUIRE(std::holds_alternative<SweepValues>(parsed));
  return std::get<Strings>(std::get<SweepValues>(parsed));
}

Interval interval(const std::string& text) {
  const Parsed<SweepValues> parsed = parse_sweep_values(text);
  INFO(text);
  REQUIRE(std::holds_alternative<SweepValues>(parsed));
  return std::get<Interval>(std::get<SweepValues>(parsed));
}

std::string problem(const std::string& text) {
  const Parsed<SweepValues> parsed = parse_sweep_values(text);
  INFO(text);
  REQUIRE(std::holds_alternative<Complaint>(parsed));
  return std::get<Complaint>(parsed).problem;
}

}  // namespace

TEST_CASE("a list keeps its values as they are written") {
  CHECK(list("wall,open") == Strings{"wall", "open"});
  CHECK(list("[40, 1],[80, 1]") == Strings{"[40, 1]", "[80, 1]"});
  CHECK(list("0.10, 2e-1") == Strings{"0.10", "2e-1"});
  CHECK(list("20 deg,30 deg") == Strings{"20 deg", "30 deg"});
  CHECK(list("{type: plane, inclination: 5 deg},{type: flat}").size() == 2);
  CHECK(list("\"a,b: c\",d") == Strings{"\"a,b: c\"", "d"});
  CHECK(list("../dem.asc") == Strings{"../dem.asc"});
  CHECK(list("5 cm") == Strings{"5 cm"});
}

TEST_CASE("a unit at the end of a list holds for all its numbers") {
  CHECK(list("20,30,40 deg") == Strings{"20 deg", "30 deg", "40 deg"});
  CHECK(list("1,2 m/s^2") == Strings{"1 m/s^2", "2 m/s^2"});
}

TEST_CASE("a range has its ends, equal steps and one unit") {
  const Strings expected{"20 deg", "25 deg", "30 deg", "35 deg", "40 deg"};
  for (const char* text : {"20:40:5 deg", "20 deg:40 deg:5", "20:40 deg:5", "20 : 40 : 5 deg"}) {
    CHECK(list(text) == expected);
  }
  CHECK(list("0.1:0.4:4") == Strings{"0.1", "0.2", "0.3", "0.4"});
  CHECK(list("3:1:3") == Strings{"3", "2", "1"});
  CHECK(list("-1:1:2 cm") == Strings{"-1 cm", "1 cm"});
  CHECK(list("1:100:3:log") == Strings{"1", "10", "100"});
}

TEST_CASE("an interval is what samples are drawn from") {
  const Interval angles = interval("20..40 deg");
  CHECK(angles.first == 20.0);
  CHECK(angles.last == 40.0);
  CHECK(angles.unit == "deg");
  CHECK(angles.at(0.25) == 25.0);
  CHECK(interval("20 deg..40 deg").unit == "deg");
  CHECK(interval("0.5..1").unit.empty());
  CHECK(interval("1..100:log").logarithmic);
}

TEST_CASE("what is no list, range or interval says what is wrong") {
  CHECK(problem("20 deg:0.7 rad:5") == "mixed units");
  CHECK(problem("20 deg:40:5 rad") == "mixed units");
  CHECK(problem("20:40 deg:5 rad") == "mixed units");
  CHECK(problem("20 deg,0.5 rad") == "mixed units");
  CHECK(problem("20 deg,30,40") == "mixed units");
  CHECK(problem("20..40 rad:log extra").find("not a number") != std::string::npos);
  CHECK(problem("") == "no values");
  CHECK(problem("20,,30") == "an empty value");
  CHECK(problem("20,30,20") == "the value '20' is given twice");
  CHECK(problem("20:20:3 deg") == "an empty range");
  CHECK(problem("20:40:1 deg") == "a range of 1 values");
  CHECK(problem("20:40:0") == "a range of 0 values");
  CHECK(problem("20:40:-3") == "a range of -3 values");
  CHECK(problem("20:40:2.5") == "the count '2.5' is no number");
  CHECK(problem("20:40") == "not a range");
  CHECK(problem("20:40:5:6") == "not a range");
  CHECK(problem("a:b:3") == "'a' is not a number with a unit");
  CHECK(problem("1:2:99999999") == "too many values");
  CHECK(problem("-1:1:3:log") == "a logarithmic range needs positive ends");
}
