#include "cli/sweep/sweep_script.hpp"

#include <fmt/format.h>

#include "cli/text.hpp"

namespace sandsim::cli {

std::string sweep_script(const SweepFiles& files, std::size_t cases, const std::filesystem::path& executable) {
  const std::filesystem::path directory = std::filesystem::absolute(files.directory).lexically_normal();
  // Slurm's own limit on the indices of an array, MaxArraySize, is 1001 unless the site has raised it.
  const std::string many =
      cases > 1000
          ? "# More than 1000 cases: if MaxArraySize (scontrol show config) is below, submit --array=1-1000 and "
            "so on.\n"
          : "";
  return fmt::format(R"(#!/bin/bash
# Submit it:    sbatch {script}
# Options that sbatch is given go before those here: --partition, --time, --array=1-{cases}%8 for eight at a time, ...
# Afterwards:   {sandsim} sweep {directory} --collect
# Submitted again, it runs what is not done, from checkpoints where there are some.
{many}#SBATCH --job-name=sandsim-sweep
#SBATCH --array=1-{cases}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --output={log}
#SBATCH --open-mode=append
# Two minutes before the time limit the case is told to write its checkpoint. `exec` makes it the receiver.
#SBATCH --signal=B:TERM@120
exec {sandsim} sweep {directory} --case "$SLURM_ARRAY_TASK_ID" --threads "${{SLURM_CPUS_PER_TASK:-1}}"
)",
                     fmt::arg("script", shell_word(files.script.string())), fmt::arg("cases", cases),
                     fmt::arg("sandsim", shell_word(executable.string())),
                     fmt::arg("directory", shell_word(directory.string())),
                     fmt::arg("log", shell_word((directory / "slurm" / "%a.log").string())), fmt::arg("many", many));
}

}  // namespace sandsim::cli
