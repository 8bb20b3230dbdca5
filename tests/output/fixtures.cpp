#include "tests/output/fixtures.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "io/hdf5/hdf5.hpp"
#include "io/output/series_reader.hpp"
#include "solver/particles.hpp"

namespace sandsim::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> field_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const OutputField field : scene.output.fields) {
    switch (field) {
      case OutputField::depth:
        names.insert(names.end(), {"depth"});
        break;
      case OutputField::velocity:
        names.insert(names.end(), {"velocity_x", "velocity_y"});
        break;
      case OutputField::surface:
        names.insert(names.end(), {"surface"});
        break;
      case OutputField::momentum:
        names.insert(names.end(), {"momentum_x", "momentum_y"});
        break;
    }
  }
  return names;
}

template <class Number>
std::vector<Number> values_of(const std::string& name, std::int64_t frame, std::size_t cells) {
  std::vector<Number> values(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) values[cell] = static_cast<Number>(field_value(name, frame, cell));
  return values;
}

FieldValues values_of(const Scene& scene, const std::string& name, std::int64_t frame) {
  const std::size_t cells = scene.grid.cell_count();
  if (scene.numerics.precision == Precision::float32) return values_of<float>(name, frame, cells);
  return values_of<double>(name, frame, cells);
}

}  // namespace

TemporaryDirectory::TemporaryDirectory() {
  std::string pattern = (fs::temp_directory_path() / "sandsim-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary directory");
  path_ = pattern;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Scene small_scene(int nx, int ny) {
  Scene scene;
  scene.title = "A small scene";
  scene.grid.cells = {nx, ny};
  scene.grid.spacing = 0.5;
  return scene;
}

double field_value(const std::string& name, std::int64_t frame, std::size_t cell) {
  const double which = name == "depth" ? 1.0 : static_cast<double>(name.back());
  return which + 0.25 * static_cast<double>(frame) + static_cast<double>(cell % 4096) / 4096.0;
}

Frame frame_of(const Scene& scene, std::int64_t index) {
  Frame frame;
  frame.index = index;
  const auto number = static_cast<double>(index);
  frame.statistics = {0.25 * number, 10.0 + number, 2.0 * number, 0.5, 0.001, 0.002, 100 * index, 0.1 * number, 7};
  if (scene.output.frames) {
    for (const std::string& name : field_names(scene)) frame.fields.push_back({name, values_of(scene, name, index)});
  }
  for (std::size_t k = 0; k < scene.output.probes.size(); ++k) {
    frame.probes.push_back({number + 0.5 * static_cast<double>(k), -number, 3.0});
  }
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    frame.objects.push_back({{number, static_cast<double>(k), -0.5}, {0.6, 0.0, 0.0, 0.8}, index != 1});
  }
  if (scene.particles) {
    const std::int64_t count = ParticleGrid(scene.grid, *scene.particles).count();
    for (std::int64_t k = 0; k < count; ++k) {
      const double x = static_cast<double>(k), y = static_cast<double>(index);
      frame.particles.position.insert(frame.particles.position.end(), {x, y, -0.5});
      frame.particles.id.push_back((index << 32) | k);
      frame.particles.visible.push_back(k % 2 == 0 ? 1 : 0);
    }
  }
  if (scene.reference) {
    for (const double depth : scene.reference->front_depths) frame.fronts.push_back(number + depth);
  }
  return frame;
}

FieldValues map_of(const Scene& scene, double first) {
  std::vector<double> values(scene.grid.cell_count());
  for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell] = first + static_cast<double>(cell);
  if (scene.numerics.precision == Precision::float64) return values;
  return std::vector<float>(values.begin(), values.end());
}

SeriesSettings settings_of(const fs::path& path) {
  return {path, "title: A small scene\n", "cpu", "sandsim run", {}};
}

void write_series(const fs::path& path, const Scene& scene, std::int64_t frames) {
  SeriesWriter writer(settings_of(path));
  writer.begin(scene, {});
  for (std::int64_t index = 0; index < frames; ++index) writer.frame(frame_of(scene, index));
  writer.end({});
}

bool completed_frames_are_intact(const fs::path& path, const Scene& scene, std::int64_t& frames) {
  const hdf5::Session session;
  const SeriesReader series(path);
  frames = static_cast<std::int64_t>(series.frames());
  const std::size_t cells = scene.grid.cell_count();
  const std::vector<std::int64_t> steps = hdf5::read_all<std::int64_t>(series.file(), "steps");
  for (const std::string& name : field_names(scene)) {
    // A frame without a time may be cut off anywhere: only what comes before it is read.
    std::vector<double> values(series.frames() * cells);
    const hdf5::Block completed{
        {0, 0, 0},
        {series.frames(), static_cast<hsize_t>(scene.grid.cells[1]), static_cast<hsize_t>(scene.grid.cells[0])}};
    hdf5::read(hdf5::open_dataset(series.file(), name).id(), H5T_NATIVE_DOUBLE, values.data(), completed);
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      const auto index = static_cast<std::size_t>(frame);
      if (series.times()[index] != 0.25 * static_cast<double>(frame) || steps[index] != 100 * frame) return false;
      for (std::size_t cell = 0; cell < cells; ++cell) {
        if (values[index * cells + cell] != field_value(name, frame, cell)) return false;
      }
    }
  }
  return true;
}

int run_in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 99;
    try {
      code = work();
    } catch (...) {
      code = 98;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace sandsim::test
