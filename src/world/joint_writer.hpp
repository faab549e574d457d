// Floor 5. From joints to rows.
#pragma once

#include <memory>

#include <cairn/constraints/problem_rows.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/model.hpp>
#include <cairn/world/row_impulses.hpp>
#include <cairn/world/substep.hpp>

namespace cairn {

/// Writes the rows of all joints of a world, and keeps what they gave.
template <Scalar Real>
class JointWriter {
 public:
  /// No joint has given anything yet.
  explicit JointWriter(const Model<Real>& model);

  /// Adds the geometric stiffness of all joints that are awake [N/m, N/m, N m/rad], under the forces that
  /// they gave, or that they have in the problem. `forces` is scratch.
  void add_stiffness(const Substep<Real>& step, ForcesOf when, const VelocityProblem<Real>& problem,
                     RowForces<Real>& forces, PerBody<Vec3<Real>>& stiffness);
  /// Puts the rows of all joints that are awake behind row `next` of the problem, which goes on to the one
  /// behind them, and a block for each joint. What the rows are in a second solve goes into `second_rows`, if
  /// it is given. How many joints hold points that are too far apart: farther than the circle around the
  /// smaller body reaches.
  int write(const Substep<Real>& step, StabilizationPass pass, VelocityProblem<Real>& problem, int& next,
            List<SecondRow<Real>>* second_rows);
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

  void look_along_arcs(const Substep<Real>& step);

  std::shared_ptr<const PerBody<Real>> radius_;  // [m] BodyTraits::radius
  List<Impulses> impulses_;                      // of each joint; the last ones are those of the hand

  // Scratch memory, kept so that a steady step allocates nothing.
  PerBody<KnownRotation<Real>> rotations_;        // of bodies that joints hold
  PerBody<KnownRotation<Real>> rotations_ahead_;  // the same at poses_ahead_
  PerBody<Pose<Real>> poses_ahead_;               // where the velocities of before would take the bodies
  PerBody<char> goes_along_arc_;                  // and whether they would take it anywhere
  List<RowError<Real>> errors_ahead_;             // of a joint there
};

}  // namespace cairn
