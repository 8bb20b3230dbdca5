# GDAL is optional for users. SANDSIM_HAS_GDAL tells the rest of the build.
set(SANDSIM_HAS_GDAL FALSE)
if(NOT SANDSIM_GDAL STREQUAL "OFF")
  find_package(GDAL 3.5)
  set(SANDSIM_HAS_GDAL ${GDAL_FOUND})
  if(SANDSIM_GDAL STREQUAL "ON" AND NOT GDAL_FOUND)
    message(FATAL_ERROR "SANDSIM_GDAL=ON, but no GDAL was found (libgdal-dev)")
  endif()
endif()
