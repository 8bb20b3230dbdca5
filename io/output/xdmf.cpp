#include "io/output/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "io/output/atomic_file.hpp"
#include "io/output/series_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

namespace fs = std::filesystem;

/// What a frame's description needs: all frames share it.
struct Layout {
  std::string file;  // the series, relative to the description
  std::size_t nx = 0, ny = 0;
  double origin_x = 0.0, origin_y = 0.0;      // [m] corner of the grid
  double spacing_x = 1.0, spacing_y = 1.0;    // [m]
  std::vector<const StoredVariable*> fields;  // (time, y, x)
  std::vector<const StoredVariable*> maps;    // (y, x)
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// Spacing of evenly spaced centres; a single row takes the other direction's.
double spacing_of(const std::vector<double>& centres, const std::vector<double>& other) {
  const std::vector<double>& axis = centres.size() > 1 ? centres : other;
  if (axis.size() < 2) return 1.0;
  return (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1);
}

Layout layout_of(const SeriesReader& series, std::string file) {
  Layout layout;
  layout.file = std::move(file);
  const std::vector<double> x = series.read_coordinate("x");
  const std::vector<double> y = series.read_coordinate("y");
  layout.nx = x.size();
  layout.ny = y.size();
  layout.spacing_x = spacing_of(x, y);
  layout.spacing_y = spacing_of(y, x);
  layout.origin_x = x.empty() ? 0.0 : x.front() - 0.5 * layout.spacing_x;
  layout.origin_y = y.empty() ? 0.0 : y.front() - 0.5 * layout.spacing_y;
  for (const StoredVariable& variable : series.variables()) {
    if (variable.has_dimensions({"time", "y", "x"})) layout.fields.push_back(&variable);
    if (variable.has_dimensions({"y", "x"})) layout.maps.push_back(&variable);
  }
  return layout;
}

/// One layer of box-shaped cells, since readers find no cells in a mesh without thickness. The mesh is given by its
/// nodes, and the slowest index is z.
std::string mesh(const Layout& l) {
  return fmt::format(
      "        <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"2 {} {}\"/>\n"
      "        <Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n"
      "          <DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"3\">0 {} {}</DataItem>\n"
      "          <DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"3\">{} {} {}</DataItem>\n"
      "        </Geometry>\n",
      l.ny + 1, l.nx + 1, l.origin_y, l.origin_x, l.spacing_x, l.spacing_y, l.spacing_x);
}

/// One frame of a field. The slab has a leading 1: without it the values are silently wrong.
std::string field(const Layout& l, const StoredVariable& variable, std::size_t frame) {
  return fmt::format(
      "        <Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Cell\">\n"
      "          <DataItem ItemType=\"HyperSlab\" Type=\"HyperSlab\" Dimensions=\"1 {1} {2}\">\n"
      "            <DataItem Format=\"XML\" Dimensions=\"3 3\">{3} 0 0 1 1 1 1 {1} {2}</DataItem>\n"
      "            <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"{4}\" Dimensions=\"{5} {1} {2}\">"
      "{6}:/{0}</DataItem>\n"
      "          </DataItem>\n"
      "        </Attribute>\n",
      variable.name, l.ny, l.nx, frame, variable.element_size, variable.extent.front(), escaped(l.file));
}

/// A map has the leading 1 as well, as if it were three-dimensional.
std::string map(const Layout& l, const StoredVariable& variable) {
  return fmt::format(
      "        <Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Cell\">\n"
      "          <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"{3}\" Dimensions=\"1 {1} {2}\">"
      "{4}:/{0}</DataItem>\n"
      "        </Attribute>\n",
      variable.name, l.ny, l.nx, variable.element_size, escaped(l.file));
}

/// A collection of frames; content(frame) is what each holds.
template <class Content>
std::string collection(const std::vector<double>& times, const Content& content) {
  std::string text =
      "<?xml version=\"1.0\" ?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"2.0\">\n  <Domain>\n"
      "    <Grid Name=\"sandsim\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    text += fmt::format("      <Grid Name=\"frame {}\" GridType=\"Uniform\">\n        <Time Value=\"{}\"/>\n", frame,
                        times[frame]);
    text += content(frame) + "      </Grid>\n";
  }
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

