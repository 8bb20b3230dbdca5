#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "io/mesh/faces.hpp"
#include "io/mesh/read_mesh.hpp"
#include "io/mesh/tokens.hpp"

namespace sandsim {

namespace {

/// Statements that say nothing about where the surface is.
constexpr std::array<std::string_view, 12> skipped{"vt",     "vn",     "vp", "g", "o",   "s",
                                                   "usemtl", "mtllib", "l",  "p", "lod", "usemap"};

/// The vertex that a corner such as "7", "7/1", "7//2" or "-1" means.
std::uint32_t read_corner(const SourceText& source, std::string_view corner, std::size_t vertices) {
  const std::string_view number = corner.substr(0, corner.find('/'));
  long long index = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc{} || stop != number.data() + number.size()) {
    source.fail(corner, fmt::format("{} is no vertex of a face (they are whole numbers)", in_quotes(corner)));
  }
  const long long count = static_cast<long long>(vertices);
  if (index == 0 || index > count || index < -count) {
    source.fail(corner, fmt::format("there is no vertex {} ({} vertices so far, counted from 1)", index, count));
  }
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

}  // namespace

objects::TriangleMesh read_obj(std::string_view text, const std::string& name) {
  objects::TriangleMesh mesh;
  Tokens tokens(text, name);
  const SourceText& source = tokens.source();
  std::vector<std::uint32_t> corners;
  for (bool more = !text.empty(); more; more = tokens.skip_line()) {
    const std::string_view statement = tokens.next_in_line();
    if (statement.empty() || statement.front() == '#') continue;
    if (statement == "v") {
      const double x = tokens.number_in_line("x");
      const double y = tokens.number_in_line("y");
      mesh.vertices.push_back({x, y, tokens.number_in_line("z")});
      if (mesh.vertices.size() > most_vertices) source.fail(statement, "too many vertices (at most 2^31)");
    } else if (statement == "f") {
      corners.clear();
      for (std::string_view corner = tokens.next_in_line(); !corner.empty() && corner.front() != '#';
           corner = tokens.next_in_line()) {
        corners.push_back(read_corner(source, corner, mesh.vertices.size()));
      }
      if (corners.size() < 3) source.fail(statement, fmt::format("a face with {} vertices", corners.size()));
      add_polygon(mesh, corners);
    } else if (std::find(skipped.begin(), skipped.end(), statement) == skipped.end()) {
      source.fail(statement, fmt::format("{} is not read (v and f are, and statements without geometry are skipped)",
                                         in_quotes(statement)));
    }
  }
  require_triangles(mesh, name);
  return mesh;
}

}  // namespace sandsim
