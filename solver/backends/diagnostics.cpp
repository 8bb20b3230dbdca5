#include "solver/backends/diagnostics.hpp"

#include <stdexcept>

namespace sandsim {

CellField cell_field(const std::string& name) {
  constexpr std::pair<const char*, CellField> fields[] = {
      {"depth", CellField::depth},
      {"momentum_x", CellField::momentum_x},
      {"momentum_y", CellField::momentum_y},
      {"velocity_x", CellField::velocity_x},
      {"velocity_y", CellField::velocity_y},
      {"surface", CellField::surface},
      {"bed", CellField::bed},
      {"flowing_depth", CellField::flowing_depth},
      {"flow_bed", CellField::flow_bed},
  };
  for (const auto& [known, field] : fields) {
    if (name == known) {
      return field;
    }
  }
  throw std::invalid_argument("no field is called '" + name + "'");
}

}  // namespace sandsim
