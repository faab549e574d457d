// Floor 5. What is known of contacts from step to step.
#pragma once

#include <memory>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/contact_graph.hpp>
#include <cairn/world/model.hpp>
#include <cairn/world/one_way_sides.hpp>
#include <cairn/world/rounds.hpp>
#include <cairn/world/step_report.hpp>
#include <cairn/world/substep.hpp>
#include <cairn/world/swept_boxes.hpp>

namespace cairn {

/// The shapes of a world, which pairs of them are near, what touches, and what the rows of contacts gave.
/// Contacts lie in the problem of a StepRecord, in the order in which they are solved.
template <Scalar Real>
class ContactCache {
 public:
  /// No contact has given anything yet.
  explicit ContactCache(const Model<Real>& model);

  /// A step begins, or is not done: who came from which side is as it was when it began.
  void begin_step() { sides_.begin_step(); }
  /// Likewise.
  void leave_step() { sides_.leave_step(); }
  /// Finds what touches, and wakes what sleeps and is touched: contacts and what sensors see go into the
  /// record. @throws std::length_error for more pairs than Broadphase::max_pairs.
  void find(const Substep<Real>& step, StepRecord<Real>& record);
  /// The contacts that were found last, where the bodies are now. For Plan::moves_manifolds.
  void move(const Substep<Real>& step, StepRecord<Real>& record);

  /// Adds the geometric stiffness of all contacts of the record, as JointWriter::add_stiffness(): with its
  /// sign, for they only push.
  void add_stiffness(ForcesOf when, const StepRecord<Real>& record, RowForces<Real>& forces,
                     PerBody<Vec3<Real>>& stiffness) const;
  /// Gives the contacts of the record on what they gave in the last step.
  void start(const Substep<Real>& step, StepRecord<Real>& record) const;
  /// Keeps what they gave, and which of them slide where the plan asks for it.
  void remember(const Plan& plan, const StepRecord<Real>& record);

  /// Takes over what contacts of a world gave that was edited: `numbers` has for each shape that it had the
  /// number now, or -1.
  void carry_over(const ContactCache& before, Span<const int> numbers, const Substep<Real>& step);
  /// Calls visit(a, b) for two bodies whose contact gave something.
  template <typename Visit>
  void for_each_touch(const Visit& visit) const {
    for (const NearPair& near : graph_.order()) {
      if (near.contact == NearPair::none || graph_[near.contact].impulses.count == 0) continue;
      visit(graph_[near.contact].a, graph_[near.contact].b);
    }
  }

 private:
  template <Scalar>
  friend class ContactFinder;

  bool may_meet(const Scene& scene, int collider_a, int collider_b) const;
  void remember_sliding(const VelocityProblem<Real>& problem);
  void choose_friction(const Substep<Real>& step, VelocityProblem<Real>& problem);
  CachedContact<Real> make_contact(const Substep<Real>& step, int collider_a, int collider_b) const;

  std::shared_ptr<const List<Collider<Real>>> colliders_;
  List<char> movable_;  // of each collider: not of a pair where neither is
  ContactGraph<Real> graph_;
  OneWaySides sides_;     // empty where nothing is one-way
  List<int> candidates_;  // contacts with a manifold that moves with its bodies
  List<int> touching_;    // contacts of the contacts of the record

  // Scratch memory, kept so that a steady step allocates nothing.
  PerBody<Frame<Real>> frames_;  // where contacts were sought
  PerBody<Vec3<Real>> going_;    // velocities, should nothing be in the way
  LookAhead<Real> outlook_;      // over the time for which contacts are sought
  SweptBoxes<Real> boxes_;       // over the same time
  Rounds<Real> rounds_;          // of looking ahead
  List<Contact<Real>> sorted_;
};

}  // namespace cairn
