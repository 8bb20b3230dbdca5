#include <algorithm>
#include <limits>

#include "io/mesh/read_mesh.hpp"
#include "tests/mesh/mesh_files.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using sandsim::objects::TriangleMesh;
using sandsim::test::bytes_of;

namespace {

const std::string facet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0.5\n endloop\nendfacet\n";

TriangleMesh read(const std::string& bytes) {
  return read_stl(bytes, "a.stl");
}
std::string error(const std::string& bytes) {
  return test::input_error([&] { read(bytes); });
}

std::string binary(double announced, const std::vector<double>& coordinates, const std::string& start = "") {
  std::string bytes = start + std::string(80 - start.size(), ' ') + bytes_of<std::uint32_t>({announced});
  for (std::size_t k = 0; k < coordinates.size(); k += 9) {
    const std::vector<double> corners(coordinates.begin() + static_cast<std::ptrdiff_t>(k),
                                      coordinates.begin() + static_cast<std::ptrdiff_t>(k + 9));
    bytes += bytes_of<float>({0, 0, 1}) + bytes_of<float>(corners) + std::string(2, '\0');
  }
  return bytes;
}

const std::vector<double> one{0, 0, 0, 1, 0, 0, 0, 1, 0.5};

}  // namespace

TEST_CASE("an ASCII STL file gives its triangles in any case and with any name") {
  const TriangleMesh mesh = read("  SOLID vertex 1 facet\n" + facet + "Facet" + facet.substr(5) + "endsolid x\n");
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.vertices.at(2).z == 0.5);
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{3, 4, 5});
  CHECK(read("solid\n" + facet + "endsolid\nsolid b\n" + facet + "endsolid b").triangles.size() == 2);
}

TEST_CASE("a binary STL file gives its triangles even if it starts with solid") {
  CHECK(read(binary(1, one)).vertices.at(2).z == 0.5);
  CHECK(read(binary(1, one, "solid x")).vertices.at(1).x == 1.0);
}

TEST_CASE("a binary STL file of the wrong length is an error") {
  CHECK(error(binary(2, one)) ==
        "a.stl: byte 80: 2 triangles are announced, which makes 184 bytes, but the file has 134 (truncated?)");
  CHECK(error(binary(1e9, one)) ==
        "a.stl: byte 80: 1000000000 triangles are announced, which makes 50000000084 bytes, but the file has 134 "
        "(truncated?)");
  CHECK(error(binary(0, one) + "x") ==
        "a.stl: byte 80: 0 triangles are announced, which makes 84 bytes, but the file has 135 (too many)");
  CHECK(error("abc") ==
        "a.stl: neither an ASCII STL file (it does not start with solid) nor a binary one (3 bytes; its header alone "
        "has 84)");
  CHECK(error("") == "a.stl: the file is empty");
  CHECK(error(binary(0, {})) == "a.stl: the file holds no triangle");
}

TEST_CASE("binary STL files that announce none or fewer of their triangles are read and that is said") {
  Warnings warnings;
  CHECK(read_stl(binary(0, one), "a.stl", &warnings).triangles.size() == 1);
  CHECK(read_stl(binary(1, one) + "material", "a.stl", &warnings).triangles.size() == 1);
  CHECK(warnings == Warnings{"a.stl: byte 80: no triangle is announced, but 1 follow: they are read",
                             "a.stl: byte 134: 8 bytes behind the 1 triangles that are announced are not read"});
}

TEST_CASE("ASCII STL files with odd ends are read and that is said") {
  const std::string start = "solid x\n" + facet;
  Warnings warnings;
  for (const std::string end : {"end solid x\n", "endsolid\nend"}) {
    CHECK(read_stl(start + end, "a.stl", &warnings).triangles.size() == 1);
  }
  CHECK(read_stl(start, "a.stl", &warnings).triangles.size() == 1);
  CHECK(read_stl(start + "endsolid x\n\x1A", "a.stl", &warnings).triangles.size() == 1);
  CHECK(warnings == Warnings{"a.stl:10:1: \"end\" behind the last solid: the rest of the file is not read",
                             "a.stl: the file ends without endsolid (truncated?)",
                             "a.stl:10:1: \"\\x1a\" behind the last solid: the rest of the file is not read"});
}

TEST_CASE("normals of STL are not judged, and marks and line ends of other systems are passed") {
  std::string text = "\xEF\xBB\xBFsolid x\n" + facet + "endsolid x\n";
  text.replace(text.find("0 0 1"), 5, "nan -1.#IND x");
  CHECK(read(text).triangles.size() == 1);
  std::replace(text.begin(), text.end(), '\n', '\r');
  CHECK(read(text).triangles.size() == 1);
}

TEST_CASE("coordinates of STL that are not finite are errors") {
  std::vector<double> broken = one;
  broken[4] = std::numeric_limits<double>::quiet_NaN();
  CHECK(error(binary(1, broken)) == "a.stl: byte 112: a coordinate of triangle 0 (counted from 0) is not finite");
  CHECK(error("solid\nfacet normal 0 0 1 outer loop vertex 0 inf 0") == "a.stl:2:40: y = \"inf\" is not finite");
}

TEST_CASE("ASCII STL files that are damaged are errors") {
  const std::string whole = "solid\n" + facet + "endsolid\n";
  CHECK(error("solid\n") == "a.stl:1:6: the file ends where facet should be (truncated?)");
  CHECK(error(whole.substr(0, 50)) == "a.stl:4:13: the file ends where z should be (truncated?)");
  CHECK(error("solid\nfacet\n") == "a.stl:2:6: the file ends where normal should be (truncated?)");
  CHECK(error("solid\nfacet normal 0 0 1 loop\n") == "a.stl:2:20: \"loop\" where outer should be");
  CHECK(error("solid\nface\n") == "a.stl:2:1: \"face\" where facet or endsolid should be");
  CHECK(error("solid\nendsolid\n") == "a.stl: the file holds no triangle");
}
