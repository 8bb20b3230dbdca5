#!/usr/bin/python3
"""Makes the flume's converged deposits, scenes/flume/deposit_*.csv: what the errors of the flume's scenes are taken
against. Runs each scene in order 2 and double precision on three grids, each twice as fine as the last, and keeps the
cell means of the finest over 1.25 mm. The differences between the three grids give the order and the error that is
left, which stand in the file's header.

    scripts/make_flume_reference.py                     # 0.625, 0.3125 and 0.15625 mm: about ten minutes on one core
    scripts/make_flume_reference.py --finest 0.625      # [mm] coarser and faster
    scripts/make_flume_reference.py scene.yaml          # one scene only
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np
import yaml

from plotting import ROOT, run
from sandsim_series import Series

FLUME = ROOT / "scenes/flume"
KEPT = 1.25                                     # [mm] spacing of the file
DRY = 1e-7                                      # [m] a film that the file may leave out
END = 4.0                                       # [s]


def deposit(scene, spacing, output):
    """Depth [m] of the cells of `spacing` mm at the end, and the run's report."""
    length = scene_length(scene)
    settings = [f"grid.cells=[{round(1000 * length / spacing)}, 1]", f"grid.spacing={spacing:g} mm",
                "numerics={scheme: balanced, order: 2, precision: float64}", "output={fields: [depth]}",
                f"time.frame_interval={END:g} s", f"time.end={END:g} s", "time.stop_at_rest=true"]
    report = run(scene, output, settings, options=["--threads", "1"])
    with Series(output) as series:
        return np.asarray(series.depth(-1), dtype=float)[0], report


def scene_length(scene):
    """[m] length of the flume, of which spacings are centimetres in the scene."""
    grid = yaml.safe_load(scene.read_text())["grid"]
    number, unit = str(grid["spacing"]).split()
    if unit != "cm":
        raise SystemExit(f"{scene}: spacing {grid['spacing']}: expected centimetres")
    return grid["cells"][0] * float(number) / 100


def means(depth, factor):
    return depth.reshape(-1, factor).mean(axis=1)


def front(depth, spacing, threshold):
    """[m] where the line through the cell centres last falls below the threshold; spacing in mm."""
    last = np.flatnonzero(depth > threshold)[-1]
    part = (depth[last] - threshold) / (depth[last] - depth[last + 1])
    return 1e-3 * spacing * (last + 0.5 + part)


def convergence(deposits):
    """Order of the last three grids, and the relative L1 error left on the finest (Richardson)."""
    coarse, middle, fine = deposits
    size = np.abs(fine).sum()
    first = 4 * np.abs(coarse - means(middle, 2)).sum() / size
    second = 2 * np.abs(middle - means(fine, 2)).sum() / size
    ratio = first / second
    return np.log2(ratio), second / (ratio - 1) if ratio > 1 else float("nan"), (first, second)


def write(path, scene, depth, finest, error, report):
    kept = means(depth, round(KEPT / finest))
    cells = int(np.flatnonzero(kept > DRY)[-1]) + 3             # two dry cells end the table at zero depth
    kept = np.where(kept > DRY, kept, 0.0)[:cells]
    with open(path, "w", encoding="ascii") as out:
        out.write(f"# Converged deposit of {scene.name}: sandsim, balanced scheme, order 2, float64, spacing "
                  f"{finest:g} mm,\n# {report['steps']} steps to {report['simulated_time']:.4g} s; means over "
                  f"{KEPT:g} mm. Made by scripts/make_flume_reference.py.\n"
                  f"# Relative L1 error that is left, from three grids: {error:.1e}.\nx_m,depth_m\n")
        for i, value in enumerate(kept):
            out.write(f"{1e-3 * KEPT * (i + 0.5):.6g},{value:.6g}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", help="names of scenes in scenes/flume (default: all)")
    parser.add_argument("--finest", type=float, default=0.15625, help="finest spacing [mm]")
    parser.add_argument("--dry-run", action="store_true", help="print the numbers, write no files")
    chosen = parser.parse_args()
    scenes = [FLUME / name for name in chosen.scenes] or sorted(FLUME.glob("*.yaml"))
    print("scene                         5 cm    5 mm   order  error left  at rest")
    for scene in scenes:
        # The file need not be there yet, and the measured one may never be: errors are not what these runs are for.
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / scene.name
            resolved = yaml.safe_load(scene.read_text())
            target = FLUME / resolved.pop("reference")["profile"]
            source.write_text(yaml.safe_dump(resolved))
            runs = [deposit(source, factor * chosen.finest, Path(folder) / str(factor)) for factor in (4, 2, 1)]
        order, error, _ = convergence([depth for depth, _ in runs])
        depth, report = runs[-1]
        fronts = [front(depth, chosen.finest, threshold) for threshold in (0.05, 0.005)]
        print(f"{scene.name:28} {fronts[0]:6.4f}  {fronts[1]:6.4f}  {order:5.2f}  {error:9.1e}  {report['at_rest']}",
              flush=True)
        if not chosen.dry_run:
            write(target, scene, depth, chosen.finest, error, report)


if __name__ == "__main__":
    main()
