// What `--help` says below the list of options: examples and rules.
#pragma once

namespace sandsim::cli::help {

inline constexpr const char* program = R"(Examples:
  sandsim run scenes/flume/scene.yaml          solve it; results go to results/flume
  sandsim check scenes/flume/scene.yaml        what it needs, before it runs
  sandsim info results/flume                   what came out, and how the run went
  sandsim export results/flume                 the sand's surface as a mesh
  sandsim COMMAND --help                       more about a command

Exit codes:
    0  done
    1  usage: the command line is wrong
    2  invalid scene
    3  missing or unreadable input
    4  no such device, or too little memory
    5  numerical failure; the last good frame is kept
    6  output: disk full, no permission, directory not empty
    7  wall-clock limit reached, checkpoint written
   70  internal error: a bug in sandsim
  130  interrupted (Ctrl-C, SIGTERM, SIGHUP), checkpoint written)";

inline constexpr const char* run = R"(Output:
  DIR holds scene.resolved.yaml, run.json (the report), series.h5 with series.xdmf, and log.txt;
  with particles also particles.xdmf.
  Without -o, DIR is results/NAME in the current directory; NAME is the scene file's name without its
  extension, or the name of its folder if the file is called scene.yaml.
  A DIR that is not empty is refused without --resume or --overwrite.

Stopping and going on:
  The first Ctrl-C (or SIGTERM, SIGHUP) ends the run after its current step, the second kills it.
  An interrupted run, and one that reaches --max-wall, leave checkpoint.h5 and the frames so far in
  series.h5.partial, which every reader of series.h5 opens. Run the same command with --resume: the result
  is the same, bit for bit, as that of a run that was never interrupted. checkpoint.h5 goes when the run is
  done, and series.h5.partial becomes series.h5.

Examples:
  sandsim run scenes/flume/scene.yaml
  sandsim run scene.yaml -o results/fine --set 'grid.spacing=5 mm' --set 'grid.cells=[320, 1]'
  sandsim run scene.yaml --precision float64 --threads 4 -v
  sandsim run scene.yaml --max-wall 08:00:00        each time for eight hours; to go on:
  sandsim run scene.yaml --max-wall 08:00:00 --resume
  sandsim run scene.yaml --json -q > report.json

Exit codes: see sandsim --help.)";

inline constexpr const char* sweep = R"(What varies (VALUES), for any key of the scene:
  sand.friction_angle=20,30,40 deg     a list; a unit at its end holds for all of it; [40, 1] is one value
  sand.friction_angle=20:40:5 deg      a range: first:last:count; also 20 deg:40 deg:5, and :log for equal ratios
  sand.friction_angle=20..40 deg       an interval from which --samples are drawn; :log likewise
  a=1,2,3; b=4,5,6                     two keys that vary together; two --vary give all combinations
A sweep file says the same, and belongs to its scene (`sandsim sweep FILE`):
  scene: scene.yaml
  vary: {sand.friction_angle: 20:40:5 deg, sand.hbar.scale: [0.3, 0.6]}
  # set: {time.end: 2 s}, samples: 64, sampling: latin, seed: 1; a list of maps under vary: keys vary together

Output:
  DIR/cases/HASH is the output of a run each; HASH stands for the scene and all files that it reads.
  DIR/summary.csv and summary.h5 are the table of cases: values, exit code, front and height of the deposit, runout,
  drop and travel angle of the front and of the centre of mass, area reached, largest depth and speed, volume out, stop
  time, errors, volume error, steps, wall time; also without frames. scripts/plot DIR draws it (--metric NAME chooses).

Stopping and going on:
  The same command again, or `sandsim sweep DIR`, goes on: finished cases are never run again, interrupted ones go on
  from their checkpoints, also after a kill. A case that fails is recorded and the others go on; called again, cases
  whose disk, memory or files failed are tried again, with --retry also those that broke down numerically. More values
  for a sweep that is done: only the new cases run.
  Every case has the bits of the same run on its own, with any -j and --threads.

