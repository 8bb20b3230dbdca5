#include "cli/sweep/case_state.hpp"

#include <algorithm>
#include <utility>

#include "solver/errors.hpp"

namespace sandsim::cli {

namespace fs = std::filesystem;

namespace {

using Kind = CaseState::Kind;

constexpr int interrupted = static_cast<int>(ExitCode::interrupted);
constexpr int wall_clock_limit = static_cast<int>(ExitCode::wall_clock_limit);

Kind kind_of(int exit_code) {
  if (exit_code == 0) {
    return Kind::done;
  }
  return exit_code == interrupted || exit_code == wall_clock_limit ? Kind::interrupted : Kind::failed;
}

/// The first line of what a run said, without "sandsim: error: ".
std::string first_line(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const std::string prefix = "sandsim: error: ";
  return line.starts_with(prefix) ? line.substr(prefix.size()) : line;
}

CaseState failed(int exit_code, std::string message) {
  return {Kind::failed, exit_code, "failed", std::move(message), std::nullopt};
}

}  // namespace

CaseState read_case_state(const Sweep& sweep, std::size_t index, const fs::path& directory) {
  const SweepCase& one = sweep.cases[index];
  if (!one.problem.empty()) {
    return failed(static_cast<int>(ExitCode::invalid_scene), first_line(one.problem));
  }
  CaseState state;
  try {
    state.report = read_case_report(directory / one.folder);
  } catch (const InputError& error) {
    return failed(static_cast<int>(error.code()), error.what());
  }
  if (!state.report) {
    state.status = "not run";
    return state;
  }
  if (state.report->run.exit_code == ExitCode::done && state.report->scene_hash != one.scene_hash) {
    return failed(static_cast<int>(ExitCode::missing_input), "the scene or a file of it changed while the case ran");
  }
  state.exit_code = static_cast<int>(state.report->run.exit_code);
  state.kind = kind_of(state.exit_code);
  state.status = state.report->run.status;
  state.message = first_line(state.report->run.message);
  return state;
}

CaseState case_state(const Sweep& sweep, std::size_t index, const fs::path& directory, const CaseOutcome& outcome) {
  CaseState state = read_case_state(sweep, index, directory);
  if (!outcome.started || outcome.exit_code == state.exit_code) {
    return state;
  }
  state.exit_code = outcome.exit_code;
  state.kind = kind_of(outcome.exit_code);
  state.status = outcome.exit_code > 128 && state.kind == Kind::failed
                     ? "killed by signal " + std::to_string(outcome.exit_code - 128)
                     : "failed";
  state.message = first_line(outcome.error_text);
  return state;
}

bool is_to_be_run(const CaseState& state, bool retry) {
  if (state.kind == Kind::done) {
    return false;
  }
  const bool by_itself =
      state.kind == Kind::failed && (state.exit_code == static_cast<int>(ExitCode::invalid_scene) ||
                                     state.exit_code == static_cast<int>(ExitCode::numerical_failure));
  return retry ? state.exit_code != static_cast<int>(ExitCode::invalid_scene) : !by_itself;
}

ExitCode exit_code_of(const std::vector<CaseState>& states) {
  const auto of_kind = [&](Kind kind) {
    return std::find_if(states.begin(), states.end(), [kind](const CaseState& state) { return state.kind == kind; });
  };
  if (const auto state = of_kind(Kind::failed); state != states.end()) {
    return static_cast<ExitCode>(state->exit_code);
  }
  if (of_kind(Kind::interrupted) != states.end()) {
    return ExitCode::interrupted;
  }
  return of_kind(Kind::not_run) != states.end() ? ExitCode::missing_input : ExitCode::done;
}

}  // namespace sandsim::cli
