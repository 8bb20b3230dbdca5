#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "io/export/bytes.hpp"
#include "io/export/mesh_files.hpp"

namespace sandsim {

namespace {

/// Names the arrays of an XML file with appended data while it collects their bytes, each behind its length.
class AppendedArrays {
 public:
  /// `bytes` are the values of `name`, of VTK's type, so many for each item.
  std::string add(const char* name, const char* type, int components, const std::string& bytes) {
    const std::string tag = fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, data_.size());
    append_bytes(data_, static_cast<std::uint64_t>(bytes.size()));
    data_ += bytes;
    return tag;
  }
  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

template <class Values>
std::string raw(const Values& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])};
}

/// 0, 1, ... or 1, 2, ..., or every third of these.
std::vector<std::int64_t> numbers(std::int64_t first, std::int64_t step, std::size_t count) {
  std::vector<std::int64_t> values(count);
  for (std::size_t k = 0; k < count; ++k) values[k] = first + step * static_cast<std::int64_t>(k);
  return values;
}

std::vector<float> depths(const surface::SurfaceMesh& mesh) {
  std::vector<float> values;
  for (std::size_t v = 0; v < mesh.bed.size(); ++v) {
    values.push_back(static_cast<float>(mesh.shape.vertices[v].z - mesh.bed[v]));
  }
  return values;
}

std::vector<std::int64_t> corners(const objects::TriangleMesh& mesh) {
  std::vector<std::int64_t> values;
  values.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) values.insert(values.end(), triangle.begin(), triangle.end());
  return values;
}

struct Piece {
  std::size_t points = 0, vertices = 0, triangles = 0;
};

std::string poly_data(const Piece& piece, const std::string& tags, const AppendedArrays& arrays) {
  return fmt::format(
             "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
             "  <PolyData>\n"
             "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
             "NumberOfPolys=\"{}\">\n",
             piece.points, piece.vertices, piece.triangles) +
         tags + "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_" + arrays.data() +
         "\n  </AppendedData>\n</VTKFile>\n";
}

std::string section(const std::string& start, const std::string& name, const std::string& content) {
  return "      <" + start + ">\n" + content + "      </" + name + ">\n";
}

template <class Values>
void append_all_big_endian(std::string& bytes, const Values& values) {
  for (const auto value : values) append_big_endian(bytes, value);
  bytes += '\n';
}

}  // namespace

std::string vtp_bytes(const surface::SurfaceMesh& mesh) {
  const auto& [vertices, triangles] = mesh.shape;
  AppendedArrays arrays;
  std::string tags = section(
      "PointData Scalars=\"depth\" Normals=\"normals\"", "PointData",
      arrays.add("normals", "Float32", 3, raw(mesh.normals)) + arrays.add("depth", "Float32", 1, raw(depths(mesh))));
  tags += section("Points", "Points", arrays.add("points", "Float64", 3, raw(vertices)));
  tags += section("Polys", "Polys",
                  arrays.add("connectivity", "Int64", 1, raw(corners(mesh.shape))) +
                      arrays.add("offsets", "Int64", 1, raw(numbers(3, 3, triangles.size()))));
  return poly_data({vertices.size(), 0, triangles.size()}, tags, arrays);
}

std::string vtp_bytes(const VisibleParticles& particles) {
  const std::size_t count = particles.positions.size();
  AppendedArrays arrays;
  std::string tags = section("PointData Scalars=\"id\"", "PointData", arrays.add("id", "Int64", 1, raw(particles.ids)));
  tags += section("Points", "Points", arrays.add("points", "Float64", 3, raw(particles.positions)));
  tags += section("Verts", "Verts",
                  arrays.add("connectivity", "Int64", 1, raw(numbers(0, 1, count))) +
                      arrays.add("offsets", "Int64", 1, raw(numbers(1, 1, count))));
  return poly_data({count, count, 0}, tags, arrays);
}

std::string vtk_bytes(const surface::SurfaceMesh& mesh) {
  const auto& [vertices, triangles] = mesh.shape;
  std::string bytes =
      fmt::format("# vtk DataFile Version 3.0\nsandsim, metres, z up\nBINARY\nDATASET POLYDATA\nPOINTS {} double\n",
                  vertices.size());
  for (const objects::Vec3& v : vertices) {
    for (const double coordinate : {v.x, v.y, v.z}) append_big_endian(bytes, coordinate);
  }
  bytes += fmt::format("\nPOLYGONS {} {}\n", triangles.size(), 4 * triangles.size());
  for (const auto& triangle : triangles) {
    append_big_endian(bytes, std::int32_t{3});
    for (const std::uint32_t corner : triangle) append_big_endian(bytes, static_cast<std::int32_t>(corner));
  }
  bytes += fmt::format("\nPOINT_DATA {}\nSCALARS depth float 1\nLOOKUP_TABLE default\n", vertices.size());
  append_all_big_endian(bytes, depths(mesh));
  bytes += "NORMALS normals float\n";
  for (const auto& normal : mesh.normals) {
    for (const float component : normal) append_big_endian(bytes, component);
  }
  return bytes + '\n';
}

}  // namespace sandsim
