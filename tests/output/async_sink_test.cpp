#include "io/output/async_sink.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

/// Records what it is given; fails at one frame; waits at the first if told to.
class RecordingSink : public Sink {
 public:
  void begin(const Scene&, const StaticFields&) override { begin_thread = std::this_thread::get_id(); }
  void frame(Frame frame) override {
    if (gate.valid()) gate.wait();
    if (frame.index == fails_at) throw OutputError("the disk is full");
    frame_thread = std::this_thread::get_id();
    indices.push_back(frame.index);
  }
  void end(const FinalFields&) override { ended = true; }

  std::int64_t fails_at = -1;
  std::shared_future<void> gate;
  std::vector<std::int64_t> indices;
  std::thread::id begin_thread, frame_thread;
  bool ended = false;
};

Frame numbered(std::int64_t index) {
  Frame frame;
  frame.index = index;
  return frame;
}

/// Hands over frames until one is refused; the message of the refusal.
std::string push_until_refused(AsyncSink& sink) {
  for (std::int64_t index = 0; index < 100000; ++index) {
    try {
      sink.frame(numbered(index));
    } catch (const OutputError& error) {
      return error.what();
    }
  }
  return "";
}

}  // namespace

TEST_CASE("Frames pass the second thread in order and all before the end") {
  RecordingSink inner;
  AsyncSink sink(inner);

  sink.begin(small_scene(1, 1), {});
  for (std::int64_t index = 0; index < 100; ++index) sink.frame(numbered(index));
  sink.end({});

  REQUIRE(inner.indices.size() == 100);
  for (std::int64_t index = 0; index < 100; ++index) CHECK(inner.indices[static_cast<std::size_t>(index)] == index);
  CHECK(inner.ended);
  CHECK(inner.begin_thread == std::this_thread::get_id());
  CHECK(inner.frame_thread != std::this_thread::get_id());
}

TEST_CASE("An error of the second thread comes back in the next call and in all later ones") {
  RecordingSink inner;
  inner.fails_at = 3;
  AsyncSink sink(inner);

  CHECK(push_until_refused(sink) == "the disk is full");

  CHECK_THROWS_AS(sink.frame(numbered(0)), OutputError);
  CHECK_THROWS_AS(sink.drain(), OutputError);
  CHECK_THROWS_AS(sink.end({}), OutputError);
  CHECK_FALSE(inner.ended);
  CHECK(inner.indices.size() == 3);
}

TEST_CASE("An error at the last frame comes back at the end") {
  RecordingSink inner;
  inner.fails_at = 0;
  AsyncSink sink(inner);

  sink.frame(numbered(0));

  CHECK_THROWS_AS(sink.end({}), OutputError);
}

TEST_CASE("The queue is bounded and frame waits when it is full") {
  std::promise<void> open;
  RecordingSink inner;
  inner.gate = open.get_future().share();
  std::atomic<int> handed_over{0};
  AsyncSink sink(inner, {}, 2);

  std::thread solver([&] {
    for (std::int64_t index = 0; index < 10; ++index, ++handed_over) sink.frame(numbered(index));
  });
  // One frame is being written and two wait: the fourth call does not return.
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const int before = handed_over;
  open.set_value();
  solver.join();
  sink.end({});

  CHECK(before <= 3);
  CHECK(inner.indices.size() == 10);
}

TEST_CASE("Destroyed without an end it writes what waits and tells an error that nobody saw") {
  RecordingSink inner;
  std::string lost;
  SECTION("no error") {
    {
      AsyncSink(inner, [&lost](const std::string& message) { lost = message; }).frame(numbered(0));
    }
    CHECK(inner.indices.size() == 1);
    CHECK(lost.empty());
  }
  SECTION("an error that nobody saw") {
    inner.fails_at = 0;
    {
      AsyncSink(inner, [&lost](const std::string& message) { lost = message; }).frame(numbered(0));
    }
    CHECK(lost == "the disk is full");
  }
  SECTION("an error that was thrown already") {
    inner.fails_at = 0;
    {
      AsyncSink sink(inner, [&lost](const std::string& message) { lost = message; });
      CHECK(push_until_refused(sink) == "the disk is full");
    }
    CHECK(lost.empty());
  }
}

TEST_CASE("A series written from the second thread is the same") {
  const TemporaryDirectory directory;
  const Scene scene = small_scene(50, 40);
  SeriesWriter writer(settings_of(directory / "series.h5"));
  AsyncSink sink(writer);

  sink.begin(scene, {});
  for (std::int64_t index = 0; index < 20; ++index) sink.frame(frame_of(scene, index));
  sink.end({});

  std::int64_t frames = 0;
  CHECK(completed_frames_are_intact(directory / "series.h5", scene, frames));
  CHECK(frames == 20);
}

}  // namespace sandsim::test
