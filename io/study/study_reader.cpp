#include "io/study/study_reader.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <utility>

#include "io/scene/document.hpp"
#include "io/scene/map_writer.hpp"
#include "io/scene/scene_reader.hpp"
#include "io/scene/yaml_tree.hpp"
#include "io/study/study_parameters.hpp"
#include "solver/checks.hpp"
#include "solver/errors.hpp"

namespace sandsim {

namespace {

namespace fs = std::filesystem;

/// The scene file that a study names.
fs::path located(const fs::path& folder, const std::string& name) {
  std::error_code ignored;  // whoever opens the file reports what is wrong with it
  const fs::path file = folder / name;
  return fs::is_directory(file, ignored) ? file / "scene.yaml" : file;
}

/// "flume" for flume/scene.yaml, "scene_truncated" for flume/scene_truncated.yaml.
std::string name_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem == "scene" ? fs::absolute(file).parent_path().filename().string() : stem;
}

bool is_named(const Reference& reference, Against against) {
  const auto holds = [](const auto& curve, const auto& values) { return curve && !((*curve).*values).empty(); };
  switch (against) {
    case Against::exact:
      return reference.exact.has_value();
    case Against::profile:
      return reference.profile.has_value();
    case Against::measured_profile:
      return holds(reference.measured_profile, &Profile::x);
    case Against::measured_front:
      return holds(reference.measured_front, &FrontCurve::time);
    case Against::fine:
      break;
  }
  return false;
}

/// One frame, at the end, of the depth alone: frames cut steps.
void keep_last_depth(Scene& scene) {
  scene.time.frame_interval = scene.time.end;
  scene.output = Output{};
  scene.output.fields = {OutputField::depth};
}

/// Reads one study: its own values first, then the scenes that follow from them.
class StudyReader {
 public:
  StudyReader(const fs::path& file, const std::string& text)
      : file_(file.string()),
        folder_(file.parent_path()),
        problems_(file_),
        root_(parse_yaml(text, problems_)),
        reading_(problems_, folder_, nullptr) {}

  StudyPlan read(const std::function<void(Study&)>& change);

 private:
  using Overrides = std::vector<Override>;

  void read_values();
  void check_values();
  void check_references(std::size_t k, const Scene& scene);
  bool check_fixed_step(const Scene& scene);
  void expand_scene(std::size_t k);
  void expand_curve(std::size_t k, const Scene& base, const StudyCase& curve, const Overrides& overrides);
  void expand_ablation();
  void name_scenes();

  std::string place(const Node& node) const;
  void append(Overrides& overrides, const Settings& settings) const;
  Override override_of(const std::string& key, const Node& value) const;
  bool append_grid(Overrides& overrides, const Grid& domain, double spacing, const std::string& path);
  std::optional<Scene> load(const fs::path& scene, const Overrides& overrides, const std::string& context);
  std::vector<std::pair<StudyCase, Overrides>> curves(const Overrides& common) const;

