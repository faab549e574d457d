// The program cairn, started as a process.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {

inline Ran run_cairn(const List<std::string>& words) { return run_program("cairn", words); }

/// Starts it with its stdout in a file, and says nothing of errors; the caller waits for it.
inline pid_t started_cairn(List<std::string> words, const std::string& out) {
  words.insert(words.begin(), std::string(CAIRN_BIN_DIR) + "/cairn");
  List<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const int file = open(out.c_str(), O_WRONLY | O_CREAT, 0600), nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(file, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  return child;
}

/// What it says with --json.
inline nlohmann::json cairn_json(List<std::string> words) {
  words.push_back("--json");
  const Ran ran = run_cairn(words);
  CAPTURE(ran.err);
  const nlohmann::json json = nlohmann::json::parse(ran.out, nullptr, false);
  REQUIRE(!json.is_discarded());
  return json;
}

inline bool text_has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace cairn::testing
