#!/usr/bin/python3
"""Draws a fit: the misfit around the best values, and which of them fit equally well."""

import csv

import matplotlib
import numpy as np
import yaml

from plotting import COLOURS, arguments, plt, save


def read(path):
    """A table of runs: columns by their names, numbers where they are; failed runs have NaN."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: column([row[name] for row in rows]) for name in rows[0]}


def column(texts):
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)


def number(text):
    """The number of "4.2 cm"."""
    return float(str(text).split()[0])


def label_of(fit, names, k):
    """The column of the k-th parameter: its key, with its unit."""
    key = fit["parameters"][k]["key"]
    return next(name for name in names if name == key or name.startswith(f"{key} ["))


def draw_curve(axes, fit, runs, grid, x):
    order = np.argsort(grid[x])
    axes.plot(grid[x][order], 1e3 * grid["misfit [m]"][order], color=COLOURS[0], label="misfit")
    axes.plot(runs[x], 1e3 * runs["misfit [m]"], ".", color="0.6", markersize=3, zorder=0, label="all runs")
    limit = 1e3 * number(fit["equally_good_up_to"])
    axes.axhline(limit, color=COLOURS[1], linestyle="--", label="equally good up to here")
    axes.axvline(number(fit["parameters"][0]["best"]), color=COLOURS[2], label="best")
    axes.set(xlabel=x, ylabel="misfit [mm]", xlim=(grid[x].min(), grid[x].max()))
    axes.set_ylim(0, 1.05 * np.nanmax(np.append(1e3 * grid["misfit [m]"], limit)))
    axes.legend()


def draw_map(figure, axes, fit, runs, grid, names):
    x, y = names
    shape = (np.unique(grid[y]).size, np.unique(grid[x]).size)
    misfit = 1e3 * grid["misfit [m]"].reshape(shape)
    xs, ys = grid[x].reshape(shape), grid[y].reshape(shape)
    limit = 1e3 * number(fit["equally_good_up_to"])
    axes.grid(False)
    axes.set_facecolor("0.8")          # failed runs
    # Below a tenth of the limit differences mean nothing.
    least = limit / 10
    levels = np.geomspace(least, max(np.nanmax(misfit), 2 * limit) * 1.001, 17)
    image = axes.contourf(xs, ys, np.maximum(misfit, least), levels, cmap="viridis_r",
                          norm=matplotlib.colors.LogNorm(levels[0], levels[-1]))
    if np.nanmin(misfit) < limit < np.nanmax(misfit):
        axes.contour(xs, ys, misfit, [limit], colors=COLOURS[1], linewidths=1.5)
    inside = (runs[x] >= xs.min()) & (runs[x] <= xs.max()) & (runs[y] >= ys.min()) & (runs[y] <= ys.max())
    fits = inside & (1e3 * runs["misfit [m]"] <= limit)
    axes.plot(runs[x][inside & ~fits], runs[y][inside & ~fits], ".", color="0.2", markersize=2)
    axes.plot(runs[x][fits], runs[y][fits], ".", color=COLOURS[1], markersize=4, label="runs that fit equally well")
    axes.plot(*[number(parameter["best"]) for parameter in fit["parameters"][:2]], "w*", markersize=11,
              markeredgecolor="k", label="best")
    axes.set(xlabel=x, ylabel=y, xlim=(xs.min(), xs.max()), ylim=(ys.min(), ys.max()))
    axes.legend(frameon=True)
    figure.colorbar(image, ax=axes, label="misfit [mm]", format="%.3g")


def main():
    options = arguments(__doc__).parse_args()
    fit = yaml.safe_load((options.result / "fit.yaml").read_text())
    if not (options.result / "map.csv").is_file():
        print("no plot: the fit has no map (--map 0)")
        return
    runs, grid = read(options.result / "fit.csv"), read(options.result / "map.csv")
    names = [label_of(fit, runs, k) for k in range(len(fit["parameters"]))]
    figure, axes = plt.subplots(figsize=(5.6, 4.2))
    if len(names) == 1:
        draw_curve(axes, fit, runs, grid, names[0])
    else:
        draw_map(figure, axes, fit, runs, grid, names[:2])
    limit = 1e3 * number(fit["equally_good_up_to"])
    rest = f"\nmap: {', '.join(names[2:])} at the best" if len(names) > 2 else ""
    axes.set_title(f"{fit['reference']['kind']}: up to {limit:.3g} mm fits equally well{rest}")
    save(figure, options.output or options.result / "fit.png")


if __name__ == "__main__":
    main()
