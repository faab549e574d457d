// Floor 7. The same scene, stepped by Box2D 2.4.1: a second opinion for tests, lessons and
// comparisons.
#pragma once

#include <memory>

#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// What Box2D can be told besides the scene. Gravity, dt, warm starting and the restitution threshold come
/// from the scene's settings; its stabilization and speculative margin have no meaning to Box2D, which uses
/// constants.
struct Box2DSettings {
  /// The order in which Box2D creates the bodies. It begins its walk over the contacts at the body created
  /// last, and solves them in the order of the walk: with `last_first` a tower built from the ground up is
  /// solved from the ground up, as Cairn does it; with `first_first` from the top down.
  enum class Creation { last_first, first_first };

  int velocity_iterations = 8;  // sweeps over the velocities, each step
  int position_iterations = 3;  // sweeps over the positions, each step
  bool sleeping = false;        // bodies that hardly moved for half a second are no longer simulated
  /// Bodies cannot pass through static ones within a step. Box2D then solves contacts with static bodies a
  /// second time after the sweeps, so that the impulses of a step are no longer those of its solver alone.
  bool continuous = false;
  Creation creation = Creation::last_first;  // which body comes first
};

/// A scene in Box2D 2.4.1, in single precision. `fast` means nothing to it. Masses, inertias and centres of
/// mass are Cairn's, friction and restitution mix by the same rules, and damping has the same formula.
/// Forces, fields and paths are Cairn's too, given to Box2D as velocities before its step.
/// Different are:
/// - Polygons and segments carry a skin of 0.01 m, and shapes may sink 0.005 m into each other's skins: two
///   polygons rest 0.015 m apart, a circle 0.005 m above a polygon.
/// - A capsule is two circles and a box between them, which begins 0.01 m below its surface.
/// - Contact rows exist only where skins overlap; there is no Baumgarte term in the velocities, but a pass
///   over the positions of its own.
/// - Friction rows come before normal rows, and the two normal rows of a manifold are solved together, unless
///   they are (nearly) the same row: then the first carries all.
/// - Springs are implicit Euler, and lose what Cairn's keep; the rope of a pulley pushes, too; the ends of a
///   rope come no nearer than 0.005 m; a drag has its limit in any direction, and slows turning; a servo is a
///   motor whose speed is set before each step.
/// - Restitution takes the approach speed after gravity has acted, and no body moves more than 2 m or turns
///   more than a quarter turn in a step.
class Box2DWorld {
 public:
  /// Copies what it needs of the scene.
  /// @throws std::invalid_argument for what Box2D 2.4.1 does not have: rounded polygons, polygons of more
  /// than 8 vertices, categories beyond 16 bits; rods, ropes and springs shorter than 0.005 m, elastic ropes,
  /// springs and ratchets of pins and slides, motors of slots, welds that are soft in their place, square
  /// friction, pulleys of other than two ends on the ground, gears but of bodies that pins or slides hold to
  /// the ground, differentials; for sensors, capsules of a radius of 0.02 m or less; for one-way bodies and
  /// joints that may break; for events that wait for a touch, or change a surface speed or a sensor; and for
  /// negative iteration counts.
  explicit Box2DWorld(const Scene& scene, const Box2DSettings& settings = {});
  ~Box2DWorld();
  Box2DWorld(const Box2DWorld&) = delete;
  Box2DWorld& operator=(const Box2DWorld&) = delete;

  /// Does the scene's events that are due before the next step, which begins with it. Whether there were any.
  bool do_events();
  /// One step of the scene's dt.
  void step();

  /// In the conventions of Cairn's own snapshots: contacts are ordered by colliders, lie where the step found
  /// them, and have the separation of the scene's shapes, without Box2D's skins. Impulses are those of the
  /// whole step. A body that sleeps keeps the contacts of its last step awake.
  Snapshot snapshot() const;

  /// Whether Box2D still simulates the body. @throws std::invalid_argument for unknown bodies.
  bool is_awake(BodyId body) const;

 private:
  struct Simulation;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace cairn
