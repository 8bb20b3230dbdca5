// The ESRI ASCII grid. Format: Esri, "ASCII to Raster" and GDAL's AAIGrid driver (dx, dy).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/raster/limits.hpp"
#include "io/raster/read_raster.hpp"
#include "io/raster/source_text.hpp"

namespace sandsim {
namespace {

enum Key { ncols, nrows, xllcorner, xllcenter, yllcorner, yllcenter, cellsize, dx, dy, nodata, key_count };
constexpr std::array<std::string_view, key_count> key_names{
    "ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "dx", "dy", "nodata_value"};

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return lower;
}

bool starts_a_word(std::string_view token) {
  const char c = lower_case(token.substr(0, 1)).front();
  return (c >= 'a' && c <= 'z') || c == '_';
}

/// Takes the text apart at blanks and line ends.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : rest_(text) {}

  /// The next token without taking it; empty at the end.
  std::string_view peek() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    return rest_.substr(0, rest_.find_first_of(blanks));
  }
  std::string_view take() {
    const std::string_view token = peek();
    rest_.remove_prefix(token.size());
    return token;
  }
  std::size_t bytes_left() const { return rest_.size(); }

 private:
  static constexpr std::string_view blanks = " \t\r\n\v\f";
  std::string_view rest_;
};

/// The keys that the header has, and where.
struct Header {
  std::array<std::string_view, key_count> key;  // empty: absent
  std::array<std::string_view, key_count> value;

  bool has(Key k) const { return !key[k].empty(); }
};

Header read_header(const SourceText& source, Tokens& tokens) {
  Header header;
  while (!tokens.peek().empty() && starts_a_word(tokens.peek())) {
    const std::string_view word = tokens.peek();
    if (parse_number(word).value) {
      break;  // nan, the first value
    }
    tokens.take();
    const auto found = std::find(key_names.begin(), key_names.end(), lower_case(word));
    if (found == key_names.end()) {
      const std::string_view nearest = nearest_name(lower_case(word), key_names);
      source.fail(word, fmt::format("{} is no key of an ESRI ASCII header. {}", in_quotes(word),
                                    nearest.empty() ? fmt::format("The keys are {}", fmt::join(key_names, ", "))
                                                    : fmt::format("Did you mean {}?", nearest)));
    }
    const auto k = static_cast<std::size_t>(found - key_names.begin());
    if (!header.key[k].empty()) {
      source.fail(word, fmt::format("{} is there twice. Remove one of the lines", *found));
    }
    header.key[k] = word;
    header.value[k] = tokens.take();
    if (header.value[k].empty()) {
      source.fail_at_end(fmt::format("the file ends after the key {} (truncated?)", *found));
    }
  }
  return header;
}

void check_exactly_one(const SourceText& source, const Header& header, Key one, Key other) {
  if (header.has(one) && header.has(other)) {
    source.fail(header.key[other].data() > header.key[one].data() ? header.key[other] : header.key[one],
                fmt::format("both {} and {} are given (they exclude each other). Remove one", key_names[one],
                            key_names[other]));
  }
}

/// Throws if keys are missing or exclude each other.
void check_keys(const SourceText& source, const Header& header, std::string_view first_value) {
  check_exactly_one(source, header, xllcorner, xllcenter);
  check_exactly_one(source, header, yllcorner, yllcenter);
  check_exactly_one(source, header, cellsize, dx);
  check_exactly_one(source, header, cellsize, dy);
  std::string missing;
  const auto require = [&](bool present, std::string_view text) {
    if (!present) {
      missing += missing.empty() ? text : fmt::format(", {}", text);
    }
  };
  require(header.has(ncols), "ncols");
  require(header.has(nrows), "nrows");
  require(header.has(xllcorner) || header.has(xllcenter), "xllcorner (or xllcenter)");
  require(header.has(yllcorner) || header.has(yllcenter), "yllcorner (or yllcenter)");
  if (header.has(dx) || header.has(dy)) {
    require(header.has(dx), "dx");
    require(header.has(dy), "dy");
  } else {
    require(header.has(cellsize), "cellsize (or dx and dy)");
  }
  if (!missing.empty()) {
    const std::string message = fmt::format("the header lacks {}", missing);
    first_value.empty() ? source.fail_at_end(message) : source.fail(first_value, message);
  }
}

std::size_t size_of(const SourceText& source, const Header& header, Key key) {
  const std::string_view token = header.value[key];
  std::uint64_t count = 0;
  const auto [stop, error] = std::from_chars(token.data(), token.data() + token.size(), count);
  if (stop != token.data() + token.size() || error == std::errc::invalid_argument ||
      (error == std::errc{} && count == 0)) {
    source.fail(token, fmt::format("{} = {} is not a positive integer", key_names[key], in_quotes(token)));
  }
  if (error == std::errc::result_out_of_range || count > most_raster_values) {
    source.fail(token, fmt::format("{} = {} is too large (at most {} values are read)", key_names[key],
                                   in_quotes(token), most_raster_values));
  }
  return static_cast<std::size_t>(count);
}

