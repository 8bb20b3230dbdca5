"""What a run writes can be read and drawn: by the plots' own reader, and by xarray through both of its engines."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import xarray

from plotting import ROOT, run
from sandsim_series import Series

PYTHON = "/usr/bin/python3"


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.flume = Path(cls.scratch.name) / "flume"
        cls.pile = Path(cls.scratch.name) / "pile"
        run(ROOT / "scenes/flume/scene.yaml", cls.flume, ["grid.cells=[40, 1]", "grid.spacing=4 cm"])
        run(ROOT / "scenes/piles/scene_30deg_dropped.yaml", cls.pile, ["grid.cells=[32, 32]", "grid.spacing=2 cm"])

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def draw(self, script, *options, picture):
        subprocess.run([PYTHON, str(ROOT / "scripts" / script), *map(str, options), "-o", str(picture)],
                       check=True, capture_output=True)
        self.assertGreater(picture.stat().st_size, 5000)

    def test_the_reader_sees_the_block_that_the_scene_describes(self):
        with Series(self.flume) as series:
            self.assertTrue(series.one_dimensional)
            np.testing.assert_allclose(series.x, 0.02 + 0.04 * np.arange(40))
            # Ten cells of 4 cm are the 40 cm of the block.
            np.testing.assert_allclose(series.depth(0)[0], np.where(np.arange(40) < 10, 0.2, 0), rtol=1e-7)
            self.assertEqual(series.depth(-1).shape, (1, 40))
            self.assertEqual(series.fronts.shape, (series.frames, 2))
            self.assertTrue(series.report["at_rest"])

    def test_velocities_of_a_run_at_rest_are_exactly_zero(self):
        for folder in (self.flume, self.pile):
            with Series(folder) as series:
                for component in series.velocity(-1):
                    self.assertEqual(np.abs(component).max(), 0)

    def test_xarray_opens_the_series_unchanged_with_both_engines(self):
        for engine in ("h5netcdf", "netcdf4"):
            with self.subTest(engine=engine), xarray.open_dataset(self.pile / "series.h5", engine=engine) as data:
                self.assertEqual(data["depth"].dims, ("time", "y", "x"))
                self.assertEqual(data["depth"].attrs["units"], "m")
                self.assertTrue(str(data.attrs["Conventions"]).startswith("CF-1."))
                with Series(self.pile) as series:
                    np.testing.assert_array_equal(data["depth"].values[-1], series.depth(-1))

    def test_profiles_and_fronts_are_drawn(self):
        self.draw("plot_flume.py", self.flume, picture=self.flume / "flume.png")

    def test_height_fields_are_drawn(self):
        self.draw("plot_field.py", self.pile, picture=self.pile / "field.png")

    def test_a_movie_of_a_height_field_has_even_sides(self):
        movie = self.pile / "field.mp4"
        self.draw("plot_field.py", self.pile, "--movie", picture=movie)
        sides = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0",
                                str(movie)], check=True, capture_output=True, text=True).stdout
        self.assertEqual([int(side) % 2 for side in sides.strip().split(",")], [0, 0])

    def test_slopes_of_a_pile_are_drawn(self):
        self.draw("plot_piles.py", self.pile, picture=self.pile / "piles.png")


if __name__ == "__main__":
    unittest.main()
