// What a reader types for a solver of his own, typed by tests.
#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace cairn::solver_tests {

namespace fs = std::filesystem;

inline const fs::path solver_folder = fs::path(CAIRN_SOURCE_DIR) / "lessons/your_solver";
struct Ended {
  int code = 0;
  std::string out = {};  // stdout and stderr
};

inline Ended run_line(const std::string& line) {
  Ended ended;
  FILE* pipe = popen(("exec 2>&1; " + line).c_str(), "r");
  REQUIRE(pipe != nullptr);
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) ended.out += static_cast<char>(c);
  const int status = pclose(pipe);
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

inline std::string in_quotes(const std::string& word) { return "'" + word + "'"; }

/// An empty folder of the build.
inline fs::path scratch_folder(const std::string& name) {
  const fs::path folder = fs::path(CAIRN_BINARY_DIR) / "reader_tests" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// `bash lessons/run solver WORDS` in a folder.
inline Ended run_solver(const fs::path& folder, const std::string& words) {
  const std::string script = CAIRN_SOURCE_DIR "/lessons/run";
  return run_line("cd " + in_quotes(folder.string()) + " && bash " + in_quotes(script) + " solver " + words);
}

inline std::string model_of(int stage) {
  return run_line("bash " + in_quotes((solver_folder / "state.sh").string()) + " " + std::to_string(stage))
      .out;
}

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

inline void write_file(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace cairn::solver_tests
