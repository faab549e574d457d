// The programs as they were built: lessons by themselves, and the driver.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "child_lesson.hpp"

using namespace cairn::testing;

namespace {

const char* const first_lesson = "lesson00_one_body";

/// Runs the driver in a folder.
Ran drive_in(const ScratchFolder& folder, const std::vector<std::string>& words) {
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

TEST_CASE("a passed check is noted once, and next goes on behind it") {
  const ScratchFolder folder;
  CHECK(drive_in(folder, {"check", "0"}).code == 0);
  CHECK(drive_in(folder, {"check", "0"}).code == 0);
  const std::string notes = folder.text("lessons-progress.txt");
  CHECK(notes.rfind("00 passed 20", 0) == 0);
  CHECK(notes.size() == std::string("00 passed 2026-11-20\n").size());
  CHECK(folder.names() == std::vector<std::string>{"lessons-progress.txt"});
  CHECK_FALSE(tells(drive_in(folder, {"next", "--frames", "none"}).out, "Next is lesson 0;"));
  CHECK(tells(drive_in(folder, {"progress"}).out, "1 of "));
}

TEST_CASE("the doctor draws a picture and leaves nothing behind") {
  const ScratchFolder folder;
  const Ran ran = drive_in(folder, {"doctor"});
  CHECK(ran.code == 0);
  CHECK(tells(ran.out, "Pictures  can be drawn, through "));
  CHECK(folder.names().empty());
}
