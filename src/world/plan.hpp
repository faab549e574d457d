// Floor 5. What a scene requires, decided once; and what it lets the step leave out.
#pragma once

#include <string>

#include "collision/broadphase.hpp"
#include "world/scene.hpp"
#include "math/list.hpp"

namespace cairn {

/// Decided from the scene alone, before the first step.
struct Plan {
  SceneSettings settings = {};                            // with what the scene has left out
  double length = 1;                                      // [m] unit_length()
  int bodies = 0;                                         // with the ground
  int dynamic_bodies = 0;                                 // those with velocities to solve for
  int turning_bodies = 0;                                 // dynamic bodies that can turn
  int colliders = 0;                                      // shapes
  int joints = 0;                                         // of every kind
  BroadphaseKind broadphase = BroadphaseKind::all_pairs;  // how pairs of shapes are found
  bool collision = false;                                 // some pair of shapes could meet
  bool gravity = false;                                   // some body feels it
  bool damping = false;                                   // some body has it
  bool friction = false;                                  // some pair of bodies with mu > 0
  FrictionRows friction_rows = FrictionRows::per_point;   // one for each point or for each manifold
  bool restitution = false;                               // some body with e > 0
  bool warm_start = false;                                // solves begin from last step's impulses
  int substeps = 1;                                       // in a step
  bool moves_manifolds = false;                           // manifolds last longer than a substep
  bool keeps_manifolds = false;                           // and longer than a step
  bool relaxes = false;                // a second solve takes out the speed that moved errors back
  bool goes_on_from_first = false;     // and begins from the first one's answer
  bool follows_arcs = false;           // joints are asked to hold where a substep ends
  bool corrects_positions = false;     // a second solve removes errors
  bool sleeping = false;               // islands at rest take no part
  bool contacts_without_rows = false;  // some solvers take them so
  List<std::string> shape_kinds = {};  // those that occur, sorted
  std::string lengths = {};            // lengths_text()
};

/// What the scene requires.
Plan make_plan(const Scene& scene);

/// The plan in words: what is modelled, and what was left out and why. One line each.
std::string explain(const Plan& plan);

}  // namespace cairn
