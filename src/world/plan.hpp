// Floor 5. What a scene requires, decided once; and what it lets the step leave out.
#pragma once

#include <string>

#include <cairn/collision/broadphase.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// How much there is in a scene.
struct SceneSize {
  int bodies = 0;                      // with the ground
  int dynamic_bodies = 0;              // those with velocities to solve for
  int turning_bodies = 0;              // dynamic bodies that can turn
  int colliders = 0;                   // shapes
  int pieces = 0;                      // those that are pieces of outlines
  int joints = 0;                      // of every kind
  int servos = 0;                      // motors with a target
  int joint_springs = 0;               // joints with a spring along what they leave free
  int ratchets = 0;                    // joints that go one way only
  List<std::string> shape_kinds = {};  // those that occur, sorted
  List<std::string> acting = {};       // what else acts on bodies or leads them
};

/// What else is solved in a substep.
enum class SecondSolve {
  none,
  from_start,   // again without the speed that moves errors back, from the same impulses
  from_answer,  // the same, from the impulses that the first solve found
  positions,    // velocities that move errors back and are forgotten
};

/// What few scenes require.
struct PlanExtras {
  bool surface_speed = false;       // some surface runs, and rubs on others
  bool static_friction = false;     // some surfaces that stick hold more than mu
  bool rolling_resistance = false;  // some resist rolling
  bool impact_sequence = false;     // rebounds may be passed on from body to body
  bool one_way = false;             // some body lets pass what comes from elsewhere than its outer side
  bool touches = false;             // some event waits for a touch
  bool breaks = false;              // some joint may break
};

/// Decided from the scene alone, before the first step.
struct Plan {
  SceneSettings settings = {};                            // with what the scene has left out
  double length = 1;                                      // [m] unit_length()
  std::string lengths = {};                               // lengths_text()
  SceneSize size = {};                                    // how much there is
  BroadphaseKind broadphase = BroadphaseKind::all_pairs;  // how pairs of shapes are found
  bool collision = false;                                 // some pair of shapes could meet
  bool gravity = false;                                   // some body feels it
  bool damping = false;                                   // some body has it
  bool friction = false;                                  // some pair of bodies with mu > 0
  bool restitution = false;                               // some body with e > 0
  PlanExtras extras = {};                                 // what few scenes have
  bool moves_manifolds = false;                           // manifolds last longer than a substep
  bool keeps_manifolds = false;                           // and longer than a step
  bool follows_arcs = false;                              // joints are asked to hold where a substep ends
  SecondSolve second_solve = SecondSolve::none;           // what else is solved

  /// Whether solvers that take contacts are given them without rows.
  bool contacts_without_rows() const {
    const bool is_plain = !extras.surface_speed && !extras.rolling_resistance && !extras.impact_sequence &&
                          (settings.friction_rows == FrictionRows::per_point || !friction);
    return collision && second_solve != SecondSolve::positions && is_plain;
  }
  /// Whether steps are looked at for what comes about in them.
  bool watches() const { return extras.touches || extras.breaks; }
  /// Whether the second solve is one of velocities.
  bool solves_again() const {
    return second_solve == SecondSolve::from_start || second_solve == SecondSolve::from_answer;
  }
};

/// What the scene requires.
Plan make_plan(const Scene& scene);

/// The plan in words: what is modelled, and what was left out and why. One line each.
std::string explain(const Plan& plan);

}  // namespace cairn
