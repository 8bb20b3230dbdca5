// The state of reading one scene, and the reading of single values.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/gis/gis.hpp"
#include "io/scene/node.hpp"
#include "io/scene/problems.hpp"
#include "io/scene/rule.hpp"
#include "solver/scene.hpp"

namespace sandsim {

class Reading {
 public:
  Reading(Problems& problems, std::filesystem::path directory, std::vector<std::string>* warnings);

  // Each reads one value, or complains and leaves the target as it was.
  void parse(const Node& node, const std::string& path, double& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, int& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, bool& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, std::string& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, ScalarMap& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, RasterFile& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, Crs& target, const Rule& rule);
  /// The layer and the attribute of the target are known.
  void parse(const Node& node, const std::string& path, PolygonFile& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, Profile& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, FrontCurve& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, MeshFile& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, SdfFile& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, PathTable& target, const Rule& rule);
  void parse(const Node& node, const std::string& path, ScriptFile& target, const Rule& rule);
  /// The index of the word in `names`; complains and returns npos if it is none of them.
  std::size_t parse_name(const Node& node, const std::string& path, const std::vector<std::string>& names);
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  /// Complains and returns false if the node is of another kind; `like` is an example of what is needed.
  bool expect(const Node& node, const std::string& path, Node::Kind kind, const std::string& like);

  void complain(const Node& node, const std::string& path, const Complaint& complaint);
  /// Without a value in the message, e.g. for keys that are missing or unknown.
  void complain_key(const Position& position, const std::string& path, const Complaint& complaint);
  /// A value was given here; later complaints about its path find it.
  void note(const std::string& path, const Node& node) { given_.try_emplace(path, &node); }
  /// "scene.yaml:7:30"
  std::string place_of(const Node& node) const { return problems_.place(node.position); }
  /// The list at `path` was written as its only entry.
  void note_single(const std::string& path) { singles_.insert(path); }

  /// The grid is read: lengths may be in its cells, and rasters in its CRS.
  void know_grid(const Grid& grid);

  /// The value at `path`, one inside it, or one that it lies in has been complained about.
  bool failed(const std::string& path) const;
  /// Reports a problem of the scene as a whole at the place of its key, or of the nearest map around it.
  void complain_at(const std::string& path, const Complaint& complaint);
  /// A warning there.
  void warn_at(const std::string& path, const Complaint& complaint);

 private:
  void warn(const Node& node, const std::string& path, const Complaint& complaint);
  void complain_input(const Node& node, const std::string& path, const Complaint& complaint);
  bool expect_file_name(const Node& node, const std::string& path, const Rule& rule);
  /// What to do about a missing file, if the scene says so.
  std::string way_to_make_files() const;
  /// The file's full name if it is there and a file; else complains (or warns) and returns an empty path.
  std::filesystem::path find_file(const Node& node, const std::string& path, const Rule& rule);
  /// The raster as it is on file. That of a grid is kept for the terrain, which mostly is the same.
  Raster as_on_file(const std::filesystem::path& file, const RasterRequest& request);
  /// Loads the raster of `node` into `target`, whose first_row says how the file lies; values are in the display unit
  /// of the rule's dimension, and are checked.
  void load(const Node& node, const std::string& path, RasterFile& target, const Rule& rule);
  void check_crs(const Node& node, const std::string& path, const Raster& raster);
  void parse_zones(const Node& node, const std::string& path, ScalarMap& target, const Rule& rule);
  template <class Table, class Read>
  void parse_table(const Node& node, const std::string& path, Table& target, const Rule& rule, Read read);
  /// Reads a mesh, puts right what can be, and says so.
  void read_mesh_file(const std::filesystem::path& full, const Node& node, const std::string& path,
                      objects::TriangleMesh& mesh);
  /// Distances that are negative all round their border are turned, or complained about.
  void check_sign(objects::DistanceGrid& grid, const Node& node, const std::string& path);
  /// Where a path was given: its value, or the nearest map around it.
  Position place_of(const std::string& path) const;
  std::string as_written(std::string path) const;

  Problems& problems_;
  std::filesystem::path directory_;
  std::vector<std::string>* warnings_;
  double cell_ = 1.0;  // [m] the grid's spacing; 1 m until it is known
  Crs crs_;            // of the grid
  bool grid_known_ = false;
  using RasterKey = std::tuple<std::filesystem::path, int, std::string>;  // file, band, variable
  std::optional<std::pair<RasterKey, Raster>> like_;  // the raster of the grid, until it is asked for
  std::filesystem::path made_by_;                     // the script that writes the scene's files; empty: none is named
  std::map<std::string, const Node*> given_;
  std::set<std::string> singles_;
  std::set<std::string> failed_;
};

}  // namespace sandsim
