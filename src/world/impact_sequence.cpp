// Floor 5. Stages of impacts.
#include <cairn/world/impact_sequence.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/math/deadline.hpp>

namespace cairn {

namespace {

// A chain of n bodies takes n stages or so; where something is lost in each, there may be no end of them, and
// less and less happens.
constexpr int most_stages = 1000;
// Of a stage: n bodies in a row that all close take about n^2.
constexpr int most_sweeps = 20000;
// Of a speed, in sums of a few terms.
template <Scalar Real>
constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();

template <Scalar Real>
bool any_rebounds(const VelocityProblem<Real>& problem) {
  return std::any_of(problem.contacts.begin(), problem.contacts.end(), [](const Contact<Real>& contact) {
    return std::any_of(contact.rebound.begin(), contact.rebound.begin() + contact.manifold.count,
                       [](Real rebound) { return rebound > 0; });
  });
}

/// Whether a row of a joint holds through an impact: springs, motors and drags give no impulses. The springs
/// of the policy soft do, which are none in the second solve.
template <Scalar Real>
bool holds(const ConstraintRow<Real>& row, const SecondRow<Real>* second) {
  const bool is_rigid = row.softness == 0 || (second != nullptr && second->softness == 0);
  return is_rigid && (row.bounds.is_equality() || row.bounds.is_unilateral());
}

}  // namespace

template <Scalar Real>
void ImpactSequence<Real>::begin(const PerBody<Vec3<Real>>& before, Real threshold,
                                 VelocityProblem<Real>& problem, List<SecondRow<Real>>& second_rows) {
  if (!any_rebounds(problem)) return;
  find_members(problem, second_rows);
  velocity_ = before;
  begin_stage(threshold, problem);
  const Real least = std::max(threshold, rounding<Real> * fastest_wish(problem));
  for (int i = 0; i < most_stages && begin_stage(least, problem); ++i) {
    Deadline::go_on();
    solve_stage(problem);
  }
  hand_on(problem, second_rows);
}

template <Scalar Real>
void ImpactSequence<Real>::find_members(const VelocityProblem<Real>& problem,
                                        const List<SecondRow<Real>>& second_rows) {
  members_.clear();
  const auto add = [&](Member member) {
    const ConstraintRow<Real>& row = problem.rows[member.row];
    member.inverse = inverse_effective_mass(problem, row) - row.softness;
    if (member.inverse > 0) members_.push_back(member);
  };
  for (int row = 0; row < problem.joint_rows(); ++row) {
    const SecondRow<Real>* const second = second_rows.empty() ? nullptr : &second_rows[row];
    if (holds(problem.rows[row], second)) add({.row = row});
  }
  for (int i = 0; i < problem.contacts.size(); ++i) {
    const Contact<Real>& contact = problem.contacts[i];
    const RowBlock& block = problem.blocks[problem.joint_blocks() + i];
    const int stride = block.count >= 2 * contact.manifold.count ? 2 : 1;  // friction may stand in between
    for (int k = 0; k < contact.manifold.count && block.count > 0; ++k) {
      add({.row = block.first + stride * k,
           .separation = contact.manifold.points[k].separation,
           .restitution = contact.restitution,
           .contact = i,
           .point = k});
    }
  }
}

template <Scalar Real>
Real ImpactSequence<Real>::speed_of(const Member& member, const VelocityProblem<Real>& problem) const {
  return row_velocity(problem, problem.rows[member.row], velocity_);
}

template <Scalar Real>
void ImpactSequence<Real>::push(const Member& member, Real impulse, const VelocityProblem<Real>& problem) {
  const auto add = [&](BodyId body, const Vec3<Real>& jacobian) {
    velocity_[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * impulse;
  };
  for_each_term(problem, problem.rows[member.row], add);
}

/// Chooses what takes part. Whether some contact closes fast enough to rebound: what is left is for the rows
/// of the substep.
template <Scalar Real>
bool ImpactSequence<Real>::begin_stage(Real threshold, const VelocityProblem<Real>& problem) {
  bool any = false;
  for (Member& member : members_) {
    const Real speed = speed_of(member, problem);
    const ConstraintRow<Real>& row = problem.rows[member.row];
    member.part = 0;
    if (member.contact < 0) {
      member.wish = 0;
      member.acts = row.bounds.is_equality() || (speed < 0 && !(row.bias < 0));
      continue;
    }
    member.acts = speed < 0 && member.separation + problem.dt * speed < 0;
    if (!member.acts) continue;
    const bool rebounds = member.restitution > 0 && -speed > threshold;
    member.wish = rebounds ? -member.restitution * speed : Real(0);
    any = any || rebounds;
  }
  return any;
}

/// [m/s] By which some member is to change its speed in a stage, at most.
template <Scalar Real>
Real ImpactSequence<Real>::fastest_wish(const VelocityProblem<Real>& problem) const {
  Real fastest = 0;
  for (const Member& member : members_) {
    if (member.acts) fastest = std::max(fastest, std::abs(speed_of(member, problem)) + member.wish);
  }
  return fastest;
}

/// Gauss-Seidel on the rows that take part, until nothing changes in the precision of Real.
template <Scalar Real>
void ImpactSequence<Real>::solve_stage(const VelocityProblem<Real>& problem) {
  const Real fastest = fastest_wish(problem), still = rounding<Real> * fastest;
  Real change = fastest;
  for (int i = 0; i < most_sweeps && change > still; ++i) {
    change = 0;
    for (Member& member : members_) {
      if (!member.acts) continue;
      const Real old = member.part;
      member.part += (member.wish - speed_of(member, problem)) / member.inverse;
      if (!problem.rows[member.row].bounds.is_equality()) member.part = std::max(member.part, Real(0));
      push(member, member.part - old, problem);
      change = std::max(change, std::abs(member.part - old) * member.inverse);
    }
  }
  for (Member& member : members_) {
    if (!member.acts) continue;
    member.impulse += member.part;
    member.has_acted = true;
  }
}

/// What took part parts as the last stage left it: it has met, and has no room left to use.
template <Scalar Real>
void ImpactSequence<Real>::hand_on(VelocityProblem<Real>& problem, List<SecondRow<Real>>& second_rows) const {
  for (const Member& member : members_) {
    problem.impulse[member.row] += member.impulse;
    if (member.contact < 0 || !member.has_acted) continue;
    Contact<Real>& contact = problem.contacts[member.contact];
    const Real rebound = std::max(speed_of(member, problem), Real(0));
    contact.rebound[member.point] = rebound;
    contact.rigid[member.point] = true;
    const auto bias = [&](bool is_second) {
      return std::max(rebound, contact_bias(problem.rule, member.separation, contact.slop_limit, rebound,
                                            false, is_second));
    };
    problem.rows[member.row].bias = bias(problem.is_second);
    problem.rows[member.row].softness = 0;
    if (!second_rows.empty()) second_rows[member.row] = {.bias = bias(true)};
  }
}

template class ImpactSequence<float>;
template class ImpactSequence<double>;

}  // namespace cairn
