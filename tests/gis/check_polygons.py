#!/usr/bin/python3
"""Releases and zones of a GIS: check_polygons.py PROGRAM."""

import numpy as np

import case
import gis_files as files
from case import EXIT_INVALID, EXIT_MISSING, GisCase


# [m^3] Edges are rounded to 2^-30 of a cell of 10 m: 300 m of them, 2 m deep.
ROUNDING = 300 * 2 * 10 / 2**30


class Releases(GisCase):
    """Polygons on a level grid of 300 m x 200 m: areas are exact."""

    RING = files.box(600032.0, 5200024.0, 600111.0, 5200093.0)          # 79 m x 69 m = 5451 m^2, not on cells

    def setUp(self):
        super().setUp()
        files.geotiff(self.folder / "dem.tif", np.zeros((20, 30), np.float32))

    def release(self, initial, **more):
        return self.report(self.run_scene(self.scene(initial=initial, **more)))["release"]

    def test_a_polygon_keeps_its_volume_and_its_hole(self):
        hole = files.box(600050.0, 5200040.0, 600060.0, 5200045.0)      # 50 m^2
        files.geojson(self.folder / "areas.geojson", [(files.polygon(self.RING, hole), {})], epsg=files.UTM32)
        release = self.release("{type: polygon, file: areas.geojson, depth: 2 m}")
        self.assertAlmostEqual(release["grid_volume"], 2.0 * (5451.0 - 50.0), delta=ROUNDING)

    def test_an_attribute_gives_the_depth_in_every_format(self):
        ring = ", ".join(f"{x} {y}" for x, y in self.RING + self.RING[:1])
        wkt = f"MULTIPOLYGON ((({ring})), ((600200 5200100, 600210 5200100, 600210 5200110, 600200 5200100)))"
        for driver, name in (("GPKG", "a.gpkg"), ("ESRI Shapefile", "a.shp"), ("GeoJSON", "a.geojson")):
            with self.subTest(driver=driver):
                files.vector_file(self.folder / name, driver, [(wkt, 1.5)])
                # GDAL writes GeoJSON in degrees with 7 decimals, a centimetre.
                release = self.release(f"{{type: polygon, file: {name}, attribute: thickness}}")
                self.assertAlmostEqual(release["grid_volume"] / (1.5 * (5451.0 + 50.0)), 1.0,
                                       delta=1e-3 if driver == "GeoJSON" else 1e-9)

    def test_degrees_are_transformed(self):
        to_degrees = files.osr.CoordinateTransformation(files.reference(files.UTM32), files.reference(4326))
        ring = [to_degrees.TransformPoint(*point)[:2] for point in self.RING]
        files.geojson(self.folder / "areas.geojson", [(files.polygon(ring), {})])
        release = self.release("{type: polygon, file: areas.geojson, depth: 2 m}")
        self.assertAlmostEqual(release["grid_volume"], 2.0 * 5451.0, delta=1e-3)

    def test_what_lies_outside_is_said_with_both_volumes(self):
        files.geojson(self.folder / "areas.geojson",
                      [(files.polygon(files.box(600250.0, 5200100.0, 600350.0, 5200150.0)), {})], epsg=files.UTM32)
        scene = self.scene(initial="{type: polygon, file: areas.geojson, depth: 2 m}")
        done = self.call("check", scene)
        self.assertEqual(done.returncode, 0)
        self.assertIn("5000 m^3 of 10000 m^3", done.stderr)
        self.assertIn("scene.yaml:3:", done.stderr)

    def test_rasters_keep_their_volume_on_any_cells(self):
        thickness = np.full((37, 41), -9999.0, np.float32)
        thickness[8:30, 5:33] = 1.25
        for cell, x0, y0 in ((1.0, 40.3, 30.7), (2.5, 61.0, 52.0), (4.0, 33.1, 20.0)):
            path = files.geotiff(self.folder / "r.tif", thickness, no_data=-9999.0,
                                 transform=(files.WEST + x0, cell, 0.0, files.SOUTH + y0 + 37 * cell, 0.0, -cell))
            meant = 22 * 28 * 1.25 * cell * cell
            for spacing in (3.0, 5.0, 7.5, 10.0):
                with self.subTest(path=path.name, cell=cell, spacing=spacing):
                    release = self.release("{type: raster, file: r.tif}", grid=f"{{like: dem.tif, spacing: {spacing} m}}")
                    self.assertAlmostEqual(release["grid_volume"] / meant, 1.0, delta=1e-6)

    def test_bad_polygons_are_refused(self):
        crossing = [(600100, 5200100), (600200, 5200150), (600200, 5200100), (600100, 5200150)]
        flat = [(600100, 5200100), (600200, 5200100), (600150, 5200100)]
        point = {"type": "Point", "coordinates": [600100, 5200100]}
        for geometry, text in ((files.polygon(crossing), "no valid polygon"), (files.polygon(flat), ""),
                               (point, "no polygon"), (None, "no geometry")):
            with self.subTest(text=text):
                files.geojson(self.folder / "areas.geojson", [(geometry, {})], epsg=files.UTM32)
                self.refused(self.scene(initial="{type: polygon, file: areas.geojson, depth: 2 m}"), EXIT_MISSING,
                             "areas.geojson", text, "scene.yaml:3:")
        files.geojson(self.folder / "areas.geojson", [], epsg=files.UTM32)
        self.refused(self.scene(initial="{type: polygon, file: areas.geojson, depth: 2 m}"), EXIT_MISSING, "empty")

    def test_bad_attributes_and_layers_are_refused(self):
        files.geojson(self.folder / "areas.geojson", [(files.polygon(self.RING), {"name": "one", "h": None})],
                      epsg=files.UTM32)
        for attribute, text in (("depth", "the layer has name, h"), ("name", "no number"), ("h", "")):
            with self.subTest(attribute=attribute):
                self.refused(self.scene(initial=f"{{type: polygon, file: areas.geojson, attribute: {attribute}}}"),
                             EXIT_MISSING, text)
        self.refused(self.scene(initial="{type: polygon, file: areas.geojson, layer: other, depth: 1 m}"), EXIT_MISSING,
                     "no layer 'other'")

    def test_a_crs_is_never_ignored(self):
        # Metres under the name of degrees; none at all where the grid has one; one where the grid has none.
        files.geojson(self.folder / "areas.geojson", [(files.polygon(self.RING), {})])
        initial = "{type: polygon, file: areas.geojson, depth: 2 m}"
        self.refused(self.scene(initial=initial), EXIT_MISSING, "ogr2ogr -a_srs EPSG:32632")
        ring = ", ".join(f"{x} {y}" for x, y in self.RING + self.RING[:1])
        files.vector_file(self.folder / "a.shp", "ESRI Shapefile", [(f"POLYGON (({ring}))", 1.0)], epsg=None)
        self.refused(self.scene(initial="{type: polygon, file: a.shp, depth: 2 m}"), EXIT_MISSING, "no CRS")
        files.geojson(self.folder / "areas.geojson", [(files.polygon(self.RING), {})], epsg=files.UTM32)
        own = {"grid": "{cells: [30, 20], spacing: 10 m, origin: [600000 m, 5200000 m]}", "terrain": "{type: flat}"}
        self.refused(self.scene(initial=initial, **own), EXIT_MISSING, "grid.crs: EPSG:32632")
        files.geojson(self.folder / "areas.geojson", [(files.polygon(self.RING), {})])
        self.assertAlmostEqual(self.release(initial, **own)["grid_volume"], 2.0 * 5451.0, delta=ROUNDING)


class Zones(GisCase):
    def test_friction_by_polygons(self):
        files.geotiff(self.folder / "dem.tif", np.zeros((20, 30), np.float32))
        files.vector_file(self.folder / "soils.gpkg", "GPKG",
                          [("POLYGON ((600000 5200000, 600105 5200000, 600105 5200200, 600000 5200200, 600000 5200000))",
                            35.0)], field=("phi", files.ogr.OFTReal))
        scene = self.folder / "scene.yaml"
        friction = "{polygons: soils.gpkg, attribute: phi, unit: deg, elsewhere: 25 deg}"
        text = (f"grid: {{like: dem.tif}}\nsand: {{friction_angle: {friction}, initial: {{type: layer, depth: 1 cm}}}}\n"
                "time: {end: 1 s, frame_interval: 1 s}\n")
        scene.write_text(text)
        self.run_scene(scene)
        scene.write_text(text.replace("phi", "psi"))
        self.refused(scene, EXIT_MISSING, "no attribute 'psi'", "scene.yaml:2:")
        scene.write_text(text.replace("unit: deg, ", ""))
        self.refused(scene, EXIT_INVALID, "unit")


if __name__ == "__main__":
    case.main()