double number_of(const SourceText& source, const Header& header, Key key) {
  const ParsedNumber number = parse_number(header.value[key]);
  if (!number.value) {
    source.fail(header.value[key], fmt::format("{}: {}", key_names[key], number.problem));
  }
  if (!std::isfinite(*number.value)) {
    source.fail(header.value[key], fmt::format("{} = {} is not finite", key_names[key], in_quotes(header.value[key])));
  }
  return *number.value;
}

double spacing_of(const SourceText& source, const Header& header, Key key) {
  const double spacing = number_of(source, header, key);
  if (spacing <= 0.0) {
    source.fail(header.value[key],
                fmt::format("{} = {} is not positive", key_names[key], in_quotes(header.value[key])));
  }
  return spacing;
}

/// Decides whether a value means "no data".
class NoData {
 public:
  NoData(const SourceText& source, const Header& header) {
    if (!header.has(nodata)) {
      return;
    }
    const ParsedNumber number = parse_number(header.value[nodata]);
    if (!number.value || std::isinf(*number.value)) {
      source.fail(header.value[nodata],
                  fmt::format("nodata_value: {} is neither a number nor nan", in_quotes(header.value[nodata])));
    }
    value_ = *number.value;
    given_ = true;
  }
  bool given() const { return given_; }
  bool is_nan() const { return given_ && std::isnan(value_); }
  /// Writers round the header and the values to different numbers of digits (-3.402823e38): seven digits decide.
  bool matches(double value) const {
    constexpr double seven_digits = 5e-7;
    return given_ && (std::isnan(value) ? is_nan() : std::abs(value - value_) <= seven_digits * std::abs(value_));
  }

 private:
  bool given_ = false;
  double value_ = 0.0;
};

double value_of(const SourceText& source, std::string_view token, const NoData& no_data) {
  const ParsedNumber number = parse_number(token);
  if (!number.value) {
    source.fail(token, number.problem);
  }
  if (no_data.matches(*number.value)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!std::isfinite(*number.value)) {
    source.fail(token, fmt::format("{} is not finite. Mark cells without data by NODATA_value in the header",
                                   in_quotes(token)));
  }
  return *number.value;
}

/// The values in the order of the file. Memory grows with the file, not with what the header claims.
std::vector<double> read_values(const SourceText& source, Tokens& tokens, std::size_t count, const NoData& no_data) {
  std::vector<double> values;
  values.reserve(std::min(count, tokens.bytes_left() / 2 + 1));
  bool any_data = false;
  while (values.size() < count) {
    const std::string_view token = tokens.take();
    if (token.empty()) {
      source.fail_at_end(fmt::format("the file ends after {} of {} values (truncated?)", values.size(), count));
    }
    values.push_back(value_of(source, token, no_data));
    any_data = any_data || !std::isnan(values.back());
  }
  if (const std::string_view surplus = tokens.take(); !surplus.empty()) {
    source.fail(surplus, fmt::format("{} is behind the last of the {} values that ncols and nrows announce. Correct "
                                     "the header or the values",
                                     in_quotes(surplus), count));
  }
  if (!any_data) {
    source.fail(source.text(), fmt::format("all {} values are NODATA (nothing to read)", count));
  }
  return values;
}

void flip_rows(Raster& raster) {
  for (std::size_t row = 0; row < raster.ny / 2; ++row) {
    const auto lower = raster.values.begin() + static_cast<std::ptrdiff_t>(row * raster.nx);
    const auto upper = raster.values.begin() + static_cast<std::ptrdiff_t>((raster.ny - 1 - row) * raster.nx);
    std::swap_ranges(lower, lower + static_cast<std::ptrdiff_t>(raster.nx), upper);
  }
}

}  // namespace

Raster read_esri_ascii(std::string_view text, const std::string& name) {
  const SourceText source(text, name);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  Tokens tokens(text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text);
  if (tokens.peek().empty()) {
    source.fail(text, "the file is empty");
  }
  const Header header = read_header(source, tokens);
  check_keys(source, header, tokens.peek());

  Raster raster;
  raster.nx = size_of(source, header, ncols);
  raster.ny = size_of(source, header, nrows);
  if (std::uint64_t{raster.nx} * raster.ny > most_raster_values) {
    source.fail(header.value[ncols], fmt::format("ncols * nrows = {} * {} is too large (at most {} values are read)",
                                                 raster.nx, raster.ny, most_raster_values));
  }
  raster.spacing_x = spacing_of(source, header, header.has(cellsize) ? cellsize : dx);
  raster.spacing_y = spacing_of(source, header, header.has(cellsize) ? cellsize : dy);
  raster.origin_x = header.has(xllcenter) ? number_of(source, header, xllcenter)
                                          : number_of(source, header, xllcorner) + 0.5 * raster.spacing_x;
  raster.origin_y = header.has(yllcenter) ? number_of(source, header, yllcenter)
                                          : number_of(source, header, yllcorner) + 0.5 * raster.spacing_y;
  raster.has_georeference = true;
  raster.values = read_values(source, tokens, raster.nx * raster.ny, NoData(source, header));
  flip_rows(raster);
  return raster;
}

}  // namespace sandsim
