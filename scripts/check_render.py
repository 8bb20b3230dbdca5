"""Pictures show sand, objects and particles where the result has them, and say what is missing."""

import contextlib
import io
import itertools
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np
import yaml

import render_camera
from plotting import ROOT
from render import COLOURED, Renderer, main, parser
from render_objects import SHAPES, read_distance
from render_particles import TONES, tones_of
from sandsim_series import Series

PYTHON = "/usr/bin/python3"
SIZE = (120, 80)
CELLS = 20                              # of 5 cm: a square of 1 m
SHAPE_EXAMPLES = {
    "sphere": {"radius": "0.2 m"}, "box": {"size": ["0.4 m", "0.2 m", "0.3 m"]},
    "capsule": {"radius": "0.1 m", "length": "0.4 m"}, "cylinder": {"radius": "0.15 m", "height": "0.4 m"},
    "cone": {"radius": "0.2 m", "height": "0.3 m"}, "ellipsoid": {"radii": ["0.25 m", "0.1 m", "0.15 m"]},
    "brush": {"radius": "0.1 m", "height": "0.4 m", "position": ["0 m", "0 m", "-0.2 m"]},
    "csg": {"operation": "union", "parts": [
        {"type": "box", "size": ["0.3 m", "0.1 m", "0.1 m"], "position": ["-0.1 m", "0 m", "0 m"]},
        {"type": "sphere", "radius": "0.1 m", "position": ["0.1 m", "0 m", "0.1 m"]}]}}


def write_result(path, depth, objects=(), poses=(), particles=None, velocity=None):
    """A series.h5 of the square: depth (time, y, x) [m], poses {name: (position, quaternion)} for every frame."""
    frames = len(depth)
    scene = {"objects": list(objects), "particles": {"spacing": "0.05 m", "layers": 1}}
    with h5py.File(path, "w") as file:
        file["time"] = 0.1 * np.arange(frames)
        file["x"] = file["y"] = 0.05 * (np.arange(CELLS) + 0.5)
        file["depth"] = np.asarray(depth, np.float32)
        file["velocity_x"], file["velocity_y"] = velocity if velocity else np.zeros((2, *file["depth"].shape))
        file.attrs["scene"] = yaml.safe_dump(scene)
        if objects:
            names = [item["name"] for item in objects]
            file["object_name"] = names
            file["object_present"] = [[int(name in pose) for name in names] for pose in poses]
            absent = (np.zeros(3), (1, 0, 0, 0))
            for k, key in enumerate(("object_position", "object_rotation")):
                file[key] = np.array([[pose.get(name, absent)[k] for name in names] for pose in poses], dtype=float)
        if particles is not None:
            file["particle_position"] = np.asarray([particles], np.float64)
            file["particle_id"] = [np.arange(len(particles))]
            file["particle_visible"] = np.ones((1, len(particles)), np.int64)
    return path


def projected(camera, point, size):
    """The pixel (x, y) at which a point of the scene is seen."""
    right, up, forward = render_camera.axes(camera.azimuth, elevation(camera))
    away = np.asarray(point) - camera.location
    depth = away @ forward
    half = np.tan(np.radians(camera.angle) / 2)
    return np.array([size[0] / 2 * (1 + away @ right / depth / half),
                     size[1] / 2 - size[0] / 2 * (away @ up / depth / half)])


def elevation(camera):
    away = camera.location - camera.look_at
    return np.degrees(np.arcsin(away[2] / np.linalg.norm(away)))


