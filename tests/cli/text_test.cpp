#include "cli/text.hpp"

#include "cli/progress.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::cli;

TEST_CASE("counts are grouped by thousands") {
  CHECK(format_count(0) == "0");
  CHECK(format_count(999) == "999");
  CHECK(format_count(1000) == "1,000");
  CHECK(format_count(1234567) == "1,234,567");
  CHECK(format_count(-123456) == "-123,456");
}

TEST_CASE("sizes and rates carry the prefix that keeps three digits") {
  CHECK(format_bytes(0.0) == "0 B");
  CHECK(format_bytes(512.0) == "512 B");
  CHECK(format_bytes(999.6) == "1.00 kB");
  CHECK(format_bytes(1.234e6) == "1.23 MB");
  CHECK(format_bytes(256.0 * 1048576.0) == "268 MB");
  CHECK(format_rate(182.4e6) == "182 M cell-steps/s");
}

TEST_CASE("durations read like a person says them") {
  CHECK(format_duration(0.0) == "0 s");
  CHECK(format_duration(12e-6) == "12 us");
  CHECK(format_duration(0.00123) == "1.23 ms");
  CHECK(format_duration(3.456) == "3.46 s");
  CHECK(format_duration(125.0) == "2 min 05 s");
  CHECK(format_duration(3723.0) == "1 h 02 min");
}

TEST_CASE("a clock shows hours only when there are any") {
  CHECK(format_clock(7.2) == "0:07");
  CHECK(format_clock(754.0) == "12:34");
  CHECK(format_clock(3723.0) == "1:02:03");
  CHECK(format_clock(1.0 / 0.0) == "-:--");
}

TEST_CASE("a wall clock limit is hours minutes and seconds") {
  CHECK(parse_wall_clock("00:00:01") == 1.0);
  CHECK(parse_wall_clock("01:30:00") == 5400.0);
  CHECK(parse_wall_clock("100:00:00") == 360000.0);
  for (const char* wrong : {"", "5", "90:00", "1:60:00", "1:00:60", "00:00:00", "-1:00:00", "1:00:00:00", "a:b:c",
                            "1:00:", "1: 0:00", "99999999999:00:00", "+1:00:00"}) {
    INFO(wrong);
    CHECK_FALSE(parse_wall_clock(wrong).has_value());
  }
}

TEST_CASE("the progress line shows percent and time left and fits the terminal") {
  Progress progress;
  progress.time = 1.5;
  progress.end = 3.0;
  progress.cell_steps_per_second = 100e6;
  // The half second since 1 s took 4 s: the 1.5 s to the end take 12 s.
  const std::string line = progress_line(progress, 1.0, 4.0, 100);
  CHECK(line.starts_with(" 50 % [###"));
  CHECK(line.find("1.5 of 3 s  left 0:12  100 M cell-steps/s") != std::string::npos);
  for (const int width : {0, 1, 20, 60, 80, 200}) {
    CHECK(progress_line(progress, 1.0, 4.0, width).size() <= static_cast<std::size_t>(width));
  }
}

TEST_CASE("the progress line of a run that has not moved yet has no time left") {
  Progress progress;
  progress.end = 3.0;
  CHECK(progress_line(progress, 0.0, 0.0, 100).find("left -:--") != std::string::npos);
}
