"""What a fit leaves can be read and drawn, and the fit that ships finds what it should."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import yaml

from plotting import ROOT, sandsim

SCENE = ROOT / "scenes/fit"
SCALE, CAP = "sand.hbar.scale=0.3:1", "sand.hbar.cap=1:10 cm"


class Fits(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "fit"

    def fit(self, *options):
        command = [sandsim(), "fit", str(SCENE), "-o", str(self.folder), "-q", "--front", str(SCENE / "front.csv")]
        done = subprocess.run([*command, *options], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return yaml.safe_load((self.folder / "fit.yaml").read_text())

    def draw(self):
        done = subprocess.run([str(ROOT / "scripts/plot"), str(self.folder)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_the_scene_that_ships_gives_its_values_and_a_map(self):
        scale, cap = self.fit("--vary", SCALE, "--vary", CAP)["parameters"]
        # The front is known to the millimetre, which moves the values by less than 2 %.
        self.assertAlmostEqual(scale["best"] / 0.7, 1, delta=0.02)
        self.assertAlmostEqual(float(cap["best"].split()[0]) / 4, 1, delta=0.02)
        self.assertIn("fit.png", self.draw())
        self.assertGreater((self.folder / "fit.png").stat().st_size, 5000)

    def test_one_parameter_is_drawn_as_a_curve(self):
        report = self.fit("--vary", CAP, "--set", "sand.hbar.scale=0.7")
        self.assertEqual(report["parameters"][0]["data_tell"], "known")
        self.draw()
        self.assertGreater((self.folder / "fit.png").stat().st_size, 5000)

    def test_a_fit_without_a_map_is_not_drawn(self):
        self.fit("--vary", CAP, "--map", "0")
        self.assertIn("no plot", self.draw())


if __name__ == "__main__":
    unittest.main()
