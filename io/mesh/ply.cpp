#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "io/mesh/binary.hpp"
#include "io/mesh/faces.hpp"
#include "io/mesh/ply_header.hpp"
#include "io/mesh/read_mesh.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace {

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::int64:
    case PlyType::uint64:
    case PlyType::float64:
      break;
  }
  return 8;
}

double load(const char* bytes, PlyType type, bool big_endian) {
  switch (type) {
    case PlyType::int8:
      return load_bytes<std::int8_t>(bytes, big_endian);
    case PlyType::uint8:
      return load_bytes<std::uint8_t>(bytes, big_endian);
    case PlyType::int16:
      return load_bytes<std::int16_t>(bytes, big_endian);
    case PlyType::uint16:
      return load_bytes<std::uint16_t>(bytes, big_endian);
    case PlyType::int32:
      return load_bytes<std::int32_t>(bytes, big_endian);
    case PlyType::uint32:
      return load_bytes<std::uint32_t>(bytes, big_endian);
    case PlyType::int64:
      return static_cast<double>(load_bytes<std::int64_t>(bytes, big_endian));
    case PlyType::uint64:
      return static_cast<double>(load_bytes<std::uint64_t>(bytes, big_endian));
    case PlyType::float32:
      return static_cast<double>(load_bytes<float>(bytes, big_endian));
    case PlyType::float64:
      break;
  }
  return load_bytes<double>(bytes, big_endian);
}

/// The values behind the header, one after the other, from text or from bytes.
class Values {
 public:
  Values(const Tokens& tokens, PlyFormat format, const std::string& name)
      : tokens_(tokens), format_(format), name_(name), bytes_(tokens.rest()) {}

  /// `what` it is stands in errors. It need not be finite.
  double next(PlyType type, const std::string& what) {
    last_ = is_ascii() ? tokens_.rest() : bytes_;
    if (is_ascii()) return tokens_.any_number(what);
    return load(take(type, what), type, format_ == PlyFormat::big_endian);
  }

  /// Passes a value that nobody wants.
  void skip(PlyType type, const std::string& what) {
    last_ = is_ascii() ? tokens_.rest() : bytes_;
    if (!is_ascii()) {
      take(type, what);
    } else if (tokens_.next().empty()) {
      tokens_.source().fail_at_end(fmt::format("the file ends where {} should be (truncated?)", what));
    }
  }

  std::string_view last() const { return last_; }
  std::string_view rest() const { return is_ascii() ? tokens_.rest() : bytes_; }
  /// Something but blanks is left.
  bool has_more() const { return rest().find_first_not_of(" \t\r\n") != std::string_view::npos; }

  /// Throws an error that points at the last value.
  [[noreturn]] void fail(const std::string& message) const { throw InputError(describe(last_, message)); }

  /// The message with a place that was last().
  std::string describe(std::string_view place, const std::string& message) const {
    if (!is_ascii()) {
      return fmt::format("{}: byte {}: {}", name_, place.data() - tokens_.source().text().data(), message);
    }
    const std::size_t blank = place.find_first_not_of(" \t\r\n");
    return tokens_.source().at(place.substr(std::min(blank, place.size())), message);
  }

 private:
  bool is_ascii() const { return format_ == PlyFormat::ascii; }

  const char* take(PlyType type, const std::string& what) {
    if (bytes_.size() < size_of(type)) fail(fmt::format("the file ends where {} should be (truncated?)", what));
    const char* const place = bytes_.data();
    bytes_.remove_prefix(size_of(type));
    return place;
  }

  Tokens tokens_;
  PlyFormat format_;
  const std::string& name_;
  std::string_view bytes_;
  std::string_view last_;
};

/// Which lists of corners an element has.
enum class Corners { none, polygon, strip };

