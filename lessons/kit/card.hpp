// What a lesson says of itself before it runs.
#pragma once

#include <string>

#include <cairn/math/list.hpp>

namespace cairn {

/// A number that the reader may change: `--dt 0.01`, also `--dt 1/60`. Refused outside [min, max].
struct Parameter {
  std::string flag = {};  // "dt"
  double standard = 0;
  double min = 0;
  double max = 0;
  std::string unit = {};  // "s"; "" for counts and ratios
  std::string what = {};  // "time step"
  enum class Kind { real, whole } kind = Kind::real;
};

/// A choice: `--precision float`. The first value is the standard.
struct Choice {
  std::string flag = {};
  List<std::string> values = {};
  std::string what = {};
};

/// A wrong guess at the question that many make, each number from `least` to `most`, and what is wrong with
/// it.
struct WrongGuess {
  List<double> least = {};
  List<double> most = {};
  std::string why = {};  // a sentence, which follows what the reader said
};

/// What a lesson is, before it runs: shown by --help, --about, `lessons list`.
struct LessonInfo {
  int number = 0;
  std::string name = {};             // "sequential_impulses": program lesson03_sequential_impulses
  std::string title = {};            // "Sequential impulses"
  std::string idea = {};             // one sentence
  std::string paper = {};            // "paper 3.2, Algorithm 1, eq (19)-(23)"
  List<std::string> equations = {};  // "(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)"
  List<std::string> needs = {};      // what to know first: "lesson 03" ...
  List<std::string> reads = {};      // files of the project to read next
  std::string question = {};         // to predict before the lesson shows it
  List<std::string> spoilers = {};   // words and numbers of the answer: none stands before a page's fold
  List<std::string> unasked = {};    // flags that may be changed, and the question is still about this scene
  List<WrongGuess> wrong = {};       // the first that a guess is among explains it
  List<std::string> hints = {};      // up to three, from vague to plain
  List<Parameter> parameters = {};
  List<Choice> choices = {};
  int cover = -1;         // the frame that stands for the lesson, from 1; negative: from the end
  std::string next = {};  // "bash lessons/run 7   (what it is about)"; "" after the last
};

/// Makes a lesson known to the program that it is linked with. Its card.cpp has one of them and nothing else.
struct LessonCard {
  explicit LessonCard(LessonInfo info);
};

/// The cards that this program has, by number: a lesson its own, the driver all.
const List<LessonInfo>& cards();

/// The card of the lesson that this program is.
const LessonInfo& card();

}  // namespace cairn
