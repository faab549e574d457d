// What lessons say they have of the paper: every item, by checks, frames, printed lines and words that there
// are.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

/// "item | how | what", of the lines that are not comments. A check may have a | in it.
struct CoverMark {
  std::string item = {};
  std::string how = {};  // "met", "shown" or "mentioned"
  int frame = 0;         // 0: none
  std::string what = {};
};

std::string without_spaces_around(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

List<CoverMark> marks_in(const fs::path& file) {
  std::ifstream stream(file);
  List<CoverMark> marks;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream parts(line);
    CoverMark mark;
    std::string how;
    std::getline(parts, mark.item, '|');
    std::getline(parts, how, '|');
    std::getline(parts, mark.what);
    std::istringstream(how) >> mark.how >> mark.frame;
    mark.item = without_spaces_around(mark.item);
    mark.what = without_spaces_around(mark.what);
    marks.push_back(mark);
  }
  return marks;
}

/// The text with each run of spaces and line ends as one space.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) all += word + " ";
  return all;
}

std::string text_in(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool has(const std::string& text, const std::string& words) {
  return in_one_line(text).find(without_spaces_around(in_one_line(words))) != std::string::npos;
}

/// The checks on which the items rest, each to be used once.
void check_marks(const fs::path& lesson, const List<CoverMark>& marks, std::set<std::string>& used) {
  const ScratchFolder folder;
  const std::string name = lesson.filename().string();
  const Ran ran = run_program("lesson" + name, {"--frames", "cover", "-o", folder.path()});
  REQUIRE(ran.code == 0);
  const auto run = nlohmann::json::parse(folder.text("run.json"));
  const auto film = nlohmann::json::parse(folder.text("frames.json"));
  for (const CoverMark& mark : marks) {
    CAPTURE(mark.item);
    CAPTURE(mark.what);
    CHECK(mark.frame <= film["frames_of_the_sequence"].get<int>());
    if (mark.how == "mentioned") CHECK(has(text_in(lesson / "README.md"), mark.what));
    if (mark.how == "shown" && mark.frame == 0) CHECK(has(ran.out, mark.what));
    if (mark.how != "met") continue;
    const auto& claims = run["claims"];
    const auto claim = std::find_if(claims.begin(), claims.end(), [&mark](const nlohmann::json& each) {
      return each["claim"].get<std::string>().rfind(mark.what, 0) == 0;
    });
    REQUIRE(claim != claims.end());
    CHECK((*claim)["holds"].get<bool>());
    CHECK(used.insert(name + ": " + (*claim)["claim"].get<std::string>()).second);
  }
}

}  // namespace

TEST_CASE("every equation, the algorithm and every claim of the paper are in a lesson") {
  const Ran ran = run_program("lessons", {"coverage"});
  CAPTURE(ran.out);
  CHECK(ran.code == 0);
}

TEST_CASE("what a lesson names for an item of the paper is there, and no check serves two items") {
  std::set<std::string> used;
  for (const fs::directory_entry& entry : fs::directory_iterator(CAIRN_SOURCE_DIR "/lessons")) {
    if (!fs::exists(entry.path() / "covers.txt")) continue;
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    check_marks(entry.path(), marks_in(entry.path() / "covers.txt"), used);
  }
  CHECK_FALSE(used.empty());
}

}  // namespace cairn::testing
