#!/usr/bin/python3
"""Draws what `sandsim study` has measured: error against run time with the frontier marked (study.png), and what
features cost (ablation.png)."""

import argparse
import csv
from pathlib import Path

import numpy as np
import yaml

from plotting import COLOURS, plt, save

STYLES = (("o-", {}), ("s:", {"mfc": "w"}), ("^--", {"mfc": "w"}), ("D-.", {"mfc": "w"}))
MEASURES = {"l1_relative": "relative L1 error of the depth [-]", "l1": "L1 error of the depth [m$^2$ or m$^3$]",
            "l2": "L2 error of the depth [m$^{1.5}$ or m$^2$]", "linf": "largest error of the depth [m]",
            "front": "error of the front [m]", "height": "error of the largest depth [m]",
            "volume": "relative error of the volume [-]"}


def read(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def spacings(rows):
    """E.g. "spacing 4 cm to 1.25 mm"."""
    values = [float(row["spacing_m"]) for row in rows]
    ends = dict.fromkeys((max(values), min(values)))
    return "spacing " + " to ".join(f"{1e3 * end:g} mm" if end < 0.00995 else f"{1e2 * end:g} cm" for end in ends)


def draw_frontier(panel, rows):
    """A band of steps along the points that nothing faster comes near: between two the dearer one is needed."""
    points = sorted((float(row["seconds"]), float(row["error"])) for row in rows if row["frontier"] == "true")
    if not points:
        return
    seconds, error = zip(*points)
    panel.step(seconds, error, where="post", color="0.75", lw=6, alpha=0.6, zorder=0, solid_capstyle="round",
               label="frontier")
    panel.plot(seconds, error, "o", ms=9, mfc="none", mec="k", mew=0.9, zorder=4)


def draw_errors(rows, study, path):
    drawn = [row for row in rows if row["error"] and row["seconds"]]
    scenes = list(dict.fromkeys(row["scene"] for row in drawn))
    if not scenes:
        print("no errors to draw")
        return
    # One colour a method; what else is varied shows in the line and the marker.
    methods = list(dict.fromkeys(row["method"] or row["setting"] for row in drawn))
    figure, axes = plt.subplots(1, len(scenes), figsize=(4.6 * len(scenes) + 2.4, 4.4), sharey=True, squeeze=False)
    figure.suptitle(f"{study.get('title') or 'Error against run time'} ({spacings(drawn)})")
    for panel, scene in zip(axes[0], scenes):
        here = [row for row in drawn if row["scene"] == scene]
        draw_frontier(panel, here)
        used = {}
        for setting in dict.fromkeys(row["setting"] for row in here):
            chosen = [row for row in here if row["setting"] == setting]
            chosen.sort(key=lambda row: -float(row["spacing_m"]))
            method = chosen[0]["method"] or setting
            style, look = STYLES[used.get(method, 0) % len(STYLES)]
            used[method] = used.get(method, 0) + 1
            panel.plot([float(row["seconds"]) for row in chosen], [float(row["error"]) for row in chosen], style,
                       color=COLOURS[methods.index(method) % len(COLOURS)], ms=4, label=setting or scene, **look)
        for target in np.atleast_1d(study.get("under", [])):
            panel.axhline(float(target), color="0.5", lw=0.8)
        panel.set(title=scene, xlabel="time of the solver [s]", xscale="log", yscale="log")
    axes[0][0].set_ylabel(MEASURES[study["error"]["measure"]])
    axes[0][-1].legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    save(figure, path)


def draw_ablation(rows, path):
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 0.9 + 0.32 * len(rows)), sharey=True)
    names = [row["variant"] for row in rows]
    for panel, key, title in zip(axes, ("wall_ratio", "ratio"), ("whole run", "a cell and step of the solver")):
        middle, least, most = ([float(row[key + end]) for row in rows] for end in ("", "_least", "_most"))
        spread = [np.subtract(middle, least), np.subtract(most, middle)]
        panel.barh(names, middle, xerr=spread, color=[COLOURS[0] if name == names[0] else COLOURS[1] for name in names],
                   error_kw={"lw": 1, "capsize": 2})
        panel.axvline(1, color="k", lw=0.8)
        for place, value in enumerate(middle):
            panel.annotate(f"{value:.2f}", (0, place), xytext=(4, 0), textcoords="offset points", va="center",
                           color="w", fontsize=8)
        panel.set(title=f"{title}: time over the base's", xlabel="ratio [-]")
    axes[0].invert_yaxis()
    save(figure, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("result", type=Path, help="folder that `sandsim study` has written")
    parser.add_argument("-o", "--output", type=Path, help="folder of the pictures (default: the result)")
    options = parser.parse_args()
    folder = options.output or options.result
    study = yaml.safe_load((options.result / "study.yaml").read_text())
    if (options.result / "study.csv").is_file():
        draw_errors(read(options.result / "study.csv"), study, folder / "study.png")
    if (options.result / "ablation.csv").is_file():
        draw_ablation(read(options.result / "ablation.csv"), folder / "ablation.png")


if __name__ == "__main__":
    main()
