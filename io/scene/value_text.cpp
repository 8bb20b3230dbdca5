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
  const RasterFile& raster = std::get<RasterFile>(value);
  const std::string unit = map_unit(rule.dimension);
  return "{raster: " + in_quotes(raster.file) + (unit.empty() ? "" : ", unit: " + unit) +
         (raster.first_row ? std::string(", first_row: ") + enum_name(*raster.first_row) : "") + '}';
}

}  // namespace sandsim
