// The ESRI ASCII grid. Format: Esri, "ASCII to Raster" and GDAL's AAIGrid driver (dx, dy).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/raster/esri_header.hpp"
#include "io/raster/esri_numbers.hpp"
#include "io/raster/limits.hpp"
#include "io/raster/read_raster.hpp"

namespace sandsim {
namespace {

using Key = EsriHeader::Key;

/// A header and the reader of its numbers.
struct Entries {
  const SourceText& source;
  const EsriHeader& header;
  EsriNumbers& numbers;

  [[noreturn]] void fail(Key key, const std::string& problem) const {
    source.fail(header.value[key],
                fmt::format("{} = {} {}", EsriHeader::key_names[key], in_quotes(header.value[key]), problem));
  }
  double number(Key key) const {
    const double value = numbers.read(header.value[key], EsriHeader::key_names[key]);
    if (!std::isfinite(value)) {
      fail(key, "is not finite");
    }
    return value;
  }
  std::size_t size(Key key) const {
    const double count = parse_number(header.value[key]).value.value_or(0.0);  // "6", or "6.0" as some write it
    if (!(count > 0.0) || count != std::floor(count)) {
      fail(key, "is not a positive integer");
    }
    if (count > static_cast<double>(most_raster_values)) {
      fail(key, fmt::format("is too large (at most {} values are read)", most_raster_values));
    }
    return static_cast<std::size_t>(count);
  }
  double spacing(Key key) const {
    const double value = number(key);
    if (value <= 0.0) {
      fail(key, "is not positive");
    }
    return value;
  }
  /// Of the centre of the first cell, from the key of the centre or that of the corner.
  double origin(Key centre, Key corner, double spacing) const {
    return header.has(centre) ? number(centre) : number(corner) + 0.5 * spacing;
  }
};

/// Decides whether a value means "no data": NaN always does.
class NoData {
 public:
  explicit NoData(const Entries& entries) {
    if (!entries.header.has(Key::nodata)) {
      return;
    }
    value_ = entries.numbers.read(entries.header.value[Key::nodata], "nodata_value");
    if (std::isinf(value_)) {
      entries.fail(Key::nodata, "is neither a number nor nan");
    }
  }
  /// Writers round the header and the values to different numbers of digits (-3.402823e38): seven digits decide.
  bool matches(double value) const {
    constexpr double seven_digits = 5e-7;
    return std::isnan(value) || std::abs(value - value_) <= seven_digits * std::abs(value_);
  }

 private:
  double value_ = std::numeric_limits<double>::quiet_NaN();
};

double value_of(const SourceText& source, std::string_view token, EsriNumbers& numbers, const NoData& no_data) {
  const double value = numbers.read(token);
  if (no_data.matches(value)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!std::isfinite(value)) {
    source.fail(token, fmt::format("{} is not finite. Mark cells without data by NODATA_value in the header",
                                   in_quotes(token)));
  }
  return value;
}

/// The values in the order of the file. Memory grows with the file, not with what the header claims.
std::vector<double> read_values(const SourceText& source, Tokens& tokens, std::size_t count, EsriNumbers& numbers,
                                const NoData& no_data) {
  numbers.begin_values();
  std::vector<double> values;
  values.reserve(std::min(count, tokens.bytes_left() / 2 + 1));
  bool any_data = false;
  while (values.size() < count) {
    const std::string_view token = tokens.take();
    if (token.empty()) {
      source.fail_at_end(fmt::format("the file ends after {} of {} values (truncated?)", values.size(), count));
    }
    values.push_back(value_of(source, token, numbers, no_data));
    any_data = any_data || !std::isnan(values.back());
  }
  if (const std::string_view surplus = tokens.take(); !surplus.empty()) {
    source.fail(surplus, fmt::format("{} is behind the last of the {} values that ncols and nrows announce. Correct "
                                     "the header or the values",
                                     in_quotes(surplus), count));
  }
  numbers.finish();
  if (!any_data) {
    source.fail(source.text(), fmt::format("all {} values are NODATA (nothing to read)", count));
  }
  return values;
}

}  // namespace

Raster read_esri_ascii(std::string_view text, const std::string& name) {
  const SourceText source(text, name);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    source.fail(text, "the file is text in UTF-16. Save it as UTF-8 or ASCII");
  }
  Tokens tokens(without_marks(text));
  if (tokens.peek().empty()) {
    source.fail(text, "the file is empty");
  }
  const EsriHeader header = read_esri_header(source, tokens);
  EsriNumbers numbers(source);
  const Entries entries{source, header, numbers};

  Raster raster;
  raster.nx = entries.size(Key::ncols);
  raster.ny = entries.size(Key::nrows);
  if (std::uint64_t{raster.nx} * raster.ny > most_raster_values) {
    source.fail(header.value[Key::ncols],
                fmt::format("ncols * nrows = {} * {} is too large (at most {} values are read)", raster.nx, raster.ny,
                            most_raster_values));
  }
  raster.spacing_x = entries.spacing(header.has(Key::cellsize) ? Key::cellsize : Key::dx);
  raster.spacing_y = entries.spacing(header.has(Key::cellsize) ? Key::cellsize : Key::dy);
  raster.origin_x = entries.origin(Key::xllcenter, Key::xllcorner, raster.spacing_x);
  raster.origin_y = entries.origin(Key::yllcenter, Key::yllcorner, raster.spacing_y);
  raster.has_georeference = true;
  const NoData no_data(entries);
  raster.values = read_values(source, tokens, raster.nx * raster.ny, numbers, no_data);
  raster.flip_rows();
  return raster;
}

}  // namespace sandsim
