"""Pictures and movies of a result by a ray tracer: sand, ground, objects and particles, with cast shadows.

  scripts/render results/butterfly                                   the last frame, results/butterfly/render.png
  scripts/render results/trails --time 1 2 4 -o trails.png           three frames side by side
  scripts/render results/cars --movie                                all frames, results/cars/render.mp4
  scripts/render results/avalanche --sand snow --view 20 25          from another side, as snow
  scripts/render results/trails --look-at 0.5 0.4 0.05 --zoom 3      closer
  scripts/render results/blades --show particles --quality best      with its particles (`particles:` in the scene)
  scripts/render results/piles_30deg --colour depth                  depth in colours, with a bar

It draws with POV-Ray, and movies with ffmpeg; neither needs a display.
"""

import argparse
import os
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import povray
import render_look
import render_scene
from movies import Movie
from plotting import plt
from render_camera import framed
from render_objects import HEADROOM, Bodies, number
from render_particles import RADIUS, particles, side_by_side
from sandsim_series import Series

# Short runs of POV-Ray spend half of their time asleep: two for each processor.
WORKERS = 2 * len(os.sched_getaffinity(0))
COLOURED = {"depth": ("depth of sand h [m]", "viridis"), "speed": ("speed of sand [m/s]", "YlOrRd")}
BAR_WIDTH, TITLE_HEIGHT = 110, 34          # [pixels] beside and above a coloured picture
PANELS_IN_A_ROW = 3
GAP = 6                                    # [pixels] between panels


class Renderer:
    """Draws frames of a result, all from the same place and in the same light."""

    def __init__(self, series, options, folder):
        self.series, self.options, self.folder = series, options, folder
        if options.show == "particles" and not series.has_particles:
            raise ValueError(f"{series.file}: no particles here: ask for them with `particles:` in the scene")
        self.quality = render_look.QUALITIES[options.quality]
        if options.show == "particles" or options.colour:
            self.quality = render_look.with_even_sky(self.quality)
        sampled = sorted(set(np.linspace(0, series.frames - 1, 6).astype(int)))
        self.domain = domain = render_scene.Domain(series, sampled)
        self.bodies = None
        objects = series.scene.get("objects") or []
        if objects and not options.no_objects:
            if series.has_objects:
                self.bodies = Bodies(folder, domain, objects)
            elif not all(is_ground(item) for item in objects):
                print(f"note: {series.file} does not say where its objects are: they are left out", file=sys.stderr)
        visible = domain.corners()
        if self.bodies:
            boxes = [domain.local(self.bodies.boxes(series.objects(frame))) for frame in sampled]
            # Objects that are lifted or driven away do not push the sand out of sight.
            visible = np.concatenate([visible, np.clip(np.concatenate(boxes), domain.low,
                                                       domain.high + [0, 0, HEADROOM])])
        width, height = options.size
        self.camera = framed(visible, options.view, width / height, options.zoom,
                             None if options.look_at is None else domain.local(options.look_at),
                             None if options.distance is None else options.distance * domain.scale)
        grain = render_look.GRAIN * self.camera.pixel(width)
        self.static = "\n".join([
            render_look.settings(self.camera, self.quality),
            render_look.light(self.camera, self.quality, even=options.colour is not None),
            render_look.materials(options.sand, grain),
            render_scene.ground(folder, domain), self.bodies.text if self.bodies else ""])

    def pictures(self, frames, largest):
        """Pictures of frames in their order, several at a time."""
        # Which of radiosity's samples are there to share depends on the threads: with one, pictures keep their bits.
        one = len(frames) > 1 or self.quality.radiosity
        with ThreadPoolExecutor(WORKERS) as pool:
            yield from pool.map(lambda frame: self.picture(frame, largest, threads=1 if one else None), frames)

    def picture(self, frame, largest=None, threads=1):
        """(height, width, 3) uint8; `largest` is the value at the end of the colours."""
        name = f"frame{frame}"
        parts = [self.static]
        depth = self.series.depth(frame).astype(float)
        if self.options.colour:
            colours = plt.get_cmap(COLOURED[self.options.colour][1])(self.values(frame) / largest)[..., :3]
            parts.append(render_scene.colour_map(self.folder, name, self.domain, colours))
        layers = 0.0
        if self.options.show == "particles":
            spacing = number(self.series.scene["particles"]["spacing"])
            layers = spacing * self.series.scene["particles"]["layers"]
            positions, ids = self.series.particles(frame)
            if self.series.one_dimensional:
                _, _, south, north = self.series.extent
                positions, ids = side_by_side(positions - [0, south, 0], ids, north - south,
                                              render_scene.ROW_WIDTH * self.domain.span)
            parts.append(particles(self.domain, positions, ids, RADIUS * spacing, self.options.sand))
        parts.append(render_scene.sand(self.folder, name, self.domain, depth, lowered=layers))
        if self.bodies:
            parts.append(self.bodies.placed(self.series.objects(frame)))
        return povray.trace(self.folder, name, "\n".join(parts), self.options.size, self.quality.options, threads)

    def values(self, frame):
        """What colours stand for: (y, x)."""
        if self.options.colour == "depth":
            return self.series.depth(frame).astype(float)
        return np.hypot(*(component.astype(float) for component in self.series.velocity(frame)))

    def largest(self, frames):
        """The end of the colours for some frames: single cells may lie above it."""
        if not self.options.colour:
            return None
        return max(max(float(np.percentile(self.values(frame), 99.8)) for frame in frames), 1e-9)


