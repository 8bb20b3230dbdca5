#include "cli/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "cli/input_files.hpp"
#include "cli/text.hpp"
#include "io/output/scene_hash.hpp"
#include "io/scene/node.hpp"
#include "io/scene/scene_reader.hpp"
#include "solver/errors.hpp"

namespace sandsim::cli {

namespace {

std::string folder_of(const std::string& hash) {
  return "cases/" + hash.substr(hash.find(':') + 1);
}

/// The reader calls every override "--set"; to the user those that vary are values of --vary.
std::string in_terms_of_vary(const std::string& message, const std::vector<std::string>& varied) {
  const std::string option = "--set ";
  std::istringstream lines(message);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const bool is_varied = std::any_of(varied.begin(), varied.end(), [&](const std::string& text) {
      return line.starts_with(option + shown(text, 200) + ':');
    });
    result += (result.empty() ? "" : "\n") + (is_varied ? "--vary " + line.substr(option.size()) : line);
  }
  return result;
}

/// A message without its numbers: ten values that lack a unit are one problem.
std::string without_digits(std::string line) {
  std::erase_if(line, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return line;
}

void require_distinct(const Sweep& sweep) {
  std::map<std::string, std::size_t> first;
  for (std::size_t k = 0; k < sweep.cases.size(); ++k) {
    const auto [found, is_new] = first.emplace(sweep.cases[k].folder, k);
    if (!is_new) {
      throw SceneError(
          fmt::format("cases {} and {} are the same scene ({} and {}).\n"
                      "  Remove one of the values, or a key that has no effect.",
                      found->second + 1, k + 1, sweep.description_of(sweep.cases[found->second]),
                      sweep.description_of(sweep.cases[k])));
    }
  }
}

}  // namespace

std::vector<std::string> Sweep::overrides_of(const SweepCase& one) const {
  std::vector<std::string> all = overrides;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    all.push_back(keys[k] + '=' + one.values[k]);
  }
  return all;
}

std::string Sweep::description_of(const SweepCase& one) const {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    parts.push_back(keys[k] + '=' + one.values[k]);
  }
  return join(", ", parts);
}

SweepCase resolve_case(const Sweep& sweep, const std::vector<std::string>& values, std::vector<std::string>* warnings) {
  SweepCase result{values, {}, {}, {}};
  const std::vector<std::string> overrides = sweep.overrides_of(result);
  try {
    const Scene scene = read_scene(sweep.scene, overrides, warnings);
    result.scene_hash = hash_of(scene, sweep.scene);
    const auto references = reference_files(scene, sweep.scene.parent_path());
    result.folder = folder_of(references.empty() ? result.scene_hash : scene_hash(result.scene_hash, references));
  } catch (const SceneError& error) {
    const Sweep varied{{}, {}, sweep.keys, {}, {}};
    result.problem = in_terms_of_vary(error.what(), varied.overrides_of(result));
    result.folder = folder_of(scene_hash("invalid\n" + join("\n", overrides), {}));
  }
  return result;
}

Sweep resolve_sweep(const SweepPlan& plan) {
  Sweep sweep{plan.scene, plan.overrides, plan.keys(), {}, {}};
  std::set<std::string> seen;
  for (const std::vector<std::string>& values : plan.cases()) {
    std::vector<std::string> warnings;
    sweep.cases.push_back(resolve_case(sweep, values, &warnings));
    for (const std::string& warning : warnings) {
      if (seen.insert(without_digits(warning)).second) {
        sweep.warnings.push_back(warning);
      }
    }
  }
  require_distinct(sweep);
  return sweep;
}

std::string problems_of(const Sweep& sweep) {
  constexpr std::size_t most = 8;
  std::set<std::string> seen;
  std::string text;
  std::size_t invalid = 0;
  for (const SweepCase& one : sweep.cases) {
    if (one.problem.empty()) {
      continue;
    }
    ++invalid;
    std::istringstream lines(one.problem);
    for (std::string line; std::getline(lines, line);) {
      if (seen.insert(without_digits(line)).second && seen.size() <= most) {
        text += line + '\n';
      }
    }
  }
  if (invalid == 0) {
    return {};
  }
  if (seen.size() > most) {
    text += fmt::format("... and {} more problems\n", seen.size() - most);
  }
  return text + fmt::format("{} of {} cases are invalid", invalid, sweep.cases.size());
}

}  // namespace sandsim::cli
