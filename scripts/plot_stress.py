#!/usr/bin/python3
"""The stability maps of `sandsim stress`: the largest speed of each run, and the runs that failed, for every scheme."""

import csv
from pathlib import Path

import matplotlib
import numpy as np

from plotting import arguments, plt, save

SCHEMES = {("paper", "1"): "paper's scheme", ("balanced", "1"): "balanced, order 1",
           ("balanced", "2"): "balanced, order 2"}
MAPS = {"courant_friction": ("Courant number [-]", "friction angle [deg]", "Column on rough ground"),
        "hbar_slope": ("hbar / h [-]", "slope of the bed [deg]", "Box on a slope, 30 deg")}


def read_maps(folder, precision):
    """{(map, scheme, order): [rows]} of a results folder, in one precision."""
    maps = {}
    with open(Path(folder) / "maps.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["precision"] == precision:
                maps.setdefault((row["map"], row["scheme"], row["order"]), []).append(row)
    if not maps:
        raise SystemExit(f"{folder}/maps.csv holds no map in {precision}")
    return maps


def table(rows):
    """The values of x and y, and the relative speed [E] and the verdict of every cell, (y, x)."""
    xs = sorted({float(row["x"]) for row in rows})
    ys = sorted({float(row["y"]) for row in rows})
    speed = np.full((len(ys), len(xs)), np.nan)
    failed = np.zeros(speed.shape, bool)
    for row in rows:
        place = ys.index(float(row["y"])), xs.index(float(row["x"]))
        speed[place] = float(row["relative_speed"])
        failed[place] = row["verdict"] != "pass"
    return xs, ys, speed, failed


def draw(axes, rows, scale):
    """One map: the cells side by side, whatever their values are."""
    xs, ys, speed, failed = table(rows)
    axes.grid(False)
    image = axes.pcolormesh(np.arange(len(xs) + 1) - 0.5, np.arange(len(ys) + 1) - 0.5, speed, norm=scale,
                            cmap="cividis", edgecolors="white", linewidth=0.3)
    for j, i in np.argwhere(failed):
        axes.plot(i, j, "x", color="#d33", markersize=5)
    axes.set_xticks(range(len(xs)), [f"{x:g}" for x in xs], rotation=60)
    axes.set_yticks(range(len(ys)), [f"{y:g}" for y in ys])
    passed = int(failed.size - failed.sum())
    axes.set_title(f"{SCHEMES[rows[0]['scheme'], rows[0]['order']]}: {passed} of {failed.size} pass")
    return image


def main():
    parser = arguments(__doc__)
    parser.add_argument("--precision", default="float32", choices=("float32", "float64"))
    options = parser.parse_args()
    maps = read_maps(options.result, options.precision)
    names = [name for name in MAPS if any(key[0] == name for key in maps)]
    figure, grid = plt.subplots(len(names), len(SCHEMES), figsize=(11, 3.9 * len(names)), squeeze=False)
    scale = matplotlib.colors.LogNorm(0.02, 3, clip=True)
    for name, row in zip(names, grid):
        across, up, title = MAPS[name]
        for axes, scheme in zip(row, SCHEMES):
            image = draw(axes, maps[(name, *scheme)], scale)
            axes.set(xlabel=across, ylabel=up)
        row[0].set_ylabel(f"{title}\n{up}")
    figure.colorbar(image, ax=grid, label="largest speed [E = u0 + sqrt(g H)]", shrink=0.6)
    figure.suptitle(f"sandsim stress, {options.precision}; a cross: a criterion failed")
    save(figure, options.output or options.result / "maps.png")


if __name__ == "__main__":
    main()
