// What `lessons export` makes of lesson 3.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {

using Names = List<std::string>;

/// `lessons export 6` into the folder `out` of another.
inline Ran export_six(const ScratchFolder& folder, const Names& flags) {
  Names words = {"export", "3", "--out", folder.path() + "/out"};
  words.insert(words.end(), flags.begin(), flags.end());
  return run_program("lessons", words);
}

/// What lesson 3 itself says of one of its frames.
inline std::string alt_of(int frame) {
  const ScratchFolder folder;
  run_program("lesson03_sequential_impulses", {"--frames", std::to_string(frame), "-o", folder.path()});
  return nlohmann::json::parse(folder.text("frames.json"))["frames"][0]["alt"];
}

}  // namespace cairn::testing
