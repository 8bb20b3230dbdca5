#!/usr/bin/python3
"""Draws the surface of the sand from above as a shaded relief: tracks and writing show as their slopes.

    scripts/plot_relief.py RESULT -o FILE [--time 2 5 8]      one panel a time; without times the last frame
"""

import numpy as np
from matplotlib.colors import LightSource, to_rgb

from plotting import BARE, SAND, arguments, plt, save
from sandsim_series import Series


def relief(series, frame, exaggeration, tones):
    """RGB (y, x, 3) of a frame, lit from the north-west: sand darker where it is high, bare ground grey.

    LightSource.hillshade stretches every picture to its own contrast; here level sand is equally bright in all.
    """
    surface, depth = series.surface(frame).astype(float), series.depth(frame).astype(float)
    colours = SAND(0.2 + 0.35 * np.clip((surface - tones[0]) / (tones[1] - tones[0]), 0, 1))[..., :3]
    colours[depth < 1e-3 * series.spacing] = to_rgb(BARE)
    light = LightSource(azdeg=315, altdeg=45)
    rise_y, rise_x = np.gradient(exaggeration * surface, series.spacing)
    normal = np.stack([-rise_x, -rise_y, np.ones_like(surface)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    shade = np.clip(0.5 * (normal @ light.direction) / light.direction[2], 0, 1)   # level: 0.5, which changes nothing
    return light.blend_overlay(colours, shade[..., None])


def tone_range(series, frames):
    """Elevations between which the colour changes, the same for all panels. [m]"""
    surfaces = np.stack([series.surface(frame) for frame in frames])
    low, high = np.percentile(surfaces, [1, 99])
    return low, max(high, low + 2 * series.spacing)


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--time", type=float, nargs="+", help="draw the frames nearest to these times [s]")
    parser.add_argument("--exaggeration", type=float, default=1.0, help="vertical exaggeration of the shading")
    parser.add_argument("--columns", type=int, help="panels side by side (default: all)")
    parser.add_argument("--dpi", type=int, default=100, help="dots per inch")
    options = parser.parse_args()
    with Series(options.result) as series:
        frames = [series.frame_at(time) for time in options.time] if options.time else [series.frames - 1]
        columns = min(options.columns or len(frames), len(frames))
        rows = -(-len(frames) // columns)
        west, east, south, north = series.extent
        width = 4.6 if columns > 1 else 6.5
        height = width * (north - south) / (east - west)
        figure, panels = plt.subplots(rows, columns, squeeze=False,
                                      figsize=(columns * width, rows * (height + 0.3) + 0.5))
        for panel in panels.flat:
            panel.axis("off")
        tones = tone_range(series, frames)
        for panel, frame in zip(panels.flat, frames):
            panel.imshow(relief(series, frame, options.exaggeration, tones), origin="lower", extent=series.extent)
            panel.set_title(f"t = {series.time[frame]:.2f} s")
        plt.rcParams["savefig.dpi"] = options.dpi
        figure.suptitle(f"{series.title} ({east - west:g} m x {north - south:g} m)", fontsize=10)
        save(figure, options.output or series.directory / "relief.png")


if __name__ == "__main__":
    main()
