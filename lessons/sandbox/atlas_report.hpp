// cairn extremes --atlas: runs the maps, and draws them.
#pragma once

#include "lessons/sandbox/verb.hpp"

namespace cairn::sandbox {

/// The exit code. Explosions are what a map is there to show: they are no failure.
int run_atlas(const Words& words, Console& console);

}  // namespace cairn::sandbox
