#!/usr/bin/python3
"""Draws the collapse of a round column: profile at rest, and the runout against the bands of experiments."""

import numpy as np

from plotting import arguments, plt, save
from sandsim_series import Series

# Final runout (R_f - R0)/R0 per aspect ratio a = H0/R0, and the a up to which it was found.
RUNOUT = {"Lube et al. 2004": (1.24, 1.7), "Lajeunesse et al. 2004": (1.35, 0.74)}
THRESHOLDS = (0.001, 0.005)            # [m] depths that define the front


def radii(series):
    x, y = np.meshgrid(series.x - np.mean(series.extent[:2]), series.y - np.mean(series.extent[2:]))
    return np.hypot(x, y)


def main():
    options = arguments(__doc__).parse_args()
    with Series(options.result) as series:
        r = radii(series)
        start = series.depth(0)
        height = float(start.max())
        radius = float(np.sqrt(np.count_nonzero(start > height / 2) / np.pi) * series.spacing)
        ratio = height / radius
        figure, (profile, fronts) = plt.subplots(1, 2, figsize=(11, 4.3))
        figure.suptitle(series.title)
        profile.plot(r.ravel(), series.depth(-1).ravel(), ".", ms=2, label="all cells, at rest")
        profile.plot([0, radius, radius], [height, height, 0], color="0.6", label="released")
        profile.set(xlabel="distance from the axis [m]", ylabel="depth of sand h [m]", title="Deposit",
                    xlim=(0, 0.5 * (series.extent[1] - series.extent[0])))
        profile.legend()
        for threshold in THRESHOLDS:
            front = [r[series.depth(frame) > threshold].max() for frame in range(series.frames)]
            fronts.plot(series.time, front, label=f"h > {1e3 * threshold:g} mm: {front[-1]:.3f} m at the end")
        for index, (source, (factor, limit)) in enumerate(RUNOUT.items()):
            if ratio <= limit:
                fronts.axhline(radius * (1 + factor * ratio), color="0.4", ls=("--", ":")[index],
                               label=f"measured, at rest: {source}: {radius * (1 + factor * ratio):.3f} m")
        fronts.set(xlabel="t [s]", ylabel="radius of the front [m]", title=f"Runout, a = {ratio:.2f}")
        fronts.legend(loc="lower right")
        save(figure, options.output or series.directory / "column.png")


if __name__ == "__main__":
    main()
