#include <limits>

#include "io/mesh/read_mesh.hpp"
#include "tests/mesh/mesh_files.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using sandsim::objects::TriangleMesh;
using sandsim::test::bytes_of;

namespace {

TriangleMesh read(const std::string& bytes) {
  return read_ply(bytes, "a.ply");
}
std::string error(const std::string& bytes) {
  return test::input_error([&] { read(bytes); });
}

std::string header(const std::string& format, const std::string& vertices = "3", const std::string& faces = "1",
                   const std::string& index = "int") {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty double z\nelement face " + faces + "\nproperty list uchar " +
         index + " vertex_indices\nend_header\n";
}

const std::string ascii_body = "0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n";

std::string binary_body(bool big_endian) {
  std::string bytes;
  for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0}, std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.1}}) {
    bytes += bytes_of<float>({x, y}, big_endian) + bytes_of<double>({z}, big_endian);
  }
  return bytes + '\3' + bytes_of<std::int32_t>({0, 1, 2}, big_endian);
}

}  // namespace

TEST_CASE("an ASCII PLY file gives its vertices and faces") {
  const TriangleMesh mesh = read(header("ascii") + ascii_body);
  REQUIRE(mesh.vertices.size() == 3);
  CHECK(mesh.vertices[2].z == 0.5);
  CHECK(mesh.triangles.at(0) == std::array<std::uint32_t, 3>{0, 1, 2});
}

TEST_CASE("binary PLY files of both byte orders give the same") {
  for (const bool big_endian : {false, true}) {
    const std::string format = big_endian ? "binary_big_endian" : "binary_little_endian";
    const TriangleMesh mesh = read(header(format) + binary_body(big_endian));
    REQUIRE(mesh.vertices.size() == 3);
    CHECK(mesh.vertices[1].x == 1.0);
    CHECK(mesh.vertices[2].z == 0.1);
    CHECK(mesh.triangles.at(0) == std::array<std::uint32_t, 3>{0, 1, 2});
  }
}

TEST_CASE("other elements and properties of PLY are passed over") {
  const TriangleMesh mesh = read(
      "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty float f\r\nelement vertex 3\r\nproperty uchar red\r\n"
      "property float x\r\nproperty float y\r\nproperty float z\r\nelement face 2\r\nproperty list uchar float uv\r\n"
      "property list int uint vertex_index\r\nobj_info x\r\nend_header\r\n"
      "7\r\n255 0 0 0\r\n0 1 0 0\r\n0 0 1 0\r\n2 0.5 0.5 3 0 1 2\r\n0 4 0 1 2 0\r\n");
  CHECK(mesh.triangles.size() == 3);
}