Beyond one machine, on a file system that all see:
  sandsim sweep SCENE --vary ... -o DIR --expand && sbatch DIR/sweep.sbatch
  sandsim sweep DIR --collect
  seq 64 | parallel -j 8 --joblog DIR/joblog sandsim sweep DIR --case {} -q

Examples:
  sandsim sweep scenes/pile_sweep
  sandsim sweep scene.yaml --vary "sand.friction_angle=20:40:8 deg" --vary sand.hbar.scale=0.3:1:8 -j 4
  sandsim sweep scene.yaml --vary "grid.cells=[80, 1],[160, 1]; grid.spacing=2,1 cm"
  sandsim sweep scene.yaml --vary "sand.friction_angle=20..40 deg" --vary sand.hbar.scale=0.3..1 --samples 64 --seed 7

Exit codes: 0 if all cases are done, else that of the first case that failed; 7 or 130 if the sweep was stopped.)";

inline constexpr const char* fit = R"(What is looked for (KEY=FROM:TO), for any number of the scene:
  sand.hbar.scale=0.3:1                a number between two bounds
  'sand.hbar.cap=1:20 cm'              with a unit, which holds for both
  'sand.hbar.cap=1:100 cm:log'         spread by ratios, for what may be of any size
  Two or three are well found; each must be valid anywhere between its bounds.

What it is fitted to:
  --front FILE.csv     time_s,front_m: where the front was, and when
  --profile FILE.csv   x_m,depth_m: depths along one row at the time --at
  --run DIR            the fronts of a run at its frames, or with --at its profile
  nothing of these     the scene's own reference: its measured front, else its measured profile, its exact solution
                       (with the scene's values as they are; its profile with --at), its profile
  The front is the largest x at which the depth crosses --front-depth downwards; if absent, the first of the scene's
  reference.front_depths, else 1 % of the largest depth at the start; where only the tip of an exact solution is known,
  the last wet cell. A run's front is linear between its frames: take time.frame_interval as short as the times of the
  data are apart.

How:
  The misfit is the root mean square difference in metres. The search starts from a Latin hypercube and goes down from
  its two best points with NLopt (BOBYQA, with one parameter Sbplx), each run in memory. Then every parameter is moved
  away from the best value, both ways, with the others fitted again, until the misfit exceeds that of the best and the
  tolerance, added in squares: that range fits equally well. Without --tolerance it is 1 % of the front's travel or of
  the largest depth, for a front at least a tenth of a cell, for a tip a cell. A range that runs into the bounds is
  said in words: then the data do not tell that value. Ranges are those of runs that were made; with three or more
  parameters the true ones may be wider. They hold nothing of the grid's own error: fit on a finer grid as well, to see
  whether the values stay (--set grid.spacing=..., grid.cells=...).
  Runs that fail count as a large misfit and are listed.
  A map of the misfit over the first two parameters, others at their best, shows the rest.

Output:
  DIR/fit.yaml: best values, ranges and findings; fit.csv: all runs; map.csv: the map. scripts/plot DIR draws it.

Examples:
  sandsim fit scenes/fit --vary sand.hbar.scale=0.3:1 --vary 'sand.hbar.cap=1:10 cm' --front scenes/fit/front.csv
  sandsim fit scene.yaml --vary 'sand.friction_angle=20:40 deg' --profile deposit.csv --tolerance '2 mm'
  sandsim fit scene.yaml --vary sand.hbar.scale=0.3:1 --run results/fine --front-depth '5 mm'

Exit codes: 0 done, also if the data do not tell; 1 usage; 2 invalid scene, somewhere between the bounds; 3 files, or a
reference that the run cannot reach; 5 all runs of the start failed; 6 output; 130 interrupted, fit.csv is kept.)";

inline constexpr const char* check =
    R"(Nothing is run and nothing is written. The number of steps is an estimate: it takes the stable step of the
initial state for all of the run.

Examples:
  sandsim check scenes/flume/scene.yaml
  sandsim check scene.yaml --set numerics.scheme=paper --set 'time.end=1 s')";

