// The programs as they were built: lessons by themselves, and the driver.
#include <doctest/doctest.h>
#include <signal.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

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

namespace fs = std::filesystem;

/// A driver of its own with lesson 02, and with a shell script for an exercise, or none.
std::string lay_out_driver(const ScratchFolder& folder, const std::optional<std::string>& script) {
  const std::string driver = driver_apart(folder, "bin", {"lesson02_effective_mass"});
  if (!script) return driver;
  folder.write("bin/bin/exercise02", "#!/bin/bash\n" + *script + "\n");
  fs::permissions(folder.path() + "/bin/bin/exercise02", fs::perms::owner_all);
  return driver;
}

Ran drive_beside_script(const ScratchFolder& folder, const std::optional<std::string>& script,
                        const List<std::string>& words) {
  const std::string driver = lay_out_driver(folder, script);
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const Ran ran = run_program(driver, words);
  fs::current_path(before);
  return ran;
}

/// With an exercise whose grader comes to this verdict.
Ran drive_beside_exercise(const ScratchFolder& folder, int verdict, const List<std::string>& words) {
  const std::string code = std::to_string(verdict);
  const std::string told = "place=${CAIRN_VERDICT%% *} word=${CAIRN_VERDICT##* }; echo \"$word $$ ended ";
  return drive_beside_script(folder, told + code + "\" >&$place; exit " + code, words);
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
  const auto is_lesson = [](const std::filesystem::directory_entry& entry) {
    return std::isdigit(static_cast<unsigned char>(entry.path().filename().string().front())) != 0;
  };
  const auto lessons =
      std::count_if(std::filesystem::directory_iterator(CAIRN_SOURCE_DIR "/lessons"), {}, is_lesson);
  CHECK(tells(drive_beside_exercise(folder, 0, {"progress"}).out,
              "1 of " + std::to_string(lessons) + " lessons passed"));
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
  const Ran ran = drive_beside_script(elsewhere, std::nullopt, {"check", "2"});
  CHECK(ran.code == 3);
  CHECK(tells(ran.err, "bash lessons/run check 2 builds it"));
  CHECK(elsewhere.names() == List<std::string>{"bin"});
}

TEST_CASE("an exercise that ends by itself, crashes or never ends is told in words, and is not noted") {
  const ScratchFolder folder;
  for (const auto& [script, words] :
       {std::pair("echo Passed.; exit 0", "exercise.cpp ended the program before the grader was done"),
        std::pair("kill -SEGV $$", "exercise.cpp read or wrote where it has nothing"),
        std::pair("trap '' TERM; while true; do sleep 1; done", "exercise.cpp did not end within 10 s")}) {
    const std::string shown = script;
    INFO(shown);
    const Ran ran = drive_beside_script(folder, script, {"check", "2"});
    CHECK(ran.code == 1);
    CHECK_MESSAGE(tells(ran.out, words), ran.out);
    CHECK(tells(ran.out, "Not yet. A hint: bash lessons/run hint 2\n"));
    CHECK(folder.names() == List<std::string>{"bin"});
  }
}

TEST_CASE("a hint comes from the exercise, under the same limits") {
  const ScratchFolder folder;
  const Ran ran = drive_beside_script(folder, "echo $*; kill -ABRT $$", {"hint", "2", "3"});
  CHECK(ran.code == 1);
  CHECK(ran.out.rfind("--hint 3\nexercise.cpp called abort()", 0) == 0);
}

TEST_CASE("Ctrl-C during a check ends the exercise with all that it has started, and notes nothing") {
  const ScratchFolder folder;
  lay_out_driver(folder,
                 "trap '' TERM INT\n"
                 "setsid sh -c 'echo $$ > left; exec sleep 300' &\n"
                 "while ! grep -qs . left; do sleep 0.1; done\n"
                 "echo $$ > own; kill -INT $PPID; sleep 300");
  const Ran ran = run_program(
      "/bin/bash", {"-c", "cd '" + folder.path() + "' && bin/bin/lessons check 2; echo \"code $?\""});
  CHECK(ran.out == "code 130\n");
  CHECK(folder.names() == List<std::string>{"bin", "left", "own"});
  for (const char* file : {"left", "own"}) CHECK(kill(std::stoi(folder.text(file)), 0) != 0);
}

TEST_CASE("the doctor draws a picture and leaves nothing behind") {
  const ScratchFolder folder;
  const Ran ran = drive_in(folder, {"doctor"});
  CHECK(ran.code == 0);
  CHECK(tells(ran.out, "Pictures  can be drawn, through "));
  CHECK(folder.names().empty());
}
