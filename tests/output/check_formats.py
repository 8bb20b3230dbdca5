#!/usr/bin/python3
"""Opens results of test_output with h5py and xarray: dimensions, units and values as interface.md has them."""

import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import h5py
import numpy as np
import xarray

ENGINES = ("h5netcdf", "netcdf4")
FIELDS = {"depth": "m", "velocity_x": "m/s", "velocity_y": "m/s", "surface": "m",
          "momentum_x": "m^2/s", "momentum_y": "m^2/s"}
MAPS = {"bed": "m", "max_depth": "m", "max_speed_over_time": "m/s", "arrival_time": "s"}
NUMBERS = {"volume": "m^3", "kinetic_energy": "m^5/s^2", "max_speed": "m/s", "time_step_min": "s",
           "time_step_max": "s", "steps": "1", "wall_time": "s", "moving_cells": "1"}


def field_value(name, frame):
    """The values of fixtures.cpp: 4 rows of 6 cells."""
    which = 1.0 if name == "depth" else float(ord(name[-1]))
    return which + 0.25 * frame + np.arange(24).reshape(4, 6) / 4096


class Formats(unittest.TestCase):
    directory = None

    def path(self, name):
        return os.path.join(self.directory, name)

    def data_sets(self, names=("float32.h5", "float64.h5")):
        for name in names:
            for engine in ENGINES:
                with self.subTest(file=name, engine=engine):
                    with xarray.open_dataset(self.path(name), engine=engine) as data:
                        yield data

    def test_dimensions_and_coordinates(self):
        for data in self.data_sets():
            self.assertEqual(dict(data.sizes), {"time": 3, "y": 4, "x": 6, "probe": 2, "front_depth": 2, "object": 2, "axis": 3,
                                                "quaternion": 4, "particle": 96})
            np.testing.assert_array_equal(data["time"], [0.0, 0.25, 0.5])
            np.testing.assert_array_equal(data["x"], 0.25 + 0.5 * np.arange(6))
            np.testing.assert_array_equal(data["y"], 0.25 + 0.5 * np.arange(4))
            for name, units in (("time", "s"), ("x", "m"), ("y", "m")):
                self.assertEqual(data[name].attrs["units"], units)

    def test_fields_and_maps(self):
        for data in self.data_sets():
            for name, units in FIELDS.items():
                self.assertEqual(data[name].dims, ("time", "y", "x"))
                self.assertEqual(data[name].attrs["units"], units)
                for frame in range(3):
                    np.testing.assert_array_equal(data[name][frame], field_value(name, frame))
            for name, units in MAPS.items():
                self.assertEqual(data[name].dims, ("y", "x"))
                self.assertEqual(data[name].attrs["units"], units)
            np.testing.assert_array_equal(data["bed"], np.zeros((4, 6)))
            np.testing.assert_array_equal(data["arrival_time"], 3 + np.arange(24).reshape(4, 6))

    def test_numbers_of_a_frame(self):
        for data in self.data_sets():
            for name, units in NUMBERS.items():
                self.assertEqual(data[name].dims, ("time",))
                self.assertEqual(data[name].attrs["units"], units)
            np.testing.assert_array_equal(data["steps"], [0, 100, 200])
            self.assertEqual(data["steps"].dtype, np.int64)
            np.testing.assert_array_equal(data["volume"], [10, 11, 12])

    def test_probes_and_references(self):
        for data in self.data_sets():
            self.assertEqual(list(data["probe_name"].values), ["left", "r\u00e4nd"])
            self.assertEqual(data["probe_depth"].dims, ("time", "probe"))
            np.testing.assert_array_equal(data["probe_depth"], [[0, 0.5], [1, 1.5], [2, 2.5]])
            self.assertIn("probe_x", data["probe_depth"].coords)
            self.assertEqual(data["front"].dims, ("time", "front_depth"))
            np.testing.assert_array_equal(data["front"].sel(front_depth=0.125), [0.125, 1.125, 2.125])
            self.assertEqual(data["reference_depth"].dims, ("time", "x"))
            self.assertTrue(np.isnan(data["reference_depth"]).all())

    def test_objects(self):
        for data in self.data_sets():
            self.assertEqual(list(data["object_name"].values), ["plate", "b\u00e4ll"])
            self.assertEqual(data["object_position"].dims, ("time", "object", "axis"))
            np.testing.assert_array_equal(data["object_position"][2, 1], [2, 1, -0.5])
            self.assertEqual(data["object_rotation"].dims, ("time", "object", "quaternion"))
            np.testing.assert_array_equal(data["object_rotation"][1, 0], [0.6, 0, 0, 0.8])
            np.testing.assert_array_equal(data["object_present"][:, 0], [1, 0, 1])

    def test_particles(self):
        for data in self.data_sets():
            self.assertEqual(data["particle_position"].dims, ("time", "particle", "axis"))
            self.assertEqual(data["particle_position"].dtype, np.float64)
            np.testing.assert_array_equal(data["particle_position"][2, 95], [95, 2, -0.5])
            np.testing.assert_array_equal(data["particle_id"][1], 2**32 + np.arange(96))
            np.testing.assert_array_equal(data["particle_visible"][0], (np.arange(96) + 1) % 2)
            for bare in ("particle", "axis", "quaternion"):
                self.assertNotIn(bare, data.coords)

    def test_xdmf_of_particles_points_into_the_series(self):
        with h5py.File(self.path("float32.h5"), "r") as file:
            frames = xml.parse(self.path("particles.xdmf")).getroot().findall("./Domain/Grid/Grid")
            self.assertEqual(len(frames), 3)
            for item in frames[2].iter("DataItem"):
                if item.get("ItemType") != "HyperSlab":
                    continue
                slab, source = item.findall("DataItem")
                rank = int(slab.get("Dimensions").split()[1])
                start, stride, count = np.array(slab.text.split(), dtype=int).reshape(3, rank)
                values = file[source.text.split(":")[1]]
                self.assertEqual(tuple(map(int, source.get("Dimensions").split())), values.shape)
                self.assertEqual((start[0], *start[1:], *stride), (2,) + (0,) * (rank - 1) + (1,) * rank)
                self.assertEqual(tuple(count), (1,) + values.shape[1:])

    def test_attributes(self):
        for data in self.data_sets():
            self.assertEqual(data.attrs["Conventions"], "CF-1.10")
            self.assertEqual(data.attrs["title"], "A small scene")
            self.assertEqual(data.attrs["scene"], "title: A small scene\n")
            self.assertEqual(data.attrs["device"], "cpu")
            self.assertTrue(data.attrs["source"].startswith("sandsim "))
            self.assertTrue(data.attrs["history"].endswith("sandsim run"))

    def test_precision_and_chunks(self):
        for name, kind in (("float32.h5", np.float32), ("float64.h5", np.float64)):
            with h5py.File(self.path(name), "r") as file:
                self.assertEqual(file["depth"].dtype, kind)
                self.assertEqual(file["depth"].chunks, (1, 4, 6))
                self.assertEqual(file["depth"].compression, "gzip" if kind is np.float64 else None)
                self.assertEqual(file["volume"].dtype, np.float64)
                self.assertTrue(np.isnan(file["depth"].fillvalue))

    def test_a_partial_series_reads_the_same(self):
        for data in self.data_sets(("killed.h5.partial",)):
            self.assertEqual(data.sizes["time"], 3)
            np.testing.assert_array_equal(data["depth"][2], field_value("depth", 2))
            self.assertTrue(np.isnan(data["max_depth"]).all())

    def test_xdmf_is_well_formed(self):
        for name in ("float32.xdmf", "killed.xdmf"):
            frames = xml.parse(self.path(name)).getroot().findall("./Domain/Grid/Grid")
            self.assertEqual([frame.find("Time").get("Value") for frame in frames], ["0", "0.25", "0.5"])
            names = {attribute.get("Name") for attribute in frames[0].findall("Attribute")}
            self.assertEqual(names, set(FIELDS) | set(MAPS))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as directory:
        Formats.directory = directory
        subprocess.run([sys.argv.pop(1), "Results for other programs"], check=True, stdout=subprocess.DEVNULL,
                       env=dict(os.environ, SANDSIM_FORMATS=directory))
        unittest.main()
