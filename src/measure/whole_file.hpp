// Floor 6. Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace cairn {

/// Writes `<path>.part` beside the file and renames it, so that no reader ever sees half of one. Devices and
/// pipes are written directly.
/// @throws std::runtime_error "cannot write PATH: reason"; an earlier file is then as it was.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

}  // namespace cairn
