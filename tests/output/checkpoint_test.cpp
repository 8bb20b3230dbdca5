#include "io/output/checkpoint.hpp"

#include <cstring>
#include <fstream>
#include <limits>

#include "io/output/scene_hash.hpp"
#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;

Checkpoint some_checkpoint() {
  Checkpoint checkpoint;
  checkpoint.steps = 123456789012;
  checkpoint.frames = 42;
  checkpoint.time = 1.0 / 3.0;
  checkpoint.frame_step_min = 1e-300;
  checkpoint.frame_step_max = std::numeric_limits<double>::infinity();
  checkpoint.wall_time = 12.5;
  checkpoint.ledger = {1.0, 0.1, 0.2, 0.3, -0.0};
  checkpoint.dt_min = 5e-324;
  checkpoint.dt_max = 0.1;
  checkpoint.smallest_step = {7, -1, 0.7, 0.001, "thin layer"};
  checkpoint.stop_time = 2.5;
  // Negative zero, a subnormal, NaN with a payload: all bits count.
  checkpoint.state.depth = std::vector<float>{0.1f, -0.0f, 1e-45f, std::nanf("77")};
  checkpoint.state.momentum_x = std::vector<float>(4, 0.25f);
  checkpoint.state.momentum_y = std::vector<float>(4, -0.25f);
  checkpoint.particles = {{0.5f, 0.25f}, {0.0f, 0.75f}, {std::int64_t{7} << 32, 1}, {1.0f}, {-1.0f}, {2, 9, 8, 6, 2}};
  checkpoint.runout = {{1, 0, 1, 1}, 0.25, 1.5};
  return checkpoint;
}

template <class Number>
bool same_bits(const FieldValues& a, const std::vector<Number>& b) {
  const auto* values = std::get_if<std::vector<Number>>(&a);
  return values != nullptr && values->size() == b.size() &&
         std::memcmp(values->data(), b.data(), b.size() * sizeof(Number)) == 0;
}

}  // namespace

TEST_CASE("A checkpoint comes back bit for bit") {
  const TemporaryDirectory directory;
  const Checkpoint written = some_checkpoint();

  write_checkpoint(directory / "checkpoint.h5", written, "hash");
  const Checkpoint read = read_checkpoint(directory / "checkpoint.h5", "hash");

  CHECK(read.steps == written.steps);
  CHECK(read.frames == 42);
  CHECK(read.time == written.time);
  CHECK(read.frame_step_min == written.frame_step_min);
  CHECK(read.frame_step_max == written.frame_step_max);
  CHECK(read.wall_time == 12.5);
  CHECK(std::memcmp(&read.ledger, &written.ledger, sizeof read.ledger) == 0);
  CHECK(read.dt_min == written.dt_min);
  CHECK(read.dt_max == written.dt_max);
  CHECK(read.smallest_step.i == 7);
  CHECK(read.smallest_step.j == -1);
  CHECK(read.smallest_step.cause == "thin layer");
  CHECK(read.stop_time == 2.5);
  CHECK(same_bits(read.state.depth, std::get<std::vector<float>>(written.state.depth)));
  CHECK(same_bits(read.state.momentum_x, std::get<std::vector<float>>(written.state.momentum_x)));
  CHECK(same_bits(read.state.momentum_y, std::get<std::vector<float>>(written.state.momentum_y)));
  CHECK_FALSE(read.state.has_covers());
  CHECK(same_bits(read.max_depth, std::vector<float>{}));
  CHECK(read.runout.reached == written.runout.reached);
  CHECK(read.runout.max_depth == 0.25);
  CHECK(read.runout.max_speed == 1.5);
  CHECK(read.particles.offset_x == written.particles.offset_x);
  CHECK(read.particles.offset_y == written.particles.offset_y);
  CHECK(read.particles.id == written.particles.id);
  CHECK(read.particles.velocity_x == written.particles.velocity_x);
  CHECK(read.particles.velocity_y == written.particles.velocity_y);
  CHECK(read.particles.report.moves == 9);
  CHECK(read.particles.report.left == 2);
  CHECK_FALSE(fs::exists(directory / "checkpoint.h5.tmp"));
}

