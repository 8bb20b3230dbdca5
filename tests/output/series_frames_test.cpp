#include "io/output/series_frames.hpp"

#include <limits>

#include "fixtures.hpp"
#include "io/hdf5/hdf5.hpp"
#include "solver/errors.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using namespace sandsim::test;

namespace {

/// Sets one value of a field over time.
void spoil(const std::filesystem::path& path, const std::string& name, hsize_t frame, hsize_t row, hsize_t column,
           float value) {
  const hdf5::Session session;
  const hdf5::Handle file = hdf5::open_file(path, true);
  const hdf5::Handle dataset = hdf5::open_dataset(file.id(), name);
  hdf5::write(dataset.id(), H5T_NATIVE_FLOAT, &value, {{frame, row, column}, {1, 1, 1}});
}

}  // namespace

TEST_CASE("the frames of a series come with its grid and its times") {
  const TemporaryDirectory folder;
  const Scene scene = small_scene(4, 3);
  write_series(folder / "series.h5", scene, 3);
  for (const std::filesystem::path& given : {folder.path(), folder / "series.h5"}) {
    const SeriesFrames series(given);
    CHECK(series.path() == folder / "series.h5");
    CHECK(series.grid().cells == scene.grid.cells);
    CHECK(series.grid().spacing == 0.5);
    CHECK(series.grid().origin == scene.grid.origin);
    CHECK(series.times() == std::vector<double>{0.0, 0.25, 0.5});
    CHECK(series.has("depth"));
    CHECK_FALSE(series.has("particle_position"));
    CHECK(series.bed().size() == 12);
    const std::vector<double> depth = series.field("depth", 2);
    for (std::size_t cell = 0; cell < 12; ++cell) CHECK(depth[cell] == field_value("depth", 2, cell));
  }
}

TEST_CASE("one column of cells is a grid as well as one row") {
  const TemporaryDirectory folder;
  write_series(folder / "row.h5", small_scene(5, 1), 1);
  write_series(folder / "column.h5", small_scene(1, 5), 1);
  CHECK(SeriesFrames(folder / "row.h5").grid().cells == std::array<int, 2>{5, 1});
  CHECK(SeriesFrames(folder / "column.h5").grid().spacing == 0.5);
}

TEST_CASE("a series without what is asked for says what the run needs") {
  const TemporaryDirectory folder;
  write_series(folder / "series.h5", small_scene(4, 3), 1);
  const SeriesFrames series(folder.path());
  const std::string file = (folder / "series.h5").string();
  CHECK(message_of<InputError>([&] { series.field("surface", 0); }) ==
        file + ": it holds no surface; the run needs output.fields with surface");
  CHECK(message_of<InputError>([&] { series.particles(0); }) ==
        file + ": it holds no particle_position; the scene needs 'particles'");
  CHECK(message_of<InputError>([&] { series.field("bed", 0); }) ==
        file + ": bed is no array of numbers with 3 dimensions");
}

TEST_CASE("a value that is not finite is told with its cell") {
  const TemporaryDirectory folder;
  write_series(folder / "series.h5", small_scene(4, 3), 2);
  spoil(folder / "series.h5", "depth", 1, 2, 3, std::numeric_limits<float>::quiet_NaN());
  const SeriesFrames series(folder.path());
  CHECK(series.field("depth", 0).size() == 12);
  CHECK(message_of<InputError>([&] { series.field("depth", 1); }) ==
        (folder / "series.h5").string() + ": depth of frame 1 is nan in cell (3, 2), counted from 0");
}

TEST_CASE("a folder without a series and a file that is none are errors of the input") {
  const TemporaryDirectory folder;
  CHECK_THROWS_AS(SeriesFrames(folder / "nothing"), InputError);
  CHECK_THROWS_AS(SeriesFrames(folder.path()), InputError);
  write_text(folder / "series.h5", "no HDF5");
  CHECK_THROWS_AS(SeriesFrames(folder.path()), InputError);
}
