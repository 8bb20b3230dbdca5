#include "io/sweep/values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace sandsim {

namespace {

constexpr int most_values = 1'000'000;  // of one key

std::string without_spaces(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(text);
}

Complaint mixed_units(const std::string& one, const std::string& other) {
  const auto named = [](const std::string& unit) { return unit.empty() ? std::string("none") : '\'' + unit + '\''; };
  return {"mixed units", named(one) + " and " + named(other),
          "Give all numbers the same unit, or write it once, at the end."};
}

/// Numbers that share a unit, which may stand at the last one only; or what is wrong.
struct Numbers {
  std::vector<double> numbers;
  std::string unit;
};
Parsed<Numbers> with_one_unit(const std::vector<NumberWithUnit>& parts) {
  Numbers result{{}, parts.back().unit};
  bool all = true, none_before = true;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result.numbers.push_back(parts[k].number);
    all = all && parts[k].unit == result.unit;
    none_before = none_before && (parts[k].unit.empty() || k + 1 == parts.size());
  }
  if (!all && !none_before) {
    for (const NumberWithUnit& part : parts) {
      if (part.unit != result.unit) return mixed_units(part.unit, result.unit);
    }
  }
  return result;
}

Parsed<Interval> make_interval(const std::string& first, const std::string& last, bool logarithmic) {
  std::vector<NumberWithUnit> ends;
  for (const std::string& text : {first, last}) {
    const std::optional<NumberWithUnit> number = number_with_unit(text);
    if (!number) {
      return Complaint{"'" + text + "' is not a number with a unit", "a range has a first and a last number",
                       "Write it like \"20 deg:40 deg:5\"."};
    }
    ends.push_back(*number);
  }
  const Parsed<Numbers> numbers = with_one_unit(ends);
  if (const Complaint* complaint = std::get_if<Complaint>(&numbers)) return *complaint;
  const auto& [values, unit] = std::get<Numbers>(numbers);
  const Interval interval{values[0], values[1], unit, logarithmic};
  if (interval.first == interval.last) {
    return Complaint{"an empty range", "its first and its last value are the same", "Give the value alone."};
  }
  if (logarithmic && !(interval.first > 0.0 && interval.last > 0.0)) {
    return Complaint{"a logarithmic range needs positive ends", "", "Leave :log out."};
  }
  return interval;
}

/// Takes a unit from the end of "5 deg", the count of a range.
std::string take_unit(std::string& count) {
  const std::optional<NumberWithUnit> number = number_with_unit(count);
  if (!number || number->unit.empty()) return {};
  count = without_spaces(std::string_view(count).substr(0, count.size() - number->unit.size()));
  return ' ' + number->unit;
}

Parsed<SweepValues> parse_range(std::vector<std::string> parts) {
  const bool logarithmic = parts.back() == "log";
  if (logarithmic) parts.pop_back();
  if (parts.size() != 3) {
    return Complaint{"not a range", "a range has a first value, a last value and a count",
                     "Write it like \"20:40:5 deg\"; a text with a colon needs quotes."};
  }
  // In "20:40:5 deg" the unit is the last value's, and with it the first one's.
  const std::string unit = take_unit(parts[2]);
  const std::optional<NumberWithUnit> last = number_with_unit(parts[1]);
  if (last && !last->unit.empty() && !unit.empty()) return mixed_units(last->unit, unit.substr(1));
  const Parsed<Interval> made = make_interval(parts[0], parts[1] + unit, logarithmic);
  if (const Complaint* complaint = std::get_if<Complaint>(&made)) return *complaint;
  const Interval& interval = std::get<Interval>(made);
  const Parsed<int> parsed = parse_count(parts[2]);
  if (const Complaint* complaint = std::get_if<Complaint>(&parsed)) {
    return Complaint{"the count '" + parts[2] + "' is no number", complaint->problem, complaint->suggestion};
  }
  const int count = std::get<int>(parsed);
  if (count < 2) {
    return Complaint{fmt::format("a range of {} values", count), "its two ends are two", "Count 2 or more."};
  }
  if (count > most_values) return Complaint{"too many values", fmt::format("at most {} of a key", most_values), ""};
  std::vector<std::string> values;
  for (int k = 0; k < count; ++k) {
    values.push_back(sweep_value_text(interval.at(static_cast<double>(k) / (count - 1)), interval.unit));
  }
  return SweepValues(std::move(values));
}

