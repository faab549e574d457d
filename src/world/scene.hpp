// Floor 5. A scene: what there is, before anything moves.
#pragma once

#include <memory>
#include <optional>

#include <cairn/constraints/constraint.hpp>
#include <cairn/constraints/contact.hpp>
#include <cairn/constraints/stabilization.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/dynamics/fields.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>
#include <cairn/math/shared_list.hpp>
#include <cairn/world/scene_event.hpp>
#include <cairn/world/scene_joints.hpp>
#include <cairn/world/scene_mixing.hpp>

namespace cairn {

/// When bodies that touch or are joined fall asleep: once all of them have been slower than this for `time`,
/// and have kept their places (SleepState).
struct Sleeping {
  double speed = 0.05;          // [m/s] of the centre of mass
  double angular_speed = 0.05;  // [rad/s]
  double time = 0.5;            // [s]

  /// Member by member.
  bool operator==(const Sleeping&) const = default;
};

/// How often shapes are compared with each other to find out where they touch. In between, manifolds move
/// with their bodies: what is left out are changes of the features that touch.
enum class ContactSearch {
  every_substep,  // the reference for the others
  every_step,     // the substeps of a step share what was found
  when_moved,     // pairs that have hardly moved beside each other keep what was found in an earlier step
};

/// What becomes of impacts that happen at the same time.
enum class Impacts {
  at_once,   // Newton's law for all of them together: of touching balls all that are struck part
  sequence,  // one after the other where the bodies pass them on (world/impact_sequence.hpp)
};

/// What holds for the whole scene, and how it steps.
struct SceneSettings {
  /// That a scene, its file or a flag may ask for.
  static constexpr int most_substeps = 1'000'000;

  Vec2<double> gravity = {0, -10};   // [m/s^2]
  Fields fields = {};                // wind, water and attractions
  double dt = 1.0 / 60;              // [s] one step
  int substeps = 1;                  // a step is so many steps of dt / substeps, each solved anew
  Stabilization stabilization = {};  // how errors in positions are taken back
  bool warm_start = true;            // begin from last step's impulses
  ContactSearch contact_search = ContactSearch::every_substep;  // how long manifolds last
  /// [m] Shapes closer than this get contact rows with room to spare. Left out: 0.02 of the unit of
  /// length (world/scene_length.hpp).
  std::optional<double> speculative_margin = {};
  /// [m/s] Slower approaches do not rebound. Left out: the speed of a fall through 1/80 of that length, which
  /// is 0.5 of bodies of 1 m; 0 without gravity.
  std::optional<double> restitution_threshold = {};
  FrictionRows friction_rows = FrictionRows::per_point;  // one for each point or for each manifold
  Mixing mixing = {};                                    // what two surfaces have in common
  Impacts impacts = Impacts::at_once;                    // where several bodies strike each other
  /// Bodies that have come to rest are left out of the steps until something wakes them. Off: none ever is.
  std::optional<Sleeping> sleeping = {};

  /// Member by member.
  bool operator==(const SceneSettings&) const = default;
};

/// How fast a body loses velocity where nothing touches it.
struct Damping {
  double linear = 0;     // [1/s]
  double angular = 0;    // [1/s]
  double quadratic = 0;  // [kg/m] against the air, by this times the square of the speed: rho c_d A / 2

  /// Member by member.
  bool operator==(const Damping&) const = default;
};

/// One body. Its mass is `mass`, or else density times area; its inertia follows from the shapes.
struct BodySpec {
  BodyType type = BodyType::dynamic;      // static, kinematic or dynamic
  SharedList<Shape<double>> shapes = {};  // in the frame of `position` and `angle`; may be none
  Vec2<double> position = {0, 0};         // [m] of the frame that the shapes are given in
  double angle = 0;                       // [rad]
  Vec2<double> velocity = {0, 0};         // [m/s] of the centre of mass
  double angular_velocity = 0;            // [rad/s]
  std::optional<double> mass = {};        // [kg]
  std::optional<double> inertia = {};     // [kg m^2] about the centre of mass
  double density = 1;                     // [kg/m^2]
  Material material = {};                 // of its surface
  Damping damping = {};                   // of its velocity
  double gravity_scale = 1;               // how many times the gravity of the scene it feels
  bool fixed_rotation = false;            // never turns: 1/I is 0
  bool sensor = false;          // is seen to touch (StepRecord::sensed), and neither pushes nor is pushed
  CollisionFilter filter = {};  // with which others it collides

