// Floor 7. Events as Box2D takes them, and refusing what it does not have.
#pragma once

#include <cairn/world/scene.hpp>

class b2Body;

namespace cairn {

/// @throws std::invalid_argument for one that waits for a touch, or changes a surface speed or a sensor.
void check_event(const SceneEvent& event);
/// @throws std::invalid_argument for static friction above that of sliding, rolling resistance, and impacts
/// that bodies pass on.
void check_surfaces(const Scene& scene);
/// @throws std::invalid_argument where one of them may break.
void check_strengths(const SceneJoints& joints);

/// Does the change to a body, whose material the scene has changed already.
void change_body(b2Body& body, const Material& material, const ChangeBody& change);

}  // namespace cairn
