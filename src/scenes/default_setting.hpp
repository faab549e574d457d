// Floor 8. The one setting for every scene of which nobody says how it is stepped.
#pragma once

#include <string>

#include <cairn/scenes/setting.hpp>

namespace cairn {

/// A setting, and why it is that one.
struct DefaultSetting {
  Setting setting = {};
  std::string reason = {};  // "36 freedoms: all rows are solved at once up to 300"
};

/// Chosen by the size of the scene alone: by its freedoms, three for each body that moves and turns, less the
/// rows of rigid joints. All rows at once (NewtonSolver) while that is cheap, and lanes
/// (WideSequentialImpulse) beyond; four substeps, or as many as the scene asks for where these are more. The
/// rest is as the scene has it.
DefaultSetting default_setting(const Scene& scene);

}  // namespace cairn
