#!/usr/bin/python3
"""Draws what objects did to the sand: shaded maps of each result at each time, and a section through all of them.

Prints for every map the volume above and below the surface at the start, the largest rise and the deepest hole, and
the trenches that the section crosses.
"""

import matplotlib
import numpy as np

from plotting import BARE, SAND, arguments, lit, plt, save
from sandsim_series import Series

# Below the level of the start, as it was, above it.
CHANGE = matplotlib.colors.LinearSegmentedColormap.from_list(
    "change", ["#2d5d8c", "#b9cad6", "#f3e8cf", "#d9a45c", "#8a4b16"])
plt.rcParams["savefig.dpi"] = 100     # maps compress badly
PILLAR = "#3f4347"


def shown(series, frame, quantity):
    """The field of a map and of the section: the depth, or how far the surface has risen since the start."""
    depth = series.depth(frame).astype(float)
    return depth if quantity == "depth" else depth - series.depth(0).astype(float)


def solid(series):
    """Cells whose ground is far above that of their neighbours: solid objects in the terrain."""
    x, y = np.meshgrid(series.x - series.x.mean(), series.y - series.y.mean())
    plane = np.column_stack([np.ones(x.size), x.ravel(), y.ravel()])
    low = series.bed.ravel() <= np.median(series.bed) + np.ptp(series.bed)
    fit = np.linalg.lstsq(plane[low], series.bed.ravel()[low], rcond=None)[0]
    off = series.bed - (plane @ fit).reshape(series.bed.shape)
    return off > np.median(off) + 5 * series.spacing


def draw_map(axes, series, frame, options, limit):
    field = shown(series, frame, options.quantity)
    cmap, low = (SAND, 0.0) if options.quantity == "depth" else (CHANGE, -limit)
    colours = cmap((field - low) / (limit - low))[..., :3]
    if options.quantity == "depth":
        colours[field <= 0.005 * limit] = matplotlib.colors.to_rgb(BARE)
    picture = lit(colours, field, series.spacing, options.exaggeration)
    picture[solid(series)] = matplotlib.colors.to_rgb(PILLAR)
    axes.imshow(picture, origin="lower", extent=100 * np.array(series.extent), interpolation="nearest")
    axes.grid(False)
    axes.set(xlabel="x [cm]", ylabel="y [cm]")
    return plt.cm.ScalarMappable(plt.Normalize(100 * low, 100 * limit), cmap)


def section(series, field, options):
    """Positions and values of `field` along the row or column of cells nearest to the section."""
    if options.axis == "x":
        return series.x, field[np.argmin(np.abs(series.y - options.at))]
    return series.y, field[:, np.argmin(np.abs(series.x - options.at))]


def trenches(place, values):
    """Where a section lies more than 1 mm below its level at the start: (middle, width at that level, depth). [m]"""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], values < -1e-3, [0]]).astype(int)))
    crossing = lambda a, b: place[a] - values[a] * (place[b] - place[a]) / (values[b] - values[a])  # noqa: E731
    for first, end in edges.reshape(-1, 2):
        left = crossing(first - 1, first) if first > 0 else place[0]
        right = crossing(end - 1, end) if end < place.size else place[-1]
        yield (left + right) / 2, right - left, -values[first:end].min()


def measure(series, frame, label):
    change = shown(series, frame, "change")
    area = series.spacing**2
    above, below = area * change.clip(min=0).sum(), area * (-change).clip(min=0).sum()
    print(f"{label}: above {above:.4e} m^3, below {below:.4e} m^3, highest {100 * change.max():+.2f} cm, "
          f"lowest {100 * change.min():+.2f} cm")


def main():
    parser = arguments(__doc__, result=False)
    parser.add_argument("results", nargs="+", help="result folders")
    parser.add_argument("--times", type=float, nargs="+", help="times of the maps [s] (default: the last frame)")
    parser.add_argument("--labels", nargs="+", help="one name a result (default: the titles)")
    parser.add_argument("--quantity", choices=("change", "depth"), default="change", help="what is drawn")
    parser.add_argument("--axis", choices=("x", "y"), default="x", help="direction of the section")
    parser.add_argument("--at", type=float, default=0.0, help="place of the section on the other axis [m]")
    parser.add_argument("--limit", type=float, help="end of the colour scale [m]")
    parser.add_argument("--exaggeration", type=float, default=1.0, help="vertical exaggeration of the shading")
    parser.add_argument("--columns", type=int, help="maps in a row")
    parser.add_argument("--title", help="title of the picture")
    options = parser.parse_args()

    results = [Series(path) for path in options.results]
    labels = options.labels or ([""] if len(results) == 1 else [series.title for series in results])
    shots = [(series, series.frame_at(time) if time is not None else series.frames - 1, label)
             for series, label in zip(results, labels, strict=True) for time in options.times or [None]]
    fields = [shown(series, frame, options.quantity) for series, frame, _ in shots]
    limit = options.limit or max(float(np.abs(field).max()) for field in fields) or 1e-3
    columns = options.columns or min(len(shots), 3)
    rows = -(-len(shots) // columns)

    extent = results[0].extent
    tall = 7.4 / columns * (extent[3] - extent[2]) / (extent[1] - extent[0]) + 0.55
    figure = plt.figure(figsize=(9.0, tall * rows + 2.5))
    grid = figure.add_gridspec(rows + 1, columns, height_ratios=[tall] * rows + [2.1])
    below = figure.add_subplot(grid[rows, :])
    maps = []
    for k, ((series, frame, label), field) in enumerate(zip(shots, fields)):
        name = ", ".join(part for part in (label, f"t = {series.time[frame]:.2f} s") if part)
        maps.append(figure.add_subplot(grid[k // columns, k % columns]))
        scale = draw_map(maps[-1], series, frame, options, limit)
        maps[-1].set_title(name)
        line = maps[-1].axhline if options.axis == "x" else maps[-1].axvline
        line(100 * options.at, color="k", lw=0.6, ls=":")
        place, values = section(series, field, options)
        below.plot(100 * place, 100 * values, label=name)
        measure(series, frame, name)
        if options.quantity == "depth":
            continue
        for middle, width, depth in trenches(*section(series, shown(series, frame, "change"), options)):
            print(f"  trench at {100 * middle:.1f} cm: {100 * width:.1f} cm wide, {100 * depth:.2f} cm deep")
    what = "depth of sand [cm]" if options.quantity == "depth" else "surface since the start [cm]"
    figure.colorbar(scale, ax=maps, label=what, shrink=0.8, aspect=25)
    other = "y" if options.axis == "x" else "x"
    below.set(xlabel=f"{options.axis} [cm]", ylabel="depth [cm]" if options.quantity == "depth" else "change [cm]",
              title=f"Section at {other} = {100 * options.at:g} cm")
    below.legend(ncols=2 if len(shots) > 3 else 1)
    figure.suptitle(options.title or results[0].title)
    save(figure, options.output or results[0].directory / "objects.png")


if __name__ == "__main__":
    main()
