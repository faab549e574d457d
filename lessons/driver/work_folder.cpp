// Folders that nobody else has, and that leave nothing behind.
#include "lessons/driver/work_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <cairn/measure/whole_file.hpp>

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const fs::path& place, const std::error_code& error) {
  throw WriteError("cannot write " + place.string() + ": " + error.message());
}

/// The first folder on the way to this one that is not there yet.
fs::path first_missing(const fs::path& folder) {
  fs::path missing;
  std::error_code ignored;
  for (fs::path place = folder; !place.empty() && !fs::exists(place, ignored); place = place.parent_path())
    missing = place;
  return missing;
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& parent) {
  const fs::path folder = fs::absolute(parent).lexically_normal();
  topmost_made_ = first_missing(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_to_write(parent, error);
  std::string name = (folder / "unfinished_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) fail_to_write(parent, {errno, std::generic_category()});
  path = name;
}

WorkFolder::~WorkFolder() {
  std::error_code error;
  fs::remove_all(path, error);
  if (topmost_made_.empty()) return;
  for (fs::path place = path.parent_path(); fs::remove(place, error); place = place.parent_path()) {
    if (place == topmost_made_) return;
  }
}

void move_to(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) fail_to_write(to, error);
}

}  // namespace cairn::driver
