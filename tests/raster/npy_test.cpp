#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/raster/read_raster.hpp"
#include "io/raster/write_npy.hpp"
#include "tests/raster/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

/// A .npy file, with the length of the header as its version writes it.
std::string npy(const std::string& dictionary, const std::string& data, int version = 1) {
  std::string bytes = "\x93NUMPY";
  bytes += static_cast<char>(version);
  bytes += '\0';
  const std::string text = dictionary + "\n";
  for (int k = 0; k < (version == 1 ? 2 : 4); ++k) {
    bytes += static_cast<char>(text.size() >> (8 * k) & 0xff);
  }
  return bytes + text + data;
}

std::string dictionary(const std::string& descr, const std::string& shape, const std::string& fortran = "False") {
  return "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
}

/// The values in memory order of type T, byte-swapped on request.
template <typename T>
std::string bytes_of(const std::vector<double>& values, bool swap = false) {
  std::string bytes;
  for (const double value : values) {
    const T item = static_cast<T>(value);
    std::string part(sizeof(T), '\0');
    std::memcpy(part.data(), &item, sizeof(T));
    bytes += swap ? std::string(part.rbegin(), part.rend()) : part;
  }
  return bytes;
}

const std::vector<double> six{1, 2, 3, 4, 5, 6};

Raster read(const std::string& bytes) {
  return read_npy(bytes, "a.npy");
}
std::string error(const std::string& bytes) {
  return test::input_error([&] { read(bytes); });
}

template <typename T>
void check_type(const std::string& descr, const std::vector<double>& values) {
  CHECK(read(npy(dictionary("<" + descr, "(2, 3)"), bytes_of<T>(values))).values == values);
  CHECK(read(npy(dictionary(">" + descr, "(2, 3)"), bytes_of<T>(values, true))).values == values);
}

TEST_CASE("a npy array keeps its rows and has no position") {
  const Raster raster = read(npy(dictionary("<f8", "(2, 3)"), bytes_of<double>(six)));

  CHECK(raster.nx == 3);
  CHECK(raster.ny == 2);
  CHECK_FALSE(raster.has_georeference);
  CHECK(raster.at(0, 0) == 1.0);
  CHECK(raster.at(2, 1) == 6.0);
}

TEST_CASE("every type is read in both byte orders") {
  check_type<float>("f4", {1.5, -2, 3, 4, 5, 6});
  check_type<double>("f8", {0.1, -2, 3, 4, 5, 6});
  check_type<std::int8_t>("i1", {-128, 127, 3, 4, 5, 6});
  check_type<std::int16_t>("i2", {-32768, 32767, 3, 4, 5, 6});
  check_type<std::int32_t>("i4", {-2147483648.0, 2147483647, 3, 4, 5, 6});
  check_type<std::int64_t>("i8", {-9007199254740992.0, 2, 3, 4, 5, 6});
  check_type<std::uint8_t>("u1", {255, 2, 3, 4, 5, 6});
  check_type<std::uint16_t>("u2", {65535, 2, 3, 4, 5, 6});
  check_type<std::uint32_t>("u4", {4294967295.0, 2, 3, 4, 5, 6});
  check_type<std::uint64_t>("u8", {9007199254740992.0, 2, 3, 4, 5, 6});
  CHECK(read(npy(dictionary("|u1", "(2, 3)"), bytes_of<std::uint8_t>(six))).values == six);
}

TEST_CASE("Fortran order is turned into rows") {
  const Raster raster = read(npy(dictionary("<f8", "(2, 3)", "True"), bytes_of<double>({1, 4, 2, 5, 3, 6})));

  CHECK(raster.values == six);
}

TEST_CASE("one dimension is one row") {
  const Raster raster = read(npy(dictionary("<f8", "(6,)"), bytes_of<double>(six)));

  CHECK(raster.nx == 6);
  CHECK(raster.ny == 1);
}

TEST_CASE("format versions 2 and 3 and any order of the keys are read") {
  const std::string turned = "{\"shape\":(2,3),\"fortran_order\":False,\"descr\":\"<f8\"}   ";
  CHECK(read(npy(turned, bytes_of<double>(six), 2)).values == six);
  CHECK(read(npy(turned, bytes_of<double>(six), 3)).values == six);
}

TEST_CASE("nan in an array means no data and infinity is an error") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(read(npy(dictionary("<f8", "(2,)"), bytes_of<double>({nan, 1}))).values[0]));
  CHECK(error(npy(dictionary("<f8", "(2, 2)"), bytes_of<double>({nan, 1, 2, -infinity}))) ==
        "a.npy: the value -inf in row 1, column 1 (counted from 0) is not finite. Mark missing data by nan");
  CHECK(error(npy(dictionary("<f4", "(2,)"), bytes_of<float>({nan, nan}))) ==
        "a.npy: all 2 values are nan (nothing to read)");
}

TEST_CASE("integers without an exact double are errors") {
  const std::string bytes("\xff\xff\xff\xff\xff\xff\xff\x7f", 8);
  CHECK(error(npy(dictionary("<i8", "(1,)"), bytes)) ==
        "a.npy: the value 9.223372036854776e+18 in row 0, column 0 (counted from 0) is too large for an exact double "
        "(over 2^53)");
}

