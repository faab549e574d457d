// Floor 5. What is known of contacts from step to step.
#pragma once

#include <memory>

#include "constraints/contact.hpp"
#include "constraints/contact_problem.hpp"
#include "math/list.hpp"
#include "world/collider.hpp"
#include "world/contact_graph.hpp"
#include "world/rounds.hpp"
#include "world/step_report.hpp"
#include "world/substep.hpp"
#include "world/swept_boxes.hpp"

namespace cairn {

/// Writes rows of contacts: of one pass of a substep of dt [s] which begins with this state.
template <Scalar Real>
class ContactWriter {
 public:
  /// Settings and state must outlive it.
  ContactWriter(const SceneSettings& settings, const BodyState<Real>& state, StabilizationPass pass, Real dt)
      : settings_(settings),
        state_(state),
        rule_(contact_rule(settings.stabilization, pass, dt, settings.gravity.norm())) {}
  /// Puts the rows of a contact behind row `next` of the problem, which goes on to the one behind them, and
  /// their block behind its blocks. What the rows are in a second solve goes into `relaxed`, if it is given.
  void write(const Contact<Real>& contact, const Manifold<Real>& manifold, VelocityProblem<Real>& problem,
             int& next, List<RelaxedRow<Real>>* relaxed) const;

 private:
  const SceneSettings& settings_;
  const BodyState<Real>& state_;
  RowRule<Real> rule_;
};

/// The shapes of a world, which pairs of them are near, what touches, and what the rows of contacts gave.
/// Manifolds lie in a StepRecord, in the order in which contacts are solved.
template <Scalar Real>
class ContactCache {
 public:
  /// Of the scene of a plan. No contact has given anything yet.
  ContactCache(List<Collider<Real>> colliders, const Scene& scene, const Plan& plan);

  /// The shapes.
  const List<Collider<Real>>& colliders() const { return *colliders_; }

  /// Finds what touches, and wakes what sleeps and is touched: manifolds and what sensors see go into the
  /// record. @throws std::length_error for more pairs than Broadphase::max_pairs.
  void find(const Substep<Real>& step, StepRecord<Real>& record);
  /// The manifolds that were found last, where the bodies are now. For Plan::moves_manifolds.
  void move(const Substep<Real>& step, StepRecord<Real>& record);

  /// Adds the geometric stiffness of all contacts of the record, as JointWriter::add_stiffness(): with its
  /// sign, for they only push.
  void add_stiffness(const Substep<Real>& step, ForcesOf when, const StepRecord<Real>& record,
                     RowForces<Real>& forces, PerBody<Vec3<Real>>& stiffness) const;
  /// Puts the rows of all contacts behind row `next` of the problem, which goes on to the one behind them,
  /// and a block for each. What the rows are in a second solve goes into `relaxed`, if it is given.
  void write(const Substep<Real>& step, const List<Manifold<Real>>& manifolds, StabilizationPass pass,
             VelocityProblem<Real>& problem, int& next, List<RelaxedRow<Real>>* relaxed) const;
  /// Gives the rows of the blocks from `first` on what they gave in the last step.
  void start(const Substep<Real>& step, int first, VelocityProblem<Real>& problem,
             PerRow<char>& is_new) const;
  /// The contacts of the record, without rows where they need none, with what these would begin from; those
  /// of others as write() puts them, with what they begin from.
  void take(const Substep<Real>& step, StepRecord<Real>& record, int& next,
            List<RelaxedRow<Real>>* relaxed) const;
  /// Keeps what they gave.
  void remember(const StepRecord<Real>& record);

  /// How many contacts are deeper than half of the thinner body.
  int count_too_deep(const Substep<Real>& step, const List<Manifold<Real>>& manifolds) const;
  /// Takes over what contacts of a world gave that was edited: `numbers` has for each shape that it had the
  /// number now, or -1.
  void carry_over(const ContactCache& before, Span<const int> numbers, const Substep<Real>& step);
  /// Calls visit(a, b) for two bodies whose contact gave something.
  template <typename Visit>
  void for_each_touch(const Visit& visit) const {
    for (const NearSlot& near : graph_.order()) {
      if (near.slot == NearSlot::none || graph_[near.slot].impulses.count == 0) continue;
      visit(graph_[near.slot].a, graph_[near.slot].b);
    }
  }

 private:
  template <Scalar>
  friend class ContactFinder;

  bool may_meet(const Scene& scene, int collider_a, int collider_b) const;
  ContactSlot<Real> make_slot(const Substep<Real>& step, int collider_a, int collider_b) const;
  void start(const Substep<Real>& step, int touch, StepRecord<Real>& record) const;

  std::shared_ptr<const List<Collider<Real>>> colliders_;
  ContactGraph<Real> graph_;
  List<int> candidates_;  // slots with a manifold that moves with its bodies
  List<int> touching_;    // slots of the manifolds of the record

  // Scratch memory, kept so that a steady step allocates nothing.
  List<char> movable_;           // of each collider: not of a pair where neither is
  PerBody<Frame<Real>> frames_;  // where contacts were sought
  PerBody<Vec3<Real>> going_;    // velocities, should nothing be in the way
  LookAhead<Real> outlook_;      // over the time for which contacts are sought
  SweptBoxes<Real> boxes_;       // over the same time
  Rounds<Real> rounds_;          // of looking ahead
  List<Manifold<Real>> sorted_;
};

}  // namespace cairn
