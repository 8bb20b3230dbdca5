"""The plot of the stability maps counts what passed and takes one precision at a time."""

import tempfile
import unittest
from pathlib import Path

from plot_stress import read_maps, table

HEADER = "map,x,y,scheme,order,precision,device,verdict,failed,steps,volume_error,max_speed,relative_speed\n"
ROWS = ("hbar_slope,1,30,paper,1,float32,cpu,known,\"rest\",10,0,3,1.5\n"
        "hbar_slope,0.1,30,paper,1,float32,cpu,pass,\"\",10,0,1,0.5\n"
        "hbar_slope,1,30,paper,1,float64,cpu,pass,\"\",10,0,1,9\n")


class Maps(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        (Path(self.scratch.name) / "maps.csv").write_text(HEADER + ROWS)

    def tearDown(self):
        self.scratch.cleanup()

    def test_cells_are_sorted_and_failures_marked(self):
        rows = read_maps(self.scratch.name, "float32")[("hbar_slope", "paper", "1")]
        xs, ys, speed, failed = table(rows)
        self.assertEqual((xs, ys), ([0.1, 1.0], [30.0]))
        self.assertEqual(speed.tolist(), [[0.5, 1.5]])
        self.assertEqual(failed.tolist(), [[False, True]])

    def test_a_precision_that_is_not_there_is_an_error(self):
        (Path(self.scratch.name) / "maps.csv").write_text(HEADER)
        with self.assertRaises(SystemExit):
            read_maps(self.scratch.name, "float64")


if __name__ == "__main__":
    unittest.main()
