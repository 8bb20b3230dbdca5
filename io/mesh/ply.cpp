#include <fmt/format.h>

#include <cmath>
#include <optional>

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

  /// `what` it is stands in errors.
  double next(PlyType type, const std::string& what) {
    if (format_ == PlyFormat::ascii) {
      last_ = tokens_.rest();
      return tokens_.number(what);
    }
    last_ = bytes_;
    if (bytes_.size() < size_of(type)) fail(fmt::format("the file ends where {} should be (truncated?)", what));
    const double value = load(bytes_.data(), type, format_ == PlyFormat::big_endian);
    bytes_.remove_prefix(size_of(type));
    if (!std::isfinite(value)) fail(fmt::format("{} is not finite", what));
    return value;
  }

  /// Throws an error that points at the last value.
  [[noreturn]] void fail(const std::string& message) const {
    const std::string_view text = tokens_.source().text();
    const std::size_t blank = format_ == PlyFormat::ascii ? last_.find_first_not_of(" \t\r\n") : 0;
    if (format_ == PlyFormat::ascii) tokens_.source().fail(last_.substr(std::min(blank, last_.size())), message);
    throw InputError(fmt::format("{}: byte {}: {}", name_, last_.data() - text.data(), message));
  }

 private:
  Tokens tokens_;
  PlyFormat format_;
  const std::string& name_;
  std::string_view bytes_;
  std::string_view last_;
};

/// Reads one element after the other into the mesh.
class PlyReader {
 public:
  PlyReader(Values& values, objects::TriangleMesh& mesh) : values_(values), mesh_(mesh) {}

  void read(const PlyElement& element) {
    for (std::uint64_t k = 0; k < element.count; ++k) {
      vertex_ = {};
      for (const PlyProperty& property : element.properties) {
        if (property.is_list) {
          read_list(property, element.name == "face" && is_corners(property.name));
        } else {
          keep(property.name, values_.next(property.type, property.name));
        }
      }
      if (element.name == "vertex") mesh_.vertices.push_back(vertex_);
    }
  }

  static bool is_corners(const std::string& name) { return name == "vertex_indices" || name == "vertex_index"; }

 private:
  void keep(const std::string& name, double value) {
    if (name == "x") vertex_.x = value;
    if (name == "y") vertex_.y = value;
    if (name == "z") vertex_.z = value;
  }

  void read_list(const PlyProperty& property, bool is_face) {
    const double count = values_.next(property.count_type, property.name);
    if (count < 0.0 || count != std::floor(count)) {
      values_.fail(fmt::format("{} has a length of {}", property.name, count));
    }
    if (is_face && count < 3.0) values_.fail(fmt::format("a face with {} vertices", count));
    corners_.clear();
    for (double k = 0.0; k < count; ++k) {
      const double value = values_.next(property.type, property.name);
      if (!is_face) continue;
      if (!(value >= 0.0 && value < static_cast<double>(mesh_.vertices.size()) && value == std::floor(value))) {
        values_.fail(fmt::format("there is no vertex {} ({} vertices, counted from 0)", value, mesh_.vertices.size()));
      }
      corners_.push_back(static_cast<std::uint32_t>(value));
    }
    if (is_face) add_polygon(mesh_, corners_);
  }

  Values& values_;
  objects::TriangleMesh& mesh_;
  objects::Vec3 vertex_;
  std::vector<std::uint32_t> corners_;
};

bool has_scalar(const PlyElement& element, const char* name) {
  for (const PlyProperty& property : element.properties) {
    if (property.name == name && !property.is_list) return true;
  }
  return false;
}

/// Throws unless there are vertices with coordinates, and then faces with corners.
void require_surface(const PlyHeader& header, const std::string& name) {
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      for (const char* axis : {"x", "y", "z"}) {
        if (!has_scalar(element, axis)) throw InputError(fmt::format("{}: vertex has no property {}", name, axis));
      }
      if (element.count > most_vertices) throw InputError(fmt::format("{}: too many vertices (at most 2^31)", name));
      if (has_vertices) throw InputError(fmt::format("{}: vertex is there twice", name));
      has_vertices = true;
    }
    if (element.name != "face") continue;
    if (!has_vertices) throw InputError(fmt::format("{}: the faces come before the vertices", name));
    for (const PlyProperty& property : element.properties) {
      if (property.is_list && PlyReader::is_corners(property.name)) return;
    }
    throw InputError(fmt::format("{}: face has no list vertex_indices", name));
  }
  throw InputError(fmt::format("{}: the file has no {}", name, has_vertices ? "face" : "vertex"));
}

}  // namespace

objects::TriangleMesh read_ply(std::string_view bytes, const std::string& name) {
  Tokens tokens(bytes, name);
  const PlyHeader header = read_ply_header(tokens);
  require_surface(header, name);
  objects::TriangleMesh mesh;
  Values values(tokens, header.format, name);
  PlyReader reader(values, mesh);
  for (const PlyElement& element : header.elements) reader.read(element);
  require_triangles(mesh, name);
  return mesh;
}

}  // namespace sandsim
