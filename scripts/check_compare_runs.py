"""The comparison of two runs sees a single bit, and nothing where there is nothing."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from compare_runs import differences
from plotting import ROOT, run


class Comparison(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.one, cls.other = (Path(cls.scratch.name) / name for name in ("one", "other"))
        for folder, threads in ((cls.one, "1"), (cls.other, "2")):
            run(ROOT / "scenes/column_collapse/scene.yaml", folder,
                ["grid.cells=[32, 32]", "grid.spacing=4 cm", "time.end=200 ms"], options=["--threads", threads])

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def changed(self, change):
        """The second run's series after `change`(file)."""
        copy = Path(self.scratch.name) / "changed.h5"
        copy.write_bytes((self.other / "series.h5").read_bytes())
        with h5py.File(copy, "r+") as file:
            change(file)
        return copy

    def test_runs_on_one_and_two_threads_are_the_same(self):
        self.assertEqual(differences(self.one, self.other), [])

    def test_the_last_bit_of_one_value_is_seen_and_named(self):
        def change(file):
            file["depth"][3, 16, 15] = np.nextafter(file["depth"][3, 16, 15], np.float32(9))
        lines = differences(self.one, self.changed(change))
        self.assertEqual(len(lines), 1)
        self.assertIn("depth: 1 of", lines[0])
        self.assertIn("(3, 16, 15)", lines[0])

    def test_the_sign_of_a_zero_counts(self):
        def change(file):
            self.assertEqual(file["depth"][0, 0, 0], 0)
            file["depth"][0, 0, 0] = -0.0
        self.assertEqual(len(differences(self.one, self.changed(change))), 1)

    def test_wall_times_do_not_count(self):
        def change(file):
            file["wall_time"][...] = 7.0
        self.assertEqual(differences(self.one, self.changed(change)), [])

    def test_a_dataset_that_is_missing_or_of_another_shape_is_named(self):
        def change(file):
            del file["volume"]
            del file["x"]
            file["x"] = np.zeros(3)
        lines = differences(self.one, self.changed(change))
        self.assertEqual(len(lines), 2)
        self.assertIn("volume: only in", lines[0])
        self.assertIn("x: (32,)", lines[1])

    def test_the_command_exits_with_1_where_something_differs(self):
        def change(file):
            file["steps"][-1] += 1
        for second, code in ((self.other, 0), (self.changed(change), 1)):
            done = subprocess.run(["/usr/bin/python3", str(ROOT / "scripts/compare_runs.py"), self.one, second],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, code, done.stderr)


if __name__ == "__main__":
    unittest.main()
