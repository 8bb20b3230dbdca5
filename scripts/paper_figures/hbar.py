"""Figure 6: the same column with three depths of the dilute layer."""

import numpy as np

from plot_hbar import FRONT_DEPTH, LAYERS, MOMENT, front_radius
from plotting import plt, show_field

from .model import Claim, Figure, Outcome, Run

RUNS = tuple(Run(f"hbar_{cells}", "hbar/scene.yaml",
                 (f"title=Column collapse, hbar = {cells} cells", f"sand.hbar.depth={cells} cells"))
             for cells in LAYERS)


def rises(values):
    return all(np.diff(values) > 0)


def draw(studio):
    figure = plt.figure(figsize=(11, 6.6))
    above, below = figure.subfigures(2, 1, height_ratios=[1.1, 1])
    pictures, (fronts, energy) = above.subplots(1, len(LAYERS)), below.subplots(1, 2)
    values = []
    for picture, cells in zip(pictures, LAYERS):
        with studio.series(f"hbar_{cells}") as series:
            moment = series.frame_at(MOMENT)
            _, scale = show_field(picture, series, moment, largest=0.15)
            picture.set_title(f"hbar = {cells} cells, t = {series.time[moment]:.2f} s")
            radius = [front_radius(series, frame) for frame in range(series.frames)]
            kinetic = series.numbers["kinetic_energy"]
            fronts.plot(series.time, radius, label=f"hbar = {cells} cells")
            energy.plot(series.time, kinetic, label=f"hbar = {cells} cells")
            values.append((radius[moment], radius[-1], kinetic.max(), series.report["stop_time"]))
    above.colorbar(scale, ax=pictures, label="depth of sand h [m]", extend="max")
    fronts.set(xlabel="t [s]", ylabel="radius of the front [m]", title=f"Front (h > {1e3 * FRONT_DEPTH:g} mm)")
    energy.set(xlabel="t [s]", ylabel="kinetic energy / density [m$^5$/s$^2$]", title="Kinetic energy")
    fronts.legend()
    at_moment, at_rest, kinetic, stop = zip(*values)
    names = ", ".join(map(str, LAYERS))
    rows = [[str(cells), *(f"{value:.3g}" for value in row)] for cells, row in zip(LAYERS, values)]
    return Outcome(
        pictures=[(studio.save(figure, "hbar.png"), "The column with hbar of " + names + " cells.")],
        claims=[Claim("'the larger value of hbar we use, the more rapid the dry granules flow'",
                      f"front at {MOMENT:g} s for {names} cells: " + ", ".join(f"{x:.3f}" for x in at_moment)
                      + " m; at rest " + ", ".join(f"{x:.3f}" for x in at_rest) + " m",
                      "the front at that moment, the front at rest and the largest kinetic energy all grow with hbar",
                      rises(at_moment) and rises(at_rest) and rises(kinetic))],
        tables=[("", ["hbar [cells]", f"front at {MOMENT:g} s [m]", "front at rest [m]",
                      "largest kinetic energy over density [m^5/s^2]", "at rest from [s]"], rows)],
        notes=["The shape of the paper's sand is not given; a column of 12 cm radius and 45 cells height is ours, so "
               "that hbar of 40 cells is less than its depth.",
               "The front goes where sand is deeper than 5 mm."])


FIGURE = Figure("6", "Fig. 6: three depths of the dilute layer",
                "'Figure 6 also demonstrates the simulation results of using different hbar. It can be noted that the "
                "larger value of hbar we use, the more rapid the dry granules flow.' Table 1: 256 x 256, 30 deg, hbar "
                "of 10 to 40 cells.", draw, RUNS)