bool is_list_of_corners(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Reads one element after the other into the mesh.
class PlyReader {
 public:
  PlyReader(Values& values, std::uint64_t vertices) : values_(values), vertices_(vertices) {}

  void read(const PlyElement& element) {
    const Corners corners = element.name == "face"        ? Corners::polygon
                            : element.name == "tristrips" ? Corners::strip
                                                          : Corners::none;
    for (std::uint64_t k = 0; k < element.count; ++k) {
      if (element.name == "vertex") mesh_.vertices.emplace_back();
      for (const PlyProperty& property : element.properties) {
        if (property.is_list) {
          read_list(property, is_list_of_corners(property) ? corners : Corners::none);
        } else {
          read_value(property, element.name == "vertex");
        }
      }
    }
  }

  objects::TriangleMesh finish(const std::string& name, Warnings* warnings) {
    if (values_.has_more()) {
      warn(warnings, values_.describe(values_.rest(), "what follows the elements of the header is not read"));
    }
    odd_.settle(mesh_, warnings,
                [&](std::string_view place, const std::string& what) { return values_.describe(place, what); });
    require_triangles(mesh_, name);
    return std::move(mesh_);
  }

 private:
  void read_value(const PlyProperty& property, bool is_vertex) {
    const bool is_place = is_vertex && (property.name == "x" || property.name == "y" || property.name == "z");
    if (!is_place) {
      values_.skip(property.type, property.name);
      return;
    }
    const double value = values_.next(property.type, property.name);
    objects::Vec3& vertex = mesh_.vertices.back();
    (property.name == "x" ? vertex.x : property.name == "y" ? vertex.y : vertex.z) = value;
    if (!std::isfinite(value)) odd_.add_vertex(mesh_.vertices.size() - 1, values_.last());
  }

  void read_list(const PlyProperty& property, Corners corners) {
    const double count = values_.next(property.count_type, property.name);
    if (!(count >= 0.0 && count == std::floor(count))) {
      values_.fail(fmt::format("{} has a length of {}", property.name, count));
    }
    if (corners == Corners::polygon && count < 3.0) odd_.add_face(values_.last());
    corners_.clear();
    for (double k = 0.0; k < count; ++k) {
      if (corners == Corners::none) {
        values_.skip(property.type, property.name);
      } else {
        read_corner(property, corners);
      }
    }
    if (corners == Corners::polygon) add_polygon(mesh_, corners_);
    if (corners == Corners::strip) add_strip();
  }

  void read_corner(const PlyProperty& property, Corners corners) {
    const double value = values_.next(property.type, property.name);
    if (corners == Corners::strip && value == -1.0) {
      add_strip();
      return;
    }
    if (!(value >= 0.0 && value < static_cast<double>(vertices_) && value == std::floor(value))) {
      values_.fail(fmt::format("there is no vertex {} ({} vertices, counted from 0)", value, vertices_));
    }
    corners_.push_back(static_cast<std::uint32_t>(value));
  }

  /// Every corner makes a triangle with the two before it; each second one runs the other way.
  void add_strip() {
    for (std::size_t k = 2; k < corners_.size(); ++k) {
      const std::size_t turn = k % 2;
      mesh_.triangles.push_back({corners_[k - 2 + turn], corners_[k - 1 - turn], corners_[k]});
    }
    corners_.clear();
  }

  Values& values_;
  std::uint64_t vertices_;  // that the header announces
  objects::TriangleMesh mesh_;
  OddParts odd_;
  std::vector<std::uint32_t> corners_;
};

bool has_scalar(const PlyElement& element, const char* name) {
  for (const PlyProperty& property : element.properties) {
    if (property.name == name && !property.is_list) return true;
  }
  return false;
}

/// Throws unless there are vertices with coordinates, and faces with corners. Returns how many vertices there are.
std::uint64_t require_surface(const PlyHeader& header, const std::string& name) {
  std::optional<std::uint64_t> vertices;
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      for (const char* axis : {"x", "y", "z"}) {
        if (!has_scalar(element, axis)) throw InputError(fmt::format("{}: vertex has no property {}", name, axis));
      }
      if (element.count > most_vertices) throw InputError(fmt::format("{}: too many vertices (at most 2^31)", name));
      if (vertices) throw InputError(fmt::format("{}: vertex is there twice", name));
      vertices = element.count;
    }
    if (element.name != "face" && element.name != "tristrips") continue;
    if (std::none_of(element.properties.begin(), element.properties.end(), is_list_of_corners)) {
      throw InputError(fmt::format("{}: {} has no list vertex_indices", name, element.name));
    }
    has_faces = true;
  }
  if (!vertices || !has_faces)
    throw InputError(fmt::format("{}: the file has no {}", name, vertices ? "face" : "vertex"));
  return *vertices;
}

}  // namespace

objects::TriangleMesh read_ply(std::string_view bytes, const std::string& name, Warnings* warnings) {
  if (bytes.starts_with("ply\rformat ascii")) return read_ply(*with_line_feeds(bytes), name, warnings);
  Tokens tokens(bytes, name);
  const PlyHeader header = read_ply_header(tokens);
  const std::uint64_t vertices = require_surface(header, name);
  Values values(tokens, header.format, name);
  PlyReader reader(values, vertices);
  for (const PlyElement& element : header.elements) reader.read(element);
  return reader.finish(name, warnings);
}

}  // namespace sandsim
