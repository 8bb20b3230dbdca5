// Rasters from files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/gis/gis.hpp"
#include "solver/raster.hpp"

namespace sandsim {

/// Reads a raster; the content tells the format, whatever the file is called: ESRI ASCII grid, NumPy array, or else
/// what GDAL reads. Throws InputError: "file:line:col: problem (why). Suggestion".
Raster read_raster(const std::filesystem::path& path, const RasterRequest& request = {});

/// Reads an ESRI ASCII grid from memory; `name` stands for the file in errors.
/// The header holds, in any order and case: ncols, nrows; xllcorner or xllcenter; yllcorner or yllcenter; cellsize, or
/// dx and dy; and perhaps NODATA_value (a number, nan or null). A colon or an equals sign may follow a key; or all keys
/// follow their values, as GeoClaw writes them. The values follow, the northern row first, separated by blanks or line
/// ends wherever they fall. Numbers have a decimal point or comma (EsriNumbers), exponents E or D. Lengths are metres.
/// Values that are NaN (nan, null, 1.#QNAN) or equal NODATA_value in single precision become NaN; the rows are flipped,
/// so that row 0 is the southern one.
Raster read_esri_ascii(std::string_view text, const std::string& name);

/// Reads a .npy file (format 1 to 3) from memory: f4, f8, i1 to i8, u1 to u8, either byte order, C or Fortran order.
/// Two dimensions (y, x); one dimension is one row. Row 0 has the smallest y, the opposite of an
/// ESRI ASCII grid, unless the scene says first_row: north (io/scene/reading.cpp flips it then).
/// NaN means no data; an array of NaN alone is an error. The file knows no position: has_georeference is false.
Raster read_npy(std::string_view bytes, const std::string& name);

}  // namespace sandsim
