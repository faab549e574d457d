// Floor 6. Writing beside, then renaming.
#include "measure/whole_file.hpp"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace cairn {

namespace {

/// Empty when all is written, else why it is not.
std::string write_directly(const std::filesystem::path& path, std::string_view text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();  // a full disk often shows only here
  if (file) return "";
  return errno != 0 ? std::generic_category().message(errno) : "the disk does not take it";
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  // A device must not be replaced by a file of its name; a folder cannot be.
  const bool is_direct = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  std::filesystem::path part = path;
  if (!is_direct) part += ".part";
  std::string reason = write_directly(part, text);
  if (reason.empty() && !is_direct) {
    std::filesystem::rename(part, path, error);
    reason = error ? error.message() : "";
  }
  if (reason.empty()) return;
  if (!is_direct) std::filesystem::remove(part, error);
  throw std::runtime_error("cannot write " + path.string() + ": " + reason);
}

}  // namespace cairn
