#include <cmath>
#include <numbers>

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

TEST_CASE("a polygon of an OBJ file is cut in halves") {
  const TriangleMesh mesh = read(corners + "f 1 2 3 4 # a square\n");
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{0, 2, 3});
}

TEST_CASE("a face of 30000 corners keeps its area and is cut into wide triangles") {
  // A disc: the polygon's area is n/2 sin(2 pi / n), and every triangle looks up.
  constexpr int n = 30000;
  std::string text;
  std::string face = "f";
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(k + 1);
  }
  const TriangleMesh mesh = read(text + face + "\n");
  REQUIRE(mesh.triangles.size() == n - 2);
  double doubled = 0.0;
  double perimeters = 0.0;
  for (const auto& t : mesh.triangles) {
    const objects::Vec3& a = mesh.vertices[t[0]];
    const objects::Vec3& b = mesh.vertices[t[1]];
    const objects::Vec3& c = mesh.vertices[t[2]];
    doubled += cross(b - a, c - a).z;
    perimeters += length(b - a) + length(c - b) + length(a - c);
  }
  // Six digits in the text of 1e-4 long sides: 2e-3 of a side, at random.
  CHECK_THAT(0.5 * doubled, WithinAbs(std::numbers::pi, 1e-5));
  // Each of the 14 halvings adds at most twice the disc's circumference; a fan would have about 2 * 1.3 * 30000.
  CHECK(perimeters < 14 * 2 * 2.0 * std::numbers::pi);
}

TEST_CASE("lines of OBJ that a backslash joins are one statement") {
  const TriangleMesh mesh =
      read("v 0 0 \\\n 0\nv 1 0\\\r\n 0 # \\\nv 1 1 0\n#\\\nv 0 1 0\nf 1 2 \\ \n 3 4\nf 1 2\\\n\\\n 3\n");
  CHECK(mesh.vertices.size() == 4);
  CHECK(mesh.triangles.size() == 3);
  CHECK(read(corners + "curv 0 1 \\\n1 2\nf 1 2 3\n").triangles.size() == 1);
}

TEST_CASE("OBJ files with a byte order mark or carriage returns alone are read") {
  CHECK(read("\xEF\xBB\xBF" + corners + "f 1 2 3\n").vertices.size() == 4);
  const TriangleMesh mesh = read("v 0 0 0\rv 1 0 0\rv 1 1 0\r# x\rf 1 2 3\r");
  CHECK(mesh.vertices.size() == 3);
  CHECK(mesh.triangles.size() == 1);
}

TEST_CASE("faces of OBJ may come before their vertices") {
  CHECK(read("f 1 2 3\n" + corners).triangles.at(0) == std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK(error("f 1 2 5\n" + corners) == "a.obj:1:7: there is no vertex 5 (4 vertices, counted from 1)");
}

TEST_CASE("what no face of OBJ uses is not judged") {
  const TriangleMesh mesh = read(corners + "v nan -1.#IND inf\nvn nan nan nan\nvt x\nf 1/7/1 2 3\n");
  CHECK(mesh.vertices.at(4) == objects::Vec3{});
  CHECK(error(corners + "v 0 1.#QNAN 0\nf 1 2 5\n") == "a.obj:5:1: a vertex of a face is not finite");
}

TEST_CASE("curves beside the faces of OBJ are skipped and surfaces are mentioned") {
  Warnings warnings;
  read_obj(corners + "cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\np 1\nl 1 2\nf 1 2 3\n", "a.obj",
           &warnings);
  CHECK(warnings.empty());
  read_obj(corners + "surf 0 1 0 1 1 2 3 4\nend\nf 1 2 3\n", "a.obj", &warnings);
  CHECK(warnings == Warnings{"a.obj:5:1: curved surfaces are not read, only faces"});
}

TEST_CASE("faces of OBJ with fewer than three corners are left out and said") {
  Warnings warnings;
  CHECK(read_obj(corners + "f 1 2\nf 1 2 3\nf 3\n", "a.obj", &warnings).triangles.size() == 1);
  CHECK(warnings == Warnings{"a.obj:5:1: a face with fewer than three corners is left out, as are 1 more"});
}

TEST_CASE("statements of OBJ without geometry are skipped") {
  CHECK(
      read("mtllib a.mtl\n" + corners + "vt 0 0\nvn 0 0 1\ng a\ns off\nusemtl x\nl 1 2\nf 1 2 3\n").triangles.size() ==
      1);
}

TEST_CASE("indices of OBJ that are out of range are errors") {
  CHECK(error(corners + "f 1 2 5\n") == "a.obj:5:7: there is no vertex 5 (4 vertices, counted from 1)");
  CHECK(error(corners + "f 0 1 2\n") == "a.obj:5:3: there is no vertex 0 (4 vertices so far, counted from 1)");
  CHECK(error(corners + "f -5 1 2\n") == "a.obj:5:3: there is no vertex -5 (4 vertices so far, counted from 1)");
  const std::string text = " is no vertex of a face (they are whole numbers)";
  CHECK(error(corners + "f 1 2 x\n") == "a.obj:5:7: \"x\"" + text);
  CHECK(error(corners + "f 1 2 1.5\n") == "a.obj:5:7: \"1.5\"" + text);
  CHECK(error(corners + "f 1 2 99999999999999999999\n") == "a.obj:5:7: \"99999999999999999999\"" + text);
}

TEST_CASE("numbers of OBJ that are missing or not finite are errors") {
  CHECK(error("v 1 nan 3\nf 1 1 1\n") == "a.obj:1:1: a vertex of a face is not finite");
  CHECK(error("v 1 2\nv 1 2 3\n") == "a.obj:1:6: z is missing");
  CHECK(error("v 1 2") == "a.obj:1:6: the file ends where z should be (truncated?)");
  CHECK(error("v 1 a 3\n") == "a.obj:1:5: y: \"a\" is not a number");
}

TEST_CASE("OBJ files without a surface are errors") {
  CHECK(error("") == "a.obj: the file holds no triangle");
  CHECK(error(corners) == "a.obj: the file holds no triangle");
  CHECK(error(corners + "f 1 2\n") == "a.obj: the file holds no triangle");
  CHECK(error("cube 1 2 3\n") ==
        "a.obj:1:1: \"cube\" is not read (v and f are, and statements without faces are skipped)");
}

TEST_CASE("the extension of a mesh tells its format") {
  CHECK(test::input_error([] { read_mesh("a.xyz"); }) ==
        "a.xyz: the format of the mesh is unknown (extension \".xyz\"). Known are .obj, .stl and .ply");
  CHECK(test::input_error([] { read_mesh("a"); }) ==
        "a: the format of the mesh is unknown (extension missing). Known are .obj, .stl and .ply");
  CHECK(test::input_error([] { read_mesh("/nonexistent/a.OBJ"); }) ==
        "/nonexistent/a.OBJ: cannot be opened (no such file)");
}
