// What the tests of `cmake --install` share: a scratch folder, a line of the shell, a prefix.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace cairn::testing {

struct CommandResult {
  int code = 0;
  std::string output = {};  // stdout and stderr
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// An empty folder of the build.
inline std::filesystem::path scratch(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(CAIRN_BINARY_DIR) / "install_test" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string quoted(const std::string& word) { return "\"" + word + "\""; }

/// Runs a line of the shell; what it prints is kept in `folder` while it runs.
inline CommandResult run_line(const std::filesystem::path& folder, const std::string& line) {
  const std::filesystem::path log = folder / "log.txt";
  const int status = std::system((line + " > " + quoted(log.string()) + " 2>&1").c_str());
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .output = text_of(log)};
}

inline void require_success(const CommandResult& result) {
  INFO(result.output);
  REQUIRE(result.code == 0);
}

/// Installs a component, and moves what was installed: it may not depend on where it first was.
inline std::filesystem::path installed_component(const std::filesystem::path& folder,
                                                 const std::string& component) {
  std::filesystem::create_directories(folder);
  const std::string install = quoted(CAIRN_CMAKE) + " --install " + quoted(CAIRN_BINARY_DIR) +
                              " --strip --component " + component + " --prefix " +
                              quoted((folder / "first").string());
  require_success(run_line(folder, install));
  std::filesystem::rename(folder / "first", folder / "prefix");
  return folder / "prefix";
}

}  // namespace cairn::testing
