#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "io/mesh/faces.hpp"
#include "io/mesh/read_mesh.hpp"
#include "io/mesh/tokens.hpp"

namespace sandsim {

namespace {

/// Statements that say nothing about where a surface of faces is: names and looks, lines and points, curves.
constexpr std::array<std::string_view, 36> skipped{
    "vt",        "vn",     "vp",  "g",      "o",      "s",     "mg",       "usemtl",   "mtllib",
    "l",         "p",      "lod", "usemap", "maplib", "bevel", "c_interp", "d_interp", "shadow_obj",
    "trace_obj", "cstype", "deg", "bmat",   "step",   "curv",  "curv2",    "parm",     "trim",
    "hole",      "scrv",   "sp",  "end",    "con",    "ctech", "stech",    "res",      "cdc"};
/// Surfaces, but curved ones.
constexpr std::array<std::string_view, 2> curved{"surf", "bzp"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The vertex that a corner such as "7", "7/1", "7//2" or "-1" means. It may still come if it counts from the start.
std::uint32_t read_corner(const SourceText& source, std::string_view corner, std::size_t vertices) {
  const std::string_view number = corner.substr(0, corner.find('/'));
  long long index = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc{} || stop != number.data() + number.size()) {
    source.fail(corner, fmt::format("{} is no vertex of a face (they are whole numbers)", in_quotes(corner)));
  }
  const long long count = static_cast<long long>(vertices);
  if (index == 0 || index > static_cast<long long>(most_vertices) || index < -count) {
    source.fail(corner, fmt::format("there is no vertex {} ({} vertices so far, counted from 1)", index, count));
  }
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

/// Reads one statement after the other into a mesh.
class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name)
      : tokens_(text, name, Backslash::joins_lines), source_(tokens_.source()) {}

  objects::TriangleMesh read(const std::string& name, Warnings* warnings) {
    for (bool more = !source_.text().empty(); more; more = tokens_.skip_line()) {
      const std::string_view statement = tokens_.next_in_line();
      if (statement.empty() || statement.front() == '#') continue;
      read_statement(statement, warnings);
      pass_words();
    }
    if (!farthest_corner_.empty() && farthest_ >= mesh_.vertices.size()) {
      source_.fail(farthest_corner_, fmt::format("there is no vertex {} ({} vertices, counted from 1)", farthest_ + 1,
                                                 mesh_.vertices.size()));
    }
    odd_.settle(mesh_, warnings,
                [&](std::string_view place, const std::string& what) { return source_.at(place, what); });
    require_triangles(mesh_, name);
    return std::move(mesh_);
  }

 private:
  void read_statement(std::string_view statement, Warnings* warnings) {
    if (statement == "v") {
      read_vertex(statement);
    } else if (statement == "f") {
      read_face(statement);
    } else if (is_one_of(curved, statement)) {
      if (!has_curved_) warn(warnings, source_.at(statement, "curved surfaces are not read, only faces"));
      has_curved_ = true;
    } else if (!is_one_of(skipped, statement)) {
      source_.fail(statement, fmt::format("{} is not read (v and f are, and statements without faces are skipped)",
                                          in_quotes(statement)));
    }
  }

  void read_vertex(std::string_view statement) {
    objects::Vec3 place;
    for (const auto& [axis, value] : {std::pair{"x", &place.x}, {"y", &place.y}, {"z", &place.z}}) {
      *value = tokens_.any_number_in_line(axis);
    }
    if (!(std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z))) {
      odd_.add_vertex(mesh_.vertices.size(), statement);
    }
    mesh_.vertices.push_back(place);
    if (mesh_.vertices.size() > most_vertices) source_.fail(statement, "too many vertices (at most 2^31)");
  }

  void read_face(std::string_view statement) {
    corners_.clear();
    for (std::string_view corner = tokens_.next_in_line(); !corner.empty() && corner.front() != '#';
         corner = tokens_.next_in_line()) {
      corners_.push_back(read_corner(source_, corner, mesh_.vertices.size()));
      if (corners_.back() < farthest_ && !farthest_corner_.empty()) continue;
      farthest_ = corners_.back();
      farthest_corner_ = corner;
    }
    if (corners_.size() < 3) odd_.add_face(statement);
    add_polygon(mesh_, corners_);
  }

  /// To the end of the statement, which may lie in a later line.
  void pass_words() {
    for (std::string_view word = tokens_.next_in_line(); !word.empty() && word.front() != '#';) {
      word = tokens_.next_in_line();
    }
  }

  Tokens tokens_;
  const SourceText& source_;
  objects::TriangleMesh mesh_;
  OddParts odd_;
  std::vector<std::uint32_t> corners_;
  std::size_t farthest_ = 0;  // vertex that a corner means
  std::string_view farthest_corner_;
  bool has_curved_ = false;
};

}  // namespace

objects::TriangleMesh read_obj(std::string_view text, const std::string& name, Warnings* warnings) {
  if (const std::optional<std::string> copy = with_line_feeds(text)) return read_obj(*copy, name, warnings);
  return ObjReader(text, name).read(name, warnings);
}

}  // namespace sandsim
