"""Every shipped scene and study is valid, and says what to expect."""

import subprocess
import unittest

from plotting import ROOT, sandsim

SCENES = sorted(ROOT.glob("scenes/*/scene*.yaml"))
STUDIES = sorted(ROOT.glob("scenes/studies/*.yaml"))


class ShippedScenes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([str(ROOT / "scripts/make_files")], check=True)       # they are not in the repository

    def test_every_scene_passes_sandsim_check(self):
        for scene in SCENES:
            with self.subTest(scene=scene.relative_to(ROOT)):
                done = subprocess.run([sandsim(), "check", str(scene)], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_study_can_be_expanded(self):
        for study in STUDIES:
            with self.subTest(study=study.relative_to(ROOT)):
                done = subprocess.run([sandsim(), "study", str(study), "--list"], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_scene_folder_says_what_to_expect(self):
        for folder in {path.parent for path in SCENES + STUDIES}:
            with self.subTest(folder=folder.relative_to(ROOT)):
                self.assertTrue((folder / "README.md").is_file())


if __name__ == "__main__":
    unittest.main()
