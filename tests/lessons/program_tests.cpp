// The programs as they were built: lessons by themselves, and the driver.
#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "child_lesson.hpp"
#include "math/list.hpp"

using namespace cairn::testing;
using cairn::List;

namespace {

const char* const first_lesson = "lesson00_one_body";

/// Runs the driver in a folder.
Ran drive_in(const ScratchFolder& folder, const List<std::string>& words) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const Ran ran = run_program("lessons", words);
  std::filesystem::current_path(before);
  return ran;
}

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a lesson program checks itself, refuses what it does not know, and explains itself") {
  CHECK(run_program(first_lesson, {"--check"}).code == 0);
  CHECK(run_program(first_lesson, {"--quaternion"}).code == 2);
  CHECK(run_program(first_lesson, {"--help"}).code == 0);
  CHECK(run_program(first_lesson, {"-q", "--frames", "cover", "-o", "/dev/null/out"}).code == 3);
}

TEST_CASE("two runs of a lesson program end in the same state") {
  const Ran first = run_program(first_lesson, {"--frames", "none"});
  const Ran second = run_program(first_lesson, {"--frames", "none"});
  CHECK(tells(first.out, "     state "));
  CHECK(first.out == second.out);
}

TEST_CASE("the driver lists the lessons and explains itself") {
  const ScratchFolder folder;
  const Ran list = drive_in(folder, {"list"});
  CHECK(list.code == 0);
  CHECK(list.out.rfind("00  One body\n    ", 0) == 0);
  CHECK(tells(drive_in(folder, {"--help"}).out, "lessons/run next"));
  CHECK(tells(drive_in(folder, {"legend"}).out, "Arrows"));
  CHECK(folder.names().empty());
}

TEST_CASE("the driver refuses a lesson or a word that there is none of, with the list") {
  const ScratchFolder folder;
  const Ran number = drive_in(folder, {"98"});
  CHECK(number.code == 2);
  CHECK(tells(number.err, "there is no lesson 98; there are\n  00  "));
  const Ran word = drive_in(folder, {"lst"});
  CHECK(word.code == 2);
  CHECK(tells(word.err, "did you mean list?"));
  CHECK(drive_in(folder, {"check"}).code == 2);
  CHECK(drive_in(folder, {"--quaternion"}).code == 2);
  CHECK(drive_in(folder, {"hint", "98"}).code == 2);
}

TEST_CASE("the driver hands flags on and returns the exit code of the lesson") {
  const ScratchFolder folder;
  CHECK(drive_in(folder, {"0", "--frames", "none"}).code == 0);
  CHECK(drive_in(folder, {"run", "00", "--quaternion"}).code == 2);
  CHECK(drive_in(folder, {"one_body", "--check"}).code == 0);
  CHECK(folder.names().empty());
}

namespace {

/// The driver and lesson 02 in a folder of their own, with an exercise that ends with this exit code, or
/// none.
Ran drive_beside_exercise(const ScratchFolder& folder, std::optional<int> exercise_code,
                          const List<std::string>& words) {
  namespace fs = std::filesystem;
  const std::string driver = driver_apart(folder, "bin", {"lesson02_effective_mass"});
  if (exercise_code) {
    folder.write("bin/bin/exercise02", "#!/bin/sh\nexit " + std::to_string(*exercise_code) + "\n");
    fs::permissions(folder.path() + "/bin/bin/exercise02", fs::perms::owner_all);
  }
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const Ran ran = run_program(driver, words);
  fs::current_path(before);
  return ran;
}

}  // namespace

TEST_CASE("a passed exercise is noted once, next goes on behind it, and then its answer is shown") {
  const ScratchFolder folder;
  CHECK(drive_beside_exercise(folder, 0, {"solution", "2"}).code == 1);
  CHECK(drive_beside_exercise(folder, 0, {"check", "2"}).code == 0);
  CHECK(drive_beside_exercise(folder, 0, {"check", "2"}).code == 0);
  const std::string notes = folder.text("lessons-progress.txt");
  CHECK(notes.rfind("02 passed 20", 0) == 0);
  CHECK(notes.size() == std::string("02 passed 2026-11-20\n").size());
  CHECK(folder.names() == List<std::string>{"bin", "lessons-progress.txt"});
  CHECK_FALSE(tells(drive_beside_exercise(folder, 0, {"next"}).out, "Next is lesson 2;"));
  CHECK(tells(drive_beside_exercise(folder, 0, {"progress"}).out, "1 of 21 lessons passed"));
  const Ran solution = drive_beside_exercise(folder, 0, {"solution", "2"});
  CHECK(solution.code == 0);
  CHECK(tells(solution.out, "(contact.wanted - jv)"));
}

TEST_CASE(
    "an exercise that fails or is not built is not noted, and does not concern the checks of all lessons") {
  const ScratchFolder folder;
  CHECK(drive_beside_exercise(folder, 1, {"check", "2"}).code == 1);
  CHECK(drive_beside_exercise(folder, 1, {"check", "--all"}).code == 0);
  CHECK(folder.names() == List<std::string>{"bin"});
  const ScratchFolder elsewhere;
  const Ran ran = drive_beside_exercise(elsewhere, std::nullopt, {"check", "2"});
  CHECK(ran.code == 3);
  CHECK(tells(ran.err, "bash lessons/run check 2 builds it"));
  CHECK(elsewhere.names() == List<std::string>{"bin"});
}

TEST_CASE("the doctor draws a picture and leaves nothing behind") {
  const ScratchFolder folder;
  const Ran ran = drive_in(folder, {"doctor"});
  CHECK(ran.code == 0);
  CHECK(tells(ran.out, "Pictures  can be drawn, through "));
  CHECK(folder.names().empty());
}
