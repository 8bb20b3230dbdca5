#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "io/mesh/binary.hpp"
#include "io/mesh/faces.hpp"
#include "io/mesh/read_mesh.hpp"
#include "io/mesh/tokens.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace {

constexpr std::size_t header_bytes = 84;    // 80 of text, then the number of triangles
constexpr std::size_t triangle_bytes = 50;  // normal, three corners, two bytes of attributes

bool is_word(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// Adds three corners as vertices of their own.
void add_triangle(objects::TriangleMesh& mesh, const std::array<objects::Vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

objects::TriangleMesh read_binary(std::string_view bytes, const std::string& name) {
  objects::TriangleMesh mesh;
  for (std::size_t first = header_bytes; first < bytes.size(); first += triangle_bytes) {
    std::array<objects::Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      double xyz[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t byte = first + 12 + 12 * k + 4 * axis;
        xyz[axis] = static_cast<double>(load_bytes<float>(bytes.data() + byte, false));
        if (!std::isfinite(xyz[axis])) {
          throw InputError(fmt::format("{}: byte {}: a coordinate of triangle {} (counted from 0) is not finite", name,
                                       byte, mesh.triangles.size()));
        }
      }
      corners[k] = {xyz[0], xyz[1], xyz[2]};
    }
    add_triangle(mesh, corners);
  }
  require_triangles(mesh, name);
  return mesh;
}

void expect(Tokens& tokens, std::string_view word) {
  const std::string_view found = tokens.next();
  if (is_word(found, word)) return;
  if (found.empty()) tokens.source().fail_at_end(fmt::format("the file ends where {} should be (truncated?)", word));
  tokens.source().fail(found, fmt::format("{} where {} should be", in_quotes(found), word));
}

objects::TriangleMesh read_ascii(std::string_view text, const std::string& name) {
  objects::TriangleMesh mesh;
  Tokens tokens(text, name);
  bool in_solid = false;
  for (std::string_view word = tokens.next(); !word.empty(); word = tokens.next()) {
    if (is_word(word, in_solid ? "endsolid" : "solid")) {
      in_solid = !in_solid;
      tokens.skip_line();  // the name, which may be anything
      continue;
    }
    if (!in_solid || !is_word(word, "facet")) {
      tokens.source().fail(
          word, fmt::format("{} where {} should be", in_quotes(word), in_solid ? "facet or endsolid" : "solid"));
    }
    expect(tokens, "normal");
    for (const std::string_view axis : {"x", "y", "z"}) tokens.number(fmt::format("{} of the normal", axis));
    expect(tokens, "outer");
    expect(tokens, "loop");
    std::array<objects::Vec3, 3> corners;
    for (objects::Vec3& corner : corners) {
      expect(tokens, "vertex");
      corner.x = tokens.number("x");
      corner.y = tokens.number("y");
      corner.z = tokens.number("z");
    }
    expect(tokens, "endloop");
    expect(tokens, "endfacet");
    add_triangle(mesh, corners);
    if (mesh.vertices.size() > most_vertices) tokens.source().fail(word, "too many vertices (at most 2^31)");
  }
  if (in_solid) tokens.source().fail_at_end("the file ends where endsolid should be (truncated?)");
  require_triangles(mesh, name);
  return mesh;
}

}  // namespace

objects::TriangleMesh read_stl(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw InputError(fmt::format("{}: the file is empty", name));
  const std::size_t count =
      bytes.size() < header_bytes ? 0 : load_bytes<std::uint32_t>(bytes.data() + header_bytes - 4, false);
  // Binary files may start with "solid", too: their length is what tells.
  if (bytes.size() >= header_bytes && bytes.size() == header_bytes + triangle_bytes * count) {
    return read_binary(bytes, name);
  }
  std::string_view start = bytes;
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  if (is_word(start.substr(0, 5), "solid") && bytes.find('\0') == std::string_view::npos) {
    return read_ascii(bytes, name);
  }
  if (bytes.size() < header_bytes) {
    throw InputError(
        fmt::format("{}: neither an ASCII STL file (it does not start with solid) nor a binary one ({} "
                    "bytes; its header alone has {})",
                    name, bytes.size(), header_bytes));
  }
  throw InputError(
      fmt::format("{}: byte 80: {} triangles are announced, which makes {} bytes, but the file has {} ({})", name,
                  count, header_bytes + triangle_bytes * count, bytes.size(),
                  bytes.size() < header_bytes + triangle_bytes * count ? "truncated?" : "too many"));
}

}  // namespace sandsim
