#include <string>
#include <vector>

#include "io/raster/read_csv.hpp"
#include "tests/raster/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

std::string error(const std::string& text) {
  return test::input_error([&] { read_profile_csv(text, "a.csv"); });
}

TEST_CASE("a profile is read with comments and blanks and carriage returns") {
  const Profile profile = read_profile_csv(
      "\xef\xbb\xbf# by hand\r\n\r\n x_m , depth_m # names\r\n0, 0.5\r\n +1e-1 ,0.25 # x\r\n", "a.csv");

  CHECK(profile.file == "a.csv");
  CHECK(profile.x == std::vector<double>{0, 0.1});
  CHECK(profile.depth == std::vector<double>{0.5, 0.25});
}

TEST_CASE("columns are found by their names in any order") {
  const FrontCurve front = read_front_csv("front_m,time_s\n1,0\n2,3", "a.csv");

  CHECK(front.time == std::vector<double>{0, 3});
  CHECK(front.front == std::vector<double>{1, 2});
}

TEST_CASE("a path has three coordinates a time") {
  const PathTable path = read_path_csv("time_s,z_m,y_m,x_m\n0,3,2,1\n2,6,5,4\n", "a.csv");

  CHECK(path.time == std::vector<double>{0, 2});
  CHECK(path.position.at(0) == std::array<double, 3>{1, 2, 3});
  CHECK(path.position.at(1) == std::array<double, 3>{4, 5, 6});
  CHECK(test::input_error([] { read_path_csv("time_s,x_m,y_m\n0,1,2\n1,2,3\n", "a.csv"); }) ==
        "a.csv:1:1: the column z_m is missing. The first line is \"time_s,x_m,y_m,z_m\"");
}

TEST_CASE("column names that are missing or doubled or unknown are errors") {
  CHECK(error("x_m\n0\n") == "a.csv:1:1: the column depth_m is missing. The first line is \"x_m,depth_m\"");
  CHECK(error("x_m,x_m\n") == "a.csv:1:5: the column x_m is there twice. Remove one");
  CHECK(error("x_m,depth\n") == "a.csv:1:5: \"depth\" is no column name. Did you mean depth_m?");
  CHECK(error("x_m,depth_m,sigma\n") == "a.csv:1:13: \"sigma\" is no column name. The first line is \"x_m,depth_m\"");
  CHECK(error("x_m,depth_m,\n") == "a.csv:1:13: \"\" is no column name. The first line is \"x_m,depth_m\"");
  CHECK(error("# no names\n0,1\n1,2\n") == "a.csv:2:1: \"0\" is no column name. The first line is \"x_m,depth_m\"");
  CHECK(error("x_m;depth_m\n") == "a.csv:1:1: \"x_m;depth_m\" is no column name. Separate the columns by commas");
}

TEST_CASE("a row with another number of fields is an error") {
  const std::string rest =
      " fields where there are 2 columns. Separate fields by commas and write decimals with a point";
  CHECK(error("x_m,depth_m\n0,1\n0,5,1\n") == "a.csv:3:1: 3" + rest);
  CHECK(error("x_m,depth_m\n 0 1\n") == "a.csv:2:2: 1" + rest);
}

TEST_CASE("a field that is no finite number is an error at its place") {
  CHECK(error("x_m,depth_m\n0,one\n") == "a.csv:2:3: depth_m: \"one\" is not a number");
  CHECK(error("x_m,depth_m\n0, \n") == "a.csv:2:3: depth_m is empty. Remove the line or fill the field");
  CHECK(error("x_m,depth_m\nnan,1\n") == "a.csv:2:1: x_m = \"nan\" is not finite. Remove the line");
  CHECK(error("x_m,depth_m\n0,-inf\n") == "a.csv:2:3: depth_m = \"-inf\" is not finite. Remove the line");
}

TEST_CASE("the first column ascends strictly") {
  CHECK(error("x_m,depth_m\n0,1\n1,1\n0.5,1\n") ==
        "a.csv:4:1: x_m = 0.5 does not ascend (the line before has 1). Sort the lines");
  CHECK(error("x_m,depth_m\n0,1\n0,2\n") ==
        "a.csv:3:1: x_m = 0 does not ascend (the line before has 0). Sort the lines");
}

TEST_CASE("a curve has at least two points") {
  CHECK(error("") == "a.csv:1:1: the file is empty. The first line is \"x_m,depth_m\"");
  CHECK(error("# nothing\n") == "a.csv:1:10: the file is empty. The first line is \"x_m,depth_m\"");
  CHECK(error("x_m,depth_m\n") == "a.csv:1:12: 0 points (a curve has at least 2)");
  CHECK(error("x_m,depth_m\n0,1\n") == "a.csv:2:4: 1 points (a curve has at least 2)");
}

}  // namespace
}  // namespace sandsim
