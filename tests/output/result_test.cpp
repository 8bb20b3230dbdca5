// What is said about a result, and how ParaView is led to it.
#include "io/output/atomic_file.hpp"
#include "io/output/result_info.hpp"
#include "io/output/run_report.hpp"
#include "io/output/series_writer.hpp"
#include "io/output/xdmf.hpp"
#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

void write_partial(const fs::path& path, const Scene& scene, std::int64_t frames) {
  SeriesWriter writer(settings_of(path));
  writer.begin(scene, {});
  for (std::int64_t index = 0; index < frames; ++index) writer.frame(frame_of(scene, index));
}

}  // namespace

TEST_CASE("The info of a finished run names dimensions units ranges and the run") {
  const TemporaryDirectory directory;
  write_series(directory / "series.h5", small_scene(4, 3), 3);
  RunReport report;
  report.status = "at rest";
  report.stages = {{"step", 0.5, 12, 1e6}};
  report.smallest_step = Incident{1, 2, 0.25, 1e-3, "speed"};
  write_file_atomically(directory / "run.json", run_report_json(report, {}));

  const std::string info = describe_result(directory.path());

  INFO(info);
  CHECK(contains(info, "A small scene"));
  CHECK(contains(info, "4 x 3 cells"));
  CHECK(contains(info, "3, time 0 to 0.5 s\n"));
  CHECK(contains(info, "depth(time, y, x)"));
  CHECK(contains(info, "m/s"));
  // depth is 1 + 0.25 frame + cell / 4096.
  CHECK(contains(info, "1 to 1.50269"));
  CHECK(contains(info, "at rest"));
  CHECK(contains(info, "12 launches"));
  CHECK(contains(info, "cell (1, 2) at 0.25 s: speed"));
  CHECK(describe_result(directory / "series.h5") == info);
}

TEST_CASE("The info of an unfinished run says so") {
  const TemporaryDirectory directory;
  write_partial(directory / "series.h5", small_scene(4, 3), 2);

  const std::string info = describe_result(directory.path());

  CHECK(contains(info, "2, time 0 to 0.25 s; not finished"));
  CHECK(contains(info, "no run.json"));
}

TEST_CASE("The info of a series without frames works") {
  const TemporaryDirectory directory;
  write_partial(directory / "series.h5", small_scene(1, 1), 0);
  CHECK(contains(describe_result(directory.path()), "no values"));
}

TEST_CASE("The info of a run that failed before its first frame is its report") {
  const TemporaryDirectory directory;
  RunReport report;
  report.status = "failed";
  report.message = "too little memory: 5 GB";
  write_file_atomically(directory / "run.json", run_report_json(report, {}));
  CHECK(contains(describe_result(directory.path()), "too little memory: 5 GB"));
}

TEST_CASE("The info of what is no result is an input error") {
  const TemporaryDirectory directory;
  write_text(directory / "text.h5", "no HDF5");
  CHECK_THROWS_AS(describe_result(directory.path()), InputError);
  CHECK_THROWS_AS(describe_result(directory / "missing"), InputError);
  CHECK_THROWS_AS(describe_result(directory / "text.h5"), InputError);
}

TEST_CASE("The XDMF file describes every completed frame with a leading one in its slab") {
  const TemporaryDirectory directory;
  write_partial(directory / "series.h5", small_scene(4, 3), 2);

  REQUIRE(write_xdmf(directory / "series.h5.partial", directory / "series.xdmf"));

  const std::string text = read_text(directory / "series.xdmf");
  CHECK(count_of(text, "<Time Value=") == 2);
  CHECK(count_of(text, "Name=\"velocity_y\"") == 2);
  CHECK(contains(text, "<DataItem Format=\"XML\" Dimensions=\"3 3\">1 0 0 1 1 1 1 3 4</DataItem>"));
  CHECK(contains(text, "Dimensions=\"2 3 4\">series.h5.partial:/depth"));
  CHECK(contains(text, "Dimensions=\"2 4 5\""));
  CHECK(contains(text, "Dimensions=\"1 3 4\">series.h5.partial:/bed"));
}

TEST_CASE("There is no XDMF file without fields or frames") {
  const TemporaryDirectory directory;
  Scene scene = small_scene(4, 3);
  SECTION("no frames") {
    write_partial(directory / "series.h5", scene, 0);
  }
  SECTION("no fields") {
    scene.output.frames = false;
    write_partial(directory / "series.h5", scene, 2);
  }
  CHECK_FALSE(write_xdmf(directory / "series.h5.partial", directory / "series.xdmf"));
  CHECK_FALSE(fs::exists(directory / "series.xdmf"));
  CHECK_THROWS_AS(write_xdmf(directory / "missing.h5", directory / "series.xdmf"), InputError);
}

}  // namespace sandsim::test
