#!/usr/bin/python3
"""Rasters of a GIS through the program and back, as GDAL's own library and tools see them: check_rasters.py PROGRAM."""

import subprocess

import h5py
import numpy as np

import case
import gis_files as files
from case import EXIT_INVALID, EXIT_MISSING, GisCase


def bed_of(output):
    with h5py.File(output / "series.h5") as series:
        return series["bed"][()]


class GridOfARaster(GisCase):
    def setUp(self):
        super().setUp()
        files.geotiff(self.folder / "dem.tif", files.elevation())

    def test_cells_origin_and_values_are_those_of_the_raster(self):
        output = self.run_scene(self.scene())
        with h5py.File(output / "series.h5") as series:
            np.testing.assert_array_equal(series["x"], files.WEST + files.CELL * (np.arange(files.COLUMNS) + 0.5))
            np.testing.assert_array_equal(series["y"], files.SOUTH + files.CELL * (np.arange(files.ROWS) + 0.5))
            np.testing.assert_array_equal(series["bed"], files.elevation())

    def test_gdal_finds_place_crs_and_values_in_the_series_itself(self):
        output = self.run_scene(self.scene(more="output: {maxima: true}\n"))
        original, found = self.folder / "dem.tif", f"NETCDF:{output}/series.h5:bed"
        self.assertEqual(files.geotransform(found), files.geotransform(original))
        self.assertTrue(files.crs_is(found, files.UTM32))
        np.testing.assert_array_equal(files.values_north_first(found), files.values_north_first(original))

    def test_spacing_resamples_and_extent_and_margin_cut(self):
        for grid, cells, origin in (
                ("{like: dem.tif, spacing: 5 m}", (60, 40), (600000, 5200000)),
                ("{like: dem.tif, spacing: 40 m}", (7, 5), (600000, 5200000)),
                ("{like: dem.tif, margin: 30 m}", (24, 14), (600030, 5200030)),
                ("{like: dem.tif, extent: [600100 m, 5200050 m, 600200 m, 5200150 m]}", (10, 10), (600100, 5200050)),
                ("{like: dem.tif, extent: [600102 m, 5200049 m, 600199 m, 5200151 m]}", (10, 10), (600100, 5200050)),
                ("{like: dem.tif, spacing: 2 m, extent: [600101 m, 5200051 m, 600200 m, 5200150 m]}", (49, 49),
                 (600101, 5200051))):
            with self.subTest(grid=grid):
                scene = self.scene(grid=grid, initial="{type: layer, depth: 1 cm}")
                with h5py.File(self.run_scene(scene) / "series.h5") as series:
                    self.assertEqual((series["x"].size, series["y"].size), cells)
                    spacing = series["x"][1] - series["x"][0]
                    self.assertEqual((series["x"][0] - spacing / 2, series["y"][0] - spacing / 2), origin)

    def test_a_part_beyond_the_raster_is_refused(self):
        self.refused(self.scene(grid="{like: dem.tif, extent: [599990 m, 5200050 m, 600200 m, 5200150 m]}"),
                     EXIT_INVALID, "grid.extent", "reaches beyond the raster", "x from 600000 m to 600300 m")
        self.refused(self.scene(grid="{like: dem.tif, margin: 150 m}"), EXIT_INVALID, "grid.margin", "no cell is left")
        self.refused(self.scene(grid="{like: dem.tif, cells: [3, 3]}"), EXIT_INVALID, "grid.cells", "not used")
        self.refused(self.scene(grid="{cells: [3, 3], spacing: 1 m, margin: 1 m}"), EXIT_INVALID, "grid.margin")

    def test_the_resolved_scene_gives_the_same_run(self):
        output = self.run_scene(self.scene(grid="{like: dem.tif, margin: 20 m}"))
        again = self.run_scene(output / "scene.resolved.yaml", "again")
        np.testing.assert_array_equal(bed_of(output), bed_of(again))
        self.assertTrue(files.crs_is(f"NETCDF:{again}/series.h5:bed", files.UTM32))

    def test_cells_that_are_no_squares_need_a_spacing(self):
        files.geotiff(self.folder / "dem.tif", files.elevation(),
                      transform=(files.WEST, 10.0, 0.0, files.SOUTH + 100.0, 0.0, -5.0))
        self.refused(self.scene(), EXIT_INVALID, "grid.like", "no squares", "spacing: 5 m")
        self.run_scene(self.scene(grid="{like: dem.tif, spacing: 5 m}", initial="{type: layer, depth: 1 cm}"))


