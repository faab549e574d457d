// Floor 6. Writing beside, then renaming.
#include <cairn/measure/whole_file.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace cairn {

namespace {

namespace fs = std::filesystem;

constexpr mode_t readable_as_usual = 0666;  // less what the user's umask takes away

[[noreturn]] void fail_write(const fs::path& path, const std::error_code& error) {
  throw WriteError("cannot write " + path.string() + ": " + error.message());
}

std::error_code last_error() { return {errno, std::generic_category()}; }

}  // namespace

WholeFile::WholeFile(fs::path path) : path_(std::move(path)), part_(path_) {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  // A device must not be replaced by a file of its name; a folder cannot be.
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail_write(path_, last_error());
    return;
  }
  error.clear();  // there may be no file yet
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
  if (error) fail_write(path_, error);
  do {
    std::uint64_t number = 0;
    if (getentropy(&number, sizeof number) != 0) fail_write(path_, last_error());
    part_ = path_;
    part_ += fmt::format(".{:016x}.part", number);
    // O_EXCL refuses whatever stands there, a link too.
    file_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, readable_as_usual);
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0) fail_write(path_, last_error());
}

WholeFile::~WholeFile() {
  if (file_ >= 0) close(file_);
  if (!is_finished_ && part_ != path_) unlink(part_.c_str());
}

void WholeFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_write(path_, last_error());
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void WholeFile::write(Span<const std::uint8_t> bytes) {
  write({reinterpret_cast<const char*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
}

void WholeFile::finish() {
  // A full disk sometimes shows only here.
  if (close(std::exchange(file_, -1)) != 0) fail_write(path_, last_error());
  if (part_ != path_ && rename(part_.c_str(), path_.c_str()) != 0) fail_write(path_, last_error());
  is_finished_ = true;
}

void write_whole_file(const fs::path& path, std::string_view text) {
  WholeFile file(path);
  file.write(text);
  file.finish();
}

}  // namespace cairn
