#!/usr/bin/python3
"""Draws a 1-D dam break: profiles over time, the deposit against its references, and fronts over time.

Measured data are drawn where the scene names files that exist; where they do not, the figure says so.
"""

from pathlib import Path

import numpy as np

from plotting import arguments, plt, save
from sandsim_series import Series, read_table

# Final runout (L_f - L0)/L0 of a collapsing column in a channel, per aspect ratio a = H0/L0 (a <= 0.7).
CHANNEL_RUNOUT = {"Lube et al. 2005": 1.2, "Lajeunesse et al. 2005, glass beads": 1.8}
LARGEST_ASPECT_RATIO = 0.7


def short(path):
    """The end of a path: enough to find it in the scene."""
    return "/".join(Path(path).parts[-2:])


def column(series):
    """(length, height) [m] of a single block of sand against the left wall of a flat channel, else None."""
    parts = series.scene.get("sand", {}).get("initial") or []
    parts = parts if isinstance(parts, list) else [parts]
    if len(parts) != 1 or parts[0].get("type") != "box" or np.ptp(series.bed) > 0:
        return None
    depth = series.depth(0)[0]
    filled = depth > 0
    length = filled.sum() * series.spacing
    # Sand must end inside the grid, and start at the wall.
    return (length, float(depth.max())) if filled[0] and not filled[-1] else None


def draw_profiles(axes, series):
    """Depth at several moments of the motion, and the exact solution while it is valid."""
    energy = series.numbers["kinetic_energy"]
    # The flow proper: until a thousandth of the largest energy is left.
    end = series.time[np.flatnonzero(energy >= 1e-3 * energy.max())[-1]]
    moments = np.unique([series.frame_at(end * part) for part in (0, 0.125, 0.25, 0.375, 0.5, 0.75, 1)])
    for colour, frame in zip(plt.cm.viridis(np.linspace(0, 0.9, len(moments))), moments):
        axes.plot(series.x, series.depth(frame)[0], color=colour, label=f"t = {series.time[frame]:.2f} s")
    exact = [frame for frame in range(1, series.frames) if series.reference_depth(frame) is not None]
    for frame in exact[-1:]:
        axes.plot(series.x, series.reference_depth(frame), "k:", lw=1.2,
                  label=f"exact, t = {series.time[frame]:.2f} s")
    axes.set(xlabel="x [m]", ylabel="depth of sand h [m]", title="Profiles")
    axes.legend()


def draw_deposit(axes, series, reference):
    """The last frame against the reference deposit and a measured profile. Returns what is missing."""
    axes.plot(series.x, series.depth(-1)[0], color="C0", label=f"sandsim, t = {series.time[-1]:.2f} s")
    missing = []
    for key, style, label in (("profile", "k--", "converged reference"), ("measured_profile", "ko", "measured")):
        path = reference.get(key)
        if path and Path(path).is_file():
            table = read_table(path)
            axes.plot(table["x_m"], table["depth_m"], style, ms=3, lw=1, label=f"{label}: {Path(path).name}")
        elif path:
            missing.append(path)
    axes.set(xlabel="x [m]", ylabel="depth of sand h [m]", title="Deposit" + relative_error(series))
    axes.legend()
    return missing


def relative_error(series):
    """The error against the reference deposit, for the title."""
    errors = [error["l1_relative"] for error in series.errors()
              if error["against"].startswith("profile") and error.get("l1_relative") is not None]
    return "".join(f" (relative L1 error {error:.2e})" for error in errors)


def draw_fronts(axes, series, reference):
    """Fronts over time, the exact tip, measured fronts, and the bands of column collapses. Returns what is missing."""
    if series.fronts is not None:
        for index, depth in enumerate(series.front_depths):
            axes.plot(series.time, series.fronts[:, index],
                      label=f"front where h > {1e3 * depth:g} mm: {series.fronts[-1, index]:.3f} m at the end")
    if series.reference_tip is not None:
        axes.plot(series.time, series.reference_tip, "k:", label="exact tip (h → 0)")
    block = column(series)
    if block and block[1] / block[0] <= LARGEST_ASPECT_RATIO:
        length, height = block
        ends = {source: length + factor * height for source, factor in CHANNEL_RUNOUT.items()}
        axes.axhspan(*sorted(ends.values()), color="0.85", zorder=0,
                     label=f"measured columns of a = {height / length:g} at rest:\n" + " to\n".join(ends))
    path = reference.get("measured_front")
    measured = path and Path(path).is_file()
    if measured:
        table = read_table(path)
        axes.plot(table["time_s"], table["front_m"], "ko", ms=3, label=f"measured: {Path(path).name}")
    axes.set(xlabel="t [s]", ylabel="front, from the wall [m]", title="Fronts")
    axes.set_ylim(bottom=0)
    axes.legend(loc="lower right")
    return [path] if path and not measured else []


def main():
    options = arguments(__doc__).parse_args()
    with Series(options.result) as series:
        reference = series.scene.get("reference") or {}
        figure, axes = plt.subplots(1, 3, figsize=(14, 4.3))
        figure.suptitle(series.title)
        draw_profiles(axes[0], series)
        missing = draw_deposit(axes[1], series, reference)
        missing += draw_fronts(axes[2], series, reference)
        if missing:
            figure.supxlabel("Missing: " + ", ".join(map(short, missing)) + " (the scene's README says what they "
                             "are and where they go)", fontsize=8, color="#a02020")
        save(figure, options.output or series.directory / "flume.png")


if __name__ == "__main__":
    main()
