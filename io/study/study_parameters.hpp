// The table of all parameters of a study, in the form of io/scene/parameters.hpp.
#pragma once

#include <array>
#include <string>

#include "io/scene/map_reader.hpp"
#include "io/scene/rule.hpp"
#include "io/scene/type_name.hpp"
#include "io/study/study.hpp"

namespace sandsim {

template <>
struct EnumNames<Device> {
  static constexpr std::array names{"auto", "cpu", "cuda"};
};
template <>
struct EnumNames<Against> {
  static constexpr std::array names{"exact", "profile", "measured_profile", "measured_front", "fine"};
};
template <>
struct EnumNames<ErrorMeasure> {
  static constexpr std::array names{"l1_relative", "l1", "l2", "linf", "front", "height", "volume"};
};

template <>
struct EnumNames<TimeChoice> {
  static constexpr std::array names{"median", "shortest"};
};

/// Free values: what they mean is for the scene to say.
void parse_member(Reading& reading, const Node& node, const std::string& path, Settings& target);
void parse_member(Reading& reading, const Node& node, const std::string& path, Variations& target);
/// As a map on one line.
std::string value_text(const Settings& settings, const Rule& rule);
std::string value_text(const Variations& variations, const Rule& rule);

template <class V>
void describe(V& v, StudyScene& s) {
  v.field("name", s.name, text(), "Name in tables and plots; without it, that of the file or its folder.");
  v.field("file", s.file, file().required().like("../flume/scene.yaml"), "Scene file, or a folder with a scene.yaml.");
  v.field("set", s.set, section(), "Values that replace those of the scene.");
}

template <class V>
void describe(V& v, StudyMethod& m) {
  v.field("name", m.name, text().required().like("order 1"), "Name in tables and plots.");
  v.field("set", m.set, section().required().like("{numerics.order: 1}"), "Values that replace those of the scene.");
}

template <class V>
void describe(V& v, ErrorChoice& e) {
  v.field("against", e.against, choice(),
          "What errors are taken against; without it, the fine run, or the scene's first reference that applies.");
  v.field("measure", e.measure, choice(),
          "The error of the frontier: of the depth, the front, the height, the volume.");
}

template <class V>
void describe(V& v, FineRun& f) {
  v.field("spacing", f.spacing, length().above(0).without_cells().required().like("1 mm"), "Side of its cells.");
  v.field("set", f.set, section(), "Values that replace those of the scene; without it, balanced, order 2, float64.");
}

template <class V>
void describe(V& v, Ablation& a) {
  v.field("file", a.file, file().required().like("../flume/scene.yaml"), "Scene file, or a folder with a scene.yaml.");
  v.field("set", a.set, section(), "Values that replace those of the scene, in all variants.");
  v.field("base", a.base, text(), "Name of the scene as it is.");
  v.field("variants", a.variants, list().required().not_empty().like("[{name: maxima, set: {output.maxima: true}}]"),
          "What is changed, one thing at a time.");
  v.field("writes", a.writes, choice(), "Write the frames to disk as a run does, rather than drop them.");
}

template <class V>
void describe(V& v, Study& s) {
  v.field("title", s.title, text(), "What the study is, in a few words.");
  v.field("scenes", s.scenes, list().single_allowed().like("[{file: ../flume/scene.yaml}]"),
          "The scenes whose errors are measured.");
  v.field("set", s.set, section(), "Values that replace those of all these scenes.");
  v.field("spacings", s.spacings, length().above(0).without_cells().single_allowed().like("[2 cm, 1 cm, 5 mm]"),
          "Sides of the cells of the same domain; without it, the scene's.");
  v.field("methods", s.methods, list(), "Named sets of values; each is a curve.");
  v.field("vary", s.vary, section(), "Keys with lists of values; every combination is a curve.");
  v.field("devices", s.devices, choice().single_allowed().not_empty(), "What the runs are timed on.");
  v.field("threads", s.threads, number().at_least(1).at_most(4096).single_allowed().not_empty(), "Numbers of threads.");
  v.field("error", s.error, section(), "What the error is.");
  v.field("fine", s.fine, section(), "A fine run that errors are taken against; the study makes and keeps it.");
  v.field("under", s.under, number().above(0).single_allowed(), "Errors for which the cheapest setting is named.");
  v.field("repeats", s.repeats, number().at_least(1).at_most(1000), "Timed runs of each setting.");
  v.field("times", s.times, choice(), "Which repeat stands for all; the shortest where the machine is not idle.");
  v.field("ablation", s.ablation, section(), "A scene and variants of it, whose costs are compared.");
}

}  // namespace sandsim
