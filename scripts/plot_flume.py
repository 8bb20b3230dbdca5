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


def find_file(name, folders):
    """A file that the scene names, relative to the scene's folder."""
    return next((folder / name for folder in folders if folder and (folder / name).is_file()), None)


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
    """Depth at several moments up to the end of the motion, and the exact solution while it is valid."""
    stop = series.report.get("stop_time") or series.time[-1]
    moments = np.unique([series.frame_at(stop * part) for part in (0, 0.125, 0.25, 0.375, 0.5, 0.75, 1)])
    for colour, frame in zip(plt.cm.viridis(np.linspace(0, 0.9, len(moments))), moments):
        axes.plot(series.x, series.depth(frame)[0], color=colour, label=f"t = {series.time[frame]:.2f} s")
    exact = [frame for frame in range(1, series.frames) if series.reference_depth(frame) is not None]
    for frame in exact[-1:]:
        axes.plot(series.x, series.reference_depth(frame), "k:", lw=1.2,
                  label=f"exact, t = {series.time[frame]:.2f} s")
    axes.set(xlabel="x [m]", ylabel="depth of sand h [m]", title="Profiles")
    axes.legend()


def draw_deposit(axes, series, reference, folders):
    """The last frame against the reference deposit and a measured profile. Returns what is missing."""
    axes.plot(series.x, series.depth(-1)[0], color="C0", label=f"sandsim, t = {series.time[-1]:.2f} s")
    missing = []
    for key, style, label in (("profile", "k--", "converged reference"), ("measured_profile", "ko", "measured")):
        name = reference.get(key)
        path = name and find_file(name, folders)
        if path:
            table = read_table(path)
            axes.plot(table["x_m"], table["depth_m"], style, ms=3, lw=1, label=f"{label}: {Path(name).name}")
        elif name and key == "measured_profile":
            missing.append(name)
    axes.set(xlabel="x [m]", ylabel="depth of sand h [m]", title="Deposit" + relative_error(series))
    axes.legend()
    return missing


def relative_error(series):
    errors = [error for error in series.errors() if error.get("l1_relative") is not None]
    return "".join(f" (relative L1 error {error['l1_relative']:.2e})" for error in errors[-1:])


def draw_fronts(axes, series, reference, folders):
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
    missing = []
    name = reference.get("measured_front")
    path = name and find_file(name, folders)
    if path:
        table = read_table(path)
        axes.plot(table["time_s"], table["front_m"], "ko", ms=3, label=f"measured: {Path(name).name}")
    elif name:
        missing.append(name)
    axes.set(xlabel="t [s]", ylabel="front, from the wall [m]", title="Fronts")
    axes.set_ylim(bottom=0)
    axes.legend(loc="lower right")
    return missing


def main():
    parser = arguments(__doc__)
    parser.add_argument("--scene", type=Path, help="scene file: data that it names are looked for beside it")
    options = parser.parse_args()
    with Series(options.result) as series:
        reference = series.scene.get("reference") or {}
        folders = [options.scene and options.scene.parent, series.directory, Path("/")]
        figure, axes = plt.subplots(1, 3, figsize=(14, 4.3))
        figure.suptitle(series.title)
        draw_profiles(axes[0], series)
        missing = draw_deposit(axes[1], series, reference, folders)
        missing += draw_fronts(axes[2], series, reference, folders)
        if missing:
            figure.supxlabel("Measured data missing: " + ", ".join(missing) + " (the scene's README says what they "
                             "are and where they go)", fontsize=8, color="#a02020")
        save(figure, options.output or series.directory / "flume.png")


if __name__ == "__main__":
    main()
