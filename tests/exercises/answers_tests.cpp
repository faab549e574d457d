// The exercises, with what may stand in their gaps: as they come they fail, their models pass, and every
// wrong answer fails with the words that are promised of it.
#include "lessons/answers.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "lessons/exercise.hpp"

using namespace cairn;

namespace {

constexpr int fewest_wrong_answers = 8;

Grade grade_of(const Exercise& exercise) {
  Grade grade;
  exercise.grade(grade);
  return grade;
}

std::string comments_on(const Grade& grade) {
  std::string all;
  for (const Mark& mark : grade.marks()) all += mark.comment + "\n";
  return all;
}

List<GapAnswer> answers_of(const Exercise& exercise) {
  // That of the template is in the build's folder.
  const char* const root = exercise.lesson == 99 ? CAIRN_MADE_FOLDER : CAIRN_SOURCE_DIR;
  const auto folder = (std::filesystem::path(root) / exercise.file).parent_path();
  std::ifstream stream(folder / "answers.txt");
  return read_answers({std::istreambuf_iterator<char>(stream), {}});
}

/// What read_answers says of a text that it does not take.
std::string refusal_of(const std::string& text) {
  try {
    read_answers(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("an exercise fails as it comes, its model passes, and every wrong answer is named") {
  for (const List<Exercise>& graded : all_answers()) {
    CAPTURE(graded.front().file);
    CHECK_FALSE(grade_of(graded.front()).passed());
    const List<GapAnswer> answers = answers_of(graded.front());
    REQUIRE(graded.size() == answers.size() + 1);
    CHECK(answers.size() > fewest_wrong_answers);
    CHECK(grade_of(graded[1]).passed());
    for (int i = 1; i < answers.size(); ++i) {
      CAPTURE(answers[i].name);
      const Grade grade = grade_of(graded[i + 1]);
      CHECK_FALSE(grade.passed());
      const std::string comments = comments_on(grade);
      CAPTURE(comments);
      for (const std::string& words : answers[i].says) CHECK(comments.find(words) != std::string::npos);
    }
  }
}

TEST_CASE("answers have a name, what is said of them, and code") {
  const List<GapAnswer> answers =
      read_answers("A head.\n\n=== model\nx = 1;\n\n=== a sign\nsays: the sign\nx =\n  -1;\n");
  REQUIRE(answers.size() == 2);
  CHECK(answers[0].name == "model");
  CHECK(answers[0].says.empty());
  CHECK(answers[0].code == "x = 1;\n");
  CHECK(answers[0].line == 4);
  CHECK(answers[1].name == "a sign");
  CHECK(answers[1].says == List<std::string>{"the sign"});
  CHECK(answers[1].code == "x =\n  -1;\n");
  CHECK(answers[1].line == 8);
}

TEST_CASE("answers without a name, words or code are refused, with their line") {
  CHECK(refusal_of("x = 1;\n") == "there must be a line \"=== NAME\" and an answer below it");
  CHECK(refusal_of("=== m\n\n=== n\nsays: a\nb\n") == "answer \"m\" (line 2) must have code, and has none");
  CHECK(refusal_of("=== m\nsays: a\nb\n") ==
        "answer \"m\" (line 3) is the model, and must have no line \"says: \"");
  CHECK(refusal_of("=== m\na\n=== n\nb\n") ==
        "answer \"n\" (line 4) must have a line \"says: \" with what the grader says of it");
}

TEST_CASE("the gap lies between its two lines, and both must be there once") {
  const std::string before = "a\n  // Your code begins here: two lines.\n",
                    behind = "  // Your code ends here.\nc\n";
  const GapText text = split_at_gap(before + "b\n" + behind);
  CHECK(text.before == before);
  CHECK(text.gap == "b\n");
  CHECK(text.behind == behind);
  CHECK_THROWS_WITH_AS(split_at_gap("a\n" + behind),
                       "\"// Your code begins here\" must stand in exactly one line", std::runtime_error);
  CHECK_THROWS_WITH_AS(split_at_gap(before + behind + behind),
                       "\"// Your code ends here\" must stand in exactly one line", std::runtime_error);
  CHECK_THROWS_WITH_AS(split_at_gap(behind + before),
                       "\"// Your code begins here\" must stand before \"// Your code ends here\"",
                       std::runtime_error);
}
