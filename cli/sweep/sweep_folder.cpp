#include "cli/sweep/sweep_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>

#include "cli/text.hpp"
#include "io/output/atomic_file.hpp"
#include "io/output/json.hpp"
#include "io/output/output_directory.hpp"
#include "io/output/run_report.hpp"
#include "io/output/version.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

std::string manifest_text(const Sweep& sweep) {
  JsonWriter json;
  const auto add_list = [&json](const char* name, const std::vector<std::string>& values) {
    json.begin_array(name);
    for (const std::string& value : values) {
      json.value(value);
    }
    json.end_array();
  };
  json.begin_object();
  json.member("source", source_line()).member("written", time_stamp());
  json.member("scene", fs::absolute(sweep.scene).lexically_normal().string());
  add_list("set", sweep.overrides);
  add_list("keys", sweep.keys);
  json.begin_array("cases");
  for (const SweepCase& one : sweep.cases) {
    json.begin_object();
    add_list("values", one.values);
    json.member("folder", one.folder).member("scene_hash", one.scene_hash);
    if (!one.problem.empty()) {
      json.member("problem", one.problem);
    }
    json.end_object();
  }
  json.end_array().end_object();
  return json.text();
}

/// The cases of `sweep` that `earlier` has as well.
std::size_t shared_cases(const Sweep& earlier, const Sweep& sweep) {
  std::set<std::string> folders;
  for (const SweepCase& one : sweep.cases) {
    folders.insert(one.folder);
  }
  return static_cast<std::size_t>(std::count_if(earlier.cases.begin(), earlier.cases.end(),
                                                [&](const SweepCase& one) { return folders.count(one.folder) > 0; }));
}

/// The results of the cases, and what else a sweep writes; never anything that was put there by others.
void remove_results(const Sweep& earlier, const SweepFiles& files) {
  std::error_code ignored;
  for (const SweepCase& one : earlier.cases) {
    const fs::path folder = files.directory / one.folder;
    if (!fs::exists(folder, ignored)) {
      continue;
    }
    prepare_output_directory(folder, true, false);
    fs::remove(folder / "case.lock", ignored);
    fs::remove(folder, ignored);  // unless something else is in it
  }
  for (const fs::path& file : {files.manifest, files.csv, files.series, files.script}) {
    fs::remove(file, ignored);
  }
}

void replace_or_refuse(const Sweep& earlier, const Sweep& sweep, const SweepFiles& files, bool overwrite) {
  if (overwrite) {
    remove_results(earlier, files);
    return;
  }
  const std::size_t shared = shared_cases(earlier, sweep);
  if (shared == earlier.cases.size()) {
    return;
  }
  throw OutputError(fmt::format(
      "{}: holds another sweep: {} over {}, of whose {} cases this one has {}; or its scene, an input file "
      "or a default has changed since\n"
      "  name another directory with -o, or replace it with --overwrite; `sandsim sweep {}` goes on with it",
      files.directory.string(), earlier.scene.string(), join(", ", earlier.keys), earlier.cases.size(), shared,
      files.directory.string()));
}

/// Nothing is there, or only the lock of a sweep that ended before it had written anything.
bool is_free(const SweepFiles& files) {
  std::error_code error;
  if (!fs::exists(files.directory, error)) {
    return true;
  }
  if (!fs::is_directory(files.directory, error)) {
    return false;
  }
  const fs::directory_iterator entries(files.directory, error);
  return !error && std::all_of(begin(entries), end(entries), [&](const fs::directory_entry& entry) {
    return entry.path().filename() == files.lock.filename();
  });
}

}  // namespace

SweepFiles::SweepFiles(const fs::path& in)
    : directory(in),
      manifest(in / "sweep.json"),
      csv(in / "summary.csv"),
      series(in / "summary.h5"),
      script(in / "sweep.sbatch"),
      lock(in / "sweep.lock") {}

bool holds_sweep(const fs::path& directory) {
  std::error_code ignored;
  return fs::is_regular_file(SweepFiles(directory).manifest, ignored);
}

Sweep read_manifest(const SweepFiles& files) {
  try {
    const YAML::Node root = YAML::LoadFile(files.manifest.string());  // JSON is YAML.
    Sweep sweep;
    sweep.scene = root["scene"].as<std::string>();
    sweep.overrides = root["set"].as<std::vector<std::string>>();
    sweep.keys = root["keys"].as<std::vector<std::string>>();
    for (const YAML::Node& node : root["cases"]) {
      SweepCase one;
      one.values = node["values"].as<std::vector<std::string>>();
      one.folder = node["folder"].as<std::string>();
      one.scene_hash = node["scene_hash"].as<std::string>();
      one.problem = node["problem"].as<std::string>("");
      if (one.values.size() != sweep.keys.size()) {
        throw InputError("a case has not one value a key");
      }
      sweep.cases.push_back(one);
    }
    return sweep;
  } catch (const std::exception& problem) {
    throw InputError(fmt::format("{}: no sweep of sandsim ({})", files.manifest.string(), problem.what()));
  }
}

FileLock lock_sweep(const SweepFiles& files) {
  FileLock lock(files.lock, FileLock::Mode::try_once);
  if (lock.taken()) {
    return lock;
  }
  throw OutputError(fmt::format("{}: another process is at work on this sweep\n  wait for it, or end it first",
                                files.directory.string()));
}

FileLock prepare_sweep_directory(const Sweep& sweep, const SweepFiles& files, bool overwrite) {
  const fs::path& directory = files.directory;
  const bool is_earlier = holds_sweep(directory);
  if (!is_earlier && !is_free(files)) {
    throw OutputError(
        fmt::format("{}: is not empty, and holds no sweep. Name another directory with -o", directory.string()));
  }
  prepare_output_directory(directory, false, true);
  FileLock lock = lock_sweep(files);  // before anything is removed
  if (is_earlier) {
    replace_or_refuse(read_manifest(files), sweep, files, overwrite);
  }
  write_file_atomically(files.manifest, manifest_text(sweep));
  return lock;
}

}  // namespace sandsim::cli
