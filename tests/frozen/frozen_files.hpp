// Frozen problems as texts and files: what the tests of frozen problems share.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>

#include "frozen/frozen_problem.hpp"

namespace cairn::testing {

inline std::string frozen_text(const FrozenProblem& frozen) {
  std::ostringstream out;
  write_frozen(out, frozen);
  return out.str();
}

/// A folder that is not there at first, and goes when the test does.
struct FrozenFolder {
  std::filesystem::path path = {};
  explicit FrozenFolder(const std::string& name) : path(std::filesystem::temp_directory_path() / name) {
    std::filesystem::remove_all(path);
  }
  ~FrozenFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  FrozenFolder(const FrozenFolder&) = delete;
  FrozenFolder& operator=(const FrozenFolder&) = delete;
};

}  // namespace cairn::testing
