#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

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

/// The first `count` triangles behind the header.
objects::TriangleMesh read_binary(std::string_view bytes, std::size_t count, const std::string& name) {
  objects::TriangleMesh mesh;
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    std::array<objects::Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      double xyz[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t byte = header_bytes + triangle_bytes * triangle + 12 + 12 * k + 4 * axis;
        xyz[axis] = static_cast<double>(load_bytes<float>(bytes.data() + byte, false));
        if (!std::isfinite(xyz[axis])) {
          throw InputError(fmt::format("{}: byte {}: a coordinate of triangle {} (counted from 0) is not finite", name,
                                       byte, triangle));
        }
      }
      corners[k] = {xyz[0], xyz[1], xyz[2]};
    }
    add_triangle(mesh, corners);
  }
  require_triangles(mesh, name);
  return mesh;
}

/// A binary file whose length is not the one that it announces.
objects::TriangleMesh read_odd_binary(std::string_view bytes, std::size_t count, const std::string& name,
                                      Warnings* warnings) {
  const std::size_t held = (bytes.size() - header_bytes) / triangle_bytes;
  const std::size_t wanted = header_bytes + triangle_bytes * count;
  if (count == 0 && held > 0 && bytes.size() == header_bytes + triangle_bytes * held) {
    warn(warnings, fmt::format("{}: byte 80: no triangle is announced, but {} follow: they are read", name, held));
    return read_binary(bytes, held, name);
  }
  if (count > 0 && held >= count) {
    warn(warnings, fmt::format("{}: byte {}: {} bytes behind the {} triangles that are announced are not read", name,
                               wanted, bytes.size() - wanted, count));
    return read_binary(bytes, count, name);
  }
  throw InputError(
      fmt::format("{}: byte 80: {} triangles are announced, which makes {} bytes, but the file has {} ({})", name,
                  count, wanted, bytes.size(), bytes.size() < wanted ? "truncated?" : "too many"));
}

/// Solids one after the other, from words.
class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& name, Warnings* warnings)
      : tokens_(text, name), source_(tokens_.source()), name_(name), warnings_(warnings) {}

  objects::TriangleMesh read() {
    for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) {
      if (!is_word(word, "solid")) {
        if (mesh_.triangles.empty()) source_.fail(word, fmt::format("{} where solid should be", in_quotes(word)));
        warn(warnings_, source_.at(word, fmt::format("{} behind the last solid: the rest of the file is not read",
                                                     in_quotes(word))));
        break;
      }
      tokens_.skip_line();  // the name, which may be anything
      read_solid();
    }
    require_triangles(mesh_, name_);
    return std::move(mesh_);
  }

 private:
  void read_solid() {
    while (true) {
      const std::string_view word = tokens_.next();
      if (word.empty() && !mesh_.triangles.empty()) {
        warn(warnings_, fmt::format("{}: the file ends without endsolid (truncated?)", name_));
        return;
      }
      if (word.empty()) source_.fail_at_end("the file ends where facet should be (truncated?)");
      if (is_end(word, "solid")) {
        tokens_.skip_line();
        return;
      }
      if (!is_word(word, "facet")) {
        source_.fail(word, fmt::format("{} where facet or endsolid should be", in_quotes(word)));
      }
      read_facet(word);
    }
  }

  void read_facet(std::string_view facet) {
    expect("normal");
    for (const std::string_view axis : {"x", "y", "z"}) {
      if (tokens_.next().empty())
        source_.fail_at_end(fmt::format("the file ends in {} of a normal (truncated?)", axis));
    }
    expect("outer");
    expect("loop");
    std::array<objects::Vec3, 3> corners;
    for (objects::Vec3& corner : corners) {
      expect("vertex");
      corner.x = tokens_.number("x");
      corner.y = tokens_.number("y");
      corner.z = tokens_.number("z");
    }
    expect_end("loop");
    expect_end("facet");
    add_triangle(mesh_, corners);
    if (mesh_.vertices.size() > most_vertices) source_.fail(facet, "too many vertices (at most 2^31)");
  }

  [[noreturn]] void fail(std::string_view found, const std::string& wanted) const {
    if (found.empty()) source_.fail_at_end(fmt::format("the file ends where {} should be (truncated?)", wanted));
    source_.fail(found, fmt::format("{} where {} should be", in_quotes(found), wanted));
  }

  void expect(std::string_view word) {
    const std::string_view found = tokens_.next();
    if (!is_word(found, word)) fail(found, std::string(word));
  }

  /// Whether this ends a `what`: "endsolid", or "end" and "solid", which is then passed.
  bool is_end(std::string_view word, std::string_view what) {
    if (is_word(word.substr(0, 3), "end") && is_word(word.substr(std::min<std::size_t>(3, word.size())), what)) {
      return true;
    }
    Tokens ahead = tokens_;
    if (!is_word(word, "end") || !is_word(ahead.next(), what)) return false;
    tokens_.next();
    return true;
  }

  void expect_end(std::string_view what) {
    const std::string_view found = tokens_.next();
    if (!is_end(found, what)) fail(found, "end" + std::string(what));
  }

  Tokens tokens_;
  const SourceText& source_;
  const std::string& name_;
  Warnings* warnings_;
  objects::TriangleMesh mesh_;
};

}  // namespace

objects::TriangleMesh read_stl(std::string_view bytes, const std::string& name, Warnings* warnings) {
  if (bytes.empty()) throw InputError(fmt::format("{}: the file is empty", name));
  const std::size_t count =
      bytes.size() < header_bytes ? 0 : load_bytes<std::uint32_t>(bytes.data() + header_bytes - 4, false);
  // Binary files may start with "solid", too: their length is what tells.
  if (bytes.size() >= header_bytes && bytes.size() == header_bytes + triangle_bytes * count) {
    return read_binary(bytes, count, name);
  }
  if (is_word(Tokens(bytes, name).next(), "solid") && bytes.find('\0') == std::string_view::npos) {
    const std::optional<std::string> copy = with_line_feeds(bytes);
    return AsciiReader(copy ? *copy : bytes, name, warnings).read();
  }
  if (bytes.size() < header_bytes) {
    throw InputError(
        fmt::format("{}: neither an ASCII STL file (it does not start with solid) nor a binary one ({} "
                    "bytes; its header alone has {})",
                    name, bytes.size(), header_bytes));
  }
  return read_odd_binary(bytes, count, name, warnings);
}

}  // namespace sandsim
