#include "io/scene/problems.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "solver/errors.hpp"

namespace sandsim {

Problems::Problems(std::string name, std::vector<std::string> override_places)
    : name_(std::move(name)), override_places_(std::move(override_places)) {}

std::string Problems::place(const Position& position) const {
  if (position.override_at >= 0) return override_places_[static_cast<std::size_t>(position.override_at)];
  if (position.line <= 0) return name_;
  return name_ + ':' + std::to_string(position.line) + ':' + std::to_string(position.column);
}

std::string Problems::format(const Position& position, std::string_view subject, const Complaint& complaint) const {
  std::string text = place(position) + ": ";
  if (!subject.empty()) text += std::string(subject) + ": ";
  text += complaint.problem;
  if (!complaint.why.empty()) text += " (" + complaint.why + ')';
  text += '.';
  if (!complaint.suggestion.empty()) text += ' ' + complaint.suggestion;
  return text;
}

void Problems::add(const Position& position, std::string_view subject, const Complaint& complaint) {
  add(position, subject, complaint, false);
}

void Problems::add_input(const Position& position, std::string_view subject, const Complaint& complaint) {
  add(position, subject, complaint, true);
}

void Problems::add(const Position& position, std::string_view subject, const Complaint& complaint, bool input) {
  messages_.push_back({position, format(position, subject, complaint), input});
}

void Problems::throw_if_any() {
  if (messages_.empty()) return;
  std::stable_sort(messages_.begin(), messages_.end(), [](const Message& a, const Message& b) {
    return std::tuple(a.position.override_at, a.position.line, a.position.column) <
           std::tuple(b.position.override_at, b.position.line, b.position.column);
  });
  // An alias repeats its problems at the same place; once is enough, and nobody reads more than a screenful.
  constexpr std::size_t most = 100;
  std::vector<std::string> lines;
  for (const Message& message : messages_) {
    if (lines.empty() || lines.back() != message.text) lines.push_back(message.text);
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(most, lines.size()); ++k) text += (k > 0 ? "\n" : "") + lines[k];
  if (lines.size() > most) text += "\n... and " + std::to_string(lines.size() - most) + " more problems.";
  if (std::all_of(messages_.begin(), messages_.end(), [](const Message& m) { return m.input; })) {
    throw InputError(text);
  }
  throw SceneError(text);
}

namespace {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.empty() || word.size() > 64) return {};
  std::string best;
  std::size_t best_distance = word.size();
  for (const std::string& candidate : candidates) {
    const bool beginning = word.size() >= 3 && (candidate.starts_with(word) || word.starts_with(candidate));
    const std::size_t distance = beginning ? 1 : edit_distance(word, candidate);
    if (distance < best_distance && distance <= std::max<std::size_t>(1, candidate.size() / 3)) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

namespace {

std::string join(const std::vector<std::string>& words, const char* last_separator) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) text += k + 1 == words.size() ? last_separator : ", ";
    text += words[k];
  }
  return text;
}

}  // namespace

std::string alternatives(const std::vector<std::string>& words) {
  return join(words, " or ");
}

std::string together(const std::vector<std::string>& words) {
  return join(words, " and ");
}

std::string listed(const std::vector<std::string>& words) {
  return join(words, ", ");
}

}  // namespace sandsim
