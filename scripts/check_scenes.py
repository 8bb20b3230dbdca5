"""Every shipped scene is valid: for the JSON Schema that editors use, and for sandsim itself."""

import json
import subprocess
import unittest

import jsonschema
import yaml

from plotting import ROOT, sandsim

SCENES = sorted(ROOT.glob("scenes/*/*.yaml"))


class ShippedScenes(unittest.TestCase):
    def test_the_committed_schema_is_the_one_of_the_program(self):
        printed = subprocess.run([sandsim(), "schema"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(json.loads(printed), json.loads((ROOT / "scenes/scene.schema.json").read_text()))

    def test_every_scene_satisfies_the_schema(self):
        validator = jsonschema.Draft7Validator(json.loads((ROOT / "scenes/scene.schema.json").read_text()))
        for scene in SCENES:
            with self.subTest(scene=scene.relative_to(ROOT)):
                problems = validator.iter_errors(yaml.safe_load(scene.read_text()))
                self.assertEqual([problem.message for problem in problems], [])

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
