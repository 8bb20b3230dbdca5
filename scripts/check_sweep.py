"""What a sweep leaves can be read and drawn: by the plots' own reader, and by xarray."""

import csv
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import xarray

from plot_sweep import choose
from plotting import ROOT, sandsim
from sandsim_series import Series, Summary

PYTHON = "/usr/bin/python3"
SCENE = ROOT / "scenes/pile_sweep/scene.yaml"
SMALL = ("--set", "grid.cells=[16, 16]", "--set", "grid.spacing=5 cm")


class Sweeps(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "sweep"

    def sweep(self, *options, code=0):
        done = subprocess.run([sandsim(), "sweep", str(SCENE), "-o", str(self.folder), "-q", *SMALL, *options],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return Summary(self.folder)

    def draw(self, *options):
        picture = self.folder / "picture.png"
        subprocess.run([PYTHON, str(ROOT / "scripts/plot_sweep.py"), str(self.folder), "-o", str(picture), *options],
                       check=True, capture_output=True)
        self.assertGreater(picture.stat().st_size, 5000)

    def test_the_summary_says_what_the_cases_hold(self):
        summary = self.sweep("--vary", "sand.friction_angle=20,30 deg", "--vary", "sand.hbar.scale=0.5,1")
        self.assertEqual(summary.parameters, ["sand.friction_angle", "sand.hbar.scale"])
        self.assertEqual(summary.units("sand.friction_angle"), "deg")
        np.testing.assert_array_equal(summary["sand.friction_angle"], [20, 20, 30, 30])
        for number, folder in enumerate(summary["folder"]):
            with Series(self.folder / folder) as series:
                last = series.depth(-1)
                self.assertAlmostEqual(summary["deposit_height"][number], last.max(), 12)
                self.assertEqual(summary["steps"][number], series.report["steps"])
                self.assertEqual(summary["stop_time"][number], series.report["stop_time"])
                # The outline lies within a cell of the outermost cell that is deep enough.
                deep = last > 0.01 * max(last.max(), series.depth(0).max())
                edge = series.x[deep.any(axis=0)].max()
                self.assertTrue(edge <= summary["front"][number] <= edge + series.spacing)
        with xarray.open_dataset(self.folder / "summary.h5") as data:
            self.assertEqual(data["runout"].dims, ("case",))
            self.assertEqual(data["runout"].attrs["units"], "m")
            np.testing.assert_array_equal(data["runout"].values, summary["runout"])
        with open(self.folder / "summary.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        np.testing.assert_array_equal([float(row["runout [m]"]) for row in rows], summary["runout"])
        self.draw()
        self.draw("--metric", "steps")

    def test_a_wall_time_is_drawn_only_when_it_is_asked_for(self):
        class Times(dict):
            metrics = ("wall_time", "volume_error")

        times = Times(wall_time=np.array([1.0, 2.0]), volume_error=np.array([0.0, 0.0]))
        self.assertEqual(choose(times, None), ["volume_error"])
        self.assertEqual(choose(times, ["wall_time"]), ["wall_time"])

    def test_the_runout_stands_in_the_summary_without_frames(self):
        summary = self.sweep("--vary", "sand.friction_angle=20,30 deg", "--set", "output.frames=false")
        self.assertGreater(summary["runout"][0], summary["runout"][1])      # less friction, farther
        for name in ("area", "deposit_height", "drop", "front", "max_depth", "max_speed", "travel_angle"):
            self.assertTrue((summary[name] > 0).all(), name)
        self.assertLess(summary["volume_out"].max(), 1e-6)  # m^3 of 2.4e-3: a film reaches the open sides
        np.testing.assert_allclose(np.tan(summary["travel_angle"]), summary["drop"] / summary["runout"])

    def test_one_key_a_sample_and_a_failed_case_are_drawn(self):
        self.sweep("--vary", "sand.hbar.policy=full,scaled,nonsense", "--set", "sand.hbar.scale=", "--skip-invalid",
                   "--vary", "sand.friction_angle=20,30 deg", code=2)
        self.draw()
        self.sweep("--vary", "sand.friction_angle=20..40 deg", "--vary", "sand.hbar.scale=0.3..1", "--samples", "5",
                   "--vary", "grid.origin=[0 m, 0 m],[-40 cm, -40 cm]", "--overwrite")
        self.draw()
        self.sweep("--vary", "sand.friction_angle=20:30:3 deg", "--overwrite")
        self.draw()

    def test_the_piles_of_the_sweep_that_ships_only_come_later_the_less_of_them_flows(self):
        folder = self.folder.parent / "piles"
        subprocess.run([sandsim(), "sweep", str(SCENE.parent), "-o", str(folder), "-q"], check=True)
        summary = Summary(folder)
        self.assertEqual(np.count_nonzero(summary["status"] == "at rest"), 64)
        later = summary["stop_time"] * np.sqrt(summary["sand.hbar.scale"])
        for angle in np.unique(summary["sand.friction_angle"]):
            chosen = summary["sand.friction_angle"] == angle
            # As in the scene's README; twice what was measured.
            self.assertLess(np.ptp(summary["runout"][chosen]) / summary["runout"][chosen].mean(), 0.0014)
            self.assertLess(np.ptp(later[chosen]) / later[chosen].mean(), 0.04)


if __name__ == "__main__":
    unittest.main()
