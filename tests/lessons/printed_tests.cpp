// What documents show of the output of commands is what the commands print now.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "child_lesson.hpp"

namespace cairn::testing {

namespace {

namespace fs = std::filesystem;

std::string file_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("every block of a document that shows a command's output is what the command prints") {
  if (!fs::exists(CAIRN_BIN_DIR "/cairn")) {
    MESSAGE("the program cairn is not built: nothing to compare");
    return;
  }
  const ScratchFolder scratch;
  const fs::path source = CAIRN_SOURCE_DIR, written = fs::path(scratch.path()) / "documents";
  const std::string command = "bash '" CAIRN_SOURCE_DIR "/lessons/documents.sh' '" CAIRN_BIN_DIR
                              "' '" CAIRN_SOURCE_DIR "' '" +
                              written.string() + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  int documents = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(written)) {
    if (!entry.is_regular_file()) continue;
    ++documents;
    const fs::path name = fs::relative(entry.path(), written);
    CAPTURE(name.string());
    CHECK(file_text(entry.path()) == file_text(source / name));
  }
  CHECK(documents >= 3);
}

}  // namespace cairn::testing
