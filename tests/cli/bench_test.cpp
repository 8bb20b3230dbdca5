#include <sstream>
#include <string>

#include "cli/bench_report.hpp"
#include "solver/backends/cuda/cuda.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::cli {
namespace {

using test::call;
using test::contains;
using test::Outcome;

TEST_CASE("bench measures every scheme on flat and wavy terrain") {
  const Outcome outcome = call({"bench", "--quick", "--size", "32", "--precision", "float32", "--repeats", "1"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  for (const char* part :
       {"copy bandwidth", "paper ", "balanced order 1", "balanced order 2", "wavy", "frame of", "first step"}) {
    INFO(part);
    CHECK(contains(outcome.out, part));
  }
  // Friction must not have stopped anything, or less than the step's work would have been measured.
  CHECK_FALSE(contains(outcome.out, "of the cells moved"));
}

TEST_CASE("bench prints JSON with every section") {
  const Outcome outcome =
      call({"bench", "--quick", "--size", "16", "--precision", "float64", "--repeats", "1", "--json"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out.starts_with("{"));
  for (const char* key : {"\"device\": \"cpu\"", "copy_bytes_per_second", "arithmetic", "steps", "percent_of_floor",
                          "frames", "overhead_seconds", "start_to_first_step"}) {
    INFO(key);
    CHECK(contains(outcome.out, key));
  }
}

TEST_CASE("bench on a CUDA device that is not there exits 4 and says why") {
  const std::string problem = survey_cuda().problem;
  if (problem.empty()) {
    WARN("skipped: there is a device");
    return;
  }
  const Outcome outcome = call({"bench", "--device", "cuda", "--quick"});
  CHECK(outcome.code == 4);
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "--device cuda: " + problem));
}

TEST_CASE("bench on a CUDA device measures the steps there") {
  if (!survey_cuda().problem.empty()) {
    WARN("skipped: " + survey_cuda().problem);
    return;
  }
  const Outcome outcome = call({"bench", "--device", "cuda", "--quick", "--size", "64", "--repeats", "1"});
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "balanced order 2"));
  CHECK_FALSE(contains(outcome.out, "of the cells moved"));
}

TEST_CASE("a size that no memory holds is a row that says so") {
  StepRow row;
  row.size = 32768;
  row.skipped = "the host needs more memory";
  std::ostringstream out;
  print_step(out, row);
  CHECK(contains(out.str(), "skipped: the host needs more memory"));
  BenchReport report;
  report.steps.push_back(row);
  CHECK(contains(bench_json(report), "\"skipped\": \"the host needs more memory\""));
}

}  // namespace
}  // namespace sandsim::cli
