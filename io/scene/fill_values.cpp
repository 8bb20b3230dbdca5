#include "io/scene/fill_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "io/scene/quantity.hpp"

namespace sandsim {
namespace {

bool is_used_for_nodata(double value) {
  constexpr std::array used{-9999.0, -99999.0, -32767.0, -32768.0};
  constexpr double beyond_all_data = 1e30;
  return std::find(used.begin(), used.end(), value) != used.end() || std::abs(value) >= beyond_all_data;
}

}  // namespace

std::optional<FillValue> find_fill_value(const Raster& raster) {
  std::optional<FillValue> fill;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;
  for (std::size_t k = 0; k < raster.values.size(); ++k) {
    const double value = raster.values[k];
    if (std::isnan(value)) continue;
    if (!is_used_for_nodata(value)) {
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    } else if (!fill) {
      fill = {value, 1, k % raster.nx, k / raster.nx};
    } else if (value == fill->value) {
      ++fill->count;
    }
  }
  if (!fill || smallest > largest) return fill;
  const double distance = std::max(smallest - fill->value, fill->value - largest);
  return distance > largest - smallest ? fill : std::nullopt;
}

Complaint describe_fill_value(const FillValue& fill) {
  const std::string value = shortest_text(fill.value);
  return {"the raster holds " + value + ", which many programs write where there is no data",
          std::to_string(fill.count) + (fill.count == 1 ? " value" : " values") + ", the first in column " +
              std::to_string(fill.column) + " and row " + std::to_string(fill.row) +
              ", counted from 0 in the south-west",
          "If it means that, declare it: \"NODATA_value " + value +
              "\" in the header of an ESRI ASCII grid, \"gdal_edit.py -a_nodata " + value +
              "\" for other rasters, NaN in a .npy."};
}

}  // namespace sandsim
