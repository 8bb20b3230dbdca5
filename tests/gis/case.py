"""The program on scenes in a folder of their own."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None        # set by main()
SKIPPED = 77
EXIT_INVALID, EXIT_MISSING = 2, 3


class GisCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="sandsim_gis_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def scene(self, name="scene.yaml", grid="{like: dem.tif}", terrain="{type: raster, file: dem.tif}",
              initial="{type: column, center: [600150 m, 5200100 m], radius: 40 m, depth: 2 m}", more=""):
        path = self.folder / name
        path.write_text(f"grid: {grid}\nterrain: {terrain}\nsand: {{friction_angle: 30 deg, initial: {initial}}}\n"
                        f"time: {{end: 1 s, frame_interval: 1 s}}\n{more}")
        return path

    def call(self, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True)

    def run_scene(self, scene, output="out", *options):
        done = self.call("run", scene, "-o", output, "-q", "--overwrite", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / output

    def report(self, output):
        return json.loads((output / "run.json").read_text())

    def refused(self, scene, code, *texts):
        """The check ends with `code`, and says each of the texts and where the scene says so."""
        done = self.call("check", scene)
        self.assertEqual(done.returncode, code, done.stdout[-500:] + done.stderr)
        for text in (*texts, f"{pathlib.Path(scene).name}:"):
            self.assertIn(text, done.stderr)


def main():
    """Runs the tests of the script with the program that its first argument names; skips them where that was built
    without GDAL."""
    global PROGRAM
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    module = pathlib.Path(PROGRAM).parent.parent / "lib" / "sandsim" / "sandsim_gdal.so"
    if not module.exists():
        print(f"skipped: built without GDAL ({module} is missing)")
        sys.exit(SKIPPED)
    unittest.main()
