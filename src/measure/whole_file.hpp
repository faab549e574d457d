// Floor 6. Files that are there whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include <cairn/math/list.hpp>

namespace cairn {

/// A file could not be written: the message names its path and the reason.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file in the making: it stands beside its place, under a name that nobody can guess, until finish() puts
/// it there. No reader ever sees half of it. Devices and pipes are written directly.
class WholeFile {
 public:
  /// Makes the folder too. @throws WriteError "cannot write PATH: reason", as all that follows.
  explicit WholeFile(std::filesystem::path path);
  /// Without finish() there is nothing left, and an earlier file is as it was.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Appends. @throws WriteError
  void write(std::string_view text);
  /// Appends. @throws WriteError
  void write(Span<const std::uint8_t> bytes);
  /// Replaces the file of that path. @throws WriteError
  void finish();
  /// Where it stands until then, for a program that writes it in our place.
  const std::filesystem::path& part() const { return part_; }

 private:
  std::filesystem::path path_;
  std::filesystem::path part_;  // path_ itself, of a device
  int file_ = -1;
  bool is_finished_ = false;
};

/// Writes all of a file, and makes its folder.
/// @throws WriteError "cannot write PATH: reason"; an earlier file is then as it was.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

}  // namespace cairn
