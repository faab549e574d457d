// Floor 5. Who begins to touch, who no longer does, and what breaks.
#include <cairn/world/event_watch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cairn {

namespace {

using Pair = std::pair<BodyId, BodyId>;

/// Whether the two of contact i push each other in the substep, or overlapped when it began.
template <Scalar Real>
bool is_touching(const StepRecord<Real>& record, int i) {
  const VelocityProblem<Real>& problem = record.problem;
  const Manifold<Real>& manifold = problem.contacts[i].manifold;
  const RowBlock& block = problem.blocks[problem.joint_blocks() + i];
  const int rows_of_point = block.count == 2 * manifold.count ? 2 : 1;
  for (int k = 0; k < manifold.count; ++k) {
    if (manifold.points[k].separation <= 0) return true;
    if (block.count > 0 && problem.impulse[block.first + rows_of_point * k] > 0) return true;
  }
  return false;
}

void sort_out(List<Pair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

bool is_one_of(BodyId body, const List<BodyId>& bodies) {
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

bool is_meant(const TouchCondition& touch, const Pair& pair) {
  const auto are = [&touch](BodyId one, BodyId other) {
    return is_one_of(one, touch.a) && (touch.b.empty() || is_one_of(other, touch.b));
  };
  return are(pair.first, pair.second) || are(pair.second, pair.first);
}

/// What a joint gave to its last body in a substep that begins so [N s, N s, N m s about where it is
/// fastened].
template <Scalar Real>
Vec3<double> given_by(const Constraint& joint, const VelocityProblem<Real>& problem, const RowBlock& block,
                      const BodyState<Real>& state) {
  Vec3<Real> sum = Vec3<Real>::Zero();
  for (int row = block.first; row < block.first + block.count; ++row)
    sum += problem.rows[row].jacobian_b * problem.impulse[row];
  const Attachment end = joint.attachments().back();
  Vec2<Real> arm = end.anchor.template cast<Real>();
  if (end.turns) arm = Rotation<Real>(state.pose[end.body].angle) * arm;
  sum.z() -= cross(arm, Vec2<Real>(sum.template head<2>()));
  return sum.template cast<double>();
}

}  // namespace

template <Scalar Real>
void EventWatch<Real>::begin() {
  now_.clear();
  impulses_.clear();
}

template <Scalar Real>
void EventWatch<Real>::see(const Substep<Real>& step, const StepRecord<Real>& record) {
  if (step.plan.extras.touches) see_touches(step, record);
  if (step.plan.extras.breaks) see_joints(step, record);
}

/// Of what sleeps there are no contacts: it touches what it touched.
template <Scalar Real>
void EventWatch<Real>::see_touches(const Substep<Real>& step, const StepRecord<Real>& record) {
  const List<Contact<Real>>& contacts = record.problem.contacts;
  for (int i = 0; i < contacts.size(); ++i) {
    if (is_touching(record, i)) now_.push_back(std::minmax(contacts[i].a, contacts[i].b));
  }
  for (const Pair& pair : record.sensed) now_.push_back(pair);
  const auto rests = [&step](BodyId body) {
    return step.scene.bodies()[body].spec.type != BodyType::dynamic || step.sleep->asleep(body);
  };
  for (const Pair& pair : before_) {
    if (step.sleep && rests(pair.first) && rests(pair.second)) now_.push_back(pair);
  }
}

template <Scalar Real>
void EventWatch<Real>::see_joints(const Substep<Real>& step, const StepRecord<Real>& record) {
  impulses_.resize(step.scene.joints().size(), Vec3<double>::Zero());
  for (int i = 0; i < impulses_.size(); ++i) {
    if (step.scene.joints().hold(i).strength.is_finite())
      impulses_[i] += given_by(step.joint(i), record.problem, record.problem.blocks[i], step.state);
  }
}

template <Scalar Real>
std::optional<Scene> EventWatch<Real>::end(double time, double dt, const Scene& scene) {
  sort_out(now_);
  const List<int> met = events_met(scene);
  const List<SceneEvent> broken = breaks(time, dt, scene);
  before_.swap(now_);
  if (met.empty() && broken.empty()) return {};
  Scene then = scene;
  then.do_events(met, time);
  for (const SceneEvent& event : broken) then.add(event);
  return then;
}

/// Each once for each pair of bodies.
template <Scalar Real>
List<int> EventWatch<Real>::events_met(const Scene& scene) const {
  Pairs begun, ended;
  std::set_difference(now_.begin(), now_.end(), before_.begin(), before_.end(), std::back_inserter(begun));
  std::set_difference(before_.begin(), before_.end(), now_.begin(), now_.end(), std::back_inserter(ended));
  List<int> met;
  for (int i = 0; i < scene.events().size(); ++i) {
    const std::optional<TouchCondition>& touch = scene.events()[i].touch;
    if (!touch) continue;
    for (const Pair& pair : touch->change == TouchCondition::Change::begins ? begun : ended) {
      if (is_meant(*touch, pair)) met.push_back(i);
    }
  }
  return met;
}

template <Scalar Real>
List<SceneEvent> EventWatch<Real>::breaks(double time, double dt, const Scene& scene) const {
  List<SceneEvent> events;
  for (int i = 0; i < impulses_.size(); ++i) {
    const JointStrength& strength = scene.joints().hold(i).strength;
    const double force = impulses_[i].head<2>().norm() / dt, torque = std::abs(impulses_[i].z()) / dt;
    if (force > strength.force || torque > strength.torque)
      events.push_back({.time = time, .action = BreakJoint{scene.joints().id(i), force, torque}});
  }
  return events;
}

template <Scalar Real>
EventWatch<Real> EventWatch<Real>::in(const Scene& scene) const {
  EventWatch watch = *this;
  erase_if(watch.before_, [&](const Pair& pair) {
    return scene.bodies()[pair.first].removed || scene.bodies()[pair.second].removed;
  });
  return watch;
}

template class EventWatch<float>;
template class EventWatch<double>;

}  // namespace cairn
