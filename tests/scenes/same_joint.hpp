// A joint from TOML beside the same one that is made by hand.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include <cairn/scenes/scene_file.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/world/world.hpp>

namespace cairn::scene_tests {

/// Three boxes a, b and c in a row.
inline const std::string three_boxes = R"(
[[body]]
name = "a"
box = [1, 1]
velocity = [0.5, 1]
[[body]]
name = "b"
box = [1, 0.5]
position = [2, 0]
angular_velocity = 3
[[body]]
name = "c"
box = [0.5, 1]
position = [4, 0]
)";

inline const BodyId a_box = {1}, b_box = {2}, c_box = {3};

inline Scene with_three_boxes() {
  Scene scene;
  scene.add({.shapes = {box(1, 1)}, .velocity = {0.5, 1}});
  scene.add({.shapes = {box(1, 0.5)}, .position = {2, 0}, .angular_velocity = 3});
  scene.add({.shapes = {box(0.5, 1)}, .position = {4, 0}});
  return scene;
}

/// Whether the joint of the text does what a joint of `spec` does, to the last bit, for half a second.
template <typename Joint>
void check_same_joint(const std::string& text, const typename Joint::Spec& spec,
                      JointCollision collision = JointCollision::as_usual) {
  CAPTURE(text);
  Scene by_hand = with_three_boxes();
  const TrialOptions options{.seconds = 0.5};
  const std::uint64_t without = run_trial(by_hand, {}, options).state_hash;
  by_hand.join<Joint>(spec, collision);
  const Scene from_text = read_scene_text(three_boxes + "[[joint]]\n" + text, "joint.toml").make();
  const TrialResult expected = run_trial(by_hand, {}, options), found = run_trial(from_text, {}, options);
  CHECK(found.steps == 30);
  CHECK(found.state_hash == expected.state_hash);
  CHECK(found.state_hash != without);  // the joint does something
  CHECK(from_text.joints().apart() == by_hand.joints().apart());
}

}  // namespace cairn::scene_tests
