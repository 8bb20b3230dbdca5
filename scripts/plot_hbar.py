#!/usr/bin/python3
"""Figure 6: the same column collapses with a dilute layer of 10, 20 and 40 cells. Runs the scene if need be."""

import numpy as np

from plotting import ROOT, arguments, plt, run, save, show_field
from sandsim_series import Series

LAYERS = (10, 20, 40)                  # hbar [cells]
MOMENT = 0.16                          # [s] at which the fields are drawn
FRONT_DEPTH = 0.005                    # [m] sand deeper than this counts for the front


def front_radius(series, frame):
    """Largest distance from the grid's centre with more than FRONT_DEPTH of sand [m]."""
    x, y = np.meshgrid(series.x - np.mean(series.extent[:2]), series.y - np.mean(series.extent[2:]))
    return float(np.hypot(x, y)[series.depth(frame) > FRONT_DEPTH].max())


def main():
    parser = arguments(__doc__, result=False)
    parser.add_argument("--reuse", action="store_true", help="draw the results that are there")
    options = parser.parse_args()
    figure = plt.figure(figsize=(11, 7))
    above, below = figure.subfigures(2, 1, height_ratios=[1.1, 1])
    pictures = above.subplots(1, len(LAYERS))
    fronts, energy = below.subplots(1, 2)
    lines = [f"| hbar [cells] | front at {MOMENT:g} s [m] | front at rest [m] | largest kinetic energy [m^5/s^2] |",
             "|---|---|---|---|"]
    for picture, cells in zip(pictures, LAYERS):
        folder = ROOT / f"results/hbar_{cells}"
        run(ROOT / "scenes/hbar/scene.yaml", folder, reuse=options.reuse,
            settings=[f"title=Column collapse, hbar = {cells} cells", f"sand.hbar.depth={cells} cells"])
        with Series(folder) as series:
            moment = series.frame_at(MOMENT)
            _, scale = show_field(picture, series, moment, largest=0.15)
            picture.set_title(f"hbar = {cells} cells, t = {series.time[moment]:.2f} s")
            radius = [front_radius(series, frame) for frame in range(series.frames)]
            fronts.plot(series.time, radius, label=f"hbar = {cells} cells")
            energy.plot(series.time, series.numbers["kinetic_energy"], label=f"hbar = {cells} cells")
            lines.append(f"| {cells} | {radius[moment]:.3f} | {radius[-1]:.3f} | "
                         f"{series.numbers['kinetic_energy'].max():.2e} |")
    above.colorbar(scale, ax=pictures, label="depth of sand h [m]", extend="max")
    fronts.set(xlabel="t [s]", ylabel="radius of the front [m]", title=f"Front (h > {1e3 * FRONT_DEPTH:g} mm)")
    energy.set(xlabel="t [s]", ylabel="kinetic energy / density [m$^5$/s$^2$]", title="Kinetic energy")
    fronts.legend()
    energy.legend()
    picture = options.output or ROOT / "results/hbar.png"
    save(figure, picture)
    picture.with_suffix(".md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