TEST_CASE("A checkpoint in double precision of more than one chunk comes back with its maxima") {
  const TemporaryDirectory directory;
  std::vector<double> values(200000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0 / (1.0 + static_cast<double>(i));
  Checkpoint written = some_checkpoint();
  written.state.depth = written.state.momentum_x = written.state.momentum_y = values;
  written.state.bed = written.state.buried = values;
  written.max_depth = written.max_speed = written.arrival_time = values;

  write_checkpoint(directory / "checkpoint.h5", some_checkpoint(), "hash");
  write_checkpoint(directory / "checkpoint.h5", written, "hash");
  const Checkpoint read = read_checkpoint(directory / "checkpoint.h5", "hash");

  CHECK(same_bits(read.state.depth, values));
  CHECK(same_bits(read.state.bed, values));
  CHECK(same_bits(read.state.buried, values));
  CHECK(same_bits(read.arrival_time, values));
}

TEST_CASE("A checkpoint that does not belong here is an input error that says why") {
  const TemporaryDirectory directory;
  const fs::path path = directory / "checkpoint.h5";
  Checkpoint checkpoint = some_checkpoint();
  checkpoint.state.depth = std::vector<float>(10000, 1.0f);
  write_checkpoint(path, checkpoint, "hash");
  std::string reason = "damaged";
  std::string hash = "hash";

  SECTION("another scene") {
    hash = "other";
    reason = "another scene (hash, this one is other)";
  }
  SECTION("no file") {
    fs::remove(path);
    reason = "no checkpoint to resume from";
  }
  SECTION("cut short") {
    fs::resize_file(path, fs::file_size(path) / 2);
  }
  SECTION("empty") {
    fs::resize_file(path, 0);
  }
  SECTION("text") {
    write_text(path, "not a checkpoint");
  }
  SECTION("a flipped bit in the depth") {
    std::string bytes = read_text(path);
    const std::string ones(reinterpret_cast<const char*>(std::vector<float>(64, 1.0f).data()), 256);
    bytes[bytes.find(ones) + 100] ^= 1;
    write_text(path, bytes);
  }

  const std::string message = message_of<InputError>([&] { read_checkpoint(path, hash); });
  INFO(message);
  CHECK(message.find(reason) != std::string::npos);
}

TEST_CASE("A checkpoint that cannot be written is an output error and leaves the old one") {
  const TemporaryDirectory directory;
  write_checkpoint(directory / "checkpoint.h5", some_checkpoint(), "hash");
  fs::create_directory(directory / "checkpoint.h5.tmp");

  CHECK_THROWS_AS(write_checkpoint(directory / "checkpoint.h5", Checkpoint{}, "hash"), OutputError);
  CHECK_THROWS_AS(write_checkpoint(directory / "missing/checkpoint.h5", Checkpoint{}, "hash"), OutputError);
  CHECK(read_checkpoint(directory / "checkpoint.h5", "hash").frames == 42);
}

TEST_CASE("The hash of a scene changes with its text and with every byte of its files") {
  const TemporaryDirectory directory;
  write_text(directory / "a", "12");
  write_text(directory / "b", "3");
  const std::string hash = scene_hash("text", {directory / "a", directory / "b"});

  CHECK(hash.starts_with("fnv1a64:"));
  CHECK(hash.size() == 24);
  CHECK(scene_hash("text", {directory / "a", directory / "b"}) == hash);
  CHECK(scene_hash("texT", {directory / "a", directory / "b"}) != hash);
  CHECK(scene_hash("text", {directory / "a"}) != hash);
  // The same bytes, cut elsewhere.
  write_text(directory / "a", "1");
  write_text(directory / "b", "23");
  CHECK(scene_hash("text", {directory / "a", directory / "b"}) != hash);
  CHECK_THROWS_AS(scene_hash("text", {directory / "c"}), InputError);
}

TEST_CASE("The content hash is FNV-1a") {
  // Test vectors of the algorithm's authors.
  ContentHash hash;
  CHECK(hash.value() == 0xcbf29ce484222325ull);
  hash.update("a");
  CHECK(hash.value() == 0xaf63dc4c8601ec8cull);
  ContentHash other;
  other.update("foobar");
  CHECK(other.value() == 0x85944171f73967e8ull);
}

}  // namespace sandsim::test
