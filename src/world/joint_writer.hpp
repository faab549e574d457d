// Floor 5. From joints to rows.
#pragma once

#include <memory>

#include "constraints/stabilization.hpp"
#include "math/list.hpp"
#include "world/substep.hpp"
#include "world/pins.hpp"
#include "world/row_impulses.hpp"

namespace cairn {

/// Writes the rows of all joints of a world, and keeps what they gave.
template <Scalar Real>
class JointWriter {
 public:
  /// Of the joints of a scene, which gave nothing yet.
  explicit JointWriter(const Scene& scene);

  /// Adds the geometric stiffness of all joints that are awake [N/m, N/m, N m/rad], under the forces that
  /// they gave, or that they have in the problem. `forces` is scratch.
  void add_stiffness(const Substep<Real>& step, ForcesOf when, const VelocityProblem<Real>& problem,
                     RowForces<Real>& forces, PerBody<Vec3<Real>>& stiffness) const;
  /// Puts the rows of all joints that are awake behind row `next` of the problem, which goes on to the one
  /// behind them, and a block for each joint. What the rows are in a second solve goes into `relaxed`, if it
  /// is given. How many joints hold points that are too far apart: farther than the circle around the smaller
  /// body reaches.
  int write(const Substep<Real>& step, StabilizationPass pass, VelocityProblem<Real>& problem, int& next,
            List<RelaxedRow<Real>>* relaxed);
  /// Gives the rows what they gave in the last step.
  void start(const Substep<Real>& step, VelocityProblem<Real>& problem, PerRow<char>& is_new) const;
  /// Keeps what the rows gave. What sleeps keeps what it has.
  void remember(const Substep<Real>& step, const VelocityProblem<Real>& problem);
  /// Takes over what joints of `then` gave that are still in the scene of the substep.
  void carry_over(const JointWriter& before, const Scene& then, const Substep<Real>& step);
  /// The hand holds something new, which gave nothing yet.
  void forget_hand() { impulses_.back() = {}; }

 private:
  using Impulses = BlockImpulses<List<RowImpulse<Real>>, Real>;

  PinRules<Real> pin_rules(const Substep<Real>& step, const Stabilization& stabilization,
                           StabilizationPass pass) const;
  void locate_pins(const Substep<Real>& step);
  bool write_pin(const Substep<Real>& step, const Pin& pin, const PinRules<Real>& rules,
                 VelocityProblem<Real>& problem, int& next, List<RelaxedRow<Real>>* relaxed) const;
  bool write_joint(const Substep<Real>& step, int number, const PinRules<Real>& rules,
                   VelocityProblem<Real>& problem, int& next, List<RelaxedRow<Real>>* relaxed);
  void look_along_arcs(const Substep<Real>& step);
  void follow_arcs(const Substep<Real>& step, int number);
  bool is_apart(const Substep<Real>& step) const;

  std::shared_ptr<const Pins> pins_;
  List<Impulses> impulses_;  // of each joint; the last ones are those of the hand

  // Scratch memory, kept so that a steady step allocates nothing.
  PerBody<Frame<Real>> pin_frames_;        // of bodies that pins hold
  PerBody<Frame<Real>> pin_frames_ahead_;  // the same at poses_ahead_
  RowSpecs<Real> specs_;
  RowSpecs<Real> specs_ahead_;       // the same after this substep
  PerBody<Pose<Real>> poses_ahead_;  // where the velocities of before would take the bodies
  PerBody<char> goes_along_arc_;     // and whether they would take it anywhere
};

}  // namespace cairn
