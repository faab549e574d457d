// How a number is graded, and what becomes of output that nothing takes.
#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "lessons/kit/exercise.hpp"

using namespace cairn;

TEST_CASE("output that a full disk does not take ends with three") {
  CHECK(WEXITSTATUS(std::system(CAIRN_BIN_DIR "/exercise00 > /dev/full 2> /dev/null")) == 3);
}

TEST_CASE("an exercise whose reader has added a main() is graded all the same") {
  constexpr int not_yet = 1;
  CHECK(WEXITSTATUS(std::system(CAIRN_BIN_DIR "/exercise_with_main > /dev/null")) == not_yet);
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

TEST_CASE("without a tolerance a number holds within 1e-9, relative where it is above 1") {
  CHECK(marked({.value = 1e6}, 1e6 + 0.9e-3).holds);
  CHECK_FALSE(marked({.value = 1e6}, 1e6 + 1.1e-3).holds);
  CHECK(marked({.value = 1e-3}, 1e-3 + 0.9e-9).holds);
  CHECK_FALSE(marked({.value = 1e-3}, 1e-3 + 1.1e-9).holds);
}

TEST_CASE("a gap without code is not graded, and an exercise without its marks is") {
  const std::filesystem::path source = std::filesystem::temp_directory_path() / "cairn_exercise_tests.cpp";
  const auto is_graded = [&source](const std::string& text) {
    std::ofstream(source) << text;
    bool graded = false;
    const char* const words[] = {"exercise"};
    CHECK(exercise_program({.grade = [&graded](Grade&) { graded = true; }}, source.string(), 1, words) == 1);
    return graded;
  };
  const std::string begin = "int f() {\n  // Your code begins here: about one line.\n";
  const std::string end = "  // Your code ends here.\n}\n";
  CHECK_FALSE(is_graded(begin + "\n" + end));
  CHECK_FALSE(is_graded(begin + "  // I will do it tomorrow.\n\n" + end));
  CHECK(is_graded(begin + "  // The answer:\n  return 42;\n" + end));
  CHECK(is_graded("int f() { return 42; }\n"));
  std::filesystem::remove(source);
}

TEST_CASE("a wrong number names the first misconception that gives it, and a right one none") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ExpectedNumber expected{.value = 2,
                                .misconceptions = {{-2, "the sign"},
                                                   {3, ""},
                                                   {3, "one too many"},
                                                   {3, "another"},
                                                   {infinity, "divided by 0"},
                                                   {nan, "0 by 0"}},
                                .tolerance = 0.1};
  const auto comment_on = [&expected](double got) { return marked(expected, got).comment; };
  CHECK(comment_on(2).empty());
  CHECK(comment_on(-2.05) == "the sign");
  CHECK(comment_on(3) == "one too many");
  CHECK(comment_on(infinity) == "divided by 0");
  CHECK(comment_on(-infinity).empty());
  CHECK(comment_on(nan) == "0 by 0");
  CHECK(comment_on(4).empty());
}

TEST_CASE("a grade of the first failure alone prints what failed first, and the first comment on any") {
  const auto stays = [](const std::function<void(Grade&)>& marks) {
    const std::string file = (std::filesystem::temp_directory_path() / "cairn_first_failure.txt").string();
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    REQUIRE(std::freopen(file.c_str(), "w", stdout) != nullptr);
    Grade grade({.width = 1, .only_first = true});
    marks(grade);
    std::fflush(stdout);
    dup2(kept, STDOUT_FILENO);
    close(kept);
    std::ifstream in(file);
    CHECK_FALSE(grade.passed());
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  CHECK(stays([](Grade& grade) {
          grade.number({"a", 1}, 1);
          grade.number({"b", 1}, 2);
          grade.number({"c", 1}, 1);
          grade.number({"d", 1}, 2);
          grade.number({"e", 1, {{2, "Named."}}}, 2);
          grade.number({"f", 1, {{2, "Named again."}}}, 2);
          grade.explain("By physics.");
        }) == "CHECK  a 1  ok\nCHECK  b 2, not 1  no\nCHECK  e 2, not 1  no\n       Named.\n");
  CHECK(stays([](Grade& grade) {
          grade.number({"b", 1}, 2);
          grade.explain("");
          grade.explain("By physics.");
          grade.number({"e", 1, {{2, "Named."}}}, 2);
        }) == "CHECK  b 2, not 1  no\n       By physics.\n");
}
