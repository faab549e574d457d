// Floor 5. A world: the state of a scene that moves, and the step that moves it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "constraints/contact.hpp"
#include "constraints/drag_joint.hpp"
#include "dynamics/integrate.hpp"
#include "constraints/contact_problem.hpp"
#include "solvers/solver.hpp"
#include "world/body_traits.hpp"
#include "world/collider.hpp"
#include "world/contact_graph.hpp"
#include "world/look_ahead.hpp"
#include "world/made_once.hpp"
#include "world/occupation.hpp"
#include "world/pins.hpp"
#include "world/plan.hpp"
#include "world/scene.hpp"
#include "world/sleeping.hpp"
#include "world/snapshot.hpp"
#include "world/step_report.hpp"
#include "math/list.hpp"

namespace cairn {

/// What a hand does before a step: takes hold of a body, goes on to another target, or lets go.
struct HandInput {
  /// The three things that it does.
  enum class Kind { grab, drag_to, let_go };

  int step = 0;                  // World::steps() when it was done
  Kind kind = Kind::let_go;      // what was done
  DragJoint::Spec grip = {};     // of grab
  Vec2<double> target = {0, 0};  // [m] of drag_to
};

/// A copyable value: `World twin = world;`. The scene is shared and never changes. Owns no solver.
///
/// Threads: each may have worlds of its own, though they be copies of one another or made of one scene; what
/// these share never changes. A world that no thread changes may be read and copied by any number of them:
/// that is all that is const. A solver or an observer takes part in one step at a time.
///
/// What is given to a world to be called, as the change of edit(), an observer or a joint of one's own, may
/// read that world and step copies of it. Whatever would change it, an assignment too, throws
/// std::logic_error there.
template <Scalar Real = double>
class World {
 public:
  /// Begins where the scene's bodies stand, at time 0, before its events.
  /// @throws std::invalid_argument for a body that Real has no number for, or which stands so far from the
  /// origin that Real cannot tell positions within it apart; and for one that springs of policy soft would
  /// let through.
  explicit World(Scene scene);

  /// One step of dt, in as many substeps as the scene asks for. The same bits for the same scene, solver and
  /// number of steps. @throws std::length_error for more pairs of shapes near each other than
  /// Broadphase::max_pairs, and for more rows than the solver takes; TimeUp; what events, solvers, observers
  /// and joints throw; and std::logic_error from within a step or an edit of this world. Then the step is not
  /// done: bodies, time, events and hand are as before it, but last_step() may be empty. The next step has
  /// the bits that it would have had; only where the scene has substeps it may begin from impulses of those
  /// that were done, with what these woke awake.
  StepReport step(Solver<Real>& solver, SolveObserver<Real>* observer = nullptr);
  /// The problem that step() would hand to its solver now: changes nothing.
  VelocityProblem<Real> velocity_problem() const;

  /// From the next step on [s]; impulses are carried over in proportion.
  /// @throws std::invalid_argument unless dt is from 1e-12 to 1e6 s.
  void set_dt(double dt);
  /// Gives a body another velocity [m/s, m/s, rad/s].
  /// @throws std::invalid_argument for unknown or static bodies and numbers that are not finite.
  void set_velocity(BodyId body, const Vec3<double>& velocity);
  /// Wakes a body with all of its island, which may sleep again after the time that the scene asks for.
  /// @throws std::invalid_argument for unknown bodies.
  void wake(BodyId body);
  /// Changes the scene in mid-run: change(scene) is given the scene as it is now, its bodies standing and
  /// moving as they do, and may add, remove and change whatever it likes. Bodies and joints that it leaves
  /// alone keep their state, their impulses and their sleep to the last bit; what it changes wakes, and so
  /// does what touched or held it. last_step() is empty until the next one.
  /// @throws what `change` throws, what the constructor refuses, and std::logic_error from within a step or
  /// an edit of this world: then nothing has changed.
  void edit(const std::function<void(Scene&)>& change);

  /// Does what the scene's events have due before the next step, which begins with it: an event happens
  /// before the first step that begins at its time or later, and then is no longer in scene(). Whether any
  /// did.
  /// @throws as edit().
  bool do_events();

  /// A hand takes hold of a body, in place of what it held before, and pulls it to grip.target.
  /// @throws std::invalid_argument as DragJoint, and for a body that is not dynamic.
  void grab(const DragJoint::Spec& grip);
  /// The hand pulls what it holds to another point [m].
  /// @throws std::invalid_argument where it holds nothing, and for numbers that are not finite.
  void drag_to(const Vec2<double>& target);
  /// The hand lets go of what it holds, if it holds anything.
  void let_go();
  /// What the hand holds; null: nothing.
  const DragJoint* hand() const { return hand_.get(); }
  /// All that the hand has done. A world that begins as this one did, and for which each is repeated before
  /// the step of its number, takes the same steps to the last bit.
  const List<HandInput>& hand_inputs() const { return hand_inputs_; }
  /// Does once more what a hand did. @throws as grab() and drag_to().
  void repeat(const HandInput& input);