def is_ground(item):
    """Whether an object of a scene is part of the terrain, and drawn with it."""
    return item.get("coupling") == "solid" and item.get("motion", {}).get("type", "fixed") == "fixed"


class Coloured:
    """Puts a title above a picture and a bar of colours beside it."""

    def __init__(self, series, quantity, largest):
        self.series, self.largest = series, largest
        self.label, self.colours = COLOURED[quantity]
        self.figure = None

    def around(self, picture, frame):
        """(height, width, 3) uint8"""
        if self.figure is None:
            self._lay_out(picture)
        self.image.set_data(picture)
        self.title.set_text(f"{self.series.title}, t = {self.series.time[frame]:.2f} s")
        self.figure.canvas.draw()
        return np.asarray(self.figure.canvas.buffer_rgba())[..., :3].copy()

    def _lay_out(self, picture):
        height, width = picture.shape[:2]
        across, up = width + BAR_WIDTH, height + TITLE_HEIGHT
        self.figure = plt.figure(figsize=(across / 100, up / 100), dpi=100, layout="none")
        axes = self.figure.add_axes([0, 0, width / across, height / up])
        axes.axis("off")
        self.image = axes.imshow(picture, aspect="auto", interpolation="nearest")
        bar = self.figure.add_axes([(width + 12) / across, 0.12, 16 / across, 0.7])
        bar.grid(False)
        scale = plt.cm.ScalarMappable(plt.Normalize(0, self.largest), self.colours)
        self.figure.colorbar(scale, cax=bar, label=self.label)
        self.title = self.figure.text(0.5, 1 - TITLE_HEIGHT / 2 / up, "", ha="center", va="center", fontsize=11)


def draw_stills(renderer, frames, path):
    """One picture, or panels of several, left to right and down."""
    largest = renderer.largest(frames)
    once = sorted(set(frames))
    drawn = dict(zip(once, renderer.pictures(once, largest)))
    pictures = [drawn[frame] for frame in frames]
    if renderer.options.colour:
        decoration = Coloured(renderer.series, renderer.options.colour, largest)
        pictures = [decoration.around(picture, frame) for picture, frame in zip(pictures, frames)]
    path.parent.mkdir(parents=True, exist_ok=True)
    plt.imsave(path, panels(pictures), pil_kwargs={"quality": 88} if path.suffix == ".jpg" else None)
    print(path)


