// What the map of settings is told as.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/sandbox/verb.hpp"

namespace cairn::sandbox {

/// Writes level3.csv and map.png, prints how the runs ended and which one setting does for most scenes.
/// @throws std::invalid_argument for a table of another kind.
int report_map(const Words& words, const std::string& csv, const std::filesystem::path& folder,
               Console& console);

}  // namespace cairn::sandbox
