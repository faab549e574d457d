// The marks of a reader's solver. It is compiled together with that file, and knows the standard library
// only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace grading {

/// A wrong number that gives away how it came about.
struct Mistake {
  double value = 0;
  const char* what = "";  // nothing where another mark has the words
};

struct Expected {
  std::string what = {};
  double value = 0;
  std::vector<Mistake> mistakes = {};
  double tolerance = 1e-9;  // of the number and of every mistake: relative where the number is above 1
};

class Report {
 public:
  /// Stages before `asked` are printed only where they fail.
  explicit Report(int asked) : asked_(asked) {}

  void begin(int stage) { stage_ = stage; }

  void number(double got, const Expected& expected) {
    const bool holds = is_near(got, expected.value, expected.tolerance);
    if (!holds) passed_ = false;
    if (holds && stage_ < asked_) return;
    std::string numbers = text(got);
    if (!holds) numbers += ", not " + text(expected.value);
    const std::string what =
        (stage_ < asked_ ? "stage 0" + std::to_string(stage_) + ": " : "") + expected.what;
    std::printf("CHECK  %s %s  %s\n", padded(what).c_str(), numbers.c_str(), holds ? "ok" : "no");
    if (!holds) comment(got, expected);
    std::fflush(stdout);  // the next number may end the program
  }

  bool passed() const { return passed_; }

 private:
  static bool is_near(double got, double value, double tolerance) {
    if (!std::isfinite(value)) return got == value;
    return std::abs(got - value) <= tolerance * std::max(1.0, std::abs(value));
  }

  static std::string text(double number) {
    char digits[32] = "";
    std::snprintf(digits, sizeof digits, "%.7g", number);
    return digits;
  }

  /// Spaces up to a column: bytes that continue a letter of UTF-8 take no room.
  static std::string padded(std::string words) {
    const auto letters = std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; });
    words.append(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, 70 - letters)), ' ');
    return words;
  }

  static void comment(double got, const Expected& expected) {
    for (const Mistake& mistake : expected.mistakes) {
      if (!is_near(got, mistake.value, expected.tolerance) || *mistake.what == 0) continue;
      std::printf("       %s\n", mistake.what);
      return;
    }
  }

  int asked_ = 0;
  int stage_ = asked_;
  bool passed_ = true;
};

}  // namespace grading
