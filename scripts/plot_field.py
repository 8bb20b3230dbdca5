#!/usr/bin/python3
"""Draws a 2-D result as a shaded height field: one frame as a PNG, or all frames as an MP4."""

import numpy as np

from movies import Movie
from plotting import arguments, plt, save, shaded, show_field
from sandsim_series import Series


def choose_frame(series, options):
    if options.time is not None:
        return series.frame_at(options.time)
    return options.frame


def draw(series, frame, largest, exaggeration):
    """The figure of one frame, with what has to change from frame to frame: (figure, image, title)."""
    height = 4.6
    width, tall = series.extent[1] - series.extent[0], series.extent[3] - series.extent[2]
    figure, axes = plt.subplots(figsize=(float(np.clip(height * width / tall + 1.2, 4.5, 12)), height))
    image, scale = show_field(axes, series, frame, largest, exaggeration)
    figure.colorbar(scale, ax=axes, label="depth of sand h [m]", shrink=0.85)
    title = axes.set_title(caption(series, frame))
    return figure, image, title


def caption(series, frame):
    return f"{series.title}\nt = {series.time[frame]:.2f} s"


def write_movie(series, path, largest, exaggeration, rate):
    figure, image, title = draw(series, 0, largest, exaggeration)
    figure.canvas.draw()
    figure.set_layout_engine("none")     # the layout stays that of the first frame
    with Movie(path, rate) as movie:
        for frame in range(series.frames):
            image.set_data(shaded(series.surface(frame).astype(float), series.depth(frame).astype(float),
                                  series.spacing, largest, exaggeration))
            title.set_text(caption(series, frame))
            figure.canvas.draw()
            movie.add(np.asarray(figure.canvas.buffer_rgba()))
    plt.close(figure)
    print(path)


def main():
    parser = arguments(__doc__)
    parser.add_argument("--frame", type=int, default=-1, help="frame to draw (default: the last)")
    parser.add_argument("--time", type=float, help="draw the frame nearest to this time [s]")
    parser.add_argument("--movie", action="store_true", help="write an MP4 of all frames instead")
    parser.add_argument("--fps", type=float, default=25, help="frames a second of the movie")
    parser.add_argument("--exaggeration", type=float, default=1.0, help="vertical exaggeration of the shading")
    parser.add_argument("--max-depth", type=float, help="depth at the end of the colour scale [m]")
    options = parser.parse_args()
    with Series(options.result) as series:
        frame = choose_frame(series, options)
        if options.movie:
            # One scale for all frames, from the middle of the run: the start is often a tall block.
            largest = options.max_depth or float(series.depth(series.frames // 2).max())
            write_movie(series, options.output or series.directory / "field.mp4", largest, options.exaggeration,
                        options.fps)
        else:
            figure, _, _ = draw(series, frame, options.max_depth, options.exaggeration)
            save(figure, options.output or series.directory / "field.png")


if __name__ == "__main__":
    main()
