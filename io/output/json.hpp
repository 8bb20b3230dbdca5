// A small JSON writer.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sandsim {

/// The JSON text of a string, quotes included. Bytes that are not valid UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// Shortest decimal form that reads back as the same number; null where JSON has no word for it (NaN, infinity).
std::string json_number(double value);

/// Builds one JSON document, indented by two spaces. Members keep the order in which they are added.
class JsonWriter {
 public:
  JsonWriter& begin_object();
  JsonWriter& begin_object(std::string_view key) { return name(key).begin_object(); }
  JsonWriter& end_object();
  JsonWriter& begin_array();
  JsonWriter& begin_array(std::string_view key) { return name(key).begin_array(); }
  JsonWriter& end_array();

  JsonWriter& value(std::string_view text) { return raw(json_string(text)); }
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
  JsonWriter& value(double number) { return raw(json_number(number)); }
  JsonWriter& value(bool truth) { return raw(truth ? "true" : "false"); }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) JsonWriter& value(Integer number) { return raw(std::to_string(number)); }
  JsonWriter& null() { return raw("null"); }

  template <class Value>
  JsonWriter& member(std::string_view key, const Value& content) {
    return name(key).value(content);
  }

  /// The name of the member whose value is added next.
  JsonWriter& name(std::string_view key);

  /// The document, with a line break at its end. All objects and arrays must be closed.
  std::string text() const;

 private:
  JsonWriter& raw(std::string_view content);
  JsonWriter& close(char bracket);
  void start_item();

  std::string text_;
  std::vector<bool> has_items_;  // one entry an open object or array
  bool after_name_ = false;
};

}  // namespace sandsim