  std::string file_;
  fs::path folder_;
  Problems problems_;
  Node root_;
  Reading reading_;
  StudyPlan plan_;
  std::set<std::string> complaints_;  // lines about the scenes, each once
  std::string messages_;              // the same, with the first setting that each was met in
  bool only_files_missing_ = true;
};

// ---- the study's own values -----------------------------------------------------------------------------------------
void StudyReader::read_values() {
  if (root_.kind != Node::Kind::map) {
    problems_.add(root_.position, "",
                  {"a study is a map of keys, and this is none", "", "Start with \"scenes: ...\"."});
  } else if (root_.find("grid") != nullptr && root_.find("sand") != nullptr) {
    problems_.add(root_.position, "",
                  {"this is a scene, not a study", "a study names a scene and what is varied in it",
                   "Write a study with \"scenes: {file: " + fs::path(file_).filename().string() +
                       "}\" and \"spacings: [...]\"."});
  } else {
    MapReader members(reading_, root_, "");
    describe(members, plan_.study);
    members.finish();
    check_values();
  }
  problems_.throw_if_any();
}

void StudyReader::check_values() {
  Study& study = plan_.study;
  if (study.scenes.empty() && !study.ablation) {
    reading_.complain_key(
        {1, 1, -1}, "scenes",
        {"missing", "there is nothing to measure", "Add \"scenes: [{file: scene.yaml}]\", or an ablation."});
  }
  if (study.error.against == Against::fine && !study.fine) {
    reading_.complain_at("error.against", {"there is no fine run", "", "Add \"fine: {spacing: 1 mm}\"."});
  }
  if (study.fine && study.error.against.value_or(Against::fine) != Against::fine) {
    reading_.complain_at("error.against", {"not used", "the study has a fine run", "Remove it, or the fine run."});
  }
  std::set<std::string> names;
  for (std::size_t k = 0; k < study.methods.size(); ++k) {
    if (names.insert(study.methods[k].name).second) continue;
    reading_.complain_at("methods." + std::to_string(k) + ".name",
                         {"given twice", "", "Name each method differently."});
  }
  std::set<double> seen;
  for (const double spacing : study.spacings) {
    if (!seen.insert(spacing).second) reading_.complain_at("spacings", {"a value is given twice", "", ""});
    if (study.fine && spacing <= study.fine->spacing) {
      reading_.complain_at("fine.spacing", {"not finer than all spacings",
                                            "one of them is " + shortest_text(spacing) + " m", "Make it smaller."});
    }
  }
}

void StudyReader::name_scenes() {
  std::set<std::string> names;
  for (std::size_t k = 0; k < plan_.study.scenes.size(); ++k) {
    StudyScene& scene = plan_.study.scenes[k];
    const fs::path file = located(folder_, scene.file);
    if (scene.name.empty()) scene.name = name_of(file);
    if (!names.insert(scene.name).second) {
      reading_.complain_at("scenes." + std::to_string(k),
                           {"a second scene named '" + scene.name + "'", "", "Give it another name."});
    }
    scene.file = file.string();
  }
}

// ---- scenes ---------------------------------------------------------------------------------------------------------
std::string StudyReader::place(const Node& node) const {
  return file_ + ':' + std::to_string(node.position.line) + ':' + std::to_string(node.position.column);
}

Override StudyReader::override_of(const std::string& key, const Node& value) const {
  return {key + '=' + (value.kind == Node::Kind::null ? "" : flow_text(value)), place(value)};
}

void StudyReader::append(Overrides& overrides, const Settings& settings) const {
  for (const Node& entry : settings.entries) overrides.push_back(override_of(entry.key, entry));
}

/// Cells of another size on the same domain. Complains at `path` of the study if they do not fill it.
bool StudyReader::append_grid(Overrides& overrides, const Grid& domain, double spacing, const std::string& path) {
  std::array<std::string, 2> cells{"1", "1"};
  for (std::size_t axis = 0; axis < (domain.one_dimensional() ? 1u : 2u); ++axis) {
    const double length = domain.cells[axis] * domain.spacing, count = length / spacing, whole = std::round(count);
    // Spacings and lengths are decimal fractions: their quotient is whole up to rounding, or not at all.
    if (whole < 1.0 || whole > 1e9 || std::abs(count - whole) > 1e-6 * whole) {
      reading_.complain_at(path, {shortest_text(spacing) + " m does not divide the domain",
                                  "it is " + shortest_text(length) + " m long in " + (axis == 0 ? "x" : "y"), ""});
      return false;
    }
    cells[axis] = std::to_string(static_cast<long>(whole));
  }
  const Node* written = root_.find(path.substr(0, path.find('.')));
  const std::string where = written == nullptr ? file_ : place(*written);
  overrides.push_back({"grid.spacing=" + quantity_text(spacing, Dimension::length), where});
  overrides.push_back({"grid.cells=[" + cells[0] + ", " + cells[1] + "]", where});
  return true;
}

/// Nothing if the scene has problems, which are kept.
std::optional<Scene> StudyReader::load(const fs::path& scene, const Overrides& overrides, const std::string& context) {
  const auto keep = [&](const Error& error) {
    // The same value is wrong in every combination that it is part of; the first one is enough to find it.
    std::string news;
    std::istringstream lines(error.what());
    for (std::string line; std::getline(lines, line);) {
      if (complaints_.insert(line).second) news += line + '\n';
    }
    if (news.empty()) return;
    messages_ += news + (context.empty() ? "" : "  with " + context + " of " + file_ + '\n');
  };
  try {
    return read_scene(scene, std::span<const Override>(overrides));
  } catch (const InputError& error) {
    keep(error);
  } catch (const SceneError& error) {
    only_files_missing_ = false;
    keep(error);
  }
  return std::nullopt;
}

void StudyReader::check_references(std::size_t k, const Scene& scene) {
  if (plan_.study.fine) return;
  const std::string path = "scenes." + std::to_string(k);
  const std::optional<Against> against = plan_.study.error.against;
  const auto named = [&](Against one) { return scene.reference && is_named(*scene.reference, one); };
  const std::string name = "'" + plan_.study.scenes[k].name + "'";
  if (against && !named(*against)) {
    reading_.complain_at("error.against", {"the scene " + name + " has none", "or its file is not there yet",
                                           std::string("Add reference.") + enum_name(*against) + " to the scene."});
  } else if (!named(Against::exact) && !named(Against::profile) && !named(Against::measured_profile) &&
             !named(Against::measured_front)) {
    reading_.complain_at(path, {"the scene " + name + " has no reference to take errors against", "",
                                "Add one to the scene, or \"fine: {spacing: 1 mm}\" to the study."});
  }
}

// ---- expansion ------------------------------------------------------------------------------------------------------
/// Every combination of a method and of the values of `vary`, without a spacing.
std::vector<std::pair<StudyCase, StudyReader::Overrides>> StudyReader::curves(const Overrides& common) const {
  std::vector<std::pair<StudyCase, Overrides>> all{{StudyCase{}, common}};
  if (!plan_.study.methods.empty()) {
    all.clear();
    for (const StudyMethod& method : plan_.study.methods) {
      all.emplace_back(StudyCase{}, common);
      all.back().first.method = method.name;
      append(all.back().second, method.set);
    }
  }
  for (const Node& axis : plan_.study.vary.axes) {
    std::vector<std::pair<StudyCase, Overrides>> longer;
    for (const auto& [curve, overrides] : all) {
      for (const Node& value : axis.children) {
        longer.emplace_back(curve, overrides);
        longer.back().first.picks.push_back(flow_text(value));
        longer.back().second.push_back(override_of(axis.key, value));
      }
    }
    all = std::move(longer);
  }
  return all;
}

void StudyReader::expand_curve(std::size_t k, const Scene& base, const StudyCase& curve, const Overrides& overrides) {
  const Study& study = plan_.study;
  std::vector<double> spacings = study.spacings;
  if (spacings.empty()) spacings.push_back(base.grid.spacing);
  for (const Device device : study.devices) {
    for (const int threads : study.threads) {
      for (const double spacing : spacings) {
        Overrides all = overrides;
        if (!study.spacings.empty() && !append_grid(all, base.grid, spacing, "spacings")) continue;
        std::string context = "spacing " + shortest_text(spacing) + " m";
        for (const std::string& pick : curve.picks) context = pick + ", " + context;
        if (!curve.method.empty()) context = "'" + curve.method + "', " + context;
        std::optional<Scene> scene = load(study.scenes[k].file, all, context);
        if (!scene) continue;
        if (scene->time.mode == TimeMode::fixed) scene->time.step *= spacing / spacings.front();
        keep_last_depth(*scene);
        if (!check_fixed_step(*scene)) continue;
        StudyCase point = curve;
        point.scene = k, point.device = device, point.threads = threads, point.setup = std::move(*scene);
        plan_.cases.push_back(std::move(point));
      }
    }
  }
}

/// A step that has been scaled with the spacing still has to fit the scene.
bool StudyReader::check_fixed_step(const Scene& scene) {
  if (scene.time.mode != TimeMode::fixed) return true;
  const std::vector<Issue> issues = check(scene);
  if (issues.empty()) return true;
  reading_.complain_at("spacings", {"a fixed step of " + shortest_text(scene.time.step) + " s does not fit the scene",
                                    issues.front().problem + ", " + issues.front().why,
                                    "The step of the first spacing falls with the spacing."});
  return false;
}

void StudyReader::expand_scene(std::size_t k) {
  const Study& study = plan_.study;
  Overrides common;
  append(common, study.set);
  append(common, study.scenes[k].set);
  const std::optional<Scene> base = load(study.scenes[k].file, common, "");
  if (!base) return;
  check_references(k, *base);
  for (const auto& [curve, overrides] : curves(common)) expand_curve(k, *base, curve, overrides);
  if (!study.fine) return;
  if (study.spacings.empty() && base->grid.spacing <= study.fine->spacing) {
    reading_.complain_at("fine.spacing", {"not finer than the scene",
                                          "that has " + shortest_text(base->grid.spacing) + " m", "Make it smaller."});
  }
  Overrides fine = common;
  fine.push_back({"numerics={scheme: balanced, order: 2, precision: float64}", file_});
  append(fine, study.fine->set);
  if (!append_grid(fine, base->grid, study.fine->spacing, "fine.spacing")) return;
  std::optional<Scene> scene = load(study.scenes[k].file, fine, "the fine run");
  if (!scene) return;
  keep_last_depth(*scene);
  plan_.fine.push_back({study.scenes[k].name, std::move(*scene), fs::path(study.scenes[k].file).parent_path()});
}

void StudyReader::expand_ablation() {
  Ablation& ablation = *plan_.study.ablation;
  const fs::path file = located(folder_, ablation.file);
  ablation.file = file.string();
  Overrides common;
  append(common, ablation.set);
  std::vector<StudyMethod> variants{{ablation.base, {}}};
  variants.insert(variants.end(), ablation.variants.begin(), ablation.variants.end());
  for (const StudyMethod& variant : variants) {
    Overrides overrides = common;
    append(overrides, variant.set);
    std::optional<Scene> scene = load(file, overrides, "'" + variant.name + "'");
    if (scene) plan_.variants.push_back({variant.name, std::move(*scene), file.parent_path()});
  }
}

StudyPlan StudyReader::read(const std::function<void(Study&)>& change) {
  read_values();
  if (change) change(plan_.study);
  name_scenes();
  for (std::size_t k = 0; k < plan_.study.scenes.size(); ++k) expand_scene(k);
  if (plan_.study.ablation) expand_ablation();
  problems_.throw_if_any();
  if (!messages_.empty() && only_files_missing_) throw InputError(messages_);
  if (!messages_.empty()) throw SceneError(messages_);
  return std::move(plan_);
}

}  // namespace

StudyPlan read_study(const std::filesystem::path& file, const std::function<void(Study&)>& change) {
  const std::string text = read_document(file, "study");
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw SceneError(file.string() + ": the study is empty (it holds no key). Start with \"scenes: ...\".");
  }
  return StudyReader(file, text).read(change);
}

std::string resolved_study(const Study& study) {
  Study copy = study;  // the table is walked through with members that may be written to
  for (StudyScene& scene : copy.scenes) scene.file = fs::absolute(scene.file).lexically_normal().string();
  if (copy.ablation) copy.ablation->file = fs::absolute(copy.ablation->file).lexically_normal().string();
  const fs::path nowhere;  // all files are absolute
  MapWriter writer("", nowhere);
  describe(writer, copy);
  return writer.lines();
}

}  // namespace sandsim
