#include "io/export/mesh_files.hpp"

#include <algorithm>

#include "io/mesh/read_mesh.hpp"
#include "solver/errors.hpp"
#include "support.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

/// A number of a legacy VTK file, whose bytes are in reverse.
template <class Number>
Number big_endian_at(const std::string& bytes, std::size_t place) {
  std::string item = bytes.substr(place, sizeof(Number));
  std::reverse(item.begin(), item.end());
  return number_at<Number>(item, 0);
}

/// The values of an array of a .vtp file by its name: its offset stands in its tag, its length before its data.
template <class Number>
std::vector<Number> vtp_array(const std::string& bytes, const std::string& name) {
  const std::size_t tag = bytes.find("Name=\"" + name + "\"");
  const std::size_t offset = std::stoul(bytes.substr(behind(bytes, "offset=\"", tag), 20));
  const std::size_t place = behind(bytes, "<AppendedData encoding=\"raw\">\n_") + offset;
  std::vector<Number> values(number_at<std::uint64_t>(bytes, place) / sizeof(Number));
  std::memcpy(values.data(), bytes.data() + place + sizeof(std::uint64_t), values.size() * sizeof(Number));
  return values;
}

VisibleParticles three_particles() {
  VisibleParticles particles;
  particles.positions = {{4567000.015625, 1.5, 2.5}, {-1.0, 0.0, 0.25}, {8.0, 9.0, 10.0}};
  particles.ids = {7, 0, (std::int64_t{3} << 32) + 5};
  return particles;
}

}  // namespace

TEST_CASE("PLY and OBJ read back to the same bits") {
  surface::SurfaceMesh mesh = sample_mesh();
  REQUIRE(mesh.shape.triangles.size() > 6);
  CHECK(same_shape(read_ply(ply_bytes(mesh), "a.ply"), mesh.shape));
  CHECK(same_shape(read_obj(obj_text(mesh), "a.obj"), mesh.shape));
  surface::close(mesh);
  CHECK(same_shape(read_ply(ply_bytes(mesh), "a.ply"), mesh.shape));
  CHECK(same_shape(read_obj(obj_text(mesh), "a.obj"), mesh.shape));
}

TEST_CASE("PLY holds the normals behind the coordinates") {
  const surface::SurfaceMesh mesh = sample_mesh();
  const std::string bytes = ply_bytes(mesh);
  const std::size_t data = behind(bytes, "end_header\n");
  CHECK(bytes.size() == data + 36 * mesh.shape.vertices.size() + 13 * mesh.shape.triangles.size());
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(number_at<float>(bytes, data + 36 * v + 24 + 4 * axis) == mesh.normals[v][axis]);
    }
  }
}

TEST_CASE("OBJ names a normal for each corner and counts from 1") {
  const surface::SurfaceMesh mesh = sample_mesh();
  const std::string text = obj_text(mesh);
  const auto [a, b, c] = mesh.shape.triangles[0];
  const auto corner = [](std::uint32_t v) { return std::to_string(v + 1) + "//" + std::to_string(v + 1); };
  CHECK(text.find("\nf " + corner(a) + ' ' + corner(b) + ' ' + corner(c) + '\n') != std::string::npos);
  CHECK(text.find("\nvn ") != std::string::npos);
}

TEST_CASE("a vtp file holds points and triangles and what is known at points") {
  const surface::SurfaceMesh mesh = sample_mesh();
  const std::string bytes = vtp_bytes(mesh);
  const std::size_t count = mesh.shape.vertices.size();
  CHECK(bytes.find("NumberOfPoints=\"" + std::to_string(count) + "\"") != std::string::npos);
  const std::vector<double> points = vtp_array<double>(bytes, "points");
  const std::vector<float> normals = vtp_array<float>(bytes, "normals");
  const std::vector<float> depths = vtp_array<float>(bytes, "depth");
  REQUIRE(points.size() == 3 * count);
  REQUIRE(normals.size() == 3 * count);
  REQUIRE(depths.size() == count);
  for (std::size_t v = 0; v < count; ++v) {
    CHECK(points[3 * v] == mesh.shape.vertices[v].x);
    CHECK(points[3 * v + 2] == mesh.shape.vertices[v].z);
    CHECK(normals[3 * v + 1] == mesh.normals[v][1]);
    CHECK(depths[v] == static_cast<float>(mesh.shape.vertices[v].z - mesh.bed[v]));
  }
  const auto corners = vtp_array<std::int64_t>(bytes, "connectivity");
  const auto offsets = vtp_array<std::int64_t>(bytes, "offsets");
  REQUIRE(offsets.size() == mesh.shape.triangles.size());
  CHECK(offsets.front() == 3);
  CHECK(offsets.back() == static_cast<std::int64_t>(corners.size()));
  CHECK(corners[1] == mesh.shape.triangles[0][1]);
  CHECK(bytes.ends_with("</VTKFile>\n"));
}

