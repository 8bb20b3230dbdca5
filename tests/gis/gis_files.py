"""Rasters and vectors for the tests, written by GDAL's own library."""

import json

import numpy as np
from osgeo import gdal, ogr, osr

gdal.UseExceptions()
ogr.UseExceptions()
osr.UseExceptions()

UTM32 = 32632
WEST, SOUTH = 600000.0, 5200000.0         # of the raster's corner, in EPSG:32632
COLUMNS, ROWS, CELL = 30, 20, 10.0


def reference(epsg):
    srs = osr.SpatialReference()
    srs.ImportFromEPSG(epsg)
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return srs


def elevation(kind=np.float32):
    """A slope that falls to the east and is no plane: every value is its own. Row 0 is the southern one."""
    i, j = np.meshgrid(np.arange(COLUMNS), np.arange(ROWS))
    return (1000.0 - 3.0 * i + 0.25 * j + 1e-3 * i * j).astype(kind)


def geotiff(path, values, epsg=UTM32, transform=None, no_data=None, kind=None, options=(), unit=None):
    """Writes `values` (bands, or one; row 0 in the south) north up."""
    bands = values if values.ndim == 3 else values[None]
    count, rows, columns = bands.shape
    kind = kind or {"f4": gdal.GDT_Float32, "f8": gdal.GDT_Float64, "i2": gdal.GDT_Int16, "u1": gdal.GDT_Byte,
                    "c8": gdal.GDT_CFloat32}[bands.dtype.str[1:]]
    data = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, count, kind, list(options))
    data.SetGeoTransform(transform or (WEST, CELL, 0.0, SOUTH + rows * CELL, 0.0, -CELL))
    if epsg:
        data.SetSpatialRef(reference(epsg))
    for number, band in enumerate(bands, 1):
        data.GetRasterBand(number).WriteArray(band[::-1])
        if no_data is not None:
            data.GetRasterBand(number).SetNoDataValue(no_data)
        if unit:
            data.GetRasterBand(number).SetUnitType(unit)
    data.FlushCache()
    return path


# GDAL's bands and references die with their data set, which a name has to hold.
def values_north_first(path):
    data = gdal.Open(str(path))
    return data.ReadAsArray()


def geotransform(path):
    data = gdal.Open(str(path))
    return data.GetGeoTransform()


def crs_is(path, epsg):
    data = gdal.Open(str(path))
    return bool(data.GetSpatialRef().IsSame(reference(epsg)))


def geojson(path, features, epsg=None):
    """`features` are (geometry, properties)."""
    collection = {"type": "FeatureCollection",
                  "features": [{"type": "Feature", "properties": properties, "geometry": geometry}
                               for geometry, properties in features]}
    if epsg:
        collection["crs"] = {"type": "name", "properties": {"name": f"urn:ogc:def:crs:EPSG::{epsg}"}}
    path.write_text(json.dumps(collection))
    return path


def polygon(*rings):
    return {"type": "Polygon", "coordinates": [[list(point) for point in ring] + [list(ring[0])] for ring in rings]}


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def vector_file(path, driver, features, epsg=UTM32, layer="zones", field=("thickness", ogr.OFTReal)):
    """`features` are (WKT, value of the field or None)."""
    source = ogr.GetDriverByName(driver).CreateDataSource(str(path))
    made = source.CreateLayer(layer, reference(epsg) if epsg else None, ogr.wkbUnknown if driver == "GPKG" else ogr.wkbPolygon)
    made.CreateField(ogr.FieldDefn(*field))
    for wkt, value in features:
        feature = ogr.Feature(made.GetLayerDefn())
        feature.SetGeometry(ogr.CreateGeometryFromWkt(wkt))
        if value is not None:
            feature.SetField(field[0], value)
        made.CreateFeature(feature)
    return path
