// The numbers of an ESRI ASCII grid in the spellings that programs write.
#pragma once

#include <string_view>

#include "io/raster/source_text.hpp"

namespace sandsim {

/// Whether a token stands for "no data" by itself, in any case: nan, null, na, and what Microsoft's runtime prints
/// (1.#QNAN, -1.#IND, -nan(ind)).
bool is_no_data_word(std::string_view token);

/// Reads numbers with a decimal point or a decimal comma, and exponents with E or Fortran's D.
///
/// A single comma between digits is a decimal comma, unless it may as well group thousands (1,234): such numbers are
/// read only where another one of the file shows that commas are decimal (10,5), and none has a point.
class EsriNumbers {
 public:
  explicit EsriNumbers(const SourceText& source) : source_(source) {}

  /// NaN for "no data". Throws InputError at the token if it is no number; `what` comes before the problem.
  double read(std::string_view token, std::string_view what = "");
  /// The values begin: among them are no commas beside points.
  void begin_values() { value_with_comma_ = value_with_point_ = {}; }
  /// All numbers have been read. Throws InputError if it is not certain what the commas mean.
  void finish() const;

 private:
  void note(std::string_view token);

  const SourceText& source_;
  // The first token of its kind; empty: none.
  std::string_view with_point_, decimal_comma_, unclear_comma_;
  std::string_view value_with_comma_, value_with_point_;
};

}  // namespace sandsim