  /// Whether the body takes part in the steps: always, unless it sleeps.
  bool is_awake(BodyId body) const { return !sleep_ || !sleep_->asleep(body); }

  /// Poses and velocities now.
  const BodyState<Real>& bodies() const { return state_; }
  /// What it was made from.
  const Scene& scene() const { return *scene_; }
  /// What the scene requires, decided when the world was made.
  const Plan& plan() const { return *plan_; }
  /// What the last step saw; empty before the first. Where the step needed no rows, they are written when
  /// this is first called. As long as the world is left alone.
  const StepRecord<Real>& last_step() const {
    return has_rows_ ? record_ : written_.get([this] { return with_rows(); });
  }
  /// What has passed since the start.
  double time() const { return time_; }  // [s]

  /// How many were taken.
  int steps() const { return steps_; }
  /// Of the next step.
  double dt() const { return dt_; }  // [s]

 private:
  using Collider = cairn::Collider<Real>;
  using JointImpulses = BlockImpulses<List<RowImpulse<Real>>, Real>;

  /// What contacts that are looked for do to bodies that go on.
  struct Stops {
    bool of_movable_wait = true;  // those of two bodies of which neither is stopped yet
    bool are_new = false;         // some are
    bool are_waiting = false;     // some do
  };

  /// The length of a substep [s].
  Real substep_length() const { return static_cast<Real>(dt_ / scene_->settings().substeps); }
  World after(const std::function<void(Scene&)>& change);
  std::optional<World> after_events();
  StepReport take_step(Solver<Real>& solver, SolveObserver<Real>* observer);
  void leave_step();
  void substep(int number, Solver<Real>& solver, SolveObserver<Real>* observer, StepReport& report);
  void find_contacts(ContactSolver<Real>* solver);
  void find_manifolds(ContactSolver<Real>* solver);
  void move_manifolds();
  void put_manifolds();
  void meet_all();
  template <typename Find>
  void find_with_others(const Find& find);
  void locate_bodies();
  void look_ahead(Real time);
  Real travel(const ContactSlot<Real>& slot) const;
  bool is_slow(const ContactSlot<Real>& slot, Real travel) const;
  Real nearness(const ContactSlot<Real>& slot) const;
  Real margin_for(const ContactSlot<Real>& slot, Real travel) const;
  void stop(const ContactSlot<Real>& slot, const Manifold<Real>& manifold);
  bool may_meet(int collider_a, int collider_b) const;
  ContactSlot<Real> make_slot(int collider_a, int collider_b) const;
  void meet(NearSlot& near);
  void touch(int slot, const Manifold<Real>& manifold);
  Manifold<Real> moved_manifold(int slot);
  Manifold<Real> manifold_ahead(const ContactSlot<Real>& slot);
  Manifold<Real> manifold_of_touch(const ContactSlot<Real>& slot, const Course<Real>& a,
                                   const Course<Real>& b, Real room, Real margin) const;
  Manifold<Real> collide_slot(const ContactSlot<Real>& slot, const Frame<Real>& frame_a,
                              const Frame<Real>& frame_b, Real margin) const;
  Pose<Real> relative_pose(const ContactSlot<Real>& slot, bool a_moves) const;
  bool has_lasting_manifold(int slot) const;
  void find_lasting_manifold(int slot);
  void apply_forces();
  void find_stiffness();
  void stiffen_bodies();
  void write_rows(StabilizationPass pass, VelocityProblem<Real>& problem);
  void relax_rows();
  void write_joint_rows(StabilizationPass pass, VelocityProblem<Real>& problem, int& next);
  bool write_tie(int number, const Stabilization& stabilization, StabilizationPass pass,
                 VelocityProblem<Real>& problem, int& next);
  PinRules<Real> pin_rules(const Stabilization& stabilization, StabilizationPass pass) const;
  bool write_pin(const Pin& pin, const PinRules<Real>& rules, VelocityProblem<Real>& problem, int& next);
  void locate_pins();
  void look_along_arcs();
  void follow_arcs(const Constraint& joint, const JointImpulses& impulses);
  int tie_count() const { return scene_->joints().size() + (hand_ ? 1 : 0); }
  bool tie_asleep(int tie) const;
  void carry_over(const World& before, const Scene& then);
  void carry_contacts(const World& before);
  void carry_sleep(const World& before, const Scene& then);
  ContactSolver<Real>* contact_solver(Solver<Real>& solver) const;
  void solve_rows(Solver<Real>& solver, SolveObserver<Real>* observer, StepReport& report);
  void solve_contacts(ContactSolver<Real>& solver, StepReport& report);
  void take_contacts();
  ContactProblem<Real> contact_problem(const ContactStabilization<Real>& stabilization);
  bool follow_contacts(ContactSolver<Real>* solver);
  bool follow_last_step(ContactSolver<Real>* solver);
  bool follow_odd_manifolds();
  void catch_up_with_manifolds();
  void take_impulses(ContactSolver<Real>& solver, FixedList<Real, 4> Contact<Real>::*impulse);
  void give_contacts(ContactSolver<Real>& solver);
  void take_back_contacts(ContactSolver<Real>& solver);
  void remember_contacts(ContactSolver<Real>& solver, int number);
  void leave_contacts();
  StepRecord<Real> with_rows() const;
  void keep_rows();
  void relax(Solver<Real>& solver, StepReport& report);
  void correct_positions(Solver<Real>& solver, StepReport& report);
  void warm_start();
  template <typename Visit>
  void for_each_block(const Visit& visit);
  void count_failures(StepReport& report) const;
  Real too_deep(const ContactSlot<Real>& slot) const;
  bool is_too_deep(int contact) const;
  bool is_apart(const RowSpecs<Real>& specs) const;
  void remember_impulses();
  std::optional<BodyId> first_not_finite() const;
  ContactMaterial<Real> material(const ContactSlot<Real>& slot) const;
  const BodyTraits<Real>& traits(BodyId body) const { return traits_[kind_[body]]; }
  int kind_of(const BodyForces<Real>& forces, const BodyTraits<Real>& traits);

