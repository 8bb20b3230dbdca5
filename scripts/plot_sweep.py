#!/usr/bin/python3
"""Draws a sweep: what came of the cases over what was varied, and maps where two keys were.

Without --metric the first of errors, runout, deposit height, stop time ... that differ between the cases are drawn, never
the wall time, which is that of a machine.
"""

import numpy as np

from plotting import arguments, plt, save
from sandsim_series import Summary

PREFERRED = ("error_l1_relative", "error_front", "runout", "deposit_height", "stop_time", "front", "travel_angle", "area",
             "max_speed", "max_depth", "steps")
OF_THE_MACHINE = ("wall_time",)
MOST = 3               # metrics in one picture, unless they are asked for


def differs(values):
    known = values[np.isfinite(values)]
    return known.size > 1 and np.ptp(known) > 0


def choose(summary, asked):
    """The metrics to draw."""
    for name in asked or ():
        if name not in summary.metrics:
            raise SystemExit(f"no metric '{name}' here; there are {', '.join(summary.metrics)}")
    found = [name for name in PREFERRED if name in summary.metrics and differs(summary[name])]
    return asked or found[:MOST] or [name for name in summary.metrics if name not in OF_THE_MACHINE][:1]


class Axis:
    """A varied key: its values as numbers, texts counted from 0."""

    def __init__(self, summary, name):
        self.label = summary.label(name)
        values = summary[name]
        self.is_number = values.dtype.kind == "f"
        self.distinct, self.index = np.unique(values, return_inverse=True)
        self.values = values if self.is_number else self.index.astype(float)

    def show(self, axes, which):
        axes.set(**{f"{which}label": self.label})
        if not self.is_number:
            axes.set(**{f"{which}ticks": range(self.distinct.size), f"{which}ticklabels": self.distinct})

    def show_cells(self, axes, which):
        """Labels for a map, whose cells are as wide as each other whatever the values are."""
        labels = [f"{value:.4g}" if self.is_number else value for value in self.distinct]
        axes.set(**{f"{which}label": self.label, f"{which}ticks": range(self.distinct.size),
                    f"{which}ticklabels": labels})


def is_product(x, y):
    """Whether every pair of values is there once."""
    pairs = {(i, j) for i, j in zip(x.index, y.index)}
    return len(pairs) == x.index.size == x.distinct.size * y.distinct.size


def draw_map(figure, axes, summary, metric, x, y):
    picture = np.full((y.distinct.size, x.distinct.size), np.nan)
    picture[y.index, x.index] = summary[metric]
    axes.set_facecolor("0.8")          # cases without the metric
    image = axes.imshow(picture, origin="lower", aspect="auto", cmap="viridis")
    x.show_cells(axes, "x")
    y.show_cells(axes, "y")
    axes.grid(False)
    figure.colorbar(image, ax=axes, label=summary.label(metric))
    axes.set_title(metric.replace("_", " "))


def draw_curves(axes, summary, metric, x, y):
    """The metric over x, one curve for each value of y."""
    for k, value in enumerate(y.distinct):
        chosen = np.flatnonzero(y.index == k)
        chosen = chosen[np.argsort(x.values[chosen])]
        colour = plt.cm.viridis(k / max(1, y.distinct.size - 1) * 0.9)
        label = f"{value:.4g}" if y.is_number else value
        axes.plot(x.values[chosen], summary[metric][chosen], ".-", color=colour, label=label)
    x.show(axes, "x")
    axes.set(ylabel=summary.label(metric))


def draw_pair(summary, metrics, x, y):
    figure, rows = plt.subplots(2, len(metrics), figsize=(3.6 * len(metrics), 5.8), squeeze=False)
    for metric, above, below in zip(metrics, rows[0], rows[1]):
        draw_map(figure, above, summary, metric, x, y)
        draw_curves(below, summary, metric, x, y)
    rows[1][0].legend(title=y.label, title_fontsize=7.5, ncols=2)
    return figure


def draw_points(summary, metrics, keys):
    """Every metric over every key: a curve for one key, points where others vary as well."""
    figure, rows = plt.subplots(len(metrics), len(keys), figsize=(4.2 * len(keys), 3.2 * len(metrics)), squeeze=False)
    for metric, row in zip(metrics, rows):
        for key, axes in zip(keys, row):
            axis = Axis(summary, key)
            order = np.argsort(axis.values)
            axes.plot(axis.values[order], summary[metric][order], ".-" if len(keys) == 1 else ".")
            axis.show(axes, "x")
            axes.set(ylabel=summary.label(metric))
    return figure


def main():
    parser = arguments(__doc__)
    parser.add_argument("--metric", action="append", help="column of summary.h5 to draw; may be repeated")
    options = parser.parse_args()
    summary = Summary(options.result)
    metrics = choose(summary, options.metric)
    if not metrics:
        print("no plot: no case of the sweep has a result")
        return
    keys = [name for name in summary.parameters if np.unique(summary[name]).size > 1]
    pair = [Axis(summary, name) for name in keys]
    if len(pair) == 2 and is_product(*pair):
        figure = draw_pair(summary, metrics, *pair)
    else:
        figure = draw_points(summary, metrics, keys)
    done = int(np.count_nonzero(summary["exit_code"] == 0))
    figure.suptitle(f"{summary.title}: {done} of {summary['exit_code'].size} cases")
    save(figure, options.output or summary.directory / "sweep.png")


if __name__ == "__main__":
    main()