TEST_CASE("a file that is no npy file or ends early is an error") {
  const std::string whole = npy(dictionary("<f8", "(2, 3)"), bytes_of<double>(six));
  CHECK(error("") == "a.npy: the file is empty");
  CHECK(error("ncols 3") == "a.npy: not a .npy file (it does not start with \\x93NUMPY). Write it with numpy.save");
  CHECK(error(whole.substr(0, 6)) == "a.npy: the file ends in its header (truncated?)");
  CHECK(error(whole.substr(0, 9)) == "a.npy: the file ends in its header (truncated?)");
  CHECK(error(whole.substr(0, 40)) == "a.npy: the file ends in its header (truncated?)");
  CHECK(error(whole.substr(0, whole.size() - 1)) ==
        "a.npy: the header announces 6 values in 48 bytes, but 47 bytes follow it (truncated?)");
  CHECK(error(whole + "x") == "a.npy: the header announces 6 values in 48 bytes, but 49 bytes follow it (too many)");
  CHECK(error(npy(dictionary("<f8", "(2, 3)"), "", 9)) ==
        "a.npy: .npy format version 9 is not read (known are 1, 2 and 3)");
}

TEST_CASE("types other than real numbers are errors that name the known ones") {
  const std::string rest = " are not read (known are f4, f8, i1 to i8, u1 to u8). Convert them: array.astype('f8')";
  for (const std::string type : {"|b1", "<f2", "<f16", "<c16", "|O", "<U4", "|f8", "f8", ""}) {
    CHECK(error(npy(dictionary(type, "(1,)"), "")) == "a.npy: values of type \"" + type + "\"" + rest);
  }
  CHECK(error(npy("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (1,)}", "")) ==
        "a.npy: structured arrays are not read. Save one field: numpy.save(file, array['field'])");
}

TEST_CASE("shapes that are no raster are errors") {
  const std::string rule = " (a raster has two dimensions, y and x; or one, which is a row)";
  CHECK(error(npy(dictionary("<f8", "()"), "")) == "a.npy: the array has shape ()" + rule);
  CHECK(error(npy(dictionary("<f8", "(1, 2, 3)"), "")) == "a.npy: the array has shape (1, 2, 3)" + rule);
  CHECK(error(npy(dictionary("<f8", "(0, 3)"), "")) == "a.npy: the array has shape (0, 3) (it is empty)");
  CHECK(error(npy(dictionary("<f8", "(0,)"), "")) == "a.npy: the array has shape (0,) (it is empty)");
}

TEST_CASE("huge shapes are refused before memory is taken") {
  CHECK(error(npy(dictionary("<f8", "(4294967296, 4294967296)"), "")) ==
        "a.npy: the array has shape (4294967296, 4294967296), which is too large (at most 268435456 values are read)");
  CHECK(error(npy(dictionary("<f8", "(16384, 16384)"), "abc")) ==
        "a.npy: the header announces 268435456 values in 2147483648 bytes, but 3 bytes follow it (truncated?)");
  CHECK(error(npy(dictionary("<f8", "(99999999999999999999,)"), "")) ==
        "a.npy: the shape is not a tuple of sizes before \"99999999999999999999,), }\\x0a\"");
}

TEST_CASE("damaged headers are errors") {
  CHECK(error(npy("descr", "")) == "a.npy: the header is damaged (expected '{' before \"descr\\x0a\")");
  CHECK(error(npy("{descr", "")) == "a.npy: the header is damaged (expected a string before \"descr\\x0a\")");
  CHECK(error(npy("{'descr", "")) == "a.npy: the header is damaged (expected a string before \"'descr\\x0a\")");
  CHECK(error(npy("{'descr' 1}", "")) == "a.npy: the header is damaged (expected ':' before \"1}\\x0a\")");
  CHECK(error(npy("{'descr': '<f8'", "")) == "a.npy: the header is damaged (expected '}' before \"\")");
  CHECK(error(npy("{'descr': '<f8'}", "")) == "a.npy: the header lacks fortran_order");
  CHECK(error(npy("{'descr': '<f8', 'fortran_order': False}", "")) == "a.npy: the header lacks shape");
  CHECK(error(npy("{}", "")) == "a.npy: the header lacks descr");
  CHECK(error(npy("{'descr': '<f8', 'descr': '<f8'}", "")) == "a.npy: descr is twice in the header");
  CHECK(error(npy("{'order': '<f8'}", "")) ==
        "a.npy: \"order\" is no key of a .npy header (descr, fortran_order, shape)");
  CHECK(error(npy("{'fortran_order': 1}", "")) == "a.npy: fortran_order is neither True nor False before \"1}\\x0a\"");
  CHECK(error(npy("{'shape': (a)}", "")) == "a.npy: the shape is not a tuple of sizes before \"a)}\\x0a\"");
  CHECK(error(npy("{'shape': (2 3)}", "")) == "a.npy: the header is damaged (expected ')' before \"3)}\\x0a\")");
  CHECK(error(npy("{} 1", "")) == "a.npy: \"1\\x0a\" follows the header's dictionary");
}

TEST_CASE("what is written as .npy reads back to the same bits") {
  const std::vector<double> values{0.1, -2.5e-300, 3.0, 1.0 / 3.0, 5.0, 6.0};
  const Raster raster = read_npy(npy_bytes(values, 3, 2), "a.npy");
  CHECK(raster.nx == 3);
  CHECK(raster.ny == 2);
  CHECK(raster.values == values);
  // The data begin at a multiple of 64 bytes, whatever the shape.
  CHECK((npy_bytes(values, 3, 2).size() - 48) % 64 == 0);
  CHECK((npy_bytes(values, 6, 1).size() - 48) % 64 == 0);
}

}  // namespace
}  // namespace sandsim
