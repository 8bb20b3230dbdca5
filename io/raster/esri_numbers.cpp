#include "io/raster/esri_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace sandsim {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

std::string_view without_sign(std::string_view token) {
  return !token.empty() && (token.front() == '+' || token.front() == '-') ? token.substr(1) : token;
}

/// The digits around the only comma of a number; empty if it has none, several, or a point as well.
struct CommaNumber {
  std::string_view before, after;
  bool empty() const { return before.empty(); }
  /// 1,234 may be 1.234 or 1234; 0,234 and 1234,567 are decimal.
  bool may_group_thousands() const { return after.size() == 3 && before.size() <= 3 && before.front() != '0'; }
};

CommaNumber split_at_comma(std::string_view token) {
  const std::string_view digits = without_sign(token);
  const std::size_t comma = digits.find(',');
  if (comma == std::string_view::npos) {
    return {};
  }
  const std::string_view rest = digits.substr(comma + 1);
  const CommaNumber number{digits.substr(0, comma), rest.substr(0, rest.find_first_of("eEdD"))};
  return all_digits(number.before) && all_digits(number.after) ? number : CommaNumber{};
}

/// With a decimal point and the exponent that C++ knows.
std::string in_plain_spelling(std::string_view token) {
  std::string plain(token);
  if (!split_at_comma(token).empty()) {
    plain[plain.find(',')] = '.';
  }
  const std::size_t exponent = plain.find_first_of("dD");
  if (exponent != std::string::npos && exponent > 0 && (is_digit(plain[exponent - 1]) || plain[exponent - 1] == '.')) {
    plain[exponent] = 'e';
  }
  return plain;
}

}  // namespace

bool is_no_data_word(std::string_view token) {
  std::string word(without_sign(token));
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (word == "null" || word == "na" || (word.starts_with("nan(") && word.ends_with(')'))) {
    return true;
  }
  if (word.starts_with("1.#")) {
    word.erase(word.find_last_not_of('0') + 1);  // which pad it to the digits that were asked for
    return word == "1.#qnan" || word == "1.#snan" || word == "1.#ind";
  }
  constexpr std::array spellings{"nan", "nanq", "nans"};
  return std::find(spellings.begin(), spellings.end(), word) != spellings.end();
}

double EsriNumbers::read(std::string_view token, std::string_view what) {
  if (is_no_data_word(token)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  ParsedNumber number = parse_number(token);
  if (!number.value) {
    if (const ParsedNumber plain = parse_number(in_plain_spelling(token)); plain.value) {
      number = plain;
    }
  }
  if (!number.value) {
    source_.fail(token, fmt::format("{}{}{}", what, what.empty() ? "" : ": ", number.problem));
  }
  note(token);
  return *number.value;
}

void EsriNumbers::note(std::string_view token) {
  const auto keep = [token](std::string_view& first) { first = first.empty() ? token : first; };
  if (const CommaNumber comma = split_at_comma(token); !comma.empty()) {
    keep(comma.may_group_thousands() ? unclear_comma_ : decimal_comma_);
    keep(value_with_comma_);
  } else if (token.find('.') != std::string_view::npos) {
    keep(with_point_);
    keep(value_with_point_);
  }
}

void EsriNumbers::finish() const {
  if (!value_with_comma_.empty() && !value_with_point_.empty()) {
    const std::string_view later =
        value_with_comma_.data() > value_with_point_.data() ? value_with_comma_ : value_with_point_;
    source_.fail(later, fmt::format("the values {} and {} do not go together (a decimal comma and a decimal point). "
                                    "Write decimals with a point and separate values by blanks",
                                    in_quotes(value_with_comma_), in_quotes(value_with_point_)));
  }
  if (!unclear_comma_.empty() && (decimal_comma_.empty() || !with_point_.empty())) {
    source_.fail(unclear_comma_, fmt::format("{} may be a decimal number or one with grouped thousands. Write decimals "
                                             "with a point, and thousands without a comma",
                                             in_quotes(unclear_comma_)));
  }
}

}  // namespace sandsim