  Occupation occupation_;  // the first: whoever must not assign has assigned nothing
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Plan> plan_;
  std::shared_ptr<const List<Collider>> colliders_;
  std::shared_ptr<const Pins> pins_;
  PerBody<int> kind_;  // of a body: its place in the next two
  List<BodyForces<Real>> forces_;
  List<BodyTraits<Real>> traits_;
  BodyState<Real> state_;
  ContactGraph<Real> graph_;
  List<JointImpulses> joint_impulses_;  // the last ones are those of the hand
  std::shared_ptr<const DragJoint> hand_;
  List<HandInput> hand_inputs_;
  StepRecord<Real> record_;
  bool has_rows_ = true;                   // the record has all rows; else:
  MadeOnce<StepRecord<Real>> written_;     // the same with rows
  bool follows_ = false;                   // the last substep had the contacts of the one before
  PerBody<Pose<Real>> pose_before_;        // the substep, and
  PerBody<Vec3<Real>> velocity_before_;    // v_1 of its solve, where that is done twice or needed no rows
  std::optional<SleepState<Real>> sleep_;  // where the scene lets bodies sleep
  double dt_ = 0;                          // [s]
  double time_ = 0;
  int steps_ = 0;

  // Scratch memory, kept so that a steady step allocates nothing.
  PerBody<Pose<Real>> first_pose_;         // where a step of several substeps began, and
  PerBody<Vec3<Real>> first_velocity_;     // how
  PerBody<Frame<Real>> frames_;            // where contacts were sought
  LookAhead<Real> outlook_;                // over the time for which contacts are sought
  Stops stops_;                            // in it
  List<char> movable_;                     // of each collider: not of a pair where neither is
  List<int> candidates_;                   // slots with a manifold that moves with its bodies
  List<int> candidates_before_;            // in the step before
  bool found_anew_ = false;                // one of them, or it has another number
  List<int> touching_;                     // slots of the manifolds of record_
  PerBody<Frame<Real>> pin_frames_;        // of bodies that pins hold
  PerBody<Frame<Real>> pin_frames_ahead_;  // the same at poses_ahead_
  RowSpecs<Real> specs_;
  RowSpecs<Real> specs_ahead_;            // the same after this substep
  PerBody<Pose<Real>> poses_ahead_;       // where the velocities of before would take the bodies
  PerBody<char> goes_along_arc_;          // and whether they would take it anywhere
  List<OddContact> odd_;                  // of the candidates
  List<Contact<Real>> contacts_;          // of the last substep, where it needed no rows
  bool may_follow_ = false;               // the solver with its contacts, in the next substep
  ContactTicket ticket_;                  // of these; none where the last substep needed rows
  bool owes_impulses_ = false;            // the solver, of the last substep
  bool has_slots_ = false;                // for their impulses: the slots are of the same rows
  List<RelaxedRow<Real>> relaxed_rows_;   // of all rows, where they are solved twice
  VelocityProblem<Real> second_problem_;  // of positions
  PerBody<Vec3<Real>> stiffness_;         // geometric: [N/m, N/m, N m/rad]
  RowForces<Real> forces_before_;         // of a joint
  PerRow<Real> impulse_before_;           // the warm start of a solve that is done twice
  PerBody<Vec3<Real>> moving_velocity_;   // what the position moves by in this substep
  int joints_apart_ = 0;                  // when rows were last written
};

/// `World world(scene);` is one in double.
World(Scene)->World<double>;

/// What the world looks like now. Contacts are those of the last step, where it found them.
template <Scalar Real>
Snapshot snapshot(const World<Real>& world);

}  // namespace cairn
