// Files that are there whole or not at all.
#include "measure/whole_file.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

using namespace cairn;

namespace {

namespace fs = std::filesystem;

struct WholeFileFolder {
  WholeFileFolder() : path(fs::temp_directory_path() / ("cairn_whole_" + std::to_string(::getpid()))) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~WholeFileFolder() { fs::remove_all(path); }
  fs::path path;
};

std::string whole_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a file is replaced as a whole, and nothing else is left in its folder") {
  const WholeFileFolder folder;
  const fs::path file = folder.path / "file";
  for (const std::string text : {"first\n", "", "a\r\nb"}) {
    write_whole_file(file, text);
    CHECK(whole_text(file) == text);
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
  }
}

TEST_CASE("where nothing can be written the message says where and why, and what was there stays") {
  const WholeFileFolder folder;
  const fs::path missing = folder.path / "no" / "file";
  CHECK_THROWS_WITH_AS(write_whole_file(missing, "x"),
                       ("cannot write " + missing.string() + ": No such file or directory").c_str(),
                       std::runtime_error);
  CHECK_THROWS_WITH_AS(write_whole_file(folder.path, "x"), doctest::Contains("directory"),
                       std::runtime_error);
  CHECK(fs::is_empty(folder.path));
  CHECK_THROWS_AS(write_whole_file("/dev/null/x", "x"), std::runtime_error);
}

TEST_CASE("a device is written to, never replaced") {
  const WholeFileFolder folder;
  const fs::path device = folder.path / "device";
  fs::create_symlink("/dev/full", device);
  CHECK_THROWS_WITH_AS(write_whole_file(device, "x"), doctest::Contains("No space left"), std::runtime_error);
  CHECK(fs::is_character_file(device));
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}
