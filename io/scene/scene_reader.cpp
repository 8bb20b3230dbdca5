#include "io/scene/scene_reader.hpp"

#include <algorithm>

#include "io/scene/document.hpp"
#include "io/scene/map_reader.hpp"
#include "io/scene/parameters.hpp"
#include "io/scene/yaml_tree.hpp"
#include "solver/checks.hpp"
#include "solver/objects/inspection.hpp"

namespace sandsim {

namespace {

/// The rules across values; those that rest on values already complained about say nothing new.
void report_issues(const Scene& scene, Reading& reading) {
  for (const Issue& issue : check(scene)) {
    const auto failed = [&](const std::string& key) { return reading.failed(key); };
    if (failed(issue.key) || std::any_of(issue.uses.begin(), issue.uses.end(), failed)) continue;
    reading.complain_at(issue.key, {issue.problem, issue.why, issue.suggestion});
  }
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, std::span<const std::string> overrides,
                 std::vector<std::string>* warnings) {
  return read_scene(file, command_line_overrides(overrides), warnings);
}

Scene read_scene(const std::filesystem::path& file, std::span<const Override> overrides,
                 std::vector<std::string>* warnings) {
  return read_scene_text(read_document(file, "scene"), file.string(), file.parent_path(), overrides, warnings);
}

Scene read_scene_text(const std::string& text, const std::string& name, const std::filesystem::path& directory,
                      std::span<const std::string> overrides, std::vector<std::string>* warnings) {
  return read_scene_text(text, name, directory, command_line_overrides(overrides), warnings);
}

Scene read_scene_text(const std::string& text, const std::string& name, const std::filesystem::path& directory,
                      std::span<const Override> overrides, std::vector<std::string>* warnings) {
  std::vector<std::string> places;
  for (const Override& given : overrides) places.push_back(given.place);
  Problems problems(name, std::move(places));
  Node root = parse_yaml(text, problems);
  apply_overrides(root, overrides, problems);
  Reading reading(problems, directory, warnings);
  Scene scene;
  if (root.kind != Node::Kind::map) {
    problems.add(root.position, "", {"a scene is a map of keys, and this is none", "", "Start with \"grid: ...\"."});
  } else {
    MapReader members(reading, root, "");
    describe(members, scene);
    members.finish();
    report_issues(scene, reading);
    if (problems.empty()) {
      for (const Issue& issue : objects::thin_objects(scene)) {
        reading.warn_at(issue.key, {issue.problem, issue.why, issue.suggestion});
      }
    }
  }
  problems.throw_if_any();
  return scene;
}

}  // namespace sandsim
