#!/usr/bin/python3
"""Writes the files of scenes/gis, as a GIS has them: a DEM, release areas and zones of the ground.

    make_gis.py [FOLDER]            writes them there (default: scenes/gis)

  dem.tif            a mountain side with a gully above a fan, 240 x 160 cells of 10 m in EPSG:32632
  catchment.tif      the same, clipped at the outline of a catchment: NODATA beyond it
  release.geojson    two release areas in longitude and latitude (EPSG:4326), with their thickness [m]
  release.tif        the upper one as a raster of thickness in cells of 4 m, NODATA around it
  ground.gpkg        forest and scree as polygons with their friction angle [deg], in EPSG:25832
"""

import argparse
import json
from pathlib import Path

import numpy as np
from osgeo import gdal, ogr, osr

gdal.UseExceptions()
ogr.UseExceptions()
osr.UseExceptions()

WEST, SOUTH = 630000.0, 5190000.0       # corner of the DEM in EPSG:32632 [m]
COLUMNS, ROWS, CELL = 240, 160, 10.0
NO_DATA = -9999.0
MIDDLE = ROWS * CELL / 2                # y of the gully [m from the corner]
FOOT = 1100.0                           # x at which the fan begins [m from the corner]


def reference(epsg):
    srs = osr.SpatialReference()
    srs.ImportFromEPSG(epsg)
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return srs


def elevation(x, y):
    """Falls to the east: 33 deg at the top, less and less below, level at last; a gully down to the fan, which is a low
    cone. [m]"""
    along = x / (COLUMNS * CELL)
    side = 1900.0 + 560.0 * np.exp(-along / 0.36)
    inside = np.clip((FOOT - x) / FOOT, 0.0, 1.0)
    gully = 45.0 * np.sin(np.pi * np.clip(x / FOOT, 0.0, 1.0)) ** 2 * np.exp(-(((y - MIDDLE) / 90.0) ** 2))
    fan = 18.0 * np.exp(-(((x - FOOT - 250.0) / 350.0) ** 2 + ((y - MIDDLE) / 260.0) ** 2))
    ribs = 3.0 * inside * np.cos(2.0 * np.pi * y / 320.0)
    return side - gully + fan + ribs


def centres(columns, rows, cell, x0=0.0, y0=0.0):
    return np.meshgrid(x0 + (np.arange(columns) + 0.5) * cell, y0 + (np.arange(rows) + 0.5) * cell)


def write_raster(path, values, cell, x0=0.0, y0=0.0, no_data=None):
    """`values` begin in the south; the file begins in the north, as GIS files do."""
    rows, columns = values.shape
    data = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, 1, gdal.GDT_Float32, ["COMPRESS=DEFLATE"])
    data.SetGeoTransform((WEST + x0, cell, 0.0, SOUTH + y0 + rows * cell, 0.0, -cell))
    data.SetSpatialRef(reference(32632))
    band = data.GetRasterBand(1)
    if no_data is not None:
        band.SetNoDataValue(no_data)
        values = np.where(np.isnan(values), no_data, values)
    band.WriteArray(values[::-1].astype(np.float32))
    data.FlushCache()


def slab(x_middle, y_middle, length, width):
    """Corners of a release area, an ellipse with 24 corners. [m from the corner of the DEM]"""
    angles = np.arange(24) * 2.0 * np.pi / 24
    return [(x_middle + 0.5 * length * np.cos(a), y_middle + 0.5 * width * np.sin(a)) for a in angles]


UPPER = slab(190.0, 800.0, 160.0, 420.0)
LOWER = slab(420.0, 560.0, 120.0, 140.0)
ROCK = slab(200.0, 860.0, 50.0, 60.0)      # an island in the upper one


def inside(corners, x, y):
    """Whether the points lie in a convex polygon whose corners run counter-clockwise."""
    result = np.ones(x.shape, bool)
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1]):
        result &= (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) >= 0.0
    return result


def in_degrees(corners):
    to_degrees = osr.CoordinateTransformation(reference(32632), reference(4326))
    ring = [to_degrees.TransformPoint(WEST + x, SOUTH + y)[:2] for x, y in corners]
    return [[round(value, 9) for value in point] for point in ring + ring[:1]]


def write_release(path):
    def feature(name, thickness, rings):
        return {"type": "Feature", "properties": {"name": name, "thickness": thickness},
                "geometry": {"type": "Polygon", "coordinates": [in_degrees(ring) for ring in rings]}}

    areas = [feature("upper", 1.5, [UPPER, ROCK[::-1]]), feature("lower", 0.8, [LOWER])]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": areas}, indent=1) + "\n", encoding="utf-8")


def write_ground(path):
    path.unlink(missing_ok=True)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = source.CreateLayer("ground", reference(25832), ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("kind", ogr.OFTString))
    layer.CreateField(ogr.FieldDefn("phi", ogr.OFTReal))
    for kind, phi, (x0, y0, x1, y1) in (("forest", 31.0, (900.0, 0.0, 1500.0, 640.0)),
                                        ("forest", 31.0, (900.0, 960.0, 1500.0, 1600.0)),
                                        ("scree", 27.0, (900.0, 640.0, 1500.0, 960.0))):
        ring = ogr.Geometry(ogr.wkbLinearRing)
        for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)):
            ring.AddPoint_2D(WEST + x, SOUTH + y)
        polygon = ogr.Geometry(ogr.wkbPolygon)
        polygon.AddGeometry(ring)
        feature = ogr.Feature(layer.GetLayerDefn())
        feature["kind"], feature["phi"] = kind, phi
        feature.SetGeometry(polygon)
        layer.CreateFeature(feature)
    source = None  # closes it


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path,
                        default=Path(__file__).resolve().parent.parent / "scenes" / "gis")
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    x, y = centres(COLUMNS, ROWS, CELL)
    dem = elevation(x, y)
    write_raster(folder / "dem.tif", dem, CELL)
    outside = ((x - 1200.0) / 1210.0) ** 2 + ((y - MIDDLE) / 815.0) ** 2 > 1.0
    write_raster(folder / "catchment.tif", np.where(outside, np.nan, dem), CELL, no_data=NO_DATA)
    x, y = centres(60, 125, 4.0, 80.0, 550.0)
    thickness = np.where(inside(UPPER, x, y) & ~inside(ROCK, x, y), 1.5, np.nan)
    write_raster(folder / "release.tif", thickness, 4.0, 80.0, 550.0, no_data=NO_DATA)
    write_release(folder / "release.geojson")
    write_ground(folder / "ground.gpkg")


if __name__ == "__main__":
    main()