class CoordinateReferenceSystems(GisCase):
    def setUp(self):
        super().setUp()
        files.geotiff(self.folder / "dem.tif", files.elevation())

    def test_the_grid_may_state_its_own(self):
        grid = "{cells: [30, 20], spacing: 10 m, origin: [600000 m, 5200000 m], crs: 'EPSG:32632'}"
        output = self.run_scene(self.scene(grid=grid))
        np.testing.assert_array_equal(bed_of(output), files.elevation())

    def test_unknown_and_geographic_ones_are_refused(self):
        for crs, text in (("EPSG:4326", "degrees"), ("EPSG:99999", "EPSG:32632"), ("somewhere", "EPSG:32632"),
                          ("EPSG:2263", "foot")):
            with self.subTest(crs=crs):
                self.refused(self.scene(grid=f"{{cells: [30, 20], spacing: 10 m, crs: '{crs}'}}"), EXIT_INVALID,
                             "grid.crs", text)

    def test_a_raster_in_another_one_is_refused_with_the_command_that_projects_it(self):
        files.geotiff(self.folder / "other.tif", files.elevation(), epsg=32633)
        self.refused(self.scene(terrain="{type: raster, file: other.tif}"), EXIT_INVALID, "EPSG:32633",
                     "gdalwarp -t_srs EPSG:32632")

    def test_a_raster_with_one_on_a_grid_without_is_a_warning(self):
        done = self.call("check", self.scene(grid="{cells: [30, 20], spacing: 10 m, origin: [600000 m, 5200000 m]}"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("crs: EPSG:32632", done.stderr)

    def test_the_prj_beside_an_ascii_grid_counts(self):
        source = files.gdal.Open(str(self.folder / "dem.tif"))
        files.gdal.GetDriverByName("AAIGrid").CreateCopy(str(self.folder / "dem.asc"), source)
        self.assertTrue((self.folder / "dem.prj").exists())
        output = self.run_scene(self.scene(grid="{like: dem.asc}", terrain="{type: raster, file: dem.asc}"))
        self.assertTrue(files.crs_is(f"NETCDF:{output}/series.h5:bed", files.UTM32))
        (self.folder / "dem.prj").write_text(files.reference(32633).ExportToWkt(["FORMAT=WKT1_ESRI"]))
        self.refused(self.scene(terrain="{type: raster, file: dem.asc}"), EXIT_INVALID, "EPSG:32633")
        (self.folder / "dem.prj").write_text(files.reference(4326).ExportToWkt(["FORMAT=WKT1_ESRI"]))
        self.refused(self.scene(terrain="{type: raster, file: dem.asc}"), EXIT_MISSING, "dem.prj", "degrees")

    def test_degrees_are_refused_with_the_zone_to_project_to(self):
        files.geotiff(self.folder / "dem.tif", files.elevation(), epsg=4326,
                      transform=(10.0, 1e-4, 0.0, 47.0, 0.0, -1e-4))
        self.refused(self.scene(grid="{cells: [3, 3], spacing: 1 m}", initial="{type: layer, depth: 1 cm}"), EXIT_MISSING, "degrees",
                     "gdalwarp -t_srs EPSG:32632", "scene.yaml:2:")


class BadRasters(GisCase):
    GRID = "{cells: [30, 20], spacing: 10 m, origin: [600000 m, 5200000 m]}"

    def expect(self, *texts, terrain="{type: raster, file: dem.tif}"):
        self.refused(self.scene(grid=self.GRID, terrain=terrain), EXIT_MISSING, "scene.yaml:2:", *texts)

    def test_a_truncated_file(self):
        for options in ((), ("COMPRESS=DEFLATE",), ("TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16")):
            path = files.geotiff(self.folder / "dem.tif", files.elevation(), options=options)
            whole = path.read_bytes()
            for part in (0.3, 0.6, 0.9):
                with self.subTest(options=options, part=part):
                    path.write_bytes(whole[:int(len(whole) * part)])
                    self.expect("dem.tif")

    def test_text_and_nothing(self):
        (self.folder / "dem.tif").write_text("no raster at all\n")
        self.expect("GDAL cannot read it as a raster")
        (self.folder / "dem.tif").write_text("")
        self.expect("dem.tif")

    def test_complex_values(self):
        files.geotiff(self.folder / "dem.tif", files.elevation(np.complex64))
        self.expect("complex")

    def test_a_picture(self):
        path = files.geotiff(self.folder / "dem.tif", np.zeros((3, 20, 30), np.uint8), options=("PHOTOMETRIC=RGB",))
        self.assertEqual(path.name, "dem.tif")
        self.expect("colours")

    def test_a_rotated_grid(self):
        files.geotiff(self.folder / "dem.tif", files.elevation(),
                      transform=(files.WEST, 9.0, 1.0, files.SOUTH + 200.0, 1.0, -9.0))
        self.expect("rotated", "gdalwarp")

    def test_values_in_feet(self):
        files.geotiff(self.folder / "dem.tif", files.elevation(), unit="ft")
        self.expect("ft", "0.3048")

    def test_nothing_but_no_data(self):
        files.geotiff(self.folder / "dem.tif", np.full((20, 30), -9999, np.float32), no_data=-9999)
        self.expect("NODATA")


class Values(GisCase):
    def test_integers_scales_and_masks(self):
        values = np.round(files.elevation(np.float64)).astype(np.int16)
        files.geotiff(self.folder / "dem.tif", values)
        np.testing.assert_array_equal(bed_of(self.run_scene(self.scene())), values)
        data = files.gdal.Open(str(self.folder / "dem.tif"), files.gdal.GA_Update)
        data.GetRasterBand(1).SetScale(0.5)
        data.GetRasterBand(1).SetOffset(100.0)
        del data
        np.testing.assert_array_equal(bed_of(self.run_scene(self.scene())), 100.0 + 0.5 * values)

    def test_doubles_keep_their_bits(self):
        values = files.elevation(np.float64) + 1e-9
        files.geotiff(self.folder / "dem.tif", values)
        output = self.run_scene(self.scene(more="numerics: {precision: float64}\n"))
        np.testing.assert_array_equal(bed_of(output), values)

    def test_other_formats_hold_the_same(self):
        source = files.gdal.Open(str(files.geotiff(self.folder / "dem.tif", files.elevation())))
        for driver, name, options in (("netCDF", "dem.nc", ()), ("VRT", "dem.vrt", ()), ("GSBG", "dem.grd", ()),
                                      ("AAIGrid", "dem.asc", ("SIGNIFICANT_DIGITS=9",)),
                                      ("AAIGrid", "ascii.grd", ("SIGNIFICANT_DIGITS=9",))):
            with self.subTest(name=name):
                files.gdal.GetDriverByName(driver).CreateCopy(str(self.folder / name), source, options=list(options))
                output = self.run_scene(self.scene(terrain=f"{{type: raster, file: {name}}}"))
                np.testing.assert_array_equal(bed_of(output), files.elevation())

    def test_a_file_whose_first_row_is_the_southern_one(self):
        files.geotiff(self.folder / "dem.tif", files.elevation()[::-1],
                      transform=(files.WEST, files.CELL, 0.0, files.SOUTH, 0.0, files.CELL))
        np.testing.assert_array_equal(bed_of(self.run_scene(self.scene())), files.elevation())


class BandsAndVariables(GisCase):
    def test_a_band_is_chosen_and_a_wrong_one_refused(self):
        bands = np.stack([files.elevation(), files.elevation() + 7])
        files.geotiff(self.folder / "dem.tif", bands)
        output = self.run_scene(self.scene(terrain="{type: raster, file: dem.tif, band: 2}"))
        np.testing.assert_array_equal(bed_of(output), bands[1])
        np.testing.assert_array_equal(bed_of(self.run_scene(output / "scene.resolved.yaml", "again")), bands[1])
        self.refused(self.scene(terrain="{type: raster, file: dem.tif, band: 3}"), EXIT_MISSING, "no band 3",
                     "2 bands")

    def test_a_variable_of_a_result_is_a_raster(self):
        files.geotiff(self.folder / "dem.tif", files.elevation())
        self.run_scene(self.scene(), "first")
        self.call("export", "first", "--what", "rasters", "--field", "depth", "--frame", "0", "-o", "depth.tif")
        (self.folder / "first" / "series.h5").rename(self.folder / "series.nc")
        output = self.run_scene(self.scene(initial="{type: raster, file: depth.tif}",
                                           terrain="{type: raster, file: series.nc, variable: bed}"))
        np.testing.assert_array_equal(bed_of(output), files.elevation())
        self.refused(self.scene(terrain="{type: raster, file: series.nc, variable: beds}"), EXIT_MISSING, "beds", "bed")

    def test_a_file_that_holds_one_map_has_no_bands(self):
        np.save(self.folder / "dem.npy", files.elevation())
        self.refused(self.scene(grid="{cells: [30, 20], spacing: 10 m, origin: [600000 m, 5200000 m]}",
                                terrain="{type: raster, file: dem.npy, band: 2}"), EXIT_MISSING, "band 2", "one map")


class NoData(GisCase):
    def setUp(self):
        super().setUp()
        values = files.elevation()
        values[:4, :5] = -9999.0
        files.geotiff(self.folder / "dem.tif", values, no_data=-9999.0)

    def test_is_an_error_unless_the_scene_says_what_to_do(self):
        self.refused(self.scene(), EXIT_INVALID, "dem.tif", "20 of 600 cells", "cell (0, 0)", "nodata: wall",
                     "nodata: nearest", "scene.yaml:2:")
        for way in ("wall", "nearest"):
            with self.subTest(way=way):
                output = self.run_scene(self.scene(terrain=f"{{type: raster, file: dem.tif, nodata: {way}}}"))
                np.testing.assert_array_equal(bed_of(output)[4:], files.elevation()[4:])
        # The last one was nearest: the first row with data is next.
        self.assertEqual(bed_of(output)[3, 2], files.elevation()[4, 2])

    def test_a_value_that_is_not_declared_is_a_warning(self):
        values = files.elevation()
        values[3, 4] = -32768.0
        files.geotiff(self.folder / "dem.tif", values)
        done = self.call("check", self.scene())
        self.assertIn("-32768", done.stderr)
        self.assertEqual(done.returncode, 0, done.stderr)


class Export(GisCase):
    def setUp(self):
        super().setUp()
        files.geotiff(self.folder / "dem.tif", files.elevation())

    def test_maps_and_fields_come_back_to_the_bit(self):
        output = self.run_scene(self.scene(more="output: {maxima: true}\n"))
        for kind, extension in (("float32", "tif"), ("float32", "asc")):
            with self.subTest(format=extension):
                done = self.call("export", output, "--what", "rasters", "--format", extension, "-q")
                self.assertEqual(done.returncode, 0, done.stderr)
                with h5py.File(output / "series.h5") as series:
                    for name in ("bed", "max_depth", "max_speed_over_time", "arrival_time", "depth", "velocity_x"):
                        path = output / "rasters" / f"{name}.{extension}"
                        expected = series[name][()] if series[name].ndim == 2 else series[name][-1]
                        found = files.values_north_first(path)[::-1]
                        if extension == "asc":
                            expected = np.where(np.isnan(expected), -9999.0, expected)
                        np.testing.assert_array_equal(found.astype(kind), expected.astype(kind), err_msg=name)
                        self.assertEqual(files.geotransform(path), files.geotransform(self.folder / "dem.tif"))
                        self.assertTrue(files.crs_is(path, files.UTM32))

    def test_gdalinfo_tells_place_and_crs(self):
        output = self.run_scene(self.scene())
        self.call("export", output, "--what", "rasters", "--field", "depth", "-o", "depth.tif")
        said = subprocess.run(["gdalinfo", self.folder / "depth.tif"], capture_output=True, text=True, check=True).stdout
        for text in ("WGS 84 / UTM zone 32N", "Upper Left  (  600000.000, 5200200.000)",
                     "Lower Right (  600300.000, 5200000.000)", "NoData Value=nan"):
            self.assertIn(text, said)

    def test_frames_are_numbered_and_nothing_is_replaced_unasked(self):
        output = self.run_scene(self.scene())
        words = ("export", output, "--what", "rasters", "--field", "depth", "--all")
        self.assertEqual(self.call(*words).returncode, 0)
        self.assertEqual(sorted(path.name for path in (output / "rasters").iterdir()),
                         ["depth_0000.tif", "depth_0001.tif"])
        self.assertEqual(self.call(*words).returncode, 6)
        self.assertEqual(self.call(*words, "--overwrite").returncode, 0)

    def test_what_is_not_there_is_said(self):
        output = self.run_scene(self.scene())
        done = self.call("export", output, "--what", "rasters", "--field", "max_depth")
        self.assertEqual(done.returncode, 1)
        self.assertIn("bed, depth, velocity_x, velocity_y", done.stderr)
        self.assertEqual(self.call("export", output, "--field", "depth").returncode, 1)


if __name__ == "__main__":
    case.main()
