// Grades numbers, and names the mistake behind a wrong one. It is compiled together with a reader's code: the
// exercises of the lessons, and the reader's own solver, which knows the standard library only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cairn {

/// A wrong number that gives away how it came about. Without words where another mark has them: what follows
/// from one mistake is no second one.
struct Misconception {
  double value = 0;       // that an answer gives which rests on it; may be infinite or NaN
  const char* what = "";  // "That is the force: an impulse is the force times dt."
};

/// One number that an answer has to give.
struct ExpectedNumber {
  std::string what = {};  // "impulse under the corner (N s)"
  double value = 0;
  std::vector<Misconception> misconceptions = {};
  /// Of the number and of every misconception, in its unit. Without one: 1e-9, relative where they are
  /// above 1.
  std::optional<double> tolerance = {};
};

/// What came of a number.
struct Mark {
  bool holds = false;
  std::string comment = {};  // names the misconception, if the number gives one away
};

/// A NaN holds nothing, and is a misconception where one is NaN.
inline Mark marked(const ExpectedNumber& expected, double got) {
  const auto is_near = [&expected, got](double value) {
    const double tolerance = expected.tolerance.value_or(1e-9 * std::max(1.0, std::abs(value)));
    // Infinity less infinity is no number.
    return got == value || (std::isfinite(value) && std::abs(got - value) <= tolerance);
  };
  if (is_near(expected.value)) return {.holds = true};
  for (const Misconception& known : expected.misconceptions) {
    const bool is_it = is_near(known.value) || (std::isnan(got) && std::isnan(known.value));
    if (is_it && *known.what != 0) return {.comment = known.what};
  }
  return {};
}

/// The marks of an answer, printed as they come.
class Grade {
 public:
  /// How marks are printed. Stages before the one that is asked for are printed only where they fail.
  struct Style {
    int width = 58;  // of what is asked, in columns
    int digits = 6;
    int stage = 0;
    /// What fails after the first failure is left out, but for the first comment if that had none.
    bool only_first = false;
  };
  Grade() = default;
  /// Begins with the stage that is asked for.
  explicit Grade(const Style& style) : style_(style), stage_(style.stage) {}

  /// What follows belongs to this stage.
  void begin(int stage) { stage_ = stage; }

  /// Prints the mark of a number, and the comment on a wrong one.
  void number(const ExpectedNumber& expected, double got) {
    const Mark mark = marked(expected, got);
    has_marks_ = true;
    const bool is_before = stage_ < style_.stage;
    const bool is_left_out = style_.only_first && has_failed_ && (is_explained_ || mark.comment.empty());
    if (!mark.holds) has_failed_ = true;
    if (is_left_out || (mark.holds && is_before)) return;
    const std::string what = (is_before ? "stage 0" + std::to_string(stage_) + ": " : "") + expected.what;
    const std::string numbers = text(got) + (mark.holds ? "" : ", not " + text(expected.value));
    std::printf("CHECK  %s %s  %s\n", padded(what).c_str(), numbers.c_str(), mark.holds ? "ok" : "no");
    std::fflush(stdout);  // the next number may end the program
    explain(mark.comment);
  }

  /// Says what a failure looks like, if no comment on a number has said it yet.
  void explain(const std::string& words) {
    if (words.empty() || !has_failed_ || (style_.only_first && is_explained_)) return;
    is_explained_ = true;
    std::printf("       %s\n", words.c_str());
    std::fflush(stdout);
  }

  /// Whether there are marks, and all of them hold.
  bool passed() const { return has_marks_ && !has_failed_; }

 private:
  std::string text(double number) const {
    char digits[32] = "";
    std::snprintf(digits, sizeof digits, "%.*g", style_.digits, number);
    return digits;
  }

  /// Spaces up to a column: bytes that continue a letter of UTF-8 take no room.
  std::string padded(std::string words) const {
    const auto letters = std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; });
    words.append(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, style_.width - letters)), ' ');
    return words;
  }

  Style style_ = {};
  int stage_ = 0;
  bool has_marks_ = false;
  bool has_failed_ = false;
  bool is_explained_ = false;
};

}  // namespace cairn