def panels(pictures):
    """Pictures of one size as one."""
    columns = min(len(pictures), PANELS_IN_A_ROW)
    count = -(-len(pictures) // columns)
    height, width = pictures[0].shape[:2]
    whole = np.full((count * (height + GAP) - GAP, columns * (width + GAP) - GAP, 3), 255, np.uint8)
    for k, picture in enumerate(pictures):
        row, column = divmod(k, columns)
        whole[row * (height + GAP):, column * (width + GAP):][:height, :width] = picture
    return whole


def draw_movie(renderer, path, rate):
    """All frames."""
    series = renderer.series
    largest = renderer.largest(sorted(set(np.linspace(0, series.frames - 1, 12).astype(int))))
    decoration = Coloured(series, renderer.options.colour, largest) if renderer.options.colour else None
    started = time.monotonic()
    with Movie(path, rate) as movie:
        for frame, picture in enumerate(renderer.pictures(range(series.frames), largest)):
            movie.add(decoration.around(picture, frame) if decoration else picture)
            progress(frame + 1, series.frames, time.monotonic() - started)
    print(path)


def progress(done, of, seconds):
    if sys.stderr.isatty():
        left = seconds / done * (of - done)
        end = "\n" if done == of else ""
        print(f"\r{done} of {of} frames, {seconds / done:.1f} s each, {left:.0f} s left  ", end=end, file=sys.stderr)


def play_rate(series):
    """Frames a second that show the movie at the speed of the sand, if an eye can follow that."""
    if series.frames < 2:
        return 25.0
    return float(np.clip((series.frames - 1) / (series.time[-1] - series.time[0]), 5, 60))


def picture_size(text):
    try:
        width, height = (int(part) for part in text.split("x"))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no size; say, for instance, 960x540") from None
    if not (16 <= width <= 8192 and 16 <= height <= 8192):
        raise argparse.ArgumentTypeError(f"'{text}': sides of 16 to 8192 pixels")
    return width, height


def positive(text):
    number = float(text)
    if not 0 < number < np.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is not above 0")
    return number


def parser():
    result = argparse.ArgumentParser(prog="scripts/render", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("result", type=Path, help="result folder or series.h5")
    result.add_argument("-o", "--output", type=Path, metavar="FILE",
                        help=".png, .jpg or .mp4 (default: render.png or render.mp4 beside the result)")
    what = result.add_argument_group("what is drawn")
    what.add_argument("--time", type=float, nargs="+", metavar="T",
                      help="frames nearest to these times [s], side by side")
    what.add_argument("--movie", action="store_true", help="all frames; so does -o FILE.mp4")
    what.add_argument("--fps", type=positive, metavar="N", help="frames a second of the movie (default: real time)")
    what.add_argument("--show", choices=("surface", "particles"), default="surface",
                      help="sand as its surface, or with its particles on it")
    what.add_argument("--sand", choices=tuple(render_look.GRAINS), default="sand", help="what it looks like")
    what.add_argument("--colour", choices=tuple(COLOURED), help="colours and a bar instead of sand's own look")
    what.add_argument("--no-objects", action="store_true", help="leave objects out")
    camera = result.add_argument_group("from where")
    camera.add_argument("--view", type=float, nargs=2, default=(-60, 32), metavar=("AZIMUTH", "ELEVATION"),
                        help="side [deg] on which the camera stands (0: +x, 90: +y) and its height (default: -60 32)")
    camera.add_argument("--zoom", type=positive, default=1.0, metavar="FACTOR", help="2 shows things twice as large")
    camera.add_argument("--look-at", type=float, nargs=3, metavar=("X", "Y", "Z"),
                        help="point in the middle of the picture [m] (default: the middle of the scene)")
    camera.add_argument("--distance", type=positive, metavar="D", help="of the camera from that point [m]")
    how = result.add_argument_group("how")
    how.add_argument("--size", type=picture_size, default=(960, 540), metavar="WxH", help="pixels (default: 960x540)")
    how.add_argument("--quality", choices=tuple(render_look.QUALITIES), default="good",
                     help="draft: an even sky and sharp shadows; good; best: ten times as long (default: good)")
    return result


def main(arguments=None):
    options = parser().parse_args(arguments)
    movie = options.movie or (options.output is not None and options.output.suffix == ".mp4")
    suffixes = (".mp4",) if movie else (".png", ".jpg")
    if options.output is not None and options.output.suffix not in suffixes:
        raise SystemExit(f"error: {options.output}: a {'movie' if movie else 'picture'} is written as "
                         f"{' or '.join(suffixes)}")
    if not 0 <= options.view[1] <= 90:
        raise SystemExit(f"error: --view: the camera stands at an elevation of 0 to 90 deg, not {options.view[1]:g}")
    if movie and options.time:
        raise SystemExit("error: --time chooses frames of a picture; a movie has all of them")
    povray.require("povray", "draws the pictures")
    if movie:
        povray.require("ffmpeg", "writes movies")
    try:
        with Series(options.result) as series, tempfile.TemporaryDirectory(prefix="render_") as folder:
            output = options.output or series.directory / f"render{suffixes[0]}"
            renderer = Renderer(series, options, Path(folder))
            if movie:
                draw_movie(renderer, output, options.fps or play_rate(series))
            else:
                chosen = [series.frame_at(t) for t in options.time] if options.time else [series.frames - 1]
                draw_stills(renderer, chosen, output)
    except (OSError, KeyError, ValueError, povray.RenderError) as error:
        raise SystemExit(f"error: {error.args[0] if isinstance(error, KeyError) else error}") from None


if __name__ == "__main__":
    main()
