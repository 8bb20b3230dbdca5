#include <cmath>
#include <string>

#include "io/raster/read_raster.hpp"
#include "tests/raster/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

const std::string header = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n";
const std::string values = "1 2 3\n4 5 6\n";

Raster read(const std::string& text) {
  return read_esri_ascii(text, "a.asc");
}
std::string error(const std::string& text) {
  return test::input_error([&] { read(text); });
}
/// The header with one piece replaced.
std::string header_with(const std::string& piece, const std::string& replacement) {
  std::string text = header;
  return text.replace(text.find(piece), piece.size(), replacement);
}

TEST_CASE("an ESRI ASCII grid is flipped so that row 0 is the southern one") {
  const Raster raster = read(header + values);

  CHECK(raster.nx == 3);
  CHECK(raster.ny == 2);
  CHECK(raster.has_georeference);
  CHECK(raster.values == std::vector<double>{4, 5, 6, 1, 2, 3});
}

TEST_CASE("corner and centre forms that mean the same place give the same raster") {
  const Raster corner = read(header + values);
  const Raster center = read("ncols 3\nnrows 2\nxllcenter 11\nyllcenter 21\ncellsize 2\n" + values);
  const Raster mixed = read("ncols 3\nnrows 2\nxllcorner 10\nyllcenter 21\ncellsize 2\n" + values);

  CHECK(corner.origin_x == 11.0);
  CHECK(corner.origin_y == 21.0);
  CHECK(center.origin_x == corner.origin_x);
  CHECK(center.origin_y == corner.origin_y);
  CHECK(mixed.origin_x == corner.origin_x);
  CHECK(mixed.origin_y == corner.origin_y);
}

TEST_CASE("dx and dy give cells that are not square") {
  const Raster raster = read("ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ndx 2\ndy 4\n" + values);

  CHECK(raster.spacing_x == 2.0);
  CHECK(raster.spacing_y == 4.0);
  CHECK(raster.origin_x == 11.0);
  CHECK(raster.origin_y == 22.0);
}

TEST_CASE("keys may come in any order and case and lines may end in carriage returns") {
  const Raster raster = read(
      "\xef\xbb\xbf"
      "CELLSIZE 2\r\nNODATA_value -9999\r\nYLLCORNER 20\r\nNROWS 2\r\nXllCorner 10\r\nNcols 3\r\n"
      "1 2 3\r\n4 5 -9999\r\n");

  CHECK(raster.origin_y == 21.0);
  CHECK(raster.at(0, 1) == 1.0);
  CHECK(std::isnan(raster.at(2, 0)));
}

TEST_CASE("values may wrap at any column and have signs and exponents") {
  const Raster raster = read(header + "+1 -2.5\n3e1 4\n\n5 .5");

  CHECK(raster.values == std::vector<double>{4, 5, 0.5, 1, -2.5, 30});
}

TEST_CASE("a grid without NODATA_value keeps -9999") {
  CHECK(read(header + "1 2 3 4 5 -9999").at(2, 0) == -9999.0);
}

TEST_CASE("NODATA_value nan makes nan a value without data") {
  const Raster raster = read(header + "NODATA_value nan\nNaN 2 3\n4 5 nan\n");

  CHECK(std::isnan(raster.at(0, 1)));
  CHECK(std::isnan(raster.at(2, 0)));
  CHECK(raster.at(1, 0) == 5.0);
}

TEST_CASE("NODATA is recognised when header and values are rounded differently") {
  const Raster raster = read(header + "NODATA_value -3.40282346638529e+38\n-3.4028235e38 2 3\n4 5 -3.402823e+38\n");

  CHECK(std::isnan(raster.at(0, 1)));
  CHECK(std::isnan(raster.at(2, 0)));
}

TEST_CASE("one cell is a grid") {
  CHECK(read("ncols 1 nrows 1 xllcorner 0 yllcorner 0 cellsize 1 7").values == std::vector<double>{7});
}

TEST_CASE("a truncated grid says how many values there are and where the file ends") {
  CHECK(error(header + "1 2 3\n4 5\n") == "a.asc:7:4: the file ends after 5 of 6 values (truncated?)");
  CHECK(error(header) == "a.asc:5:11: the file ends after 0 of 6 values (truncated?)");
  CHECK(error("ncols 3\nnrows") == "a.asc:2:6: the file ends after the key nrows (truncated?)");
}

TEST_CASE("too many values are an error at the first one that is too many") {
  CHECK(error(header + values + "7 8\n") ==
        "a.asc:8:1: \"7\" is behind the last of the 6 values that ncols and nrows announce. Correct the header or the "
        "values");
}

TEST_CASE("a token that is no number is an error with its line and column") {
  CHECK(error(header + "1 2 3\n4 five 6\n") == "a.asc:7:3: \"five\" is not a number");
  CHECK(error(header + "1 2 3\n4 5x 6\n") == "a.asc:7:3: \"5x\" is not a number");
  CHECK(error(header + "1 2 3\n4 +-5 6\n") == "a.asc:7:3: \"+-5\" is not a number");
  CHECK(error(header + "1 2 3\n4 + 6\n") == "a.asc:7:3: \"+\" is not a number");
  CHECK(error(header + "1 2 3\n4 1e999 6\n") ==
        "a.asc:7:3: \"1e999\" is out of range (a double holds 1e-308 to 1e308)");
}

TEST_CASE("a token that is not printable is shown in hexadecimal and shortened") {
  CHECK(error(header + "1 2 3\n4 \x01\xff 6\n") == "a.asc:7:3: \"\\x01\\xff\" is not a number");
  CHECK(error(header + "1 " + std::string(100, 'z')) ==
        "a.asc:6:3: \"" + std::string(40, 'z') + "...\" is not a number");
}