  /// Member by member.
  bool operator==(const BodySpec&) const = default;
};

/// The surface of the ground.
struct GroundSpec {
  double height = 0;       // [m] of its surface
  double half_width = 50;  // [m] wide enough for bodies of 1 m, and so is
  double thickness = 1;    // [m] this; scene files say more of both where bodies are larger
  Material material = {};  // of its surface
};

/// A body as the scene keeps it: its frame is at the centre of mass, and its shapes are moved accordingly.
struct SceneBody {
  BodySpec spec = {};       // with its shapes in the frame of `pose`
  Pose<double> pose = {};   // [m, rad] of the centre of mass
  double mass = 0;          // [kg]; 0 unless dynamic
  double inertia = 0;       // [kg m^2]; 0 unless it can turn
  double area = 0;          // [m^2] of its shapes: their mass at density 1
  double area_inertia = 0;  // [m^4] likewise, about the centre of mass
  bool removed = false;     // an empty place: static, without shapes, and nothing can be fastened to it
};

/// Whether the bodies of a joint may touch each other.
enum class JointCollision {
  as_usual,  // as the kind of joint says: most keep their bodies apart
  off,
  on,
};

/// Body 0 is the ground: it is always there, and has a surface once add_ground was called.
/// Every function refuses bad input with std::invalid_argument, naming field, rule, unit and value.
///
/// Threads: a scene that no thread changes may be read and copied by any number of them. Each may change
/// scenes of its own, though they be copies of one another.
class Scene {
 public:
  /// Holds the ground and nothing else.
  /// @throws std::invalid_argument for settings out of range.
  explicit Scene(const SceneSettings& settings = {});

  /// @throws std::invalid_argument, also for a dynamic body without area and without mass.
  BodyId add(const BodySpec& spec);
  /// Gives the ground a flat surface.
  BodyId add_ground(const GroundSpec& spec = {});
  /// A joint from its Spec, whose anchors are in world coordinates where the bodies stand now.
  /// @throws std::invalid_argument for unknown bodies, or none that can move.
  template <typename Joint>
  JointId join(const typename Joint::Spec& spec, JointCollision collision = JointCollision::as_usual) {
    const PerBody<Pose<double>> start = poses();
    if constexpr (requires { spec.a; }) require_body(spec.a, "a");
    if constexpr (requires { spec.b; }) require_body(spec.b, "b");
    if constexpr (requires { spec.c; }) require_body(spec.c, "c");
    return join(std::make_shared<const Joint>(spec, start), collision);
  }
  /// Any constraint, one of your own too.
  JointId join(std::shared_ptr<const Constraint> joint, JointCollision collision = JointCollision::as_usual);
  /// Something that is to happen while the scene runs: a world does it in its steps. It is forgotten where
  /// its body or joint is removed before, or all bodies whose touch it waits for; a count stays.
  /// @throws std::invalid_argument unless the time is finite and not negative, for what is not in the scene,
  /// for impulses and forces on the ground and on what cannot move, for a path of a body that is not
  /// kinematic, leads nowhere, or would begin at more than one touch, for a motor or a body that change()
  /// refuses, for velocities of what is static, for a touch of bodies of which none is dynamic, and for a
  /// count that waits for none.
  void add(const SceneEvent& event);
  /// The same bodies and joints under other rules. @throws std::invalid_argument, and then changes nothing.
  void set_settings(const SceneSettings& settings);
  /// Puts the centre of mass of a body where `pose` says [m, rad], to begin at `velocity` [m/s, m/s, rad/s].
  /// Its joints stay fastened to it where they are, and so begin with an error.
  /// @throws std::invalid_argument for the ground, unknown and removed bodies, numbers that are not finite,
  /// and where a static body would move.
  void place(BodyId body, const Pose<double>& pose, const Vec3<double>& velocity);
  /// Gives a body another spec: bodies()[body].spec with fields changed, so that its shapes are in the frame
  /// of the centre of mass. Position and angle stay as they are. Where new shapes have another centre of
  /// mass, the frame moves there, and the shapes stay where they are in the world; a body with joints, which
  /// are fastened in that frame, must keep its centre.
  /// @throws std::invalid_argument for the ground, unknown and removed bodies, what add() refuses, another
  /// position or angle, another centre of mass while there are joints, and a joint that would be left without
  /// a body that can move.
  void change(BodyId body, const BodySpec& spec);
  /// Gives a joint another motor in place of its own; none takes it away.
  /// @throws std::invalid_argument for a joint that is not in the scene, for one that can have no motor, and
  /// for what its class refuses.
  void change(JointId joint, const std::optional<JointMotor>& motor);
  /// Gives a joint a spring of its own under the policy soft, in place of Stabilization::joint_soft. It is of
  /// the rows that hold positions; under other policies it does nothing.
  /// @throws std::invalid_argument for a joint that is not in the scene and for a spring out of range.
  void change(JointId joint, const SwingSoftness& spring);
  /// Lets a joint break above a force or a torque.
  /// @throws std::invalid_argument for a joint that is not in the scene, unless both are > 0, and for a
  /// finite torque of a joint of more than two bodies.
  void change(JointId joint, const JointStrength& strength);
  /// Takes a body out, with every joint that holds it. Other bodies keep their ids, and its own is not used
  /// again: its place stays, static, without shapes and marked as removed.
  /// @throws std::invalid_argument for the ground, unknown and removed bodies.
  void remove(BodyId body);
  /// Takes a joint out. Its bodies may touch from now on, unless another joint keeps them apart.
  /// @throws std::invalid_argument for a joint that is not in the scene.
  void remove(JointId joint);
  /// Does all events whose time has come by `until` [s], in their order. Whether there were any. What lasts
  /// (lasting_action.hpp) stays among them, and so do events that wait for a touch.
  bool do_events(double until);
  /// What waits for a touch has come about at `time` [s]: those of these numbers in events(), which ascend
  /// and may come more than once. Each is counted, or becomes an event of its time.
  void do_events(const List<int>& met, double time);

