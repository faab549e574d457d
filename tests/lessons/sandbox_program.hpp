// The program cairn, started as a process.
#pragma once

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "child_lesson.hpp"

namespace cairn::testing {

inline Ran run_cairn(const std::vector<std::string>& words) { return run_program("cairn", words); }

/// What it says with --json.
inline nlohmann::json cairn_json(std::vector<std::string> words) {
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
