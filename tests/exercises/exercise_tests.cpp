// What all exercises keep to: as they come they fail, their model answers pass, and every wrong number that
// an exercise claims to know is told from the right one.
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "lessons/exercise.hpp"
#include "math/list.hpp"

using namespace cairn;

namespace {

/// "02", for every lesson with an exercise.
List<std::string> lessons_with_exercises() {
  List<std::string> numbers;
  for (const auto& entry : std::filesystem::directory_iterator(CAIRN_SOURCE_DIR "/lessons")) {
    if (std::filesystem::exists(entry.path() / "solution.cpp"))
      numbers.push_back(entry.path().filename().string().substr(0, 2));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::string output_of(const std::string& program) {
  std::string text;
  FILE* pipe = popen((std::filesystem::path(CAIRN_BIN_DIR) / program).c_str(), "r");
  REQUIRE(pipe != nullptr);
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  CHECK(pclose(pipe) == 0);
  return text;
}

std::string lines_ending(const std::string& ending) {
  std::string lines;
  for (const std::string& number : lessons_with_exercises()) lines += number + " " + ending + "\n";
  return lines;
}

}  // namespace

TEST_CASE("every exercise fails as it comes") { CHECK(output_of("all_exercises") == lines_ending("failed")); }

TEST_CASE("every model answer passes") { CHECK(output_of("all_solutions") == lines_ending("passed")); }

TEST_CASE("output that a full disk does not take ends with three") {
  CHECK(WEXITSTATUS(std::system(CAIRN_BIN_DIR "/all_solutions > /dev/full 2> /dev/null")) == 3);
}

TEST_CASE("a number holds within its tolerance, and a NaN never does") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [got, holds] :
       {std::pair(2.0, true), std::pair(2.25, true), std::pair(2.5, false), std::pair(nan, false)}) {
    Grade grade;
    grade.number({.what = "a number", .value = 2, .tolerance = 0.25}, got);
    CHECK(grade.passed() == holds);
  }
  CHECK_FALSE(Grade().passed());
}

TEST_CASE("a wrong number names the first misconception that gives it, and a right one none") {
  const ExpectedNumber expected{.what = "a number",
                                .value = 2,
                                .tolerance = 0.1,
                                .misconceptions = {{-2, "the sign"}, {3, "one too many"}, {3, "another"}}};
  const auto comment_on = [&expected](double got) {
    Grade grade;
    grade.number(expected, got);
    return grade.marks().front().comment;
  };
  CHECK(comment_on(2).empty());
  CHECK(comment_on(-2.05) == "the sign");
  CHECK(comment_on(3) == "one too many");
  CHECK(comment_on(4).empty());
}
