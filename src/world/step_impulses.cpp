// Floor 5. Impulses of substeps, added contact by contact and joint by joint.
#include <cairn/world/step_impulses.hpp>

#include <algorithm>
#include <tuple>

#include <cairn/math/check.hpp>

namespace cairn {

namespace {

auto key_of(const SnapshotContact& contact) { return std::tuple(contact.a, contact.b, contact.feature); }

bool comes_before(const SnapshotContact& one, const SnapshotContact& other) {
  return key_of(one) < key_of(other);
}

}  // namespace

void StepImpulses::clear() {
  contacts_.clear();
  joints_.clear();
  dt_ = 0;
}

template <Scalar Real>
void StepImpulses::add(const StepRecord<Real>& substep) {
  List<Vec2<double>> joints;
  for (int i = 0; i < substep.problem.joint_blocks(); ++i) joints.push_back(joint_impulse(substep, i));
  add(contacts_of(substep), joints, static_cast<double>(substep.problem.dt));
}

void StepImpulses::add(const Snapshot& substep) {
  List<Vec2<double>> joints;
  for (const SnapshotJoint& joint : substep.joints) joints.push_back(joint.impulse);
  add(substep.contacts, joints, substep.dt);
}

/// Two contacts of the same features, of bodies with several shapes, are told apart by their order.
void StepImpulses::add(List<SnapshotContact> contacts, const List<Vec2<double>>& joints, double dt) {
  std::stable_sort(contacts.begin(), contacts.end(), comes_before);
  List<SnapshotContact> all;
  int next = 0;
  for (SnapshotContact& contact : contacts) {
    while (next < contacts_.size() && comes_before(contacts_[next], contact))
      all.push_back(contacts_[next++]);
    if (next < contacts_.size() && !comes_before(contact, contacts_[next])) {
      const SnapshotContact& before = contacts_[next++];
      contact.normal_impulse += before.normal_impulse;
      contact.friction_impulse += before.friction_impulse;
      contact.is_new = before.is_new;
    }
    all.push_back(contact);
  }
  while (next < contacts_.size()) all.push_back(contacts_[next++]);
  contacts_ = std::move(all);
  joints_.resize(joints.size(), Vec2<double>::Zero());
  for (int i = 0; i < joints.size(); ++i) joints_[i] += joints[i];
  dt_ += dt;
}

Snapshot StepImpulses::in(Snapshot end) const {
  if (dt_ == 0) return end;
  require(end.joints.size() == joints_.size(), "StepImpulses::in", "end.joints", "those of the step",
          end.joints.size());
  for (int i = 0; i < joints_.size(); ++i) end.joints[i].impulse = joints_[i];
  end.contacts = contacts_;
  end.dt = dt_;
  return end;
}

template void StepImpulses::add(const StepRecord<float>&);
template void StepImpulses::add(const StepRecord<double>&);

}  // namespace cairn
