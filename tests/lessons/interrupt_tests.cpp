// The driver when it is told to stop in the middle of a book: with 130, and with everything as it was.
#include <doctest/doctest.h>
#include <signal.h>

#include <filesystem>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

namespace fs = std::filesystem;

/// A driver whose one lesson sends it this signal and goes on for a minute.
std::string driver_that_is_stopped(const ScratchFolder& folder, const std::string& signal) {
  const std::string driver = driver_apart(folder, "tree", {});
  const std::string lesson = "tree/bin/lesson03_sequential_impulses";
  folder.write(lesson, "#!/bin/sh\necho $$ >'" + folder.path() + "/tree/pid'\nkill -" + signal +
                           " $PPID\nexec sleep 60\n");
  fs::permissions(folder.path() + "/" + lesson, fs::perms::owner_all);
  return driver;
}

bool lesson_is_running(const ScratchFolder& folder) {
  const std::string pid = folder.text("tree/pid");
  REQUIRE_FALSE(pid.empty());
  return kill(std::stoi(pid), 0) == 0;
}

bool makes_no_books(const Ran& ran) {
  const bool cannot = ran.code == 3 && (ran.err.find("made by pandoc") != std::string::npos ||
                                        ran.err.find("needs chromium") != std::string::npos);
  if (cannot) MESSAGE("left out: " << ran.err);
  return cannot;
}

}  // namespace

TEST_CASE("a book or a film that is interrupted ends with its lesson, says so and leaves nothing") {
  for (const std::string signal : {"INT", "TERM"}) {
    const List<List<std::string>> commands = {
        {"book", "made"}, {"handouts", "made/handouts.pdf"}, {"export", "3", "--out", "made"}};
    for (const List<std::string>& command : commands) {
      CAPTURE(signal);
      CAPTURE(command.front());
      const ScratchFolder folder;
      List<std::string> words = {"-C", folder.path(), driver_that_is_stopped(folder, signal)};
      words.insert(words.end(), command.begin(), command.end());
      const Ran ran = run_program("/usr/bin/env", words);
      if (makes_no_books(ran)) continue;
      CAPTURE(ran.err);
      CHECK(ran.code == 130);
      CHECK(ran.err.find("lessons: interrupted; ") != std::string::npos);
      CHECK_FALSE(lesson_is_running(folder));
      CHECK(folder.names() == List<std::string>{"tree"});
    }
  }
}

TEST_CASE("a book that is interrupted leaves the earlier one as it was") {
  const ScratchFolder folder;
  fs::create_directories(folder.path() + "/made/frames");
  folder.write("made/index.html", "earlier");
  folder.write("made/frames/lesson03_0001_light.png", "earlier");
  folder.write("made/handouts.pdf", "earlier");
  const std::string driver = driver_that_is_stopped(folder, "INT");
  for (const List<std::string>& command : List<List<std::string>>{
           {"book", folder.path() + "/made"}, {"handouts", folder.path() + "/made/handouts.pdf"}}) {
    const Ran ran = run_program(driver, command);
    if (makes_no_books(ran)) continue;
    CHECK(ran.code == 130);
    CHECK(ran.err == "lessons: interrupted; " + command.back() + " is as it was\n");
  }
  CHECK(folder.names("made") == List<std::string>{"frames", "handouts.pdf", "index.html"});
  for (const char* file : {"index.html", "frames/lesson03_0001_light.png", "handouts.pdf"})
    CHECK(folder.text("made/" + std::string(file)) == "earlier");
}