  /// What holds for the whole scene.
  const SceneSettings& settings() const { return settings_; }
  /// In the order of their ids; the ground is the first. As long as the scene lives and is left alone.
  const PerBody<SceneBody>& bodies() const { return *bodies_; }
  /// In the order in which they were added, with their ids, and who is kept apart by them.
  const SceneJoints& joints() const { return joints_; }
  /// What is still to happen, or lasts, by time; those of one time in the order in which they were added.
  /// Behind them, in the order in which they were added, those that wait for a touch.
  const List<SceneEvent>& events() const { return events_; }

 private:
  PerBody<SceneBody>& own_bodies();
  PerBody<Pose<double>> poses() const;
  bool holds(int joint, BodyId body, const PerBody<Pose<double>>& start) const;
  bool has_joints(BodyId body) const;
  int number_of(JointId joint, const char* who) const;
  std::shared_ptr<const Constraint> with_motor(JointId joint, const std::optional<JointMotor>& motor,
                                               const char* who) const;
  void forget_events();
  void schedule(const SceneEvent& event);
  void require_body(BodyId id, const char* field) const;
  void require_other_movers(BodyId body, BodyType type) const;

  SceneSettings settings_;
  std::shared_ptr<PerBody<SceneBody>> bodies_;  // copies of the scene have the same until one is changed
  SceneJoints joints_;
  List<SceneEvent> events_;  // as events()
};

/// Moves a body by `offset` [m] and turns it about its centre of mass by `angle` [rad], as Scene::place does.
/// @throws std::invalid_argument for the ground, unknown and removed bodies and numbers that are not finite.
void displace(Scene& scene, BodyId body, const Vec2<double>& offset, double angle = 0);

/// A body as an event leaves it.
BodySpec changed(BodySpec spec, const ChangeBody& change);

/// What may be placed, changed and removed. @throws std::invalid_argument unless it is a body of the scene
/// other than the ground, and was not removed.
void require_changeable(const Scene& scene, BodyId body, const char* place);

/// @throws std::invalid_argument unless dt is from 1e-12 to 1e6 s.
void require_time_step(double dt, const char* place);

}  // namespace cairn
