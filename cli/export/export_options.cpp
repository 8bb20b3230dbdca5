#include "cli/export/export_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/export/export_plan.hpp"
#include "cli/help.hpp"
#include "cli/option_checks.hpp"

namespace sandsim::cli {

namespace {

void add_frames(CLI::App& command, ExportArguments& arguments) {
  CLI::Option* frame =
      command.add_option("--frame", arguments.frame, "Which frame, from 0 on; -1 is the last, which is the default");
  frame->type_name("N");
  CLI::Option* time = command.add_option("--time", arguments.time, "The frame nearest to a time, as in '1.5 s'");
  time->type_name("TIME")->excludes(frame);
  command.add_flag("--all", arguments.all, "All frames, a numbered file each")->excludes(frame)->excludes(time);
}

}  // namespace

void add_export(CLI::App& app, ExportArguments& arguments) {
  CLI::App& command = *app.add_subcommand("export", "Turn a result into meshes, particles, level sets or rasters");
  command.add_option("RESULT", arguments.result, "Results directory or series file")->required();
  command.add_option("--what", arguments.what, "What of it; surface if absent")
      ->type_name(join("|", subject_names()))
      ->check(one_of(subject_names()));
  command.add_option("--format", arguments.format, "Format of the files (see below)")
      ->type_name(join("|", all_formats()))
      ->check(one_of(all_formats()));
  add_frames(command, arguments);
  command.add_option("-o,--output", arguments.output, "The file; with --all the folder for files (see below)")
      ->type_name("FILE");
  command.add_flag("--overwrite", arguments.overwrite, "Replace what is there");
  command.add_option("--iso", arguments.iso, "Depth below which sand is left out; '0.1 cells' if absent")
      ->type_name("LENGTH");
  command.add_flag("--closed", arguments.closed, "Close the surface by the ground and upright sides");
  command.add_option("--cell", arguments.cell, "Spacing of a level set; '0.5 cells' if absent")->type_name("LENGTH");
  command.add_option("--band", arguments.band, "Largest distance in a level set; 4 spacings if absent")
      ->type_name("LENGTH");
  command.add_option("--field", arguments.fields, "A raster that is wanted, as 'max_depth'; all if absent")
      ->type_name("NAME")
      ->expected(1)
      ->take_all();
  CLI::Option* json = command.add_flag("--json", arguments.json, "Print counts, volumes and times as JSON");
  command.add_flag("-q,--quiet", arguments.quiet, "Print errors only")->excludes(json);
  command.footer(help::exported);
}

}  // namespace sandsim::cli
