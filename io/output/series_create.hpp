// Makes the data sets and attributes of a new series.h5. Internal to io/output.
#pragma once

#include "io/hdf5/hdf5.hpp"
#include "io/output/file_reserve.hpp"
#include "io/output/series_layout.hpp"
#include "io/output/series_writer.hpp"

namespace sandsim {

/// Type in which numbers are stored; not for text.
hid_t stored_type(const Variable& variable, Precision precision);

/// Length of each dimension of a variable; 0 for time.
std::vector<hsize_t> initial_extent(const Variable& variable, const Scene& scene);

/// Length of a chunk along each dimension: one frame, and no more than 256 KB in float32.
std::vector<hsize_t> chunk_extent(const Variable& variable, const Scene& scene);

/// What one frame adds to the file at most, uncompressed.
SeriesGrowth growth_of(const Scene& scene);

/// Creates the variables with their attributes and dimension scales.
void create_variables(hid_t file, const Scene& scene);

/// Fills in the coordinates and what else is known at the start.
void write_coordinates(hid_t file, const Scene& scene);

void write_global_attributes(hid_t file, const Scene& scene, const SeriesSettings& settings);

}  // namespace sandsim