inline constexpr const char* info = R"(RESULT is a results directory, or a series.h5 or series.h5.partial in one.

Examples:
  sandsim info results/flume
  sandsim info results/flume/series.h5)";

inline constexpr const char* exported =
    R"(What is written, in metres with z up, and its formats (the first if none is named):
  surface    ply obj vtp vtk   the sand as triangles with normals, clipped where less than --iso of it lies
                               (marching squares at the paper's 0.1 cells). It reaches half a cell beyond the
                               last cell centres, to the sides of the domain; one row of cells is a band one
                               cell wide. With --closed the ground and upright sides make it a closed solid.
  terrain    ply obj vtp vtk   the bed as triangles
  particles  ply vtp           the visible particles with their ids (scenes with 'particles')
  level-set  h5 npy            signed distances to the closed sand, negative inside, cut off beyond --band:
                               for renderers, and as 'shape: {type: sdf}' of an object in another scene.
                               .npy holds neither origin nor spacing: they are printed, ready for the scene
  rasters    tif asc           bed, maxima (output.maxima) and the fields of a frame as GeoTIFF or ESRI ASCII grids,
                               north up, with the CRS of the grid: a file each, in the folder RESULT/rasters or -o.
                               --field NAME takes one of them (and may be repeated)
The format may also be told by the name after -o. The surface is at the height that the series has in 'surface',
where a run kept that (sand on an object lies on the object), else and for solids at bed + depth.

RESULT is a results directory, or a series.h5 or series.h5.partial. Without -o the file is RESULT/WHAT.FORMAT, with
--all RESULT/WHAT/WHAT_0000.FORMAT and so on, by the numbers of the frames. The printed volume is that between
the mesh and the ground, beside that of all sand in the frame: what lies thinner than --iso is not under it.

Examples:
  sandsim export results/flume                                    the last frame's sand: surface.ply
  sandsim export results/flume --frame 0 -o start.obj
  sandsim export results/flume --what terrain
  sandsim export results/flume --time '0.5 s' --closed -o sand.ply    to print, or to measure
  sandsim export results/flume --all --format vtp                 a numbered file a frame, for ParaView
  sandsim export results/cars --what level-set --cell '0.25 cells'
  sandsim export results/cars --what particles --all --overwrite
  sandsim export results/gis --what rasters                       for QGIS: max_depth.tif, depth.tif, ...
  sandsim export results/gis --what rasters --field max_depth --format asc)";

inline constexpr const char* schema =
    R"(Editors complete and check scenes with it. For VS Code and others with a YAML language server:
  sandsim schema > sandsim.schema.json
and as the first line of a scene:
  # yaml-language-server: $schema=sandsim.schema.json

Examples:
  sandsim schema > sandsim.schema.json
  sandsim schema --reference > scene_format.md)";

inline constexpr const char* devices = R"(Example:
  sandsim devices)";

inline constexpr const char* bench = R"(What is measured, on the processor or on a CUDA device:
  - the copy bandwidth: arrays much larger than the last-level cache, bytes counted as read + written. On the
    processor ordinary (not non-temporal) stores; on a device the faster of the runtime's copy and a kernel's;
  - the arithmetic: additions and multiplications, divisions and square roots a second, in registers;
  - the speed of the step on SIZE x SIZE cells that all move, periodic, on flat and on wavy terrain, for the
    paper scheme and the balanced scheme of order 1 and 2, in loops as a run has them from frame to frame. The
    floor is the time to copy 28 bytes a cell in float32, 56 in float64, and the bed's 4 or 8 more where the
    terrain is not flat; grids that a cache holds can beat it. 'bytes a cell' is what the step itself counts:
    depth and two momenta, read and written, and the bed. Sizes that the memory does not hold are skipped;
  - what a frame adds to a step that it is taken beside, on 256 x 256 cells;
  - the time the solver needs from a scene in memory to the first step, without output (log.txt of a run says
    how long it took from the command, reading and files included).
Numbers are medians of the repeats, with the range from the slowest to the fastest.

