#include "io/scene/value_text.hpp"

namespace sandsim {

std::string in_quotes(const std::string& text) {
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7F) {
      result += "\\u00";
      result += digits[code >> 4];
      result += digits[code & 15];
    } else {
      result += c;
    }
  }
  return result + '"';
}

const char* map_unit(Dimension dimension) {
  switch (dimension) {
    case Dimension::angle:
      return "deg";
    case Dimension::length:
      return "m";
    default:
      return "";
  }
}

std::string value_text(const ScalarMap& value, const Rule& rule) {
  if (const double* number = std::get_if<double>(&value)) return value_text(*number, rule);
  const std::string of_unit = map_unit(rule.dimension);
  const std::string unit = of_unit.empty() ? "" : ", unit: " + of_unit;
  if (const auto* raster = std::get_if<RasterFile>(&value)) {
    return "{raster: " + in_quotes(raster->file) + unit +
           (raster->band ? ", band: " + std::to_string(*raster->band) : "") +
           (raster->variable ? ", variable: " + in_quotes(*raster->variable) : "") +
           (raster->first_row ? std::string(", first_row: ") + enum_name(*raster->first_row) : "") + '}';
  }
  const ZoneMap& zones = std::get<ZoneMap>(value);
  const PolygonFile& file = zones.polygons;
  return "{polygons: " + in_quotes(file.file) + (file.layer.empty() ? "" : ", layer: " + in_quotes(file.layer)) +
         ", attribute: " + in_quotes(file.attribute) + unit + ", elsewhere: " + value_text(zones.elsewhere, rule) + '}';
}

}  // namespace sandsim
