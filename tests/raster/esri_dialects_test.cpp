// ESRI ASCII grids as different programs write them: 6 x 4 values of 2 m from (100, 200), each 10 + its row from the
// north + a tenth of its column.
#include <cmath>
#include <string>

#include "io/raster/esri_header.hpp"
#include "io/raster/read_raster.hpp"
#include "tests/raster/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

const std::string size = "ncols 6\nnrows 4\n";
const std::string place = "xllcorner 100\nyllcorner 200\ncellsize 2\n";
const std::string rest = "11 11.1 11.2 11.3 11.4 11.5\n12 12.1 12.2 12.3 12.4 12.5\n13 13.1 13.2 13.3 13.4 13.5\n";
const std::string body = "10 10.1 10.2 10.3 10.4 10.5\n" + rest;

Raster read(const std::string& text) {
  return read_esri_ascii(text, "a.asc");
}
std::string error(const std::string& text) {
  return test::input_error([&] { read(text); });
}
std::string replaced(std::string text, const std::string& piece, const std::string& by) {
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + by.size())) {
    text.replace(at, piece.size(), by);
  }
  return text;
}

/// Whether it is the grid above; the `holes` first values of the northern row have no data.
void check_grid(const Raster& raster, std::size_t holes = 0) {
  REQUIRE(raster.nx == 6);
  REQUIRE(raster.ny == 4);
  CHECK((raster.spacing_x == 2.0 && raster.spacing_y == 2.0));
  CHECK((raster.origin_x == 101.0 && raster.origin_y == 201.0));  // centre of the south-western cell
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 6; ++column) {
      CAPTURE(row, column);
      const double value = raster.at(column, 3 - row);
      if (row == 0 && column < holes) {
        CHECK(std::isnan(value));
      } else {
        const double expected = 10.0 + static_cast<double>(row) + static_cast<double>(column) / 10.0;
        CHECK_THAT(value, Catch::Matchers::WithinAbs(expected, 1e-12));  // rounding of decimals near 10
      }
    }
  }
}

TEST_CASE("NaN in any spelling is a cell without data whatever NODATA_value says") {
  for (const std::string word : {"nan", "NaN", "-nan", "+NaN", "NAN", "null", "NULL", "NA", "1.#QNAN", "-1.#IND",
                                 "1.#IND", "1.#QNAN0", "-1.#IND00", "nan(ind)", "-nan(ind)", "NaNQ"}) {
    CAPTURE(word);
    const std::string values = word + " 10.1 10.2 10.3 10.4 10.5\n" + rest;
    check_grid(read(size + place + values), 1);
    check_grid(read(size + place + "NODATA_value -9999\n" + values), 1);
    check_grid(read(size + place + "NODATA_value " + word + "\n" + values), 1);
    check_grid(read(size + place + "NODATA_value -9999\n" + replaced(values, "10.1", "-9999")), 2);
  }
}

TEST_CASE("words that only resemble NaN are errors with their place") {
  for (const std::string word : {"nano", "nil", "1.#INF", "1.#", "#N/A", "-", "nan("}) {
    CAPTURE(word);
    CHECK(error(size + place + replaced(body, "10.2", word)) == "a.asc:6:9: \"" + word + "\" is not a number");
  }
}

TEST_CASE("a decimal comma is read in the header and in the values") {
  check_grid(read(size + replaced(place, "100", "100,0") + body));
  check_grid(read(size + place + "NODATA_value -9999,0\n" + replaced(body, ".", ",")));
  check_grid(read(size + place + replaced(replaced(body, ".", ","), "13,5", "1,35e+01")));
  // Three decimals: other numbers of the file, or their digits, show that they are none of thousands.
  CHECK(read(size + place + replaced(replaced(body, ".", ","), "10,1", "10,125")).at(1, 3) == 10.125);
  CHECK(read("ncols 1 nrows 1 xllcorner 0 yllcorner 0 cellsize 1 0,125").at(0, 0) == 0.125);
  CHECK(read("ncols 1 nrows 1 xllcorner 0 yllcorner 0 cellsize 1 1234,125").at(0, 0) == 1234.125);
}

TEST_CASE("commas that may mean something else are refused with their place") {
  const std::string not_a_number =
      " is not a number (it holds a comma). Write decimals with a point and separate "
      "values by blanks";
  // A list separated by commas, with blanks and without; thousands and a point.
  CHECK(error(size + place + replaced(body, " ", ", ")) == "a.asc:6:1: \"10,\"" + not_a_number);
  CHECK(error(size + place + replaced(body, " ", ",")) == "a.asc:6:1: \"10,10.1,10.2,10.3,10.4,10.5\"" + not_a_number);
  CHECK(error(size + place + replaced(body, "10.2", "1,010.2")) == "a.asc:6:9: \"1,010.2\"" + not_a_number);
  CHECK(error(size + place + replaced(body, "10.2", "1,010,200")) == "a.asc:6:9: \"1,010,200\"" + not_a_number);
  CHECK(error("ncols 2\nnrows 2\n" + place + "10,11\n12,13\n") ==
        "a.asc:7:6: the file ends after 2 of 4 values (truncated?)");
  // Thousands, or three decimals?
  CHECK(error("ncols 2\nnrows 2\n" + place + "1,250 1,260\n1,270 1,280\n") ==
        "a.asc:6:1: \"1,250\" may be a decimal number or one with grouped thousands. Write decimals with a point, and "
        "thousands without a comma");
  CHECK(error(size + replaced(place, "100", "1,250") + body).starts_with("a.asc:3:11: \"1,250\" may be a decimal"));
  CHECK(error(size + place + replaced(body, "10.2", "10,2")) ==
        "a.asc:6:9: the values \"10,2\" and \"10.1\" do not go together (a decimal comma and a decimal point). Write "
        "decimals with a point and separate values by blanks");
}