TEST_CASE("a legacy vtk file holds the same in big-endian numbers") {
  const surface::SurfaceMesh mesh = sample_mesh();
  const std::string bytes = vtk_bytes(mesh);
  const std::size_t count = mesh.shape.vertices.size();
  const std::size_t points = behind(bytes, "POINTS " + std::to_string(count) + " double\n");
  REQUIRE(points != std::string::npos);
  CHECK(big_endian_at<double>(bytes, points + 24) == mesh.shape.vertices[1].x);
  const std::size_t triangles = mesh.shape.triangles.size();
  const std::string head = "POLYGONS " + std::to_string(triangles) + ' ' + std::to_string(4 * triangles) + '\n';
  const std::size_t polygons = behind(bytes, head);
  REQUIRE(polygons != std::string::npos);
  for (std::size_t k = 0; k < triangles; ++k) {
    CHECK(big_endian_at<std::int32_t>(bytes, polygons + 16 * k) == 3);
    CHECK(big_endian_at<std::uint32_t>(bytes, polygons + 16 * k + 8) == mesh.shape.triangles[k][1]);
  }
  const std::size_t normals = behind(bytes, "NORMALS normals float\n");
  CHECK(big_endian_at<float>(bytes, normals + 8) == mesh.normals[0][2]);
  CHECK(bytes.size() == normals + 12 * count + 1);
}

TEST_CASE("an empty mesh is a valid file in each format") {
  const surface::SurfaceMesh empty;
  CHECK(ply_bytes(empty).find("element vertex 0\n") != std::string::npos);
  CHECK(ply_bytes(empty).ends_with("end_header\n"));
  CHECK(obj_text(empty).starts_with("#"));
  CHECK(vtp_array<double>(vtp_bytes(empty), "points").empty());
  CHECK(vtk_bytes(empty).find("POINTS 0 double") != std::string::npos);
}

TEST_CASE("particles are a point cloud with ids") {
  const VisibleParticles particles = three_particles();
  const std::string ply = ply_bytes(particles);
  const std::size_t data = behind(ply, "end_header\n");
  REQUIRE(ply.size() == data + 3 * 32);
  const std::string vtp = vtp_bytes(particles);
  CHECK(vtp_array<std::int64_t>(vtp, "id") == particles.ids);
  CHECK(vtp_array<std::int64_t>(vtp, "connectivity") == std::vector<std::int64_t>{0, 1, 2});
  CHECK(vtp_array<std::int64_t>(vtp, "offsets") == std::vector<std::int64_t>{1, 2, 3});
  const std::vector<double> points = vtp_array<double>(vtp, "points");
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(number_at<double>(ply, data + 32 * k + 24) == static_cast<double>(particles.ids[k]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(number_at<double>(ply, data + 32 * k + 8 * axis) == particles.positions[k][axis]);
      CHECK(points[3 * k + axis] == particles.positions[k][axis]);
    }
  }
}

TEST_CASE("an id that PLY cannot hold is refused with the format that can") {
  VisibleParticles particles = three_particles();
  particles.ids[1] = (std::int64_t{1} << 53) + 1;
  CHECK(vtp_array<std::int64_t>(vtp_bytes(particles), "id")[1] == particles.ids[1]);
  try {
    ply_bytes(particles);
    FAIL("nothing was thrown");
  } catch (const OutputError& error) {
    CHECK(std::string(error.what()).find("--format vtp") != std::string::npos);
  }
}
