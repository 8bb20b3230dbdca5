// Numbers, times and sizes as people read and write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sandsim::cli {

/// "1,234,567".
std::string format_count(std::int64_t count);
/// "512 B", "1.2 MB": powers of 1000.
std::string format_bytes(double bytes);
/// "1.2 ms", "3.45 s", "2 min 05 s", "1 h 02 min".
std::string format_duration(double seconds);
/// "0:07", "12:34", "1:02:03": for clocks that count down.
std::string format_clock(double seconds);
/// "182 M cell-steps/s".
std::string format_rate(double cell_steps_per_second);
/// "depth, velocity".
std::string join(std::string_view separator, const std::vector<std::string>& parts);

/// The text as one word for a shell.
std::string shell_word(const std::string& text);

/// Seconds in "HH:MM:SS", where hours may have any number of digits; nothing if the text has another form or is zero.
std::optional<double> parse_wall_clock(std::string_view text);

}  // namespace sandsim::cli
