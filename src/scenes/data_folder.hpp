// Floor 8. Where the files are that come with the programs.
#pragma once

#include <filesystem>

namespace cairn {

/// The folder of what comes with the programs, such as scenes: share/cairn of the prefix that the running
/// program was installed to, or of the folder that it was built in. No program remembers where its sources
/// were.
std::filesystem::path data_folder();

}  // namespace cairn
