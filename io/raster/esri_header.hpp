// The header of an ESRI ASCII grid.
#pragma once

#include <array>
#include <string_view>

#include "io/raster/source_text.hpp"

namespace sandsim {

/// Takes a text apart at blanks and line ends.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : rest_(text) {}

  /// The next token without taking it; empty at the end.
  std::string_view peek();
  std::string_view take();
  std::size_t bytes_left() const { return rest_.size(); }

 private:
  std::string_view rest_;
};

/// The keys that a header has, and where.
struct EsriHeader {
  enum Key { ncols, nrows, xllcorner, xllcenter, yllcorner, yllcenter, cellsize, dx, dy, nodata, key_count };
  static constexpr std::array<std::string_view, key_count> key_names{
      "ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "dx", "dy", "nodata_value"};

  std::array<std::string_view, key_count> key;  // as in the file; empty: absent
  std::array<std::string_view, key_count> value;

  bool has(Key k) const { return !key[k].empty(); }
};

/// The text that the tokens are taken from: without a byte order mark, and without the Ctrl-Z and the zeros that old
/// programs leave at the end.
std::string_view without_marks(std::string_view text);

/// Whether a text begins with a key of a header, or with a number before one.
bool begins_like_esri_ascii(std::string_view text);

/// Takes the header: "key value", "key: value", "key = value", or "value key" as GeoClaw writes it. Throws InputError
/// (file:line:col) for unknown keys, and for keys that are missing, there twice or exclude each other.
EsriHeader read_esri_header(const SourceText& source, Tokens& tokens);

}  // namespace sandsim
