// Words and numbers of a text, with errors that point at them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/raster/source_text.hpp"

namespace sandsim {

/// What a backslash at the end of a line means: nothing, or that the line goes on in the next one.
enum class Backslash { none, joins_lines };

/// Hands out the words of a text one after the other, blanks and line ends between them. A byte order mark is passed.
class Tokens {
 public:
  Tokens(std::string_view text, const std::string& name, Backslash backslash = Backslash::none);

  /// The next word; empty at the end.
  std::string_view next();
  /// The next word of this line; empty at its end, which is not passed.
  std::string_view next_in_line();
  /// Passes the rest of the line and its end. False if there is no further line.
  bool skip_line();

  /// The next word (of this line) as a finite number; `what` it is stands in the error, e.g. "x".
  double number(std::string_view what);
  double number_in_line(std::string_view what);
  /// The same, but it may be infinite or not a number, also in the words of some compilers ("1.#IND").
  double any_number(std::string_view what);
  double any_number_in_line(std::string_view what);

  const SourceText& source() const { return source_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view take_word();
  bool joins_next_line(std::string_view word) const;
  double any(std::string_view word, std::string_view what) const;
  double finite(std::string_view word, std::string_view what) const;

  SourceText source_;
  std::string_view rest_;
  Backslash backslash_;
};

/// The text with a line feed for every carriage return that stands alone, if there is one: some programs write such
/// line ends. Positions stay.
std::optional<std::string> with_line_feeds(std::string_view text);

}  // namespace sandsim
