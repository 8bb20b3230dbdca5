// Which cases a sweep has: the product of its axes, and of the points of its samples.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/sweep/values.hpp"

namespace sandsim {

/// Keys that vary together: as many values of each.
struct SweepAxis {
  std::vector<std::string> keys;
  std::vector<std::vector<std::string>> values;  // one list a key
};

/// A key whose values are drawn from an interval.
struct SampledKey {
  std::string key;
  Interval interval;
};

enum class Sampling {
  latin,   // Latin hypercube: each of `count` equal parts of every interval is hit once (McKay, Beckman, Conover 1979)
  random,  // independent points
};

struct Samples {
  int count = 0;
  Sampling sampling = Sampling::latin;
  std::uint64_t seed = 1;
};

struct SweepPlan {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  // "a.b=v", for all cases
  std::vector<SweepAxis> axes;
  std::vector<SampledKey> sampled;
  Samples samples;

  /// All keys that vary, in the order in which they were given, sampled ones last.
  std::vector<std::string> keys() const;
  /// Number of cases; the largest number there is if it is beyond that.
  std::uint64_t count() const;
  /// The values of every case in the order of keys(): the last axis changes fastest, samples faster still. The same
  /// seed gives the same samples everywhere. Call it only for a count() that fits into the memory.
  std::vector<std::vector<std::string>> cases() const;
};

// What these find wrong they return; the plan is then not to be used.

/// Adds one `--vary`: "key=VALUES", or several of them separated by semicolons, which vary together.
[[nodiscard]] std::optional<Complaint> add_vary(SweepPlan& plan, const std::string& text);

/// Adds keys that vary together: intervals become sampled keys, the others an axis. A key varies once, and lists that
/// go together are equally long.
[[nodiscard]] std::optional<Complaint> add_axis(SweepPlan& plan, const std::vector<std::string>& keys,
                                                std::vector<SweepValues> values);

/// Rules across the plan: something varies, samples and intervals go together, no key is both set and varied.
[[nodiscard]] std::optional<Complaint> check_plan(const SweepPlan& plan);

}  // namespace sandsim
