#include "io/raster/npy_header.hpp"

#include <fmt/format.h>

#include <charconv>

#include "io/raster/source_text.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

/// Reads the Python dictionary in the header, as far as NumPy writes it: strings, True, False, tuples of integers.
class DictionaryReader {
 public:
  DictionaryReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  NpyHeader read() {
    NpyHeader header;
    expect('{');
    while (!accept('}')) {
      read_entry(header);
      if (!accept(',')) {
        expect('}');
        break;
      }
    }
    skip_blanks();
    if (!rest_.empty()) {
      fail(fmt::format("{} follows the header's dictionary", in_quotes(rest_)));
    }
    if (!has_descr_ || !has_order_ || !has_shape_) {
      fail(fmt::format("the header lacks {}", !has_descr_ ? "descr" : !has_order_ ? "fortran_order" : "shape"));
    }
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError(fmt::format("{}: {}", name_, message)); }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }

  bool accept(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) {
      return false;
    }
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (!accept(c)) {
      fail(fmt::format("the header is damaged (expected '{}' before {})", c, in_quotes(rest_)));
    }
  }

  std::string_view read_string() {
    skip_blanks();
    const char quote = rest_.empty() ? '\0' : rest_.front();
    const std::size_t end = quote == '\'' || quote == '"' ? rest_.find(quote, 1) : std::string_view::npos;
    if (end == std::string_view::npos) {
      fail(fmt::format("the header is damaged (expected a string before {})", in_quotes(rest_)));
    }
    const std::string_view text = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    return text;
  }

  void read_entry(NpyHeader& header) {
    const std::string_view key = read_string();
    expect(':');
    bool* seen = key == "descr" ? &has_descr_ : key == "fortran_order" ? &has_order_ : &has_shape_;
    if (key == "descr") {
      read_descr(header);
    } else if (key == "fortran_order") {
      header.fortran_order = read_bool();
    } else if (key == "shape") {
      header.shape = read_shape();
    } else {
      fail(fmt::format("{} is no key of a .npy header (descr, fortran_order, shape)", in_quotes(key)));
    }
    if (*seen) {
      fail(fmt::format("{} is twice in the header", key));
    }
    *seen = true;
  }

  void read_descr(NpyHeader& header) {
    skip_blanks();
    if (rest_.starts_with('[')) {
      fail("structured arrays are not read. Save one field: numpy.save(file, array['field'])");
    }
    const std::string_view type = read_string();
    constexpr std::string_view known[]{"f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"};
    const char order = type.empty() ? '\0' : type.front();
    const std::string_view item = type.substr(type.empty() ? 0 : 1);
    const bool order_is_known = order == '<' || order == '>' || order == '|' || order == '=';
    for (const std::string_view candidate : known) {
      if (item == candidate && order_is_known && (order != '|' || item[1] == '1')) {
        header.kind = item[0];
        header.item_size = static_cast<std::size_t>(item[1] - '0');
        header.big_endian = order == '>';
        return;
      }
    }
    fail(
        fmt::format("values of type {} are not read (known are f4, f8, i1 to i8, u1 to u8). Convert them: "
                    "array.astype('f8')",
                    in_quotes(type)));
  }

  bool read_bool() {
    skip_blanks();
    for (const std::string_view word : {"True", "False"}) {
      if (rest_.starts_with(word)) {
        rest_.remove_prefix(word.size());
        return word == "True";
      }
    }
    fail(fmt::format("fortran_order is neither True nor False before {}", in_quotes(rest_)));
  }

  std::vector<std::uint64_t> read_shape() {
    std::vector<std::uint64_t> shape;
    expect('(');
    while (!accept(')')) {
      skip_blanks();
      std::uint64_t size = 0;
      const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), size);
      if (error != std::errc{}) {
        fail(fmt::format("the shape is not a tuple of sizes before {}", in_quotes(rest_)));
      }
      rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
      shape.push_back(size);
      if (!accept(',')) {
        expect(')');
        break;
      }
    }
    return shape;
  }

  std::string_view rest_;
  const std::string& name_;
  bool has_descr_ = false;
  bool has_order_ = false;
  bool has_shape_ = false;
};

std::size_t little_endian_integer(std::string_view bytes) {
  std::size_t value = 0;
  for (std::size_t k = bytes.size(); k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[k]);
  }
  return value;
}

}  // namespace

NpyHeader read_npy_header(std::string_view bytes, const std::string& name) {
  constexpr std::string_view magic = "\x93NUMPY";
  constexpr std::size_t version_bytes = 2;
  if (bytes.empty()) {
    throw InputError(fmt::format("{}: the file is empty", name));
  }
  if (!bytes.starts_with(magic)) {
    throw InputError(
        fmt::format("{}: not a .npy file (it does not start with \\x93NUMPY). Write it with numpy.save", name));
  }
  const std::size_t length_offset = magic.size() + version_bytes;
  const int version = bytes.size() > magic.size() ? static_cast<unsigned char>(bytes[magic.size()]) : 0;
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  if (bytes.size() >= length_offset && (version < 1 || version > 3)) {
    throw InputError(fmt::format("{}: .npy format version {} is not read (known are 1, 2 and 3)", name, version));
  }
  const std::size_t text_offset = length_offset + length_bytes;
  const std::size_t text_bytes =
      bytes.size() < text_offset ? 0 : little_endian_integer(bytes.substr(length_offset, length_bytes));
  if (bytes.size() < text_offset || bytes.size() - text_offset < text_bytes) {
    throw InputError(fmt::format("{}: the file ends in its header (truncated?)", name));
  }
  NpyHeader header = DictionaryReader(bytes.substr(text_offset, text_bytes), name).read();
  header.data_offset = text_offset + text_bytes;
  return header;
}

}  // namespace sandsim
