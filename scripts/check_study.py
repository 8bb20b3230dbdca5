"""A study runs, and its tables can be drawn and give the same errors again."""

import csv
import subprocess
import tempfile
import unittest
from pathlib import Path

import yaml

from plotting import ROOT, sandsim

STUDY = {
    "scenes": {"file": str(ROOT / "scenes/flume/scene.yaml")},
    "spacings": ["4 cm", "2 cm"],
    "methods": [{"name": "one", "set": {"numerics.order": 1}}, {"name": "two", "set": {"numerics.order": 2}}],
    "error": {"against": "profile"},
    "repeats": 1,
    "ablation": {"file": str(ROOT / "scenes/flume/scene.yaml"),
                 "variants": [{"name": "float64", "set": {"numerics.precision": "float64"}}]},
}


class Study(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.result = Path(cls.scratch.name) / "result"
        file = Path(cls.scratch.name) / "tiny.yaml"
        file.write_text(yaml.safe_dump(STUDY))
        subprocess.run([sandsim(), "study", str(file), "-o", str(cls.result), "-q"], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_scripts_plot_draws_the_frontier_and_the_ablation(self):
        subprocess.run([str(ROOT / "scripts/plot"), str(self.result)], check=True, capture_output=True)
        for picture in ("study.png", "ablation.png"):
            self.assertGreater((self.result / picture).stat().st_size, 5000)

    def test_the_errors_are_those_of_the_run_alone(self):
        with (self.result / "study.csv").open(newline="") as file:
            row = next(row for row in csv.DictReader(file) if row["method"] == "two" and row["spacing_m"] == "0.04")
        output = Path(self.scratch.name) / "run"
        settings = ["grid.cells=[40, 1]", "grid.spacing=4 cm", "output={frames: false}", "time.frame_interval=4 s"]
        command = [sandsim(), "run", str(ROOT / "scenes/flume/scene.yaml"), "-o", str(output), "-q"]
        subprocess.run(command + [word for setting in settings for word in ("--set", setting)], check=True)
        report = yaml.safe_load((output / "run.json").read_text())
        error = next(error for error in report["errors"] if error["against"].startswith("profile"))
        self.assertEqual(float(row["error"]), float(error["l1_relative"]))
        self.assertEqual(int(row["steps"]), report["steps"])


if __name__ == "__main__":
    unittest.main()
