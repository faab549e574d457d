// A folder for what a test writes.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::testing {

/// An empty folder that is gone when this is.
class ScratchFolder {
 public:
  ScratchFolder() : path_((std::filesystem::temp_directory_path() / "cairn-lesson-test-XXXXXX").string()) {
    REQUIRE(mkdtemp(path_.data()) != nullptr);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }

  std::filesystem::path operator/(const std::string& file) const {
    return std::filesystem::path(path_) / file;
  }

  /// The names in a folder below it ("" for itself), sorted.
  List<std::string> names(const std::string& below = {}) const {
    List<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(*this / below, error))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::string text(const std::string& file) const {
    std::ifstream stream(*this / file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((*this / file).parent_path());
    std::ofstream(*this / file, std::ios::binary) << text;
  }

 private:
  std::string path_;
};

}  // namespace cairn::testing
