// Every key frame of every lesson, at three sizes: nothing overlaps, is cut off, too small or too pale.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

constexpr int skipped = 77;

/// "lesson03_sequential_impulses", of all that are built.
List<std::string> built_programs() {
  List<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(CAIRN_BIN_DIR)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("lesson") && name != "lessons") names.push_back(name);
  }
  return names;
}

}  // namespace

TEST_CASE("the key frames of all lessons are laid out without fault at three sizes") {
  for (const std::string& name : built_programs()) {
    for (const char* size : {"960x540", "1280x720", "1920x1080"}) {
      const std::string run = name + " --size " + size;
      CAPTURE(run);
      const ScratchFolder folder;
      const Ran ran = run_program(name, {"-q", "-v", "--size", size, "-o", folder.path()});
      CAPTURE(ran.err);
      CHECK((ran.code == 0 || ran.code == skipped));
      CHECK((folder.names().size() > 3 || ran.code == skipped));  // pictures, and what describes them
    }
  }
}

TEST_CASE("the forces of lesson 11 are named without overlap, whatever slope and friction are") {
  for (const List<std::string>& values : List<List<std::string>>{{"--mu", "0.05"},
                                                                 {"--mu", "0.05", "--angle", "5"},
                                                                 {"--mu-rough", "0.4", "--angle", "20"},
                                                                 {"--mu", "0.8", "--mu-rough", "0.8"}}) {
    const ScratchFolder folder;
    List<std::string> flags = {"-q", "-v", "--frames", "1:4", "-o", folder.path()};
    flags.insert(flags.end(), values.begin(), values.end());
    const Ran ran = run_program("lesson11_friction", flags);
    CAPTURE(ran.err);
    CHECK((ran.code == 0 || ran.code == skipped));
  }
}

}  // namespace cairn::testing
