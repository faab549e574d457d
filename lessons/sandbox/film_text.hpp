// Words and numbers in the frames of a film: none may grow without bounds, and a bad end is told.
#pragma once

#include <string>

#include "lessons/sandbox/scene_run.hpp"

namespace cairn::sandbox {

/// "0.02 mm", always as wide as long as it is of common size: in a film it must not jump about.
std::string error_text(double metres);

/// "t = 0.250 s · step 15", with as many decimals as tell steps apart, and room for the longest time.
std::string time_text(const Snapshot& now, const Snapshot& last);

/// How a run ended that did not end well, with the body to blame: "stopped at t = 0.5 s: body 3 (bomb) would
/// not be finite"; nothing for a run that did.
std::string ending_text(const SceneEntry& scene, const SceneRun& run);

}  // namespace cairn::sandbox
