// The problems of a scene, collected while it is read and reported all at once.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/scene/node.hpp"

namespace sandsim {

/// What is wrong with a value, why, and what to write instead. `why` and `suggestion` may be empty.
struct Complaint {
  std::string problem;
  std::string why;
  std::string suggestion;
};

/// Collects messages of the form `file:line:col: key = value: problem (why). Suggestion`.
class Problems {
 public:
  /// `name` is the file's name in messages; `override_places` say where each override was written.
  explicit Problems(std::string name, std::vector<std::string> override_places = {});

  /// `subject` is "key = value", "key", or empty.
  void add(const Position& position, std::string_view subject, const Complaint& complaint);
  /// A file that the scene refers to and that cannot be read.
  void add_input(const Position& position, std::string_view subject, const Complaint& complaint);
  std::string format(const Position& position, std::string_view subject, const Complaint& complaint) const;
  /// "scene.yaml:7:30", or where the override was written.
  std::string place(const Position& position) const;

  bool empty() const { return messages_.empty(); }
  /// Throws SceneError if there is a problem of the scene, InputError if only files are missing; else returns.
  void throw_if_any();

 private:
  struct Message {
    Position position;
    std::string text;
    bool input;
  };
  void add(const Position& position, std::string_view subject, const Complaint& complaint, bool input);

  std::string name_;
  std::vector<std::string> override_places_;
  std::vector<Message> messages_;
};

/// The candidate nearest to `word`, or empty if none is near enough to be meant.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b or c".
std::string alternatives(const std::vector<std::string>& words);

/// "a, b and c".
std::string together(const std::vector<std::string>& words);

/// "a, b, c".
std::string listed(const std::vector<std::string>& words);

}  // namespace sandsim
