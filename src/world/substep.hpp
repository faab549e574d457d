// Floor 5. What the parts of a world are given of a substep.
#pragma once

#include <cstdint>

#include <cairn/constraints/drag_joint.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/world/acting.hpp>
#include <cairn/world/body_kinds.hpp>
#include <cairn/world/plan.hpp>
#include <cairn/world/sleeping.hpp>

namespace cairn {

/// A world where a substep begins. Joints are those of its scene, then that of the hand, where it holds
/// something.
template <Scalar Real>
struct Substep {
  /// RowKey::source of the hand's rows; those of joints are their ids.
  static constexpr std::uint64_t hand_source = std::uint64_t{1} << 62;

  const Scene& scene;                 // that moves
  const Plan& plan;                   // of the scene
  const BodyKinds<Real>& kinds;       // of its bodies
  const BodyState<Real>& state;       // where these are, and how fast
  const DragJoint* hand = nullptr;    // null: it holds nothing
  SleepState<Real>* sleep = nullptr;  // null: nobody sleeps
  const Acting<Real>* acting = nullptr;  // null: nothing else acts on bodies
  SubstepTime when = {};                 // in the life of the world
  Real dt = 1;                        // [s] of the substep
  Real step_dt = 1;                   // [s] of the step

  /// Of all joints.
  int joint_count() const { return scene.joints().size() + (hand ? 1 : 0); }
  /// Whether one is that of the hand.
  bool is_hand(int joint) const { return joint == scene.joints().size(); }
  /// One of them.
  const Constraint& joint(int number) const { return is_hand(number) ? *hand : *scene.joints()[number]; }
  /// RowKey::source of its rows.
  std::uint64_t source(int joint) const {
    return is_hand(joint) ? hand_source : static_cast<std::uint64_t>(scene.joints().id(joint).index);
  }
  /// Whether its bodies sleep; the hand holds none that does.
  bool asleep(int joint) const { return sleep && !is_hand(joint) && sleep->joint_asleep(joint); }
  /// v + time M^-1 f: as bodies go on while nothing holds them. What sleeps stays.
  void add_forces(PerBody<Vec3<Real>>& velocity, Real time) const {
    if (plan.gravity)
      kinds.pull(velocity, state.inverse_mass, scene.settings().gravity.template cast<Real>(),
                 acting ? acting->kick(when, time) : time);
    if (acting) acting->add(state, when, time, velocity);
    if (plan.damping) kinds.damp(velocity, state.inverse_mass, time);
    if (sleep) sleep->hold(velocity);
  }
};

}  // namespace cairn
