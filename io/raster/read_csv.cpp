#include "io/raster/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/raster/source_text.hpp"

namespace sandsim {
namespace {

constexpr std::size_t most_csv_bytes = std::size_t{1} << 28;

using ColumnNames = std::vector<std::string_view>;
using Columns = std::vector<std::vector<double>>;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Hands out the lines that hold something, without comments.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// The next line; empty at the end.
  std::string_view take() {
    while (!rest_.empty()) {
      const std::size_t length = std::min(rest_.find('\n'), rest_.size());
      const std::string_view line = rest_.substr(0, length);
      rest_.remove_prefix(std::min(length + 1, rest_.size()));
      if (const std::string_view content = trimmed(line.substr(0, line.find('#'))); !content.empty()) {
        return content;
      }
    }
    return {};
  }

 private:
  std::string_view rest_;
};

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t length = std::min(line.find(','), line.size());
    // An empty field still points to where it should be.
    const std::string_view field = trimmed(line.substr(0, length));
    fields.push_back(field.empty() ? line.substr(0, 0) : field);
    if (length == line.size()) {
      return fields;
    }
    line.remove_prefix(length + 1);
  }
}

/// For each column of the file the column of the result. Throws unless the names are there once each and alone.
std::vector<std::size_t> read_header(const SourceText& source, std::string_view line, const ColumnNames& names) {
  const std::vector<std::string_view> fields = split(line);
  std::vector<std::size_t> order(fields.size());
  std::vector<bool> seen(names.size());
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto found = std::find(names.begin(), names.end(), fields[k]);
    if (found == names.end()) {
      const std::string_view nearest = nearest_name(fields[k], names);
      const bool other_separator = fields[k].find_first_of("; \t") != std::string_view::npos;
      source.fail(fields[k],
                  fmt::format("{} is no column name. {}", in_quotes(fields[k]),
                              other_separator   ? "Separate the columns by commas"
                              : nearest.empty() ? fmt::format("The first line is \"{}\"", fmt::join(names, ","))
                                                : fmt::format("Did you mean {}?", nearest)));
    }
    const auto column = static_cast<std::size_t>(found - names.begin());
    if (seen[column]) {
      source.fail(fields[k], fmt::format("the column {} is there twice. Remove one", *found));
    }
    seen[column] = true;
    order[k] = column;
  }
  for (std::size_t column = 0; column < names.size(); ++column) {
    if (!seen[column]) {
      source.fail(line, fmt::format("the column {} is missing. The first line is \"{}\"", names[column],
                                    fmt::join(names, ",")));
    }
  }
  return order;
}

double read_field(const SourceText& source, std::string_view field, std::string_view column) {
  if (field.empty()) {
    source.fail(field, fmt::format("{} is empty. Remove the line or fill the field", column));
  }
  const ParsedNumber number = parse_number(field);
  if (!number.value) {
    source.fail(field, fmt::format("{}: {}", column, number.problem));
  }
  if (!std::isfinite(*number.value)) {
    source.fail(field, fmt::format("{} = {} is not finite. Remove the line", column, in_quotes(field)));
  }
  return *number.value;
}

void read_row(const SourceText& source, std::string_view line, const ColumnNames& names,
              const std::vector<std::size_t>& order, Columns& columns) {
  const std::vector<std::string_view> fields = split(line);
  if (fields.size() != names.size()) {
    source.fail(line, fmt::format("{} fields where there are {} columns. Separate fields by commas and write decimals "
                                  "with a point",
                                  fields.size(), names.size()));
  }
  for (std::size_t k = 0; k < fields.size(); ++k) {
    columns[order[k]].push_back(read_field(source, fields[k], names[order[k]]));
  }
  const std::vector<double>& ascending = columns[0];
  if (ascending.size() > 1 && !(ascending.back() > ascending[ascending.size() - 2])) {
    source.fail(line, fmt::format("{} = {} does not ascend (the line before has {}). Sort the lines", names[0],
                                  ascending.back(), ascending[ascending.size() - 2]));
  }
}

Columns read_columns(std::string_view text, const std::string& name, const ColumnNames& names) {
  const SourceText source(text, name);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  Lines lines(text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text);
  const std::string_view header = lines.take();
  if (header.empty()) {
    source.fail_at_end(fmt::format("the file is empty. The first line is \"{}\"", fmt::join(names, ",")));
  }
  const std::vector<std::size_t> order = read_header(source, header, names);
  Columns columns(names.size());
  for (std::string_view line = lines.take(); !line.empty(); line = lines.take()) {
    read_row(source, line, names, order, columns);
  }
  if (columns[0].size() < 2) {
    source.fail_at_end(fmt::format("{} points (a curve has at least 2)", columns[0].size()));
  }
  return columns;
}

}  // namespace

Profile read_profile_csv(std::string_view text, const std::string& name) {
  Columns columns = read_columns(text, name, {"x_m", "depth_m"});
  return {name, std::move(columns[0]), std::move(columns[1])};
}

Profile read_profile_csv(const std::filesystem::path& path) {
  return read_profile_csv(read_file_bytes(path, most_csv_bytes), path.string());
}

FrontCurve read_front_csv(std::string_view text, const std::string& name) {
  Columns columns = read_columns(text, name, {"time_s", "front_m"});
  return {name, std::move(columns[0]), std::move(columns[1])};
}

FrontCurve read_front_csv(const std::filesystem::path& path) {
  return read_front_csv(read_file_bytes(path, most_csv_bytes), path.string());
}

PathTable read_path_csv(std::string_view text, const std::string& name) {
  Columns columns = read_columns(text, name, {"time_s", "x_m", "y_m", "z_m"});
  PathTable path{name, std::move(columns[0]), {}};
  for (std::size_t k = 0; k < path.time.size(); ++k) {
    path.position.push_back({columns[1][k], columns[2][k], columns[3][k]});
  }
  return path;
}

PathTable read_path_csv(const std::filesystem::path& path) {
  return read_path_csv(read_file_bytes(path, most_csv_bytes), path.string());
}

}  // namespace sandsim
