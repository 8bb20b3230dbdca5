#!/usr/bin/python3
"""Error against run time: the flume's deposit over the grid spacing, for four schemes, both precisions and hbar = h
and min(0.8 h, 5 cm). Writes results/error_vs_time/table.csv and table.md and draws them (plot_error_time.py).

Error: relative L1 of the deposit against the converged profile. Time: the steps' own (the stages but for the frames,
one thread), the median of the repeats, or with --shortest the least of them, for a machine that is not idle.
"""

import argparse
import csv
import statistics
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import plot_error_time
from plotting import ROOT, run

LENGTH = 1.6                                                       # [m] of the flume
SPACINGS = (0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125)              # [m]
SCHEMES = {
    "paper, as printed": "scheme: paper, momentum_flux: printed, rest_gate: false, velocity: desingularised",
    "paper, repaired": "scheme: paper, momentum_flux: full, rest_gate: true, velocity: quotient",
    "balanced, order 1": "scheme: balanced, order: 1",
    "balanced, order 2": "scheme: balanced, order: 2",
}
SCENES = {"h": "scene.yaml", "min(0.8 h, 5 cm)": "scene_truncated.yaml"}
PRECISIONS = ("float32", "float64")
TARGET = 1e-2                                                      # error at which run times are compared


def measure(scene, scheme, precision, spacing, options, output):
    """One row of the table."""
    settings = [f"grid.cells=[{round(LENGTH / spacing)}, 1]", f"grid.spacing={100 * spacing:g} cm",
                f"numerics={{{SCHEMES[scheme]}, precision: {precision}}}",
                "output={frames: false}", "time.frame_interval=4 s"]
    reports = [run(scene, output, settings, options=["--threads", "1"]) for _ in range(options.repeats)]
    report = reports[0]
    errors = [error for error in report.get("errors", [])
              if error["against"].startswith("profile") and error.get("l1_relative") is not None]
    if not errors:
        raise SystemExit(f"{scene}: no error against a profile: does the scene name its deposit (reference.profile)?")
    choose = min if options.shortest else statistics.median
    seconds = choose([sum(stage["seconds"] for stage in report["stages"] if stage["name"] != "frames")
                      for report in reports])
    return {"error": errors[-1]["l1_relative"], "seconds": seconds, "steps": report["steps"],
            "cell_steps": report["steps"] * report["cells"], "at_rest": report["at_rest"]}


def cost_at(rows, target, column):
    """Time or cell-steps at which a scheme reaches an error, on the line through its points; None if it never does."""
    rows = sorted(rows, key=lambda row: -row["spacing"])
    error = np.log([row["error"] for row in rows])
    cost = np.log([row[column] for row in rows])
    below = np.flatnonzero(error <= np.log(target))
    if not below.size:
        return None
    if below[0] == 0:
        return float(np.exp(cost[0]))
    pair = slice(below[0] - 1, below[0] + 1)
    return float(np.exp(np.interp(-np.log(target), -error[pair], cost[pair])))


def write_tables(rows, folder):
    with (folder / "table.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    lines = ["Relative L1 error of the deposit, and seconds of the solver on one thread.", ""]
    head = "| hbar | scheme | precision | " + " | ".join(f"{100 * s:g} cm" for s in SPACINGS)
    lines += [head + f" | time to {TARGET:g} | cell-steps to {TARGET:g} |", "|---" * (len(SPACINGS) + 5) + "|"]
    for key in dict.fromkeys((row["hbar"], row["scheme"], row["precision"]) for row in rows):
        chosen = [row for row in rows if (row["hbar"], row["scheme"], row["precision"]) == key]
        cells = [f"{row['error']:.2e} ({1e3 * row['seconds']:.3g} ms)" for row in chosen]
        time, steps = (cost_at(chosen, TARGET, column) for column in ("seconds", "cell_steps"))
        cells += [f"{1e3 * time:.3g} ms", f"{steps:.2e}"] if time else ["never", "never"]
        lines.append("| " + " | ".join([*key, *cells]) + " |")
    (folder / "table.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--shortest", action="store_true", help="take the shortest repeat, not the median")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "results/error_vs_time")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for hbar, scene in SCENES.items():
            for scheme in SCHEMES:
                for precision in PRECISIONS:
                    for spacing in SPACINGS:
                        case = {"hbar": hbar, "scheme": scheme, "precision": precision, "spacing": spacing}
                        try:
                            case |= measure(ROOT / "scenes/flume" / scene, scheme, precision, spacing,
                                            options, Path(scratch) / "run")
                        except subprocess.CalledProcessError as failure:
                            raise SystemExit(f"{case}: sandsim ended with {failure.returncode}")
                        rows.append(case)
    write_tables(rows, options.output)
    plot_error_time.draw(rows, options.output / "error_vs_time.png")


if __name__ == "__main__":
    main()