TEST_CASE("a grid may end in the marks of old programs") {
  for (const std::string& end : {std::string("\x1a"), std::string("\x1a\x1a\r\n"), std::string(3, '\0'),
                                 std::string("\r\n\x1a") + std::string(100, '\0')}) {
    check_grid(read(size + place + body + end));
  }
  CHECK(error(size + place + replaced(body, "10.2", "\x1a")) == "a.asc:6:9: \"\\x1a\" is not a number");
  CHECK(error(size + place + replaced(body, "10.2", std::string(1, '\0'))) == "a.asc:6:9: \"\\x00\" is not a number");
  CHECK(error("\x1a") == "a.asc:1:1: the file is empty");
}

TEST_CASE("exponents may be those of Fortran") {
  const std::string fortran = replaced(replaced(body, "10.1", "1.010000D+01"), "13.5", "-.135d2");
  CHECK(read(size + place + fortran).at(1, 3) == 10.1);
  CHECK(read(size + place + fortran).at(5, 0) == -13.5);
  check_grid(read(size + "xllcorner 1.0D+02\nyllcorner 2D2\ncellsize 0.2D+01\nNODATA_value -9.999D+03\n" + body));
  CHECK(error(size + place + replaced(body, "10.1", "1D")) == "a.asc:6:4: \"1D\" is not a number");
  CHECK(error(size + place + replaced(body, "10.1", "D+01")) == "a.asc:6:4: \"D+01\" is not a number");
}

TEST_CASE("keys may be followed by a colon or an equals sign") {
  for (const std::string sign : {": ", ":", " : ", " :", "=", " = ", "= "}) {
    CAPTURE(sign);
    check_grid(read(replaced(size + place, " ", sign) + "NODATA_value -9999\n" + body));
  }
  CHECK(error("ncols:\n") == "a.asc:1:7: the file ends after the key ncols (truncated?)");
  CHECK(error("ncols: 6\nrows: 4\n") == "a.asc:2:1: \"rows\" is no key of an ESRI ASCII header. Did you mean nrows?");
  CHECK(error("ncols:: 6\nnrows 4\n" + place + body).starts_with("a.asc:1:9: the header lacks nrows"));
}

TEST_CASE("all keys may come behind their values") {
  const std::string before = "6 ncols\n4 nrows\n100 xllcorner\n200 yllcorner\n2 cellsize\n";
  check_grid(read(before + body));
  check_grid(read(before + "-9999 nodata_value\n" + replaced(body, "10 ", "-9999 ")), 1);
  check_grid(read(before + "nan NODATA_value\n" + replaced(body, "10 ", "nan ")), 1);
  const std::string points = replaced(replaced(before, "100 xllcorner", "101 xlower"), "200 yllcorner", "201 ylower");
  check_grid(read(points + body));  // of the first point, as GeoClaw has it
  CHECK(error("6 ncols\n4 rows\n") == "a.asc:2:3: \"rows\" is no key of an ESRI ASCII header. Did you mean nrows?");
  CHECK(error("6 ncols\n6 ncols\n") == "a.asc:2:3: ncols is there twice. Remove one of the lines");
  CHECK(error("6 ncols\n4 nrows\n2 cellsize\n" + body) ==
        "a.asc:4:1: the header lacks xllcorner (or xllcenter), yllcorner (or yllcenter)");
}

TEST_CASE("NODATA_value has short names, and sizes may have decimals") {
  check_grid(read(size + place + "nodata 10\n" + body), 1);
  check_grid(read(size + place + "NO_DATA 10\n" + body), 1);
  check_grid(read("ncols 6.0\nnrows 4.000000\n" + place + body));
}

TEST_CASE("text in UTF-16 is refused by name") {
  CHECK(error(std::string("\xff\xfen\0c\0", 6)) == "a.asc:1:1: the file is text in UTF-16. Save it as UTF-8 or ASCII");
}

TEST_CASE("an ESRI ASCII grid is known by its first words") {
  for (const char* text : {"ncols 6", "NCOLS: 6", "cellsize=2", "6 ncols", "\xef\xbb\xbf\r\n xllcorner 1",
                           "nodata_value -9999", "-9999 NODATA_value"}) {
    CAPTURE(text);
    CHECK(begins_like_esri_ascii(text));
  }
  for (const char* text : {"", "DSAA 6 4", "1 2 3", "north: 200", "nan 1", "6 columns", "II*", "CDF\x01"}) {
    CAPTURE(text);
    CHECK_FALSE(begins_like_esri_ascii(text));
  }
}

}  // namespace
}  // namespace sandsim
