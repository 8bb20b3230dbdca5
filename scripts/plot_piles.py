#!/usr/bin/python3
"""Figure 5: piles at rest, and the slopes at which they stand along the axes and the diagonals of the grid.

Without results it runs the four poured piles of scenes/piles first. Writes the slopes beside the picture.
"""

from pathlib import Path

import numpy as np

from plotting import ROOT, arguments, plt, run, save, show_field
from sandsim_series import Series

ANGLES = (15, 30, 45, 60)
FLANK = (0.2, 0.8)     # part of the peak's height between which the slope is fitted: without apex and foot


def flank(series, directions):
    """Distance from the centre and depth, (r, h) [m], of the cells along lines through the centre of the grid."""
    x, y = np.meshgrid(series.x - np.mean(series.extent[:2]), series.y - np.mean(series.extent[2:]))
    near = np.zeros(x.shape, bool)
    for angle in np.radians(directions):
        near |= np.abs(y * np.cos(angle) - x * np.sin(angle)) < 0.6 * series.spacing
    r, h = np.hypot(x, y)[near], series.depth(-1)[near].astype(float)
    order = np.argsort(r)
    return r[order], h[order]


def slope(series, directions):
    """Angle of the flanks [deg] along lines through the centre: a straight line fitted to their cells.

    NaN where there is no flank: sand that has spread over the whole grid is nowhere below FLANK of its height.
    """
    r, h = flank(series, directions)
    chosen = (h > FLANK[0] * h.max()) & (h < FLANK[1] * h.max())
    if np.count_nonzero(chosen) < 3:
        return float("nan")
    return float(np.degrees(np.arctan(-np.polyfit(r[chosen], h[chosen], 1)[0])))


def friction_angle(series):
    """[deg], from the resolved scene, which may give it in either unit."""
    value, unit = series.scene["sand"]["friction_angle"].split()
    return float(value) if unit == "deg" else float(np.degrees(float(value)))


def main():
    parser = arguments(__doc__, result=False)
    parser.add_argument("results", type=Path, nargs="*", help="results of piles")
    parser.add_argument("--reuse", action="store_true", help="draw the results that are there")
    options = parser.parse_args()
    folders = options.results or [ROOT / f"results/piles_{angle}deg" for angle in ANGLES]
    if not options.results:
        for angle, folder in zip(ANGLES, folders):
            run(ROOT / f"scenes/piles/scene_{angle}deg.yaml", folder, reuse=options.reuse)

    count = len(folders)
    figure = plt.figure(figsize=(max(3.2 * count, 8), 6.4))
    pictures, below = figure.subfigures(2, 1, height_ratios=[1, 1.15])
    top = pictures.subplots(1, count, squeeze=False)[0]
    profiles, angles = below.subplots(1, 2)
    rows = []
    for index, folder in enumerate(folders):
        with Series(folder) as series:
            expected = friction_angle(series)
            axis, diagonal = slope(series, (0, 90)), slope(series, (45, 135))
            rows.append((expected, axis, diagonal, float(series.depth(-1).max())))
            show_field(top[index], series, -1)
            top[index].set_title(f"{series.title}\nstands at {axis:.1f}° (axis), {diagonal:.1f}° (diagonal)",
                                 fontsize=8)
            r, h = flank(series, (0, 90))
            profiles.plot(r, h, color=f"C{index}", label=f"{series.title}: axis")
            profiles.plot(*flank(series, (45, 135)), ":", color=f"C{index}", label="diagonal")
    rows = np.array(rows)
    profiles.set(xlabel="distance from the centre [m]", ylabel="depth of sand h [m]", title="Flanks at rest")
    profiles.legend()
    angles.plot([0, 70], [0, 70], color="0.7", label="slope = friction angle")
    angles.plot(rows[:, 0], rows[:, 1], "o", label="axis")
    angles.plot(rows[:, 0], rows[:, 2], "x", label="diagonal")
    angles.set(xlabel="friction angle [deg]", ylabel="slope at rest [deg]", title="Slopes")
    angles.legend()
    picture = options.output or (folders[0] / "piles.png" if options.results else ROOT / "results/piles.png")
    save(figure, picture)
    lines = ["| friction angle [deg] | axis [deg] | diagonal [deg] | height [m] |", "|---|---|---|---|"]
    lines += [f"| {row[0]:g} | {row[1]:.1f} | {row[2]:.1f} | {row[3]:.3f} |" for row in rows]
    picture.with_suffix(".md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
