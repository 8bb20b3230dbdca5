#include "cli/cases/case_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/output/output_directory.hpp"
#include "io/output/series_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

std::optional<CaseReport> read_case_report(const fs::path& directory) {
  const OutputFiles files(directory);
  CaseReport report;
  try {
    StoredRun stored = read_run_report(files.report);
    report.run = std::move(stored.report);
    report.scene_hash = std::move(stored.scene_hash);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (report.run.exit_code != ExitCode::done) {
    return report;
  }
  const hdf5::Session session;
  try {
    const SeriesReader series(files.series);
    report.has_one_row = series.read_coordinate("y").size() == 1;
  } catch (const hdf5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", files.series.string(), failure.what()));
  }
  return report;
}

}  // namespace sandsim::cli
