#include "io/output/table_file.hpp"

#include <fmt/format.h>
#include <hdf5_hl.h>

#include <cmath>
#include <type_traits>

#include "io/hdf5/hdf5.hpp"
#include "io/output/atomic_hdf5.hpp"
#include "io/scene/quantity.hpp"

namespace sandsim {
namespace {

using hdf5::Handle;
using hdf5::require;

std::string field(double number) {
  return std::isnan(number) ? "" : shortest_text(number);
}
std::string field(std::int64_t number) {
  return std::to_string(number);
}
std::string field(const std::string& text) {
  return csv_field(text);
}

std::size_t row_count(const Table& table) {
  return table.columns.empty() ? 0
                               : std::visit([](const auto& values) { return values.size(); }, table.columns[0].values);
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type");
  require(H5Tset_size(type.id(), H5T_VARIABLE), "size a text type");
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text type UTF-8");
  return type;
}

Handle create_column(hid_t file, const Column& column, hid_t type, std::size_t rows) {
  const hsize_t size = rows;
  const std::string tried = "create " + column.name;
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, tried);
  return Handle(H5Dcreate2(file, column.name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                H5Dclose, tried);
}

Handle write_values(hid_t file, const Column& column, std::size_t rows) {
  return std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, std::string>) {
          const Handle type = text_type();
          Handle dataset = create_column(file, column, type.id(), rows);
          std::vector<const char*> texts;
          for (const std::string& value : values) texts.push_back(value.c_str());
          hdf5::write(dataset.id(), type.id(), texts.data());
          return dataset;
        } else {
          const hid_t type = std::is_same_v<Value, double> ? H5T_IEEE_F64LE : H5T_STD_I64LE;
          Handle dataset = create_column(file, column, type, rows);
          hdf5::write(dataset.id(), hdf5::native_type<Value>(), values.data());
          return dataset;
        }
      },
      column.values);
}

void write_columns(hid_t file, const Table& table) {
  for (const Column& column : table.columns) {
    const Handle dataset = write_values(file, column, row_count(table));
    hdf5::write_attribute(dataset.id(), "long_name", column.long_name);
    if (!column.units.empty()) hdf5::write_attribute(dataset.id(), "units", column.units);
    if (!column.role.empty()) hdf5::write_attribute(dataset.id(), "role", column.role);
    if (column.name == table.dimension) {
      require(H5DSset_scale(dataset.id(), column.name.c_str()), "make " + column.name + " a dimension");
    } else {
      const Handle scale = hdf5::open_dataset(file, table.dimension);
      require(H5DSattach_scale(dataset.id(), scale.id(), 0), "attach the dimension of " + column.name);
    }
  }
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_text(const Table& table) {
  std::string text;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    text += (k > 0 ? "," : "") + field(column.units.empty() ? column.name : column.name + " [" + column.units + ']');
  }
  text += '\n';
  for (std::size_t row = 0; row < row_count(table); ++row) {
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      text += k > 0 ? "," : "";
      text += std::visit([row](const auto& values) { return field(values[row]); }, table.columns[k].values);
    }
    text += '\n';
  }
  return text;
}

void write_table(const std::filesystem::path& path, const Table& table) {
  write_hdf5_atomically(path, [&table](hid_t file) {
    for (const auto& [name, text] : table.attributes) hdf5::write_attribute(file, name, text);
    write_columns(file, table);
  });
}

}  // namespace sandsim
