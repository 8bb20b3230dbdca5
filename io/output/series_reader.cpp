#include "io/output/series_reader.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <cmath>

#include "io/output/output_directory.hpp"
#include "io/output/series_layout.hpp"
#include "io/output/series_writer.hpp"
#include "solver/errors.hpp"

namespace sandsim {
namespace {

using hdf5::Handle;

std::string name_of_object(hid_t object) {
  char name[256] = {};
  if (H5Iget_name(object, name, sizeof name) <= 0) return {};
  return name + (name[0] == '/' ? 1 : 0);
}

herr_t take_name(hid_t, unsigned, hid_t scale, void* name) {
  *static_cast<std::string*>(name) = name_of_object(scale);
  return 1;
}

std::vector<std::string> dimension_names(hid_t dataset, const std::string& name, std::size_t rank) {
  if (H5DSis_scale(dataset) > 0) return {name};
  std::vector<std::string> names(rank);
  for (std::size_t axis = 0; axis < rank; ++axis) {
    const auto number = static_cast<unsigned>(axis);
    if (H5DSget_num_scales(dataset, number) > 0) H5DSiterate_scales(dataset, number, nullptr, take_name, &names[axis]);
  }
  return names;
}

bool is_bare_dimension(hid_t dataset) {
  char name[64] = {};
  return H5DSis_scale(dataset) > 0 && H5DSget_scale_name(dataset, name, sizeof name) > 0 &&
         std::string(name).starts_with(bare_dimension_name);
}

StoredVariable describe(hid_t file, const std::string& name) {
  const Handle dataset = hdf5::open_dataset(file, name);
  StoredVariable variable;
  variable.name = name;
  variable.extent = hdf5::extent(dataset.id());
  variable.dimensions = dimension_names(dataset.id(), name, variable.extent.size());
  variable.units = hdf5::read_text_attribute(dataset.id(), "units").value_or("");
  variable.numeric = hdf5::is_numeric(dataset.id());
  variable.bare_dimension = is_bare_dimension(dataset.id());
  variable.element_size = hdf5::element_size(dataset.id());
  return variable;
}

}  // namespace

std::filesystem::path series_path(const std::filesystem::path& given) {
  std::error_code ignored;
  if (!std::filesystem::exists(given, ignored)) {
    throw InputError(given.string() + ": no such folder of results, or series");
  }
  if (!std::filesystem::is_directory(given, ignored)) return given;
  const std::filesystem::path finished = OutputFiles(given).series;
  return std::filesystem::exists(finished, ignored) ? finished : partial_series_path(finished);
}

SeriesReader::SeriesReader(const std::filesystem::path& path) : file_(hdf5::open_file(path, false)) {
  for (const std::string& name : hdf5::dataset_names(file_.id())) variables_.push_back(describe(file_.id(), name));
  times_ = read_coordinate("time");
  // A run that was killed while it wrote a time leaves NaN there.
  times_.erase(std::find_if(times_.begin(), times_.end(), [](double time) { return std::isnan(time); }), times_.end());
}

const StoredVariable* SeriesReader::find(const std::string& name) const {
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [&name](const auto& variable) { return variable.name == name; });
  return found == variables_.end() ? nullptr : &*found;
}

std::vector<double> SeriesReader::read_coordinate(const std::string& name) const {
  const StoredVariable* variable = find(name);
  if (variable == nullptr || !variable->numeric || variable->extent.size() != 1) {
    throw hdf5::Failure("no series of sandsim: it has no coordinate " + name);
  }
  return hdf5::read_all<double>(file_.id(), name);
}

std::string SeriesReader::attribute(const std::string& name) const {
  return hdf5::read_text_attribute(file_.id(), name).value_or("");
}

Grid SeriesReader::grid() const {
  const std::vector<double> x = read_coordinate("x"), y = read_coordinate("y");
  if (x.empty() || y.empty() || (x.size() < 2 && y.size() < 2)) throw hdf5::Failure("fewer than two cells");
  const std::vector<double>& longer = x.size() > 1 ? x : y;
  Grid grid;
  grid.cells = {static_cast<int>(x.size()), static_cast<int>(y.size())};
  grid.spacing = (longer.back() - longer.front()) / static_cast<double>(longer.size() - 1);
  if (!(grid.spacing > 0.0)) throw hdf5::Failure("the coordinates of its cells do not rise");
  grid.origin = {x.front() - 0.5 * grid.spacing, y.front() - 0.5 * grid.spacing};
  if (find(grid_mapping_name) != nullptr) {
    const Handle mapping = hdf5::open_dataset(file_.id(), grid_mapping_name);
    if (const auto wkt = hdf5::read_text_attribute(mapping.id(), "crs_wkt")) grid.crs = Crs{*wkt, *wkt};
  }
  return grid;
}

}  // namespace sandsim