/// "20..40 deg" or "0.1..10:log" in two; nothing if it does not begin with a number, as "../dem.asc" does not.
std::optional<Parsed<SweepValues>> parse_interval(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos || !number_with_unit(without_spaces(text.substr(0, dots)))) return std::nullopt;
  std::string last = without_spaces(text.substr(dots + 2));
  const bool logarithmic = last.ends_with(":log");
  if (logarithmic) last.resize(last.size() - 4);
  const Parsed<Interval> made = make_interval(without_spaces(text.substr(0, dots)), last, logarithmic);
  if (const Complaint* complaint = std::get_if<Complaint>(&made)) return *complaint;
  return SweepValues(std::get<Interval>(made));
}

}  // namespace

double Interval::at(double fraction) const {
  if (fraction == 0.0) return first;
  if (fraction == 1.0) return last;
  return logarithmic ? first * std::exp(fraction * std::log(last / first)) : first + fraction * (last - first);
}

std::string sweep_value_text(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.12g}", value) : fmt::format("{:.12g} {}", value, unit);
}

std::optional<NumberWithUnit> number_with_unit(std::string_view text) {
  NumberWithUnit result;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.number);
  if (error != std::errc{} || !std::isfinite(result.number)) return std::nullopt;
  result.unit = without_spaces(text.substr(static_cast<std::size_t>(end - text.data())));
  const bool word = result.unit.find_first_not_of("abcdefghijklmnopqrstuvwxyz/^23") == std::string::npos;
  if (!word || (!result.unit.empty() && result.unit[0] < 'a')) return std::nullopt;
  return result;
}

std::vector<std::string> split_outside_brackets(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = '\0';
  for (const char c : text) {
    if (quote != '\0') {
      quote = c == quote ? '\0' : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == separator && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  for (std::string& part : parts) part = without_spaces(part);
  return parts;
}

Parsed<SweepValues> parse_sweep_list(std::vector<std::string> values) {
  std::vector<NumberWithUnit> numbers;
  for (const std::string& value : values) {
    if (value.empty()) {
      return Complaint{"an empty value", "values are separated by single commas", "Write them like \"20,30,40 deg\"."};
    }
    if (const std::optional<NumberWithUnit> number = number_with_unit(value)) numbers.push_back(*number);
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    for (std::size_t m = 0; m < k && values.size() <= 1000; ++m) {
      if (values[m] == values[k]) return Complaint{"the value '" + values[k] + "' is given twice", "", "Remove one."};
    }
  }
  if (numbers.size() < values.size() || values.empty()) return SweepValues(std::move(values));
  const Parsed<Numbers> shared = with_one_unit(numbers);
  if (const Complaint* complaint = std::get_if<Complaint>(&shared)) return *complaint;
  // The numbers stay as they were written.
  const std::string& unit = std::get<Numbers>(shared).unit;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (numbers[k].unit != unit) values[k] += ' ' + unit;
  }
  return SweepValues(std::move(values));
}

Parsed<SweepValues> parse_sweep_values(std::string_view text) {
  if (without_spaces(text).empty()) {
    return Complaint{"no values", "", "Write a list, \"20,30 deg\", or a range, \"20:40:5 deg\"."};
  }
  if (std::optional<Parsed<SweepValues>> interval = parse_interval(text)) return *std::move(interval);
  std::vector<std::string> parts = split_outside_brackets(text, ':');
  if (parts.size() > 1) return parse_range(std::move(parts));
  return parse_sweep_list(split_outside_brackets(text, ','));
}

}  // namespace sandsim
