// What lessons say they meet of the paper: every item is met, by frames and checks that there are.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "child_lesson.hpp"
#include "math/list.hpp"

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

/// "item | frame | check", of the lines that are not comments. A check may have a | in it.
struct CoverMark {
  int frame = 0;
  std::string check = {};
};

List<CoverMark> marks_in(const fs::path& file) {
  std::ifstream stream(file);
  List<CoverMark> marks;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream parts(line);
    std::string item, frame, check;
    std::getline(parts, item, '|');
    std::getline(parts, frame, '|');
    std::getline(parts, check);
    marks.push_back({.frame = std::stoi(frame), .check = check.substr(check.find_first_not_of(' '))});
  }
  return marks;
}

void check_marks(const std::string& lesson, const List<CoverMark>& marks) {
  const ScratchFolder folder;
  REQUIRE(run_program("lesson" + lesson, {"-q", "--frames", "cover", "-o", folder.path()}).code == 0);
  const auto run = nlohmann::json::parse(folder.text("run.json"));
  const auto film = nlohmann::json::parse(folder.text("frames.json"));
  for (const CoverMark& mark : marks) {
    CAPTURE(mark.check);
    CHECK(mark.frame >= 1);
    CHECK(mark.frame <= film["frames_of_the_sequence"].get<int>());
    CHECK(std::any_of(run["claims"].begin(), run["claims"].end(), [&mark](const nlohmann::json& claim) {
      return claim["holds"].get<bool>() && claim["claim"].get<std::string>().rfind(mark.check, 0) == 0;
    }));
  }
}

}  // namespace

TEST_CASE("every equation, the algorithm and every claim of the paper are met in a lesson") {
  const Ran ran = run_program("lessons", {"coverage"});
  CAPTURE(ran.out);
  CHECK(ran.code == 0);
}

TEST_CASE("every frame and every check that a lesson names for an item of the paper is there") {
  int lessons = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(CAIRN_SOURCE_DIR "/lessons")) {
    if (!fs::exists(entry.path() / "covers.txt")) continue;
    ++lessons;
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    check_marks(name, marks_in(entry.path() / "covers.txt"));
  }
  CHECK(lessons == 21);
}

}  // namespace cairn::testing
