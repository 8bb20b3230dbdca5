// Words and numbers of a text, with errors that point at them.
#pragma once

#include <string>
#include <string_view>

#include "io/raster/source_text.hpp"

namespace sandsim {

/// Hands out the words of a text one after the other, blanks and line ends between them.
class Tokens {
 public:
  Tokens(std::string_view text, const std::string& name) : source_(text, name), rest_(text) {}

  /// The next word; empty at the end.
  std::string_view next();
  /// The next word of this line; empty at its end, which is not passed.
  std::string_view next_in_line();
  /// Passes the rest of the line and its end. False if there is no further line.
  bool skip_line();

  /// The next word (of this line) as a finite number; `what` it is stands in the error, e.g. "x".
  double number(std::string_view what);
  double number_in_line(std::string_view what);

  const SourceText& source() const { return source_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view take_word();
  double finite(std::string_view word, std::string_view what) const;

  SourceText source_;
  std::string_view rest_;
};

}  // namespace sandsim