std::string fields_of(const Layout& layout, std::size_t frame) {
  std::string text = mesh(layout);
  for (const StoredVariable* variable : layout.fields) text += field(layout, *variable, frame);
  for (const StoredVariable* variable : layout.maps) text += map(layout, *variable);
  return text;
}

/// One frame of a variable over (time, particle) or (time, particle, axis).
std::string particle_values(const StoredVariable& variable, const std::string& file, std::size_t frame) {
  const bool vector = variable.extent.size() == 3;
  const std::string extent = fmt::format("{}", fmt::join(variable.extent.begin() + 1, variable.extent.end(), " "));
  const std::string type = variable.name == "particle_position" ? "Float" : variable.element_size == 1 ? "Char" : "Int";
  return fmt::format(
      "          <DataItem ItemType=\"HyperSlab\" Type=\"HyperSlab\" Dimensions=\"1 {0}\">\n"
      "            <DataItem Format=\"XML\" Dimensions=\"3 {1}\">{2} {3} 1 {0}</DataItem>\n"
      "            <DataItem Format=\"HDF\" NumberType=\"{4}\" Precision=\"{5}\" Dimensions=\"{6} {0}\">"
      "{7}:/{8}</DataItem>\n"
      "          </DataItem>\n",
      extent, vector ? 3 : 2, frame, vector ? "0 0 1 1 1" : "0 1 1", type, variable.element_size,
      variable.extent.front(), escaped(file), variable.name);
}

std::string particles_of(const SeriesReader& series, const std::string& file, std::size_t frame) {
  const StoredVariable& position = *series.find("particle_position");
  std::string text =
      fmt::format("        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n", position.extent[1]);
  text +=
      "        <Geometry GeometryType=\"XYZ\">\n" + particle_values(position, file, frame) + "        </Geometry>\n";
  for (const char* name : {"particle_id", "particle_visible"}) {
    text += fmt::format("        <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Node\">\n", name) +
            particle_values(*series.find(name), file, frame) + "        </Attribute>\n";
  }
  return text;
}

/// describe(series, its path relative to the description) gives the text; none if there is nothing to describe.
template <class Describe>
bool write_description(const fs::path& series_file, const fs::path& xdmf_file, const Describe& describe) {
  std::string text;
  {
    const hdf5::Session session;
    try {
      const SeriesReader series(series_file);
      const fs::path relative = fs::absolute(series_file).lexically_relative(fs::absolute(xdmf_file).parent_path());
      if (series.frames() == 0) return false;
      text = describe(series, relative.string());
    } catch (const hdf5::Failure& failure) {
      throw InputError(fmt::format("{}: {}", series_file.string(), failure.what()));
    }
  }
  if (text.empty()) return false;
  write_file_atomically(xdmf_file, text);
  return true;
}

}  // namespace

bool write_xdmf(const fs::path& series_file, const fs::path& xdmf_file) {
  return write_description(series_file, xdmf_file, [](const SeriesReader& series, const std::string& path) {
    const Layout layout = layout_of(series, path);
    if (layout.fields.empty()) return std::string();
    return collection(series.times(), [&](std::size_t frame) { return fields_of(layout, frame); });
  });
}

bool write_particle_xdmf(const fs::path& series_file, const fs::path& xdmf_file) {
  return write_description(series_file, xdmf_file, [](const SeriesReader& series, const std::string& path) {
    if (series.find("particle_position") == nullptr) return std::string();
    return collection(series.times(), [&](std::size_t frame) { return particles_of(series, path, frame); });
  });
}

}  // namespace sandsim
