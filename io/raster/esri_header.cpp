#include "io/raster/esri_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "io/raster/esri_numbers.hpp"

namespace sandsim {
namespace {

using Key = EsriHeader::Key;

constexpr std::string_view blanks = " \t\r\n\v\f";
/// Other names: GeoClaw's of the first point, and short ones of NODATA_value.
constexpr std::array<std::pair<std::string_view, Key>, 4> aliases{
    {{"xlower", Key::xllcenter}, {"ylower", Key::yllcenter}, {"nodata", Key::nodata}, {"no_data", Key::nodata}}};

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return lower;
}

/// A word that may be a key: no value such as nan or inf.
bool is_word(std::string_view token) {
  const char c = token.empty() ? '0' : lower_case(token.substr(0, 1)).front();
  return ((c >= 'a' && c <= 'z') || c == '_') && !is_no_data_word(token) && !parse_number(token).value;
}

bool is_value(std::string_view token) {
  return is_no_data_word(token) ||
         (!token.empty() && std::string_view("0123456789+-.").find(token.front()) != std::string_view::npos);
}

/// key_count if it is none.
Key key_of(std::string_view word) {
  const std::string name = lower_case(word);
  const auto alias = std::find_if(aliases.begin(), aliases.end(), [&](const auto& each) { return each.first == name; });
  if (alias != aliases.end()) {
    return alias->second;
  }
  const auto& names = EsriHeader::key_names;
  return static_cast<Key>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// The part of a token before the colon or the equals sign of "key: value".
std::string_view before_sign(std::string_view token) {
  return token.substr(0, token.find_first_of(":="));
}

/// The value behind a key, whose token may hold the sign between them, and the value as well.
std::string_view take_value(std::string_view key, Tokens& tokens) {
  std::string_view rest = tokens.take().substr(key.size());
  if (rest.empty()) {
    rest = tokens.take();
    if (rest.empty() || (rest.front() != ':' && rest.front() != '=')) {
      return rest;
    }
  }
  rest.remove_prefix(1);
  return rest.empty() ? tokens.take() : rest;
}

void add(const SourceText& source, EsriHeader& header, std::string_view word, std::string_view value) {
  const Key k = key_of(word);
  if (k == Key::key_count) {
    const std::string_view nearest = nearest_name(lower_case(word), EsriHeader::key_names);
    source.fail(word,
                fmt::format("{} is no key of an ESRI ASCII header. {}", in_quotes(word),
                            nearest.empty() ? fmt::format("The keys are {}", fmt::join(EsriHeader::key_names, ", "))
                                            : fmt::format("Did you mean {}?", nearest)));
  }
  if (header.has(k)) {
    source.fail(word, fmt::format("{} is there twice. Remove one of the lines", EsriHeader::key_names[k]));
  }
  if (value.empty()) {
    source.fail_at_end(fmt::format("the file ends after the key {} (truncated?)", EsriHeader::key_names[k]));
  }
  header.key[k] = word;
  header.value[k] = value;
}

void check_exactly_one(const SourceText& source, const EsriHeader& header, Key one, Key other) {
  if (header.has(one) && header.has(other)) {
    source.fail(header.key[other].data() > header.key[one].data() ? header.key[other] : header.key[one],
                fmt::format("both {} and {} are given (they exclude each other). Remove one",
                            EsriHeader::key_names[one], EsriHeader::key_names[other]));
  }
}

/// Throws if keys are missing or exclude each other.
void check_keys(const SourceText& source, const EsriHeader& header, std::string_view first_value) {
  check_exactly_one(source, header, Key::xllcorner, Key::xllcenter);
  check_exactly_one(source, header, Key::yllcorner, Key::yllcenter);
  check_exactly_one(source, header, Key::cellsize, Key::dx);
  check_exactly_one(source, header, Key::cellsize, Key::dy);
  std::string missing;
  const auto require = [&](bool present, std::string_view text) {
    if (!present) {
      missing += missing.empty() ? text : fmt::format(", {}", text);
    }
  };
  require(header.has(Key::ncols), "ncols");
  require(header.has(Key::nrows), "nrows");
  require(header.has(Key::xllcorner) || header.has(Key::xllcenter), "xllcorner (or xllcenter)");
  require(header.has(Key::yllcorner) || header.has(Key::yllcenter), "yllcorner (or yllcenter)");
  if (header.has(Key::dx) || header.has(Key::dy)) {
    require(header.has(Key::dx), "dx");
    require(header.has(Key::dy), "dy");
  } else {
    require(header.has(Key::cellsize), "cellsize (or dx and dy)");
  }
  if (!missing.empty()) {
    const std::string message = fmt::format("the header lacks {}", missing);
    first_value.empty() ? source.fail_at_end(message) : source.fail(first_value, message);
  }
}

}  // namespace

std::string_view Tokens::peek() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  return rest_.substr(0, rest_.find_first_of(blanks));
}

std::string_view Tokens::take() {
  const std::string_view token = peek();
  rest_.remove_prefix(token.size());
  return token;
}

std::string_view without_marks(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  constexpr std::string_view at_end(" \t\r\n\v\f\x1a\0", 8);
  if (text.starts_with(byte_order_mark)) {
    text.remove_prefix(byte_order_mark.size());
  }
  return text.substr(0, text.find_last_not_of(at_end) + 1);
}

bool begins_like_esri_ascii(std::string_view text) {
  Tokens tokens(without_marks(text));
  std::string_view first = tokens.take();
  if (is_value(first)) {
    first = tokens.take();
  }
  return key_of(before_sign(first)) != Key::key_count;
}

EsriHeader read_esri_header(const SourceText& source, Tokens& tokens) {
  EsriHeader header;
  while (is_word(tokens.peek())) {
    const std::string_view word = before_sign(tokens.peek());
    if (key_of(word) == Key::key_count) {
      add(source, header, word, word);  // says what is wrong with it
    }
    add(source, header, word, take_value(word, tokens));
  }
  if (header.key == EsriHeader{}.key) {
    for (Tokens ahead = tokens; is_value(ahead.peek()); ahead = tokens) {
      const std::string_view value = ahead.take();
      if (!is_word(ahead.peek())) {
        break;
      }
      add(source, header, ahead.take(), value);
      tokens = ahead;
    }
  }
  check_keys(source, header, tokens.peek());
  return header;
}

}  // namespace sandsim
