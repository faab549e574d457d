// A new lesson: what `lessons/run new` makes, and that it works as it comes.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

/// cairn_new_lesson NAME in a folder of lessons; what it says is in the file "said".
int make_lesson(const ScratchFolder& scratch, const std::string& name) {
  const std::string command = "bash -c \"cairn_root='" CAIRN_SOURCE_DIR "'; . '" CAIRN_SOURCE_DIR
                              "/lessons/new.sh'; cairn_new_lesson '" +
                              name + "' '" + scratch.path() + "'\" > '" + scratch.path() + "/said' 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));
}

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("a new lesson has the next number, and its name wherever one is needed") {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() + "/08_before");
  CHECK(make_lesson(scratch, "ball_on_ice") == 0);
  CHECK(scratch.names().front() == "08_before");
  const List<std::string> made = scratch.names("09_ball_on_ice");
  CHECK(made.size() == 9);  // as in the template
  for (const std::string& name : made) {
    CAPTURE(name);
    const std::string text = scratch.text("09_ball_on_ice/" + name);
    for (const char* token : {"NN", "NAME", "TITLE", "FOLDER", "NUMBER", "DECIMAL"})
      CHECK(text.find(token) == std::string::npos);
  }
  CHECK(scratch.text("09_ball_on_ice/card.cpp").find(".number = 9,") != std::string::npos);
  CHECK(scratch.text("09_ball_on_ice/README.md").starts_with("# 09 · Ball on ice\n"));
}

TEST_CASE("a name that is none, or is taken, makes no lesson") {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() + "/08_before");
  for (const char* name : {"Ball", "ball-on-ice", "_ball", "ball__ice", "8ball", "before", "../ball"}) {
    CAPTURE(name);
    CHECK(make_lesson(scratch, name) == 2);
    CHECK(scratch.text("said").starts_with("lessons/run: new: "));
    CHECK(scratch.names().size() == 2);
  }
}

TEST_CASE("a new lesson runs, checks itself and draws at every size") {
  const std::string program = CAIRN_MADE_FOLDER "/lesson99_made";
  for (const char* size : {"960x540", "1280x720", "1920x1080"}) {
    CAPTURE(size);
    const ScratchFolder folder;
    const Ran ran = run_program(program, {"--size", size, "-o", folder.path()});
    CAPTURE(ran.out);
    CHECK(ran.code == 0);
    CHECK(nlohmann::json::parse(folder.text("frames.json"))["frames"].size() == 2);
  }
  CHECK(run_program(program, {"--answer", "6", "--frames", "none"}).code == 0);
  CHECK(run_program(program, {"--answer", "3", "--frames", "none"}).code == 1);
}

TEST_CASE("the page of a new lesson quotes its program") {
  const std::string folder = CAIRN_MADE_FOLDER "/lessons/99_made/";
  const std::string source = text_of(folder + "lesson.cpp");
  const std::string begin = "// [impulse]\n", end = "// [/impulse]\n";
  REQUIRE(source.find(begin) < source.find(end));
  const std::size_t from = source.find(begin) + begin.size();
  const std::string quoted = source.substr(from, source.find(end) - from);
  CHECK(text_of(folder + "README.md").find("```cpp\n" + quoted + "```\n") != std::string::npos);
}

}  // namespace cairn::testing