@unittest.skipUnless(shutil.which("povray"), "POV-Ray is not installed (apt-get install povray)")
class Pictures(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.level = np.full((1, CELLS, CELLS), 0.1)
        self.results = itertools.count()

    def result(self, *arguments, **more):
        return write_result(self.folder / f"{next(self.results)}.h5", *arguments, **more)

    def draw(self, *calls):
        """For each call [path, options...] the first frame, (height, width, 3) int, and what drew it."""
        # POV-Ray waits half a second in each run: they wait together.
        with ThreadPoolExecutor(len(calls)) as pool:
            return list(pool.map(self.draw_one, calls))

    def draw_one(self, call):
        path, *options = call
        given = parser().parse_args([str(path), "--size", "{}x{}".format(*SIZE), "--quality", "draft", *options])
        with Series(path) as series:
            renderer = Renderer(series, given, Path(tempfile.mkdtemp(dir=self.folder)))
            return renderer.picture(0, renderer.largest([0])).astype(int), renderer

    def with_body(self, shape, position, quaternion=(1, 0, 0, 0)):
        """A level bed with one object."""
        body = {"name": "body", "shape": shape}
        return self.result(self.level, [body], [{"body": (np.asarray(position, dtype=float), quaternion)}])

    def test_a_bed_is_sand_coloured_on_a_white_ground(self):
        [(picture, renderer)] = self.draw([self.result(self.level)])
        x, y = projected(renderer.camera, renderer.domain.local([0.5, 0.5, 0.1]), SIZE).astype(int)
        red, green, blue = picture[y - 4:y + 5, x - 4:x + 5].reshape(-1, 3).mean(axis=0)
        self.assertTrue(250 > red > green > blue > 60, (red, green, blue))
        self.assertGreater(picture[2, 2].min(), 235)

    def test_an_object_stands_where_it_is_and_casts_a_shadow(self):
        path = self.with_body({"type": "sphere", "radius": "0.08 m"}, [0.35, 0.6, 0.25])
        # Objects make room for themselves in the picture: here both are seen from the same place.
        place = ["--look-at", "0.5", "0.5", "0.1", "--distance", "2.6"]
        (without, _), (picture, renderer) = self.draw([path, "--no-objects", *place], [path, *place])
        red = (picture[..., 0] > picture[..., 1] + 60) & (picture[..., 0] > picture[..., 2] + 60)
        rows, columns = np.nonzero(red)
        x, y = projected(renderer.camera, renderer.domain.local([0.35, 0.6, 0.25]), SIZE)
        self.assertLess(np.hypot(columns.mean() + 0.5 - x, rows.mean() + 0.5 - y), 1.5)
        darker = (without.sum(axis=2) - picture.sum(axis=2) > 60) & ~red
        self.assertGreater(np.count_nonzero(darker), 20)

    def test_a_result_that_does_not_say_where_its_objects_are_is_drawn_without_them(self):
        body = {"name": "body", "shape": {"type": "sphere", "radius": "0.1 m"}}
        path = self.result(self.level, [body], [{"body": ((0.5, 0.5, 0.1), (1, 0, 0, 0))}])
        with h5py.File(path, "r+") as file:
            del file["object_name"]
        with contextlib.redirect_stderr(io.StringIO()) as stderr:
            (picture, _), (without, _) = self.draw([path], [path, "--no-objects"])
        self.assertIn("does not say where its objects are", stderr.getvalue())
        np.testing.assert_array_equal(picture, without)

    def test_an_object_that_is_not_there_is_not_drawn(self):
        body = {"name": "body", "shape": {"type": "sphere", "radius": "0.1 m"}}
        path = self.result(self.level, [body], [{}])
        (picture, _), (without, _) = self.draw([path], [path, "--no-objects"])
        np.testing.assert_array_equal(picture, without)

    def test_sand_is_as_high_as_it_is_deep(self):
        # A wedge from 0 to 40 cm. A small block in its middle shows above 20 cm and not below.
        wedge = np.broadcast_to(0.4 * (np.arange(CELLS) + 0.5) / CELLS, (1, CELLS, CELLS))
        shape = {"type": "box", "size": ["0.02 m", "0.3 m", "0.02 m"]}
        view = ["--view", "-90", "60", "--look-at", "0.5", "0.5", "0.2", "--distance", "2"]
        low, high = (self.result(wedge, [{"name": "body", "shape": shape}],
                                 [{"body": ((0.5, 0.5, height), (1, 0, 0, 0))}]) for height in (0.17, 0.23))
        (without, _), (hidden, _), (shown, _) = self.draw([low, "--no-objects", *view], [low, *view], [high, *view])
        np.testing.assert_array_equal(hidden, without)
        self.assertGreater(np.count_nonzero(np.any(shown != without, axis=2)), 20)

    def test_every_shape_fills_the_box_that_it_says_it_is_in(self):
        examples = dict(SHAPE_EXAMPLES, mesh={"file": str(ROOT / "scenes/cars/car.obj"), "unit": "m", "scale": 1},
                        sdf={"file": str(self.write_ball(0.22)), "spacing": "0.025 m",
                             "origin": ["-0.4 m", "-0.4 m", "-0.4 m"]})
        self.assertEqual({*examples, "half_space"}, set(SHAPES))
        # Seen from above, turned by 90 deg about x: the shape's z runs down the picture. Its shadow falls 1.5 m beside.
        view = ["--view", "-90", "90", "--look-at", "0.5", "0.5", "1.1", "--distance", "4", "--size", "240x160"]
        size = (240, 160)
        paths = [self.with_body({"type": kind, **sizes}, [0.5, 0.5, 1.1], (np.sqrt(0.5), np.sqrt(0.5), 0, 0))
                 for kind, sizes in examples.items()]
        (nothing, _), *drawn = self.draw([self.result(self.level), *view], *([path, *view] for path in paths))
        for kind, path, (picture, renderer) in zip(examples, paths, drawn):
            with self.subTest(shape=kind):
                with Series(path) as series:
                    corners = renderer.bodies.boxes(series.objects(0))
                box = [projected(renderer.camera, corner, size) for corner in renderer.domain.local(corners)]
                changed = np.abs(picture - nothing).max(axis=2) > 20
                changed[:, :60] = changed[:, 180:] = False
                rows, columns = np.nonzero(changed)
                # Two pixels for the edges, and half a one because what is round is not seen by its box's corners.
                np.testing.assert_allclose([columns.min(), rows.min()], np.min(box, axis=0), atol=2.5)
                np.testing.assert_allclose([columns.max() + 1, rows.max() + 1], np.max(box, axis=0), atol=2.5)

    def test_a_half_space_ends_where_the_scene_does(self):
        path = self.with_body({"type": "half_space", "normal": [-1, 0, 0]}, [0.7, 0.5, 0.1])
        place = ["--view", "-90", "60", "--look-at", "0.5", "0.5", "0.2", "--distance", "2.6"]
        (without, renderer), (picture, _) = self.draw([path, "--no-objects", *place], [path, *place])
        red = picture[..., 0] > 2 * picture[..., 1]
        x, y = projected(renderer.camera, renderer.domain.local([0.7, 0.5, 0.1]), SIZE).astype(int)
        self.assertTrue(red[y, x + 8])                        # the sand's right end, up to the room above it
        self.assertFalse(np.any(picture[:, :x - 8] != without[:, :x - 8]))
        self.assertLess(red.mean(), 0.3)

    def write_ball(self, radius):
        along = np.linspace(-0.4, 0.4, 33)
        z, y, x = np.meshgrid(along, along, along, indexing="ij")
        np.save(self.folder / "ball.npy", np.sqrt(x * x + y * y + z * z) - radius)
        return self.folder / "ball.npy"

    def test_sand_thinner_than_a_tenth_of_a_cell_is_drawn_as_ground(self):
        place = ["--look-at", "0.5", "0.5", "0", "--distance", "2.6"]
        (bare, _), (thin, _) = self.draw(*([self.result(np.full((1, CELLS, CELLS), depth)), *place]
                                           for depth in (0.0, 0.0049)))
        np.testing.assert_array_equal(bare, thin)

    def test_the_same_result_gives_the_same_bits(self):
        body = {"name": "body", "shape": {"type": "box", "size": ["0.2 m", "0.2 m", "0.2 m"]}}
        path = self.result(np.repeat(self.level, 2, axis=0), [body], 2 * [{"body": ((0.5, 0.5, 0.2), (1, 0, 0, 0))}])
        pictures = []
        for times in ([], ["--time", "0", "0.1"]):
            self.call(path, "--size", "120x80", *times, "-o", self.folder / "still.png")
            pictures.append(plt.imread(self.folder / "still.png"))
        for again in (pictures[1][:, :120], pictures[1][:, -120:]):        # the two were drawn at the same time
            np.testing.assert_array_equal(pictures[0], again)

    def test_particles_keep_their_tones_and_lie_on_the_sand(self):
        ids = np.arange(10000)
        order = np.random.default_rng(1).permutation(ids)
        np.testing.assert_array_equal(tones_of(ids)[order], tones_of(order))
        # Every tone is as frequent: 417 of 10000 each, with a standard deviation of 20.
        self.assertLess(np.abs(np.bincount(tones_of(ids), minlength=TONES) - 10000 / TONES).max(), 100)
        middles = 0.05 * (np.arange(CELLS) + 0.5)
        places = np.array([[x, y, 0.09] for x in middles for y in middles])
        path = self.result(self.level, particles=places)
        (picture, _), (surface, _) = self.draw([path, "--show", "particles"], [path])
        self.assertGreater(np.count_nonzero(np.any(picture != surface, axis=2)), 1000)

    def test_level_ground_has_the_colour_of_the_bar(self):
        speed = np.zeros((1, CELLS, CELLS))
        speed[:, :, CELLS // 2:] = 2.0
        path = self.result(self.level, velocity=[speed, 0 * speed])
        [(picture, renderer)] = self.draw([path, "--colour", "speed", "--view", "-90", "60"])
        for place, share in (((0.25, 0.5, 0.1), 0.0), ((0.75, 0.5, 0.1), 1.0)):
            x, y = projected(renderer.camera, renderer.domain.local(place), SIZE).astype(int)
            colour = 255 * np.array(plt.get_cmap(COLOURED["speed"][1])(share)[:3])
            np.testing.assert_allclose(picture[y, x], colour, atol=12)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed (apt-get install ffmpeg)")
    def test_a_movie_has_all_frames_and_even_sides(self):
        path = self.result(np.repeat(self.level, 3, axis=0))
        movie = self.folder / "movie.mp4"
        subprocess.run([ROOT / "scripts/render", path, "--quality", "draft", "--size", "97x65", "-o", movie],
                       check=True, capture_output=True)
        told = json.loads(subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json", movie],
            check=True, capture_output=True).stdout)["streams"][0]
        self.assertEqual([told[key] for key in ("codec_name", "pix_fmt", "width", "height", "nb_read_frames")],
                         ["h264", "yuv420p", 98, 66, "3"])

    def test_times_are_drawn_side_by_side(self):
        path = self.result(np.repeat(self.level, 4, axis=0))
        self.call(path, "--time", 0, 0.1, 0.2, 0.3, "--quality", "draft", "--size", "60x40",
                  "-o", self.folder / "stills.png")
        self.assertEqual(plt.imread(self.folder / "stills.png").shape[:2], (2 * 46 - 6, 3 * 66 - 6))

    def test_what_is_wrong_is_said(self):
        path = self.result(self.level)
        nowhere = {"name": "car", "shape": {"type": "mesh", "file": "/nowhere/car.obj"}}
        for arguments, words in (([path, "-o", "picture.tif"], "written as .png or .jpg"),
                                 ([path, "--size", "large"], "960x540"),
                                 ([self.folder / "nothing"], "nothing"),
                                 ([path, "--show", "particles"], "particles:"),
                                 ([path, "--view", "0", "-5"], "0 to 90"),
                                 ([path, "--movie", "--time", "1"], "--time")):
            self.assertIn(words, self.complaint(*arguments))
        path = self.result(self.level, [nowhere], [{"car": (np.zeros(3), (1, 0, 0, 0))}])
        self.assertIn("/nowhere/car.obj", self.complaint(path))

    def call(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()):
            main(list(map(str, arguments)))

    def complaint(self, *arguments):
        """What the script ends with."""
        with contextlib.redirect_stderr(io.StringIO()) as stderr, self.assertRaises(SystemExit) as end:
            self.call(*arguments)
        return stderr.getvalue() + str(end.exception)


class SignedDistances(unittest.TestCase):
    def test_all_formats_give_the_same_samples_in_the_same_place(self):
        distance = np.random.default_rng(1).random((2, 3, 4)).round(6)
        with tempfile.TemporaryDirectory() as folder:
            npy, h5, sdf = (Path(folder) / f"distance.{suffix}" for suffix in ("npy", "h5", "sdf"))
            np.save(npy, distance)
            with h5py.File(h5, "w") as file:
                file["distance"] = distance
                file["distance"].attrs.update(origin_x=0.1, origin_y=0.2, origin_z=0.3, spacing=0.5)
            sdf.write_text("4 3 2\n0.1 0.2 0.3\n0.5\n" + "\n".join(map(str, distance.ravel())))
            place = {"spacing": "0.5 m", "origin": ["0.1 m", "0.2 m", "0.3 m"]}
            for shape in ({"file": npy, **place}, {"file": h5}, {"file": sdf}):
                samples, origin, spacing = read_distance({**shape, "scale": 2})
                np.testing.assert_allclose(samples, 2 * distance, rtol=1e-12)
                np.testing.assert_allclose([*origin, spacing], [0.2, 0.4, 0.6, 1.0], rtol=1e-12)


class WithoutPrograms(unittest.TestCase):
    def test_a_missing_ray_tracer_is_named_with_its_package(self):
        with tempfile.TemporaryDirectory() as empty:
            done = subprocess.run([PYTHON, str(ROOT / "scripts/render.py"), "results/any"], capture_output=True,
                                  text=True, env={**os.environ, "PATH": empty})
        self.assertEqual(done.returncode, 1)
        self.assertIn("povray is missing", done.stderr)
        self.assertIn("apt-get install povray", done.stderr)


if __name__ == "__main__":
    unittest.main()
