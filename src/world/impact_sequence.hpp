// Floor 5. Impacts that bodies pass on: Newton's law again and again, for those alone that close.
#pragma once

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What a chain of bodies that touch makes of impacts. Newton's law for all contacts at once asks nothing of
/// the many that do not close: balls in a row that are struck all part. Here it is applied in stages. The law
/// of a stage holds for the contacts that close then, and no other takes part,
///   u+ >= -e u-,  p >= 0,  p (u+ + e u-) = 0,  u = J v  of those with u- < 0, J v = 0 of joints that hold,
/// and v+ = v- + M^-1 J^T p of one is v- of the next, until none closes. One ball that strikes a row throws
/// one out, two throw out two, and what is alike on both sides stays so. With e = 1 every stage keeps the
/// energy, as each keeps the momentum. These are the generalized reflections of B. Smith, D. Kaufman,
/// E. Vouga, R. Tamstorf and E. Grinspun, Reflections on Simultaneous Impact (2012), section 6; that paper
/// mixes in loss at the end, while e acts here in every stage, as in the law for two bodies.
///
/// Stages are without friction and without gravity. They give the speeds with which contacts are to part:
/// rows of the substep ask for these, so that the answer of the last stage is that of the substep, where
/// friction and loads do not change it.
///
/// Cost: a sweep over the rows of all joints and of contacts that close, until impulses stand still, for
/// each stage. Nothing in a substep in which nothing rebounds. Owns scratch memory only.
template <Scalar Real>
class ImpactSequence {
 public:
  /// Of a problem with rows, whose contacts have met (contact_rows.hpp): where one of them rebounds, finds
  /// how contacts part from the velocities `before` [m/s] the substep's forces, and writes it into `rebound`
  /// of each and the bias of its row, and of the second row, if there are any. Approaches no faster than
  /// `threshold` [m/s] do not rebound. The impulses that this took are added to those that the rows begin
  /// from.
  void begin(const PerBody<Vec3<Real>>& before, Real threshold, VelocityProblem<Real>& problem,
             List<SecondRow<Real>>& second_rows);

 private:
  /// A row of the problem that takes part in stages.
  struct Member {
    int row = 0;           // its number
    Real inverse = 0;      // [1/kg] of its effective mass
    Real impulse = 0;      // [N s] of all stages
    Real part = 0;         // [N s] of this stage
    Real wish = 0;         // [m/s] the speed that it asks for in this stage
    Real separation = 0;   // [m] of a contact
    Real restitution = 0;  // likewise
    int contact = -1;      // its number; -1: a row of a joint
    int point = 0;         // of the contact
    bool acts = false;     // in this stage
    bool has_acted = false;
  };

  void find_members(const VelocityProblem<Real>& problem, const List<SecondRow<Real>>& second_rows);
  bool begin_stage(Real threshold, const VelocityProblem<Real>& problem);
  void solve_stage(const VelocityProblem<Real>& problem);
  void hand_on(VelocityProblem<Real>& problem, List<SecondRow<Real>>& second_rows) const;
  Real speed_of(const Member& member, const VelocityProblem<Real>& problem) const;
  void push(const Member& member, Real impulse, const VelocityProblem<Real>& problem);

  Real fastest_wish(const VelocityProblem<Real>& problem) const;

  List<Member> members_;
  PerBody<Vec3<Real>> velocity_;  // as stages leave it
};

}  // namespace cairn
