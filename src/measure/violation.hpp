// Floor 6. How far a snapshot violates what must hold.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// Two bodies in each other.
struct Overlap {
  double depth = 0;                // [m]; 0: none
  BodyId a = {};                   // the body whose shape comes first
  BodyId b = {};                   // the other
  Vec2<double> normal = {0, 0};    // unit, from a to b
  Vec2<double> position = {0, 0};  // [m] where they are deepest in each other
  /// [m] of the thinner of the two shapes, measured along the normal; infinite where both are lines.
  double thickness = 0;
  bool one_sided = false;  // one of them is a link of a chain: what comes from behind it goes through
};

/// Of every two shapes of different bodies that overlap, of which one is dynamic. Measured on the shapes as
/// they stand now, not on the contacts that a solver saw: it is the same measure for every engine. Left out
/// are sensors, and pairs that a joint or their categories keep from touching.
List<Overlap> overlaps(const Snapshot& snapshot);
/// The deepest of them, and of those the first.
Overlap deepest_of(const List<Overlap>& overlaps);
/// The deepest overlap of all.
Overlap deepest_overlap(const Snapshot& snapshot);
/// Its depth [m]; 0 when no shapes overlap.
double worst_penetration(const Snapshot& snapshot);

/// The deepest overlap of the ground and a body that a joint keeps from touching it.
Overlap deepest_in_ground(const Snapshot& snapshot);

/// The largest drift of a joint [m or rad]; 0 without joints.
double worst_joint_drift(const Snapshot& snapshot);

/// The largest |friction impulse| - mu * normal impulse over the contacts [N s]; 0 when all are inside the
/// cone.
double worst_cone_violation(const Snapshot& snapshot);

/// The sum of all normal impulses between two bodies [N s], in whichever order they are named.
double normal_impulse_between(const Snapshot& snapshot, BodyId first, BodyId second);

/// The largest difference of any velocity component between two snapshots of one scene [m/s or rad/s].
/// @throws std::invalid_argument when they do not have equally many bodies.
double largest_velocity_gap(const Snapshot& first, const Snapshot& second);

}  // namespace cairn
