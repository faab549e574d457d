// Floor 5. A world: the state of a scene that moves, and the step that moves it.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <cairn/solvers/solver.hpp>
#include <cairn/world/clock.hpp>
#include <cairn/world/contact_cache.hpp>
#include <cairn/world/event_watch.hpp>
#include <cairn/world/hand.hpp>
#include <cairn/world/joint_writer.hpp>
#include <cairn/world/model.hpp>
#include <cairn/world/occupation.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/sleeping.hpp>
#include <cairn/world/snapshot.hpp>
#include <cairn/world/step_impulses.hpp>
#include <cairn/world/step_report.hpp>
#include <cairn/world/substep.hpp>
#include <cairn/world/two_solves.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Who looks at a step: nobody, an observer, or sums of impulses.
template <Scalar Real>
struct StepWatch {
  StepWatch(SolveObserver<Real>* observer = nullptr) : solves(observer) {}  ///< null: nobody
  StepWatch(StepImpulses& sums) : impulses(&sums) {}                        ///< which begin anew

  SolveObserver<Real>* solves = nullptr;  // at each sweep
  StepImpulses* impulses = nullptr;       // at what contacts and joints give in all of the step
};

/// How bodies were when a step began, for one that is not done.
template <Scalar Real>
struct StepStart {
  PerBody<Pose<Real>> pose;      // [m, rad]
  PerBody<Vec3<Real>> velocity;  // [m/s, m/s, rad/s]
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
  static_assert(!std::same_as<Real, long double>, "World: Real must be float or double");

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
  /// Whoever watches it changes none of its bits.
  StepReport step(Solver<Real>& solver, const StepWatch<Real>& watch = {});
  /// The problem that step() would hand to its solver first: changes nothing.
  VelocityProblem<Real> velocity_problem() const;

  /// From the next step on [s]; impulses are carried over in proportion.
  /// @throws std::invalid_argument unless dt is from 1e-12 to 1e6 s.
  void set_dt(double dt);
  /// Gives a body another velocity [m/s, m/s, rad/s], or the one that it has, and wakes it with all of its
  /// island, which may sleep again after the time that the scene asks for.
  /// @throws std::invalid_argument for unknown or static bodies and numbers that are not finite.
  void set_velocity(BodyId body, const Vec3<double>& velocity);
  /// Changes the scene in mid-run: change(scene) is given the scene as it is now, its bodies standing and
  /// moving as they do, and may add, remove and change whatever it likes. Bodies and joints that it leaves
  /// alone keep their state, their impulses and their sleep to the last bit; what it changes wakes, and so
  /// does what touched or held it. last_step() is empty until the next one.
  /// @throws what `change` throws, what the constructor refuses, and std::logic_error from within a step or
  /// an edit of this world: then nothing has changed.
  void edit(const std::function<void(Scene&)>& change);

  /// Does what a hand does, before the next step.
  /// @throws std::invalid_argument as Hand::move().
  void move_hand(const HandInput& input);
  /// What it holds, and all that it has done.
  const Hand& hand() const { return hand_; }

  /// Whether the body takes part in the steps: always, unless it sleeps.
  bool is_awake(BodyId body) const { return !sleep_ || !sleep_->asleep(body); }

  /// Poses and velocities now.
  const BodyState<Real>& bodies() const { return state_; }
  /// What it was made from.
  const Scene& scene() const { return *model_.scene; }
  /// What the last step saw; empty before the first.
  const StepRecord<Real>& last_step() const { return record_; }
  /// The time now, the steps that were taken, and the length of the next one.
  const Clock& clock() const { return clock_; }

 private:
  World after(const std::function<void(Scene&)>& change);
  std::optional<World> after_events();
  StepReport take_step(Solver<Real>& solver, const StepWatch<Real>& watch);
  void begin_step();
  void leave_step();
  void end_step();
  void substep(int number, Solver<Real>& solver, const StepWatch<Real>& watch, StepReport& report);
  Substep<Real> now(int number = 0);
  void carry_over(const World& before, const Scene& then);

  Occupation occupation_;  // the first: whoever must not assign has assigned nothing
  Model<Real> model_;
  BodyState<Real> state_;
  ContactCache<Real> contacts_;
  JointWriter<Real> joints_;
  Hand hand_;
  std::optional<SleepState<Real>> sleep_;  // where the scene lets bodies sleep
  Clock clock_;
  EventWatch<Real> watch_;
  StepRecord<Real> record_;

  // Scratch memory, kept so that a steady step allocates nothing.
  TwoSolves<Real> solves_;
  StepStart<Real> start_;  // where it may be needed
};

/// `World world(scene);` is one in double.
World(Scene)->World<double>;

/// Does what the scene's events have due before the next step, which would begin with it: an event happens
/// before the first step that begins at its time or later, and then is no longer in scene(). Whether any did.
/// @throws as World::edit().
template <Scalar Real>
bool do_events(World<Real>& world);

/// What its last step saw, with the rows of all contacts, where its solver took them without.
template <Scalar Real>
StepRecord<Real> with_rows(const World<Real>& world);

/// What the world looks like now. Contacts are those of the last step, where it found them.
template <Scalar Real>
Snapshot snapshot(const World<Real>& world);

}  // namespace cairn
