#include "io/raster/read_raster.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/raster/read_csv.hpp"
#include "tests/raster/errors.hpp"
#include "tests/support/catch.hpp"

namespace sandsim {
namespace {

/// A folder of its own that goes with the test.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("sandsim_raster_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

const std::string grid = "ncols 2 nrows 1 xllcorner 0 yllcorner 0 cellsize 1 3 4";

std::string error(const std::filesystem::path& path) {
  return test::input_error([&] { read_raster(path); });
}

TEST_CASE("the content chooses the format whatever the file is called") {
  const Folder folder;
  const std::string dictionary = "{'descr': '|u1', 'fortran_order': False, 'shape': (2,)}";
  const std::string array =
      std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(dictionary.size()) + '\0' + dictionary + "\x03\x04";

  for (const auto& path : {folder.write("a.asc", grid), folder.write("a.TXT", grid), folder.write("a.grd", grid),
                           folder.write("a", grid), folder.write("b.npy", array), folder.write("b.dat", array)}) {
    CHECK(read_raster(path).values == std::vector<double>{3, 4});
  }
}

TEST_CASE("what is neither an ESRI ASCII grid nor .npy goes to GDAL, which does not know it either or is not there") {
  const Folder folder;
  const std::string path = folder.write("dem.xyz", "1 2 3\n").string();
  const std::string message = error(path);
  INFO(message);
  CHECK(message.starts_with(path + ": "));
  CHECK(message.find("GDAL") != std::string::npos);
}

TEST_CASE("a name that promises a format brings the error of its reader") {
  const Folder folder;
  const std::string text = folder.write("a.txt", "north: 20\n").string(), array = folder.write("a.npy", grid).string();
  CHECK(error(text).starts_with(text + ":1:1: \"north\" is no key of an ESRI ASCII header."));
  CHECK(error(array).starts_with(array + ": not a .npy file"));
}

TEST_CASE("a file that is missing or a folder or not readable is an error") {
  const Folder folder;
  const std::string missing = (folder.path() / "b.asc").string();
  CHECK(error(missing) == missing + ": cannot be opened (no such file)");

  const std::string directory = (folder.path() / "c.asc").string();
  std::filesystem::create_directory(directory);
  CHECK(error(directory) == directory + ": cannot be read (not a regular file)");

  const std::string secret = folder.write("d.asc", grid).string();
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  const bool may_read_all = geteuid() == 0;  // permissions do not hold for root
  CHECK(error(secret) == (may_read_all ? "no error" : secret + ": cannot be opened (permission denied?)"));
}

TEST_CASE("a file that is too large is refused before it is read") {
  const Folder folder;
  const std::string path = folder.write("e.asc", grid).string();
  std::filesystem::resize_file(path, (std::uintmax_t{1} << 33) + 1);  // sparse: takes no space
  CHECK(error(path) == path + ": the file is too large (8589934593 bytes; at most 8589934592 are read)");
}

TEST_CASE("errors of a file begin with its path") {
  const Folder folder;
  const std::string path = folder.write("f.asc", "ncols 2 nrows x").string();
  CHECK(error(path).starts_with(path + ":1:"));
}

TEST_CASE("curves are read from files") {
  const Folder folder;
  const auto profile = folder.write("g.csv", "x_m,depth_m\n0,1\n1,2\n");
  const auto front = folder.write("h.csv", "time_s,front_m\n0,1\n1,2\n");

  CHECK(read_profile_csv(profile).depth == std::vector<double>{1, 2});
  CHECK(read_profile_csv(profile).file == profile.string());
  CHECK(read_front_csv(front).front == std::vector<double>{1, 2});
  CHECK(read_front_csv(front).file == front.string());
}

}  // namespace
}  // namespace sandsim