Examples:
  sandsim bench
  sandsim bench --threads 1 --precision float32
  sandsim bench --device cuda --size 4096
  sandsim bench --quick --json)";

inline constexpr const char* study = R"(A study file names scenes and what is varied in them:

  title: Deposit of the flume
  scenes: [{name: hbar = h, file: ../flume/scene.yaml}]
  spacings: [4 cm, 2 cm, 1 cm, 5 mm]     # cells of the same domain; a fixed time.step falls with them
  methods:                               # named sets of values; each is a curve
    - {name: order 1, set: {numerics: {scheme: balanced, order: 1}}}
    - {name: order 2, set: {numerics: {scheme: balanced, order: 2}}}
  vary: {numerics.precision: [float32, float64]}        # every combination is a curve
  error: {against: profile, measure: l1_relative}
  repeats: 5

Errors are taken at the end of a run: against a reference of the scene (error.against: exact, profile,
measured_profile or measured_front), or against a fine run, 'fine: {spacing: 0.5 mm}', which the study makes
with the balanced scheme of order 2 in float64, keeps beside its results as fine-HASH.npy, and restricts to the
cells of each grid by their means. error.measure is l1_relative (default), l1, l2, linf, front, height or volume;
study.csv has all of them. 'set' replaces values in all scenes. 'devices: [cpu, cuda]' and 'threads: [1, 2]' are
varied, too. Each run keeps one frame, its last: frames would cut steps.

  ablation:                              # what features cost: variants of a scene, timed side by side
    file: ../flume/scene.yaml
    variants: [{name: maxima, set: {output.maxima: true}}]
    writes: true                         # frames go to disk, as those of a run

Runs go strictly one after the other, in rounds over all settings; the first round warms up. The time of a run
is that of the solver's steps. A time is the median of the repeats, or with 'times: shortest' (--shortest) the
least. Leave the machine alone meanwhile: the load average is reported.

Output: DIR holds study.yaml (with it, 'sandsim study DIR/study.yaml -o OTHER' gives the same errors to the last
digit), table.md, study.csv, ablation.csv. 'scripts/plot DIR' draws error over time with the frontier marked.
A setting that fails is reported in its row; the others are run, and the exit code is 5.

Examples:
  sandsim study scenes/studies/flume.yaml
  sandsim study scenes/studies/flume.yaml --list
  sandsim study scenes/studies/flume.yaml -o results/try --quick --under 5e-2)";

inline constexpr const char* stress =
    R"(Each case is run with the paper scheme and the balanced one of order 1 and 2, in float32 and float64, each twice.
What a run has to satisfy; E is the speed that its energy explains, u0 + sqrt(g H), H from the lowest bed
to the highest sand:
  ending   it comes to its end, or is refused with the right message
  finite   no depth or momentum is infinite or not a number
  depth    no depth is negative
  volume   |error| at most 2e-6 in float32, 1e-13 in float64, of what was there and came in
  speed    at most 5 E
  step     none shorter than 0.015 dx/E
  rest     sand that friction holds has not changed by a bit (in cases at rest)
  repeat   the second run has the bits of the first
  stops    sand comes to exact rest, no face steeper than friction holds (in cases that have to stop)
Some cases state other bounds. Cases that the paper scheme is known to fail, with the reason, count as known.
Runs are processes of their own: a crash or a hang is a failure of its case and stops nothing.

Output:
  DIR/stress.csv and maps.csv hold a row a case (a cell of the stability maps) and scheme, DIR/stress.md the
  table to read, DIR/scenes all cases as scene files, DIR/failures those that failed with their scheme set:
  'sandsim run DIR/failures/NAME.yaml' reproduces one. scripts/plot DIR draws the maps.

Exit code 0 if all is as expected, 5 if something else failed.

Examples:
  sandsim stress                                  the built-in matrix: a few minutes
  sandsim stress --quick -o results/quick
  sandsim stress --only velocity_ --overwrite
  sandsim stress --only random_ --random 5000     look for trouble
  sandsim stress scenes/flume/scene.yaml my.yaml  your own scenes by the same criteria)";

}  // namespace sandsim::cli::help
