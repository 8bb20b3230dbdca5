// A table of cases as CSV and as HDF5 that is also NetCDF-4.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sandsim {

struct Column {
  std::string name;
  std::string units;      // empty for pure numbers and texts
  std::string long_name;  // for people
  std::string role;       // "parameter" for what was varied, "metric" for what came of it, "" for the rest
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;
};

struct Table {
  std::string dimension;  // of the rows; a column of that name gives its coordinates
  std::vector<Column> columns;
  std::vector<std::pair<std::string, std::string>> attributes;
};

/// A field of a CSV file (RFC 4180): in quotes where it has to be.
std::string csv_field(const std::string& text);

/// RFC 4180, with "name [units]" in the first line. Numbers read back to the same bits; NaN is an empty field.
std::string csv_text(const Table& table);

/// One data set a column along the table's dimension, with units, long_name and role as attributes. The file is whole
/// or not there. Throws OutputError.
void write_table(const std::filesystem::path& path, const Table& table);

}  // namespace sandsim
