#include "cli/text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <regex>

namespace sandsim::cli {

namespace {

/// Three significant digits and a prefix of `prefixes`, one step of 1000 each.
std::string with_prefix(double value, const std::array<const char*, 6>& prefixes) {
  std::size_t step = 0;
  while (std::abs(value) >= 999.5 && step + 1 < prefixes.size()) {
    value /= 1000.0;
    ++step;
  }
  const double magnitude = std::abs(value);
  // Whole numbers below the first step stay whole: "512 B", not "512.0 B".
  const int digits = step == 0 && value == std::floor(value) ? 0 : magnitude < 9.995 ? 2 : magnitude < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f} {}", value, digits, prefixes[step]);
}

/// Exactly the digits of `text` as a number; nothing if there is anything else, or nothing at all.
std::optional<int> parse_digits(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool digits_only = text.find_first_not_of("0123456789") == std::string_view::npos;
  if (text.empty() || !digits_only || error != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

std::string format_count(std::int64_t count) {
  const std::string digits = fmt::format("{}", count < 0 ? -count : count);
  std::string text = count < 0 ? "-" : "";
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) {
      text.push_back(',');
    }
    text.push_back(digits[k]);
  }
  return text;
}

std::string format_bytes(double bytes) {
  return with_prefix(bytes, {"B", "kB", "MB", "GB", "TB", "PB"});
}

std::string format_duration(double seconds) {
  if (!std::isfinite(seconds)) {
    return fmt::format("{} s", seconds);
  }
  const double magnitude = std::abs(seconds);
  if (magnitude == 0.0) {
    return "0 s";
  }
  if (magnitude < 0.9995) {
    return magnitude < 0.9995e-3 ? fmt::format("{:.3g} us", seconds * 1e6) : fmt::format("{:.3g} ms", seconds * 1e3);
  }
  if (magnitude < 59.95) {
    return fmt::format("{:.3g} s", seconds);
  }
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string format_clock(double seconds) {
  // Beyond a thousand hours an estimate says nothing.
  if (!std::isfinite(seconds) || seconds < 0.0 || seconds > 3.6e6) {
    return "-:--";
  }
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  if (whole < 3600) {
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
  }
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string format_rate(double cell_steps_per_second) {
  const std::array<const char*, 6> prefixes{"", "k ", "M ", "G ", "T ", "P "};
  return with_prefix(cell_steps_per_second, prefixes) + "cell-steps/s";
}

std::string join(std::string_view separator, const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& part : parts) {
    all += (all.empty() ? "" : std::string(separator)) + part;
  }
  return all;
}

std::string shell_word(const std::string& text) {
  if (!text.empty() && text.find_first_of(" \t\n\"'\\$`*?[]{}()<>|&;#~!") == std::string::npos) {
    return text;
  }
  return "'" + std::regex_replace(text, std::regex("'"), "'\\''") + "'";
}

std::optional<double> parse_wall_clock(std::string_view text) {
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string_view::npos ? first : text.find(':', first + 1);
  if (second == std::string_view::npos) {
    return std::nullopt;
  }
  const auto hours = parse_digits(text.substr(0, first));
  const auto minutes = parse_digits(text.substr(first + 1, second - first - 1));
  const auto seconds = parse_digits(text.substr(second + 1));
  if (!hours || !minutes || !seconds || *minutes > 59 || *seconds > 59) {
    return std::nullopt;
  }
  const double total = *hours * 3600.0 + *minutes * 60.0 + *seconds;
  return total > 0.0 ? std::optional(total) : std::nullopt;
}

}  // namespace sandsim::cli
