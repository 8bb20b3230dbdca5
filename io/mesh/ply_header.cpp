#include "io/mesh/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace sandsim {

namespace {

template <class Value, std::size_t N>
using Words = std::array<std::pair<std::string_view, Value>, N>;

constexpr Words<PlyFormat, 3> formats{{{"ascii", PlyFormat::ascii},
                                       {"binary_little_endian", PlyFormat::little_endian},
                                       {"binary_big_endian", PlyFormat::big_endian}}};
constexpr Words<PlyType, 20> types{
    {{"char", PlyType::int8},      {"int8", PlyType::int8},      {"uchar", PlyType::uint8},
     {"uint8", PlyType::uint8},    {"short", PlyType::int16},    {"int16", PlyType::int16},
     {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},  {"int", PlyType::int32},
     {"int32", PlyType::int32},    {"uint", PlyType::uint32},    {"uint32", PlyType::uint32},
     {"long", PlyType::int64},     {"int64", PlyType::int64},    {"ulong", PlyType::uint64},
     {"uint64", PlyType::uint64},  {"float", PlyType::float32},  {"float32", PlyType::float32},
     {"double", PlyType::float64}, {"float64", PlyType::float64}}};

/// The next word of the line, which is one of `words`.
template <class Value, std::size_t N>
Value read_word(Tokens& tokens, const Words<Value, N>& words, const char* what) {
  const std::string_view word = tokens.next_in_line();
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == word; });
  if (found == words.end()) tokens.source().fail(word, fmt::format("{} is no {} of PLY", in_quotes(word), what));
  return found->second;
}

std::string read_name(Tokens& tokens) {
  const std::string_view name = tokens.next_in_line();
  if (name.empty()) tokens.source().fail(name, "a name is missing");
  return std::string(name);
}

PlyElement read_element(Tokens& tokens) {
  PlyElement element{read_name(tokens), 0, {}};
  const std::string_view count = tokens.next_in_line();
  const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error != std::errc{} || stop != count.data() + count.size()) {
    tokens.source().fail(count, fmt::format("{} is no number of {} elements", in_quotes(count), element.name));
  }
  return element;
}

PlyProperty read_property(Tokens& tokens) {
  PlyProperty property;
  Tokens ahead = tokens;
  property.is_list = ahead.next_in_line() == "list";
  if (property.is_list) {
    tokens = ahead;
    const std::string_view place = tokens.rest();
    property.count_type = read_word(tokens, types, "type");
    if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
      tokens.source().fail(place, "the length of a list is a whole number");
    }
  }
  property.type = read_word(tokens, types, "type");
  property.name = read_name(tokens);
  return property;
}

void require_complete(const PlyHeader& header, const Tokens& tokens, bool has_format) {
  const std::string_view here = tokens.rest();
  if (!has_format) tokens.source().fail(here, "the header has no format");
  for (const PlyElement& element : header.elements) {
    // Without properties an element takes no bytes, and any number of them could be announced.
    if (element.properties.empty()) tokens.source().fail(here, fmt::format("{} has no property", element.name));
  }
}

}  // namespace

PlyHeader read_ply_header(Tokens& tokens) {
  PlyHeader header;
  bool has_format = false;
  const SourceText& source = tokens.source();
  if (const std::string_view magic = tokens.next_in_line(); magic != "ply") {
    source.fail(magic, source.text().empty() ? "the file is empty" : "not a PLY file (it does not start with ply)");
  }
  while (tokens.skip_line()) {
    const std::string_view word = tokens.next_in_line();
    if (word == "end_header") {
      tokens.skip_line();
      require_complete(header, tokens, has_format);
      return header;
    }
    if (word == "format") {
      header.format = read_word(tokens, formats, "format");
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(tokens));
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(tokens));
    } else if (word != "comment" && word != "obj_info") {
      source.fail(word, fmt::format("{} in a header (format, element, property after an element, comment, obj_info "
                                    "and end_header are known)",
                                    in_quotes(word)));
    }
  }
  source.fail_at_end("the file ends in its header (truncated?)");
}

}  // namespace sandsim
