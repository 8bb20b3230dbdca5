#include "io/sweep/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace sandsim {

namespace {

/// Uniform in [0, 1) from the 53 highest bits: std::uniform_real_distribution differs between libraries.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// 0, 1, ..., count - 1 in random order (Fisher and Yates); std::shuffle differs between libraries.
std::vector<int> permutation(int count, std::mt19937_64& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = order.size(); k > 1; --k) {
    std::swap(order[k - 1], order[static_cast<std::size_t>(uniform(random) * static_cast<double>(k))]);
  }
  return order;
}

/// The values of one sampled key. Each key has a generator of its own: adding a key leaves the others as they are.
std::vector<std::string> draw(const Interval& interval, const Samples& samples, std::size_t key) {
  std::seed_seq seeds{samples.seed & 0xFFFFFFFF, samples.seed >> 32, static_cast<std::uint64_t>(key)};
  std::mt19937_64 random(seeds);
  std::vector<int> strata;
  if (samples.sampling == Sampling::latin) strata = permutation(samples.count, random);
  std::vector<std::string> values;
  for (int k = 0; k < samples.count; ++k) {
    const double place = uniform(random);
    const double fraction = strata.empty() ? place : (strata[static_cast<std::size_t>(k)] + place) / samples.count;
    values.push_back(sweep_value_text(interval.at(fraction), interval.unit));
  }
  return values;
}

bool varies(const SweepPlan& plan, const std::string& key) {
  const std::vector<std::string> keys = plan.keys();
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

SweepAxis sample_axis(const SweepPlan& plan) {
  SweepAxis axis;
  for (std::size_t k = 0; k < plan.sampled.size(); ++k) {
    axis.keys.push_back(plan.sampled[k].key);
    axis.values.push_back(draw(plan.sampled[k].interval, plan.samples, k));
  }
  return axis;
}

}  // namespace

std::vector<std::string> SweepPlan::keys() const {
  std::vector<std::string> all;
  for (const SweepAxis& axis : axes) all.insert(all.end(), axis.keys.begin(), axis.keys.end());
  for (const SampledKey& key : sampled) all.push_back(key.key);
  return all;
}

std::uint64_t SweepPlan::count() const {
  std::uint64_t product = sampled.empty() ? 1 : static_cast<std::uint64_t>(samples.count);
  for (const SweepAxis& axis : axes) {
    if (__builtin_mul_overflow(product, axis.values.front().size(), &product)) {
      return std::numeric_limits<std::uint64_t>::max();
    }
  }
  return product;
}

std::vector<std::vector<std::string>> SweepPlan::cases() const {
  std::vector<SweepAxis> all = axes;
  if (!sampled.empty()) all.push_back(sample_axis(*this));
  std::vector<std::vector<std::string>> cases{{}};
  for (const SweepAxis& axis : all) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& before : cases) {
      for (std::size_t k = 0; k < axis.values.front().size(); ++k) {
        longer.push_back(before);
        for (const std::vector<std::string>& values : axis.values) longer.back().push_back(values[k]);
      }
    }
    cases = std::move(longer);
  }
  return cases;
}

std::optional<Complaint> add_axis(SweepPlan& plan, const std::vector<std::string>& keys,
                                  std::vector<SweepValues> values) {
  SweepAxis axis;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const bool again = std::find(axis.keys.begin(), axis.keys.end(), keys[k]) != axis.keys.end();
    if (again || varies(plan, keys[k]))
      return Complaint{"'" + keys[k] + "' varies twice", "", "Remove one of the two."};
    if (const Interval* interval = std::get_if<Interval>(&values[k])) {
      plan.sampled.push_back({keys[k], *interval});
      continue;
    }
    axis.keys.push_back(keys[k]);
    axis.values.push_back(std::get<std::vector<std::string>>(std::move(values[k])));
    const std::size_t first = axis.values.front().size(), now = axis.values.back().size();
    if (first != now) {
      return Complaint{fmt::format("'{}' has {} values and '{}' has {}", axis.keys.front(), first, keys[k], now),
                       "keys that vary together need as many values", "Give them a --vary each for all combinations."};
    }
  }
  if (!axis.keys.empty()) plan.axes.push_back(std::move(axis));
  return std::nullopt;
}

std::optional<Complaint> add_vary(SweepPlan& plan, const std::string& text) {
  std::vector<std::string> keys;
  std::vector<SweepValues> values;
  for (const std::string& part : split_outside_brackets(text, ';')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0) {
      return Complaint{"not of the form key=values", "", "Write it like \"sand.friction_angle=20:40:5 deg\"."};
    }
    keys.push_back(part.substr(0, equals));
    Parsed<SweepValues> parsed = parse_sweep_values(std::string_view(part).substr(equals + 1));
    if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) return *complaint;
    values.push_back(std::get<SweepValues>(std::move(parsed)));
  }
  return add_axis(plan, keys, std::move(values));
}

std::optional<Complaint> check_plan(const SweepPlan& plan) {
  if (plan.axes.empty() && plan.sampled.empty()) {
    return Complaint{"nothing varies", "a sweep runs a scene with different values",
                     "Say which: --vary sand.friction_angle=\"20:40:5 deg\"."};
  }
  if (!plan.sampled.empty() && plan.samples.count < 1) {
    return Complaint{"no number of samples",
                     "'" + plan.sampled.front().key + "' is an interval that samples are drawn from",
                     "Say how many: --samples 64. A range has a count: first:last:count."};
  }
  if (plan.sampled.empty() && plan.samples.count > 0) {
    return Complaint{"nothing to draw samples from", "samples come from intervals, and no key has one",
                     "Write one like \"20..40 deg\"."};
  }
  for (const std::string& text : plan.overrides) {
    const std::string key = text.substr(0, text.find('='));
    if (varies(plan, key)) return Complaint{"'" + key + "' is both set and varied", "", "Remove one of the two."};
  }
  return std::nullopt;
}

}  // namespace sandsim
