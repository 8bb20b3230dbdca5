"""scripts/gpu_check judges what its programs say, with programs made up for it; and reads what ptxas says."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import gpu_report

ROOT = Path(__file__).resolve().parent.parent
PTXAS = """\
ptxas info    : Compiling entry function '_ZN7sandsim4cuda10run_kernelINS_5tiles9RowKernelIfEEEEvT_y' for 'sm_90'
ptxas info    : Function properties for it
    0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads
ptxas info    : Used 20 registers, used 1 barriers
ptxas info    : Compiling entry function '_ZN7sandsim4cuda10run_kernelINS_5tiles10StepKernelINS2_12BalancedTileIfLi2ELb1E\
Lb1ELb0EEEEEEEvT_y' for 'sm_90'
ptxas info    : Function properties for it
    24 bytes stack frame, 8 bytes spill stores, 12 bytes spill loads
ptxas info    : Used 119 registers, used 1 barriers
"""


class ReadingPtxas(unittest.TestCase):
    def test_step_kernels_come_with_registers_and_spills(self):
        kernels = gpu_report.kernels(PTXAS)
        self.assertEqual(len(kernels), 1)
        self.assertEqual(kernels[0]["kernel"], "balanced order 2, float32, flat, uniform, 2-D")
        self.assertEqual([kernels[0][key] for key in ("registers", "stack", "spill_stores", "spill_loads")],
                         [119, 24, 8, 12])

    def test_nothing_is_made_of_nothing(self):
        self.assertEqual(gpu_report.kernels(""), [])


class Judging(unittest.TestCase):
    def check(self, **programs):
        """The exit code and the report of a check with these programs, shell scripts by name."""
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch)
            (folder / "bin").mkdir()
            (folder / "ptxas.log").write_text(PTXAS)
            for name, script in programs.items():
                path = folder / "bin" / name
                path.write_text("#!/bin/sh\n" + script)
                path.chmod(0o755)
            done = subprocess.run([sys.executable, str(ROOT / "scripts/gpu_check"), "--build", scratch, "--output",
                                   scratch, "--minutes", "1"], capture_output=True, text=True)
            report = json.loads((folder / "gpu_check.json").read_text())
            self.assertIn("# gpu_check", (folder / "gpu_check.md").read_text())
            return done.returncode, {part["name"]: part["status"] for part in report["parts"]}, report["passed"]

    def test_without_a_device_it_exits_with_77_and_passes_nothing(self):
        code, parts, passed = self.check(test_cuda="echo skipped: no device; exit 77\n", test_tiles="exit 0\n")
        self.assertEqual(code, 77)
        self.assertEqual(parts["tests of the tiles"], "passed")
        self.assertEqual(parts["device"], "skipped")
        self.assertFalse(passed)

    def test_a_failure_that_needs_no_device_counts_without_one(self):
        code, parts, _ = self.check(test_cuda="exit 77\n", test_tiles="exit 1\n")
        self.assertEqual(code, 1)
        self.assertEqual(parts["tests of the tiles"], "failed")

    def test_every_part_is_tried_after_a_failure(self):
        code, parts, passed = self.check(test_cuda='[ "$1" = --list-tests ]\n', test_tiles="exit 0\n",
                                         sandsim="echo broken; exit 5\n")
        self.assertEqual(code, 1)
        for name in ("tests of the device", "scenes on processor and device", "bench"):
            self.assertEqual(parts[name], "failed", name)
        self.assertIn("compute-sanitizer", parts)
        self.assertFalse(passed)

    def test_without_sandsim_the_check_does_not_pass(self):
        code, parts, _ = self.check(test_cuda="exit 0\n", test_tiles="exit 0\n")
        self.assertEqual(code, 1)
        self.assertEqual(parts["tests of the device"], "passed")
        self.assertEqual(parts["bench"], "skipped")


if __name__ == "__main__":
    unittest.main()
