#include "io/mesh/read_mesh.hpp"
#include "tests/mesh/mesh_files.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using sandsim::objects::TriangleMesh;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TriangleMesh read(const std::string& text) {
  return read_obj(text, "a.obj");
}
std::string error(const std::string& text) {
  return test::input_error([&] { read(text); });
}

}  // namespace

TEST_CASE("an OBJ file gives its vertices and faces") {
  const TriangleMesh mesh =
      read("# a triangle\r\no thing\r\nv 1 2.5 -3e1 1.0 # w\r\n\r\nv 4 5 6\r\nv 7 8 9\r\nf 1 2 3");
  REQUIRE(mesh.vertices.size() == 3);
  CHECK(mesh.vertices[0].y == 2.5);
  CHECK(mesh.vertices[0].z == -30.0);
  REQUIRE(mesh.triangles.size() == 1);
  CHECK(mesh.triangles[0] == std::array<std::uint32_t, 3>{0, 1, 2});
}

TEST_CASE("corners of OBJ faces may have texture and normal indices and count from the end") {
  const TriangleMesh mesh = read(corners + "f 1/9 2/9/9 3//9\nf -4 -2 -1\n");
  CHECK(mesh.triangles.at(0) == std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK(mesh.triangles.at(1) == std::array<std::uint32_t, 3>{0, 2, 3});
}

TEST_CASE("a polygon of an OBJ file becomes a fan") {
  const TriangleMesh mesh = read(corners + "f 1 2 3 4 # a square\n");
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{0, 2, 3});
}

TEST_CASE("statements of OBJ without geometry are skipped") {
  CHECK(
      read("mtllib a.mtl\n" + corners + "vt 0 0\nvn 0 0 1\ng a\ns off\nusemtl x\nl 1 2\nf 1 2 3\n").triangles.size() ==
      1);
}

TEST_CASE("indices of OBJ that are out of range are errors") {
  CHECK(error(corners + "f 1 2 5\n") == "a.obj:5:7: there is no vertex 5 (4 vertices so far, counted from 1)");
  CHECK(error(corners + "f 0 1 2\n") == "a.obj:5:3: there is no vertex 0 (4 vertices so far, counted from 1)");
  CHECK(error(corners + "f -5 1 2\n") == "a.obj:5:3: there is no vertex -5 (4 vertices so far, counted from 1)");
  CHECK(error("f 1 2 3\n" + corners) == "a.obj:1:3: there is no vertex 1 (0 vertices so far, counted from 1)");
  const std::string text = " is no vertex of a face (they are whole numbers)";
  CHECK(error(corners + "f 1 2 x\n") == "a.obj:5:7: \"x\"" + text);
  CHECK(error(corners + "f 1 2 1.5\n") == "a.obj:5:7: \"1.5\"" + text);
  CHECK(error(corners + "f 1 2 99999999999999999999\n") == "a.obj:5:7: \"99999999999999999999\"" + text);
}

TEST_CASE("numbers of OBJ that are missing or not finite are errors") {
  CHECK(error("v 1 nan 3\n") == "a.obj:1:5: y = \"nan\" is not finite");
  CHECK(error("v 1 2 inf\n") == "a.obj:1:7: z = \"inf\" is not finite");
  CHECK(error("v 1 2\nv 1 2 3\n") == "a.obj:1:6: z is missing");
  CHECK(error("v 1 2") == "a.obj:1:6: the file ends where z should be (truncated?)");
  CHECK(error("v 1 a 3\n") == "a.obj:1:5: y: \"a\" is not a number");
}

TEST_CASE("OBJ files without a surface are errors") {
  CHECK(error("") == "a.obj: the file holds no triangle");
  CHECK(error(corners) == "a.obj: the file holds no triangle");
  CHECK(error(corners + "f 1 2\n") == "a.obj:5:1: a face with 2 vertices");
  CHECK(error("curv 1 2 3\n") ==
        "a.obj:1:1: \"curv\" is not read (v and f are, and statements without geometry are skipped)");
}

TEST_CASE("the extension of a mesh tells its format") {
  CHECK(test::input_error([] { read_mesh("a.xyz"); }) ==
        "a.xyz: the format of the mesh is unknown (extension \".xyz\"). Known are .obj, .stl and .ply");
  CHECK(test::input_error([] { read_mesh("a"); }) ==
        "a: the format of the mesh is unknown (extension missing). Known are .obj, .stl and .ply");
  CHECK(test::input_error([] { read_mesh("/nonexistent/a.OBJ"); }) ==
        "/nonexistent/a.OBJ: cannot be opened (no such file)");
}