TEST_CASE("indices of PLY that are out of range are errors") {
  CHECK(error(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n") ==
        "a.ply:14:7: there is no vertex 3 (3 vertices, counted from 0)");
  CHECK(error(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n") ==
        "a.ply:14:5: there is no vertex -1 (3 vertices, counted from 0)");
  CHECK(error(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n") ==
        "a.ply:14:7: there is no vertex 1.5 (3 vertices, counted from 0)");
  std::string bytes = header("binary_little_endian") + binary_body(false);
  bytes[bytes.size() - 4] = 9;
  CHECK(error(bytes) ==
        "a.ply: byte " + std::to_string(bytes.size() - 4) + ": there is no vertex 9 (3 vertices, counted from 0)");
}

TEST_CASE("more faces or vertices announced than there are is an error") {
  CHECK(error(header("ascii", "3", "1000000000") + ascii_body) ==
        "a.ply:14:8: the file ends where vertex_indices should be (truncated?)");
  const std::string bytes = header("binary_little_endian", "3", "1000000000") + binary_body(false);
  CHECK(error(bytes) ==
        "a.ply: byte " + std::to_string(bytes.size()) + ": the file ends where vertex_indices should be (truncated?)");
  CHECK(error(header("ascii", "4000000000")) == "a.ply: too many vertices (at most 2^31)");
  CHECK(error(header("ascii", "99999999999999999999")).find("is no number of vertex elements") != std::string::npos);
  CHECK(error(header("ascii", "-3")) == "a.ply:4:16: \"-3\" is no number of vertex elements");
}

TEST_CASE("numbers of PLY that are not finite are errors") {
  CHECK(error(header("ascii") + "0 nan 0\n1 0 0\n0 1 0\n3 0 1 2\n") == "a.ply:11:3: a vertex of a face is not finite");
  std::string bytes = header("binary_big_endian");
  const std::size_t place = bytes.size();
  bytes += bytes_of<float>({std::numeric_limits<double>::infinity()}, true) + binary_body(true).substr(4);
  CHECK(error(bytes) == "a.ply: byte " + std::to_string(place) + ": a vertex of a face is not finite");
}

TEST_CASE("what no face of PLY uses is not judged") {
  const TriangleMesh mesh = read(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "quality\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar float uv\nend_header\n"
      "0 0 0 nan\n1 0 0 -1.#IND\n0 1 0 nan\nnan nan nan nan\n3 0 1 2 2 nan inf\n");
  CHECK(mesh.triangles.size() == 1);
  CHECK(mesh.vertices.at(3) == objects::Vec3{});
}

TEST_CASE("lists of PLY may have 64 bits") {
  for (const std::string type : {"int64", "uint64"}) {
    CHECK(read(header("ascii", "3", "1", type) + ascii_body).triangles.size() == 1);
    const std::string body = binary_body(false);
    const std::string bytes = header("binary_little_endian", "3", "1", type) + body.substr(0, body.size() - 12) +
                              bytes_of<std::int64_t>({0, 1, 2});
    CHECK(read(bytes).triangles.at(0) == std::array<std::uint32_t, 3>{0, 1, 2});
  }
}

TEST_CASE("strips of PLY become triangles that all look the same way") {
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const TriangleMesh mesh = read(start + "8 0 1 2 3 -1 1 3 2\n");
  REQUIRE(mesh.triangles.size() == 3);
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{2, 1, 3});
  CHECK(mesh.triangles[2] == std::array<std::uint32_t, 3>{1, 3, 2});
  CHECK(error(start + "3 0 1 -2\n") == "a.ply:14:7: there is no vertex -2 (4 vertices, counted from 0)");
}

TEST_CASE("faces of PLY may come before their vertices") {
  const std::string text =
      "ply\rformat ascii 1.0\relement face 1\rproperty list uchar int vertex_indices\relement vertex 3\r"
      "property float x\rproperty float y\rproperty float z\rend_header\r3 0 1 2\r0 0 0\r1 0 0\r0 1 0\r";
  CHECK(read(text).triangles.size() == 1);
}

TEST_CASE("what follows the elements of PLY is said not to be read") {
  Warnings warnings;
  read_ply(header("ascii") + ascii_body + "7\n", "a.ply", &warnings);
  read_ply(header("binary_big_endian") + binary_body(true) + "\n", "a.ply", &warnings);
  CHECK(warnings == Warnings{"a.ply:15:1: what follows the elements of the header is not read"});
}

TEST_CASE("faces of PLY need three corners and lists a length") {
  Warnings warnings;
  CHECK(read_ply(header("ascii", "3", "2") + ascii_body + "2 0 1\n", "a.ply", &warnings).triangles.size() == 1);
  CHECK(warnings == Warnings{"a.ply:15:1: a face with fewer than three corners is left out"});
  CHECK(error(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n") == "a.ply:14:1: vertex_indices has a length of -3");
}

TEST_CASE("headers of PLY that are damaged are errors") {
  CHECK(error("") == "a.ply:1:1: the file is empty");
  CHECK(error("plz\n") == "a.ply:1:1: not a PLY file (it does not start with ply)");
  CHECK(error("ply\nformat ascii 1.0\n") == "a.ply:2:17: the file ends in its header (truncated?)");
  CHECK(error("ply\nformat utf8 1.0\n") == "a.ply:2:8: \"utf8\" is no format of PLY");
  CHECK(error("ply\nelement vertex 3\nproperty half x\n") == "a.ply:3:10: \"half\" is no type of PLY");
  CHECK(error("ply\nelement vertex 3\nproperty float\nend_header\n") == "a.ply:3:15: a name is missing");
  CHECK(error("ply\nelement face 3\nproperty list float int vertex_indices\n") ==
        "a.ply:3:14: the length of a list is a whole number");
  CHECK(error("ply\nproperty float x\n") ==
        "a.ply:2:1: \"property\" in a header (format, element, property after an element, comment, obj_info and "
        "end_header are known)");
  CHECK(error("ply\nend_header\n") == "a.ply:3:1: the header has no format");
  CHECK(error("ply\nformat ascii 1.0\nelement vertex 1000000000\nend_header\n") == "a.ply:5:1: vertex has no property");
}

TEST_CASE("PLY files without a surface are errors") {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 0\nproperty list uchar int vertex_indices\n";
  CHECK(error(start + "end_header\n") == "a.ply: the file has no vertex");
  CHECK(error(start + vertex + "end_header\n0 0 0\n") == "a.ply: the file has no face");
  CHECK(error(start + vertex + vertex + "end_header\n") == "a.ply: vertex is there twice");
  CHECK(error(start + "element vertex 1\nproperty float x\nproperty float y\nend_header\n") ==
        "a.ply: vertex has no property z");
  CHECK(error(start + vertex + "element face 1\nproperty list uchar int corners\nend_header\n") ==
        "a.ply: face has no list vertex_indices");
  CHECK(error(start + vertex + face + "end_header\n0 0 0\n") == "a.ply: the file holds no triangle");
}
