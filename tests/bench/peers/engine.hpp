// A scene that an engine steps, whichever engine it is: Cairn, or one of its peers.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <cairn/constraints/constraint.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>
#include <cairn/scenes/setting.hpp>
#include <cairn/world/scene.hpp>

namespace cairn::bench {

/// A world of an engine. Sleeping and continuous collision are off; friction mixes as in Cairn, masses and
/// inertias are the scene's.
class Engine {
 public:
  virtual ~Engine() = default;
  /// One step of the scene's dt: all that is timed.
  virtual void step() = 0;
  /// Where the centres of mass are, in the scene's order.
  virtual PerBody<Pose<double>> poses() const = 0;
  /// [m/s, m/s, rad/s] of the centres of mass, in the scene's order.
  virtual PerBody<Vec3<double>> velocities() const = 0;
};

/// How hard a peer works. What it has no use for it ignores.
struct PeerSettings {
  int iterations = 10;          // sweeps over the velocities, each step
  int position_iterations = 3;  // of Box2D 2.4.1
  int substeps = 4;             // of Box2D 3
};

// Each throws std::invalid_argument for a scene that its engine cannot run, and says why. Those whose library
// was not there when this was built are not defined.

/// The step of the scene is the setting's.
std::unique_ptr<Engine> make_cairn(const Scene& scene, const Setting& setting);
/// Box2D 2.4.1, without the listener that cairn::Box2DWorld has for its snapshots.
std::unique_ptr<Engine> make_box2d_2(const Scene& scene, const PeerSettings& settings);
std::unique_ptr<Engine> make_box2d_3(const Scene& scene, const PeerSettings& settings);
/// Chipmunk 7. Its slop of 0.1 is meant for pixels; here it is that of the others, 0.005 m.
std::unique_ptr<Engine> make_chipmunk(const Scene& scene, const PeerSettings& settings);
/// Bullet, whose bodies are kept in the plane, with its collision of boxes in the plane.
std::unique_ptr<Engine> make_bullet(const Scene& scene, const PeerSettings& settings);

/// A part of what is done again and again, as of every step.
struct Phase {
  std::string name = {};
  List<double> seconds = {};  // each time
};

/// Where the time of some steps went.
struct Phases {
  List<Phase> parts = {};
  int points = 0;  // of contact, in a step on average; only Cairn's are counted
};

/// The solver, and all else that the steps do.
Phases phases_of_cairn(const Scene& scene, const Setting& setting, int steps);
/// Its profile, by the clock on the wall.
Phases phases_of_box2d_3(const Scene& scene, const PeerSettings& settings, int steps);

// What it takes to add `body` to a scene of many, so many times: each time one more. The first steps of the
// world are not among what is timed.

/// To a scene; to a world that runs; the step after that; and a copy of such a world.
List<Phase> edits_of_cairn(const Scene& scene, const BodySpec& body, int times);
/// To a world that runs, and the step after that. Its worlds cannot be copied.
List<Phase> edits_of_box2d_3(const Scene& scene, const BodySpec& body, int times);

// What was found of each: "3.2.0".

std::string box2d_3_version();
std::string chipmunk_version();
std::string bullet_version();

/// A pin through two bodies, in words that every engine has. Angles are those of b, seen from a.
struct Pin {
  BodyId a = {}, b = {};
  Vec2<double> anchor_a = {0, 0}, anchor_b = {0, 0};  // [m] in the frames of the bodies
  double start = 0;                                   // [rad] of the scene: from there limits count
  std::optional<double> lower = {}, upper = {};       // [rad]; both or neither
  std::optional<JointMotor> motor = {};
  bool touch = false;  // the bodies may
};

/// The joints of a scene. @throws std::invalid_argument for one that is no pin, and for one that has a lower
/// limit or an upper one alone: no scene here has them.
List<Pin> pins_of(const Scene& scene);

}  // namespace cairn::bench