TEST_CASE("infinite values are errors") {
  const std::string suggestion = " is not finite. Mark cells without data by NODATA_value in the header";
  CHECK(error(header + "1 2 3\n4 5 -inf\n") == "a.asc:7:5: \"-inf\"" + suggestion);
  CHECK(error(header + "NODATA_value -9999\n1 2 3\n4 inf 6\n") == "a.asc:8:3: \"inf\"" + suggestion);
}

TEST_CASE("missing header keys are listed") {
  CHECK(error("1 2 3") ==
        "a.asc:1:1: the header lacks ncols, nrows, xllcorner (or xllcenter), yllcorner (or yllcenter), cellsize (or dx "
        "and dy)");
  CHECK(error(header_with("nrows 2\n", "") + values) == "a.asc:5:1: the header lacks nrows");
  CHECK(error(header_with("cellsize", "dx") + values) == "a.asc:6:1: the header lacks dy");
  CHECK(error("ncols 3") ==
        "a.asc:1:8: the header lacks nrows, xllcorner (or xllcenter), yllcorner (or yllcenter), cellsize (or dx and "
        "dy)");
}

TEST_CASE("keys that are there twice or exclude each other are errors") {
  CHECK(error(header + "ncols 3\n" + values) == "a.asc:6:1: ncols is there twice. Remove one of the lines");
  CHECK(error(header + "xllcenter 3\n" + values) ==
        "a.asc:6:1: both xllcorner and xllcenter are given (they exclude each other). Remove one");
  CHECK(error("yllcenter 3\n" + header + values) ==
        "a.asc:5:1: both yllcorner and yllcenter are given (they exclude each other). Remove one");
  CHECK(error(header + "dx 3\n" + values) ==
        "a.asc:6:1: both cellsize and dx are given (they exclude each other). Remove one");
  CHECK(error(header + "dy 3\n" + values) ==
        "a.asc:6:1: both cellsize and dy are given (they exclude each other). Remove one");
}

TEST_CASE("an unknown key is an error that names the nearest one") {
  CHECK(error("nclos 3\n") == "a.asc:1:1: \"nclos\" is no key of an ESRI ASCII header. Did you mean ncols?");
  CHECK(error("projection 3\n") ==
        "a.asc:1:1: \"projection\" is no key of an ESRI ASCII header. The keys are ncols, nrows, xllcorner, xllcenter, "
        "yllcorner, yllcenter, cellsize, dx, dy, nodata_value");
}

TEST_CASE("sizes must be positive integers") {
  CHECK(error(header_with("ncols 3", "ncols 0") + values) == "a.asc:1:7: ncols = \"0\" is not a positive integer");
  CHECK(error(header_with("ncols 3", "ncols -3") + values) == "a.asc:1:7: ncols = \"-3\" is not a positive integer");
  CHECK(error(header_with("nrows 2", "nrows 2.5") + values) == "a.asc:2:7: nrows = \"2.5\" is not a positive integer");
}

TEST_CASE("huge sizes are refused before memory is taken") {
  CHECK(error(header_with("ncols 3", "ncols 99999999999999999999") + values) ==
        "a.asc:1:7: ncols = \"99999999999999999999\" is too large (at most 268435456 values are read)");
  CHECK(error(header_with("nrows 2", "nrows 300000000") + values) ==
        "a.asc:2:7: nrows = \"300000000\" is too large (at most 268435456 values are read)");
  CHECK(error("ncols 200000\nnrows 200000\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + values) ==
        "a.asc:1:7: ncols * nrows = 200000 * 200000 is too large (at most 268435456 values are read)");
}

TEST_CASE("a size that is allowed but not in the file takes no memory for what is missing") {
  CHECK(error("ncols 16384\nnrows 16384\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + values) ==
        "a.asc:7:6: the file ends after 6 of 268435456 values (truncated?)");
}

TEST_CASE("positions and spacings must be finite numbers and spacings positive") {
  CHECK(error(header_with("cellsize 2", "cellsize 0") + values) == "a.asc:5:10: cellsize = \"0\" is not positive");
  CHECK(error(header_with("cellsize 2", "cellsize -2") + values) == "a.asc:5:10: cellsize = \"-2\" is not positive");
  CHECK(error(header_with("cellsize 2", "cellsize inf") + values) == "a.asc:5:10: cellsize = \"inf\" is not finite");
  CHECK(error(header_with("xllcorner 10", "xllcorner nan") + values) ==
        "a.asc:3:11: xllcorner = \"nan\" is not finite");
  CHECK(error(header_with("yllcorner 20", "yllcorner north") + values) ==
        "a.asc:4:11: yllcorner: \"north\" is not a number");
}

TEST_CASE("NODATA_value must be a number or nan") {
  CHECK(error(header + "NODATA_value none\n" + values) == "a.asc:6:14: nodata_value: \"none\" is not a number");
  CHECK(error(header + "NODATA_value inf\n" + values) ==
        "a.asc:6:14: nodata_value = \"inf\" is neither a number nor nan");
}

TEST_CASE("a grid of NODATA alone is an error") {
  CHECK(error(header + "NODATA_value -1\n-1 -1 -1\n-1 -1 -1\n") ==
        "a.asc:1:1: all 6 values are NODATA (nothing to read)");
}

TEST_CASE("an empty grid file is an error") {
  CHECK(error("") == "a.asc:1:1: the file is empty");
  CHECK(error(" \r\n") == "a.asc:1:1: the file is empty");
}

}  // namespace
}  // namespace sandsim
