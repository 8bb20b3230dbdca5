"""Every shipped scene is valid, and says what to expect."""

import subprocess
import unittest

from plotting import ROOT, sandsim

SCENES = sorted(ROOT.glob("scenes/*/*.yaml"))


class ShippedScenes(unittest.TestCase):
    def test_every_scene_passes_sandsim_check(self):
        for scene in SCENES:
            with self.subTest(scene=scene.relative_to(ROOT)):
                done = subprocess.run([sandsim(), "check", str(scene)], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_scene_folder_says_what_to_expect(self):
        for folder in {scene.parent for scene in SCENES}:
            with self.subTest(folder=folder.relative_to(ROOT)):
                self.assertTrue((folder / "README.md").is_file())


if __name__ == "__main__":
    unittest.main()
