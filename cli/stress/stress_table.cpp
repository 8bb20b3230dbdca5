#include "cli/stress/stress_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "cli/text.hpp"
#include "io/output/table_file.hpp"

namespace sandsim::cli {

namespace {

/// The first line of a text as a field.
std::string csv_line(const std::string& text) {
  return csv_field(text.substr(0, text.find('\n')));
}

std::string csv_numbers(const StressRow& row, const std::string& device) {
  const Measurement& m = row.measured;
  return fmt::format("{},{},{},{},{},{},{},{:.3e},{:.4e},{:.4g},{:.4e},{:.4g},{:.3f},{},{}\n", row.variant.scheme,
                     std::max(1, row.variant.order), row.variant.precision_name(), device, row.verdict(),
                     csv_line(row.failed_criteria()), m.steps, m.volume_error, m.max_speed, m.relative_speed(),
                     m.dt_min, m.relative_step(), m.wall_time, m.exit_code, csv_line(m.message));
}

constexpr const char* number_columns =
    "scheme,order,precision,device,verdict,failed,steps,volume_error,max_speed,relative_speed,dt_min,relative_step,"
    "wall_time,exit_code,message\n";

/// Counts of the rows of a variant that satisfy a condition.
template <class Condition>
std::size_t count(const StressTable& table, std::size_t variant, const Condition& condition) {
  const std::size_t variants = all_variants().size();
  std::size_t found = 0;
  for (std::size_t k = variant; k < table.rows.size(); k += variants) {
    found += condition(table.rows[k]) ? 1 : 0;
  }
  return found;
}

std::vector<std::string> themes_of(const StressTable& table) {
  std::vector<std::string> themes;
  for (const StressCase& each : table.cases) {
    if (themes.empty() || themes.back() != each.theme) {
      themes.push_back(each.theme);
    }
  }
  return themes;
}

std::string variant_columns() {
  std::string header;
  for (const Variant& variant : all_variants()) {
    header += fmt::format(" {} {} |", variant.name(), variant.precision_name());
  }
  return header;
}

}  // namespace

std::string StressRow::failed_criteria() const {
  std::vector<std::string> names;
  for (const Finding& finding : findings) {
    names.push_back(finding.criterion);
  }
  return join(", ", names);
}

bool StressTable::passed() const {
  return std::all_of(rows.begin(), rows.end(), [](const StressRow& row) { return row.passed() || row.is_known; });
}

std::string stress_csv(const StressTable& table) {
  std::string text = std::string("theme,case,") + number_columns;
  for (const StressRow& row : table.rows) {
    const StressCase& its = table.cases[row.index];
    text += fmt::format("{},{},", its.theme, csv_line(its.name)) + csv_numbers(row, table.device);
  }
  return text;
}

std::string maps_csv(const StressTable& table) {
  std::string text = std::string("map,x,y,") + number_columns;
  for (const StressRow& row : table.rows) {
    const MapPlace& place = *table.cases[row.index].place;
    text += fmt::format("{},{},{},", place.map, place.x, place.y) + csv_numbers(row, table.device);
  }
  return text;
}

std::string stress_markdown(const StressTable& table) {
  const std::size_t variants = all_variants().size();
  std::string text = "| case |" + variant_columns() + " what is extreme |\n|---|";
  for (std::size_t k = 0; k <= variants; ++k) {
    text += "---|";
  }
  text += '\n';
  std::string reasons;
  for (std::size_t k = 0; k < table.cases.size(); ++k) {
    const StressCase& its = table.cases[k];
    text += fmt::format("| {} |", its.name);
    std::string reason;
    for (std::size_t v = 0; v < variants; ++v) {
      const StressRow& row = table.rows[k * variants + v];
      reason = row.is_known ? its.paper : reason;
      text += row.passed() ? " pass |" : fmt::format(" {}: {} |", row.verdict(), row.failed_criteria());
    }
    text += fmt::format(" {} |\n", its.meaning);
    if (!reason.empty()) {
      reasons += fmt::format("- {}: {}.\n", its.name, reason);
    }
  }
  return text + (reasons.empty() ? "" : "\nWhy failures are known:\n\n" + reasons);
}

std::string count_markdown(const StressTable& table) {
  const std::vector<Variant> variants = all_variants();
  std::string text = "| theme | cases |" + variant_columns() + "\n|---|---|";
  for (std::size_t v = 0; v < variants.size(); ++v) {
    text += "---|";
  }
  text += '\n';
  std::vector<std::string> themes = themes_of(table);
  themes.push_back("all");
  for (const std::string& theme : themes) {
    const auto is_in = [&](const StressRow& row) { return theme == "all" || table.cases[row.index].theme == theme; };
    text += fmt::format("| {} | {} |", theme, count(table, 0, is_in));
    for (std::size_t v = 0; v < variants.size(); ++v) {
      text += fmt::format(" {} |", count(table, v, [&](const StressRow& row) { return is_in(row) && row.passed(); }));
    }
    text += '\n';
  }
  return text;
}

void print_counts(std::ostream& out, const StressTable& table, const std::string& name) {
  const std::vector<Variant> variants = all_variants();
  out << fmt::format("{}: {}\n", name, table.cases.size());
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const auto is = [&](const char* verdict) {
      return count(table, v, [&](const StressRow& row) { return row.verdict() == std::string_view(verdict); });
    };
    out << fmt::format("  {:<18}{:<9}{:>5} passed{:>5} failed as known{:>5} FAILED\n", variants[v].name(),
                       variants[v].precision_name(), is("pass"), is("known"), is("FAIL"));
  }
}

void print_failures(std::ostream& out, const StressTable& table) {
  for (const StressRow& row : table.rows) {
    if (row.passed() || row.is_known) {
      continue;
    }
    out << fmt::format("FAILED  {}, {} {}\n", table.cases[row.index].name, row.variant.name(),
                       row.variant.precision_name());
    for (const Finding& finding : row.findings) {
      out << fmt::format("        {}: {}\n", finding.criterion, finding.what);
    }
  }
}

}  // namespace sandsim::cli
