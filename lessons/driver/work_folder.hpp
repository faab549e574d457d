// A place for what is not finished yet.
#pragma once

#include <filesystem>

namespace cairn::driver {

/// A new folder in `parent`, under a name that was free; it is gone when this is. So is `parent`, where it
/// was made for it and is empty.
struct WorkFolder {
  std::filesystem::path path = {};

  /// @throws WriteError "cannot write PARENT: reason".
  explicit WorkFolder(const std::filesystem::path& parent);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

 private:
  std::filesystem::path topmost_made_ = {};  // of the folders around it; empty: all were there
};

/// Puts a finished file or folder in its place. @throws WriteError "cannot write TO: reason".
void move_to(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace cairn::driver
