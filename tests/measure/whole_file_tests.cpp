// Files that are there whole or not at all.
#include <cairn/measure/whole_file.hpp>

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
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

/// No file may become longer, as on a full disk.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  rlimit before_ = {};
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
  CHECK_THROWS_WITH_AS(write_whole_file(folder.path, "x"),
                       ("cannot write " + folder.path.string() + ": Is a directory").c_str(), WriteError);
  CHECK(fs::is_empty(folder.path));
  write_whole_file(folder.path / "file", "old");
  const fs::path below_a_file = folder.path / "file" / "x";
  CHECK_THROWS_WITH_AS(write_whole_file(below_a_file, "x"),
                       ("cannot write " + below_a_file.string() + ": Not a directory").c_str(), WriteError);
  {
    const FileLimit limit(1000);
    CHECK_THROWS_WITH_AS(write_whole_file(folder.path / "file", std::string(2000, 'x')),
                         doctest::Contains("File too large"), WriteError);
  }
  CHECK(whole_text(folder.path / "file") == "old");
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("the folder of a file is made") {
  const WholeFileFolder folder;
  write_whole_file(folder.path / "a" / "b" / "file", "x");
  CHECK(whole_text(folder.path / "a" / "b" / "file") == "x");
}

TEST_CASE("a file that is not finished leaves nothing, and its name until then cannot be foreseen") {
  const WholeFileFolder folder;
  const fs::path file = folder.path / "file", victim = folder.path / "victim";
  write_whole_file(victim, "precious");
  fs::create_symlink(victim, folder.path / "file.part");
  {
    WholeFile first(file), second(file);
    CHECK(first.part() != second.part());
    CHECK(first.part().parent_path() == folder.path);
    first.write("half");
    CHECK_FALSE(fs::exists(file));
  }
  write_whole_file(file, "whole");
  CHECK(whole_text(victim) == "precious");
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 3);
  // As others may read what the user writes elsewhere.
  std::ofstream(folder.path / "usual") << "x";
  CHECK(fs::status(file).permissions() == fs::status(folder.path / "usual").permissions());
}

TEST_CASE("a device is written to, never replaced") {
  const WholeFileFolder folder;
  const fs::path device = folder.path / "device";
  fs::create_symlink("/dev/full", device);
  CHECK_THROWS_WITH_AS(write_whole_file(device, "x"), doctest::Contains("No space left"), WriteError);
  CHECK(fs::is_character_file(device));
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}
