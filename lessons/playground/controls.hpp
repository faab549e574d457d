// The settings that a student may change, in words.
#pragma once

#include <optional>
#include <string>

#include <cairn/scenes/setting.hpp>

namespace cairn::playground {

/// All that can be set.
struct Controls {
  Setting setting = {};                   // of the world that is looked at
  std::optional<std::string> other = {};  // a second solver beside it
  std::optional<double> friction = {};    // mu of all bodies; none: as the scene has it
  std::optional<double> bounce = {};      // e of all bodies; none: as the scene has it
  double gravity = 10;                    // [m/s^2], downwards where the scene has none
  double mass_ratio = 1;                  // by which the uppermost body is heavier than in the scene
};

/// Gives the control of that name a value. Its limits hold what the scene recommends, also where that is
/// beyond the usual ones.
/// @throws std::invalid_argument for an unknown control, with the nearest known one, and for a value that it
/// does not take.
void set_control(Controls& controls, const Controls& recommended, const std::string& name,
                 const std::string& value);

/// All controls as JSON, with what the scene recommends: an array of objects with name, title, value,
/// recommended, unit, least, most, choices and what these mean.
std::string controls_text(const Controls& controls, const Controls& recommended);

/// One control with its value, such as "Gravity 5 m/s^2".
std::string control_text(const Controls& controls, const std::string& name);

/// Whether both compute in the same number: then a world goes on from one to the other.
bool can_go_on(const Controls& from, const Controls& to);

}  // namespace cairn::playground
