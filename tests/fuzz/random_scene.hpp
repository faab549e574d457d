// Scenes with a bit of everything, and changes to them, from choices.
#pragma once

#include "fuzz/choices.hpp"
#include <cairn/world/scene.hpp>

namespace cairn::fuzz {

/// In every second one, contacts are all that there is to solve.
Scene random_scene(Choices& choices);
/// A body of the scene or, sometimes, none of it.
BodyId random_body(const Scene& scene, Choices& choices);
/// Adds, removes and changes a few things. What the scene refuses is left out.
void edit_randomly(Scene& scene, Choices& choices);
/// Other rules for the same things. @throws std::invalid_argument as Scene::set_settings.
void change_rules(Scene& scene, Choices& choices);

}  // namespace cairn::fuzz
