// Stands in for Catch2 where it is not installed, for scripts/gpu_check: the few words that the tests of the tiles and
// of the device use, as macros because Catch2's are. A failed check is printed with its place; a test that fails or
// throws makes the program exit with 1.
#pragma once

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace Catch {
namespace Matchers {
struct WithinAbs;
struct WithinRel;
}  // namespace Matchers

struct PlainTest {
  const char* name;
  void (*run)();
};
inline std::vector<PlainTest>& plain_tests() {
  static std::vector<PlainTest> tests;
  return tests;
}
inline int plain_failures = 0;
struct PlainEntry {
  PlainEntry(const char* name, void (*run)()) { plain_tests().push_back({name, run}); }
};
struct PlainAbort {};  // a failed REQUIRE ends its test

inline bool plain_check(bool holds, const char* text, const char* file, int line) {
  if (!holds) {
    plain_failures += 1;
    std::printf("%s:%d: failed: %s\n", file, line, text);
  }
  return holds;
}

template <class... Values>
void plain_ignore(const Values&...) {}

/// Runs the tests that are named, or all.
class Session {
 public:
  int run(int count, char** words) {
    for (const PlainTest& test : plain_tests()) {
      bool wanted = count < 2;
      for (int k = 1; k < count; ++k) {
        wanted = wanted || std::string(words[k]) == test.name;
      }
      if (wanted) {
        run_one(test);
      }
    }
    std::printf("%s\n", plain_failures == 0 ? "All tests passed" : "Some tests failed");
    return plain_failures == 0 ? 0 : 1;
  }

 private:
  static void run_one(const PlainTest& test) {
    const int before = plain_failures;
    try {
      test.run();
    } catch (const PlainAbort&) {
    } catch (const std::exception& error) {
      plain_check(false, error.what(), test.name, 0);
    }
    std::printf("%s: %s\n", plain_failures == before ? "passed" : "FAILED", test.name);
  }
};
}  // namespace Catch

#define PLAIN_JOIN_(a, b) a##b
#define PLAIN_JOIN(a, b) PLAIN_JOIN_(a, b)
#define PLAIN_TEST(function, name)                                             \
  static void function();                                                      \
  static const Catch::PlainEntry PLAIN_JOIN(function, _entry)(name, function); \
  static void function()
#define TEST_CASE(name, ...) PLAIN_TEST(PLAIN_JOIN(plain_test_, __LINE__), name)
#define CHECK(...) \
  static_cast<void>(Catch::plain_check(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__))
#define CHECK_FALSE(...) CHECK(!(__VA_ARGS__))
#define REQUIRE(...)                                                                             \
  do {                                                                                           \
    if (!Catch::plain_check(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)) { \
      throw Catch::PlainAbort{};                                                                 \
    }                                                                                            \
  } while (false)
#define CHECK_THROWS_AS(expression, type)                  \
  do {                                                     \
    bool thrown = false;                                   \
    try {                                                  \
      static_cast<void>(expression);                       \
    } catch (const type&) {                                \
      thrown = true;                                       \
    }                                                      \
    CHECK(thrown && "throws " #type " from " #expression); \
  } while (false)
#define CAPTURE(...) Catch::plain_ignore(__VA_ARGS__)
#define INFO(...) static_cast<void>(0)
#define WARN(text) std::printf("%s\n", std::string(text).c_str())
