// Floor 5. The unit of length of a scene, and what follows from it.
#pragma once

#include <string>

#include <cairn/world/scene.hpp>

namespace cairn {

/// [m] How long most bodies of the scene are: the median of sqrt(area) over its dynamic bodies, rounded to
/// the nearest power of two, so that a scene that is twice as large has exactly twice the length. 1 where no
/// dynamic body has an area.
double scene_length(const Scene& scene);

/// [m] The unit of length of a scene: scene_length(), or 300 g h^2 where that is more, what gravity g makes
/// fall in 24 substeps of h. Contacts come and go by a few g h^2, however small the bodies are: nothing finer
/// than that can be asked of them.
double unit_length(const Scene& scene);

/// The settings of a scene, in which what was left out follows from its unit of length L [m] and its gravity,
/// so that scenes of all sizes behave alike. With L = 1 m and 10 m/s^2 it is as each member says.
///   speculative_margin       L / 50
///   stabilization.slop       L / 200
///   stabilization.max_speed  the speed of a fall through 0.8 L; without gravity 4 L a second
///   restitution_threshold    the speed of a fall through L / 80; without gravity 0
SceneSettings full_settings(const SceneSettings& given, double length);
/// Those of a scene.
SceneSettings full_settings(const Scene& scene);

/// Lengths and speeds of full_settings() in words, those that the scene states marked as such.
std::string lengths_text(const SceneSettings& given, double length);

}  // namespace cairn
