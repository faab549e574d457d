// Floor 5. Which islands fall asleep, and which wake.
#include <cairn/world/sleeping.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <cairn/geometry/aabb.hpp>

namespace cairn {

namespace {

// Of a body's size: what stays within it rests. Ten sweeps leave the boxes of a pile creeping to their places
// at first by ten times as much in half a second, and by less each second.
constexpr double still_share = 2e-3;

/// [m] A mass without shapes has the size of its radius of gyration.
double size_of(const SceneBody& body) {
  double size = 0;
  for (const Shape<double>& shape : body.spec.shapes) {
    const Aabb<double> box = bounding_box(shape, Pose<double>{});
    size = std::max(size, box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).norm());
  }
  return size > 0 || !(body.mass > 0) ? size : std::sqrt(body.inertia / body.mass);
}

}  // namespace

template <Scalar Real>
SleepState<Real>::SleepState(const Scene& scene) : settings_(scene.settings().sleeping.value()) {
  for (const SceneBody& body : scene.bodies()) {
    const BodyId id{type_.size()};
    type_.push_back(body.spec.type);
    sensor_.push_back(body.spec.sensor ? 1 : 0);
    size_.push_back(size_of(body));
    place_.push_back(
        {.position = body.pose.position.template cast<Real>(), .angle = static_cast<Real>(body.pose.angle)});
    for (const Shape<double>& shape : body.spec.shapes) owner_.resize(owner_.size() + piece_count(shape), id);
  }
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) {
    List<BodyId> connected;
    for (const Attachment& place : joint->attachments()) connected.push_back(place.body);
    joints_.push_back(connected);
  }
  island_.assign(type_.size(), awake);
  still_for_.assign(type_.size(), 0);
  held_.resize(type_.size());
  restless_.resize(type_.size());
  note_drives(scene);
}

template <Scalar Real>
void SleepState<Real>::note_drives(const Scene& scene) {
  driven_.assign(type_.size(), 0);
  falls_.assign(type_.size(), 0);
  for (int i = 0; i < joints_.size(); ++i) {
    const std::optional<JointMotor> motor = scene.joints()[i]->motor();
    if (!motor || motor->speed == 0) continue;
    for (const BodyId body : joints_[i]) driven_[body] = 1;
  }
  const SceneSettings& settings = scene.settings();
  const Fields& fields = settings.fields;
  const bool in_field = fields.water || !fields.attractions.empty() || fields.gravitation != 0;
  for (const BodyId body : falls_.indices()) {
    const BodySpec& spec = scene.bodies()[body].spec;
    falls_[body] = in_field || (!settings.gravity.isZero(0) && spec.gravity_scale != 0) ||
                   (!fields.wind.isZero(0) && spec.damping.quadratic > 0);
  }
  for (const SceneEvent& event : scene.events()) {
    if (const auto* const pull = std::get_if<ApplyForce>(&event.action)) falls_[pull->body] = 1;
  }
}

/// Calls visit(bodies) for every contact and every joint.
template <Scalar Real>
template <typename Visit>
void SleepState<Real>::for_each_connection(const List<Contact<Real>>& contacts, const Visit& visit) const {
  for (const Contact<Real>& contact : contacts) {
    const FixedList<BodyId, 2> connected = {contact.a, contact.b};
    visit(Span<const BodyId>(connected));
  }
  for (const List<BodyId>& connected : joints_) visit(Span<const BodyId>(connected));
}

template <Scalar Real>
bool SleepState<Real>::joint_asleep(int joint) const {
  const List<BodyId>& connected = joints_[joint];
  return std::any_of(connected.begin(), connected.end(), [this](BodyId body) { return asleep(body); });
}

/// Whether it can disturb what it touches: an awake dynamic body, or a kinematic one on its way.
template <Scalar Real>
bool SleepState<Real>::disturbs(BodyId body, const PerBody<Vec3<Real>>& velocity) const {
  if (is_dynamic(body)) return !asleep(body);
  return type_[body] == BodyType::kinematic && !velocity[body].isZero(0);
}

template <Scalar Real>
void SleepState<Real>::mark_movable(const PerBody<Vec3<Real>>& velocity, List<char>& movable) const {
  for (int i = 0; i < owner_.size(); ++i) {
    movable[i] = sensor_[owner_[i]] || disturbs(owner_[i], velocity) ? 1 : 0;
  }
}

template <Scalar Real>
bool SleepState<Real>::wake_touched(const List<Contact<Real>>& contacts,
                                    const PerBody<Vec3<Real>>& velocity) {
  bool found = false;
  for_each_connection(contacts, [&](Span<const BodyId> connected) {
    const bool disturbed = std::any_of(connected.begin(), connected.end(),
                                       [&](BodyId body) { return disturbs(body, velocity); });
    if (!disturbed) return;
    for (const BodyId body : connected) {
      if (!asleep(body)) continue;
      wake(body);
      found = true;
    }
  });
  return found;
}

template <Scalar Real>
void SleepState<Real>::wake(BodyId body) {
  still_for_[body] = 0;
  if (!asleep(body)) return;
  const BodyId woken = island_[body];
  for (const BodyId other : island_.indices()) {
    if (island_[other] != woken) continue;
    island_[other] = awake;
    still_for_[other] = 0;
  }
}

template <Scalar Real>
void SleepState<Real>::carry_over(const SleepState& before) {
  for (const BodyId body : before.island_.indices()) {
    if (!is_dynamic(body)) continue;
    island_[body] = before.island_[body];
    place_[body] = before.place_[body];
    still_for_[body] = before.still_for_[body];
  }
}

template <Scalar Real>
void SleepState<Real>::hold(PerBody<Vec3<Real>>& velocity) const {
  for (const BodyId body : island_.indices()) {
    if (island_[body] != awake) velocity[body].setZero();
  }
}

template <Scalar Real>
void SleepState<Real>::let_sleep(const List<Contact<Real>>& contacts, double dt, BodyState<Real>& state) {
  count_still_time(dt, state);
  connected_.begin(type_.size());
  std::fill(held_.begin(), held_.end(), char{0});
  for_each_connection(contacts, [&](Span<const BodyId> connected) { connect(connected, state.velocity); });
  find_restless(dt);
  put_to_sleep(state.velocity);
}

template <Scalar Real>
void SleepState<Real>::count_still_time(double dt, const BodyState<Real>& state) {
  for (const BodyId body : place_.indices()) {
    if (is_still(body, state)) {
      still_for_[body] += dt;
    } else {
      place_[body] = state.pose[body];
      still_for_[body] = 0;
    }
  }
}

/// Written so that a number that is none is not still.
template <Scalar Real>
bool SleepState<Real>::is_still(BodyId body, const BodyState<Real>& state) const {
  const Vec2<Real> way = state.pose[body].position - place_[body].position;
  const Real turn = std::abs(state.pose[body].angle - place_[body].angle);
  const double gone = static_cast<double>(way.norm()) + size_[body] * static_cast<double>(turn);
  const Vec3<Real>& velocity = state.velocity[body];
  return gone <= still_share * size_[body] &&
         static_cast<double>(velocity.template head<2>().norm()) < settings_.speed &&
         std::abs(static_cast<double>(velocity.z())) < settings_.angular_speed;
}

/// Makes one island of the dynamic bodies among those connected; keeps them awake if one moves by a given
/// velocity.
template <Scalar Real>
void SleepState<Real>::connect(Span<const BodyId> connected, const PerBody<Vec3<Real>>& velocity) {
  const bool carried = std::any_of(connected.begin(), connected.end(), [&](BodyId body) {
    return !is_dynamic(body) && disturbs(body, velocity);
  });
  const bool is_held =
      !std::all_of(connected.begin(), connected.end(), [&](BodyId body) { return is_dynamic(body); });
  BodyId first = awake;
  for (const BodyId body : connected) {
    if (!is_dynamic(body)) continue;
    if (carried) still_for_[body] = 0;
    if (is_held) held_[body] = 1;
    if (first == awake) first = body;
    connected_.connect(first, body);
  }
}

/// Islands of which some body has not been still for long enough, to the nearest step, or is driven.
template <Scalar Real>
void SleepState<Real>::find_restless(double dt) {
  std::fill(restless_.begin(), restless_.end(), char{0});
  for (const BodyId body : held_.indices()) {
    if (held_[body]) held_[connected_.lowest(body)] = 1;
  }
  for (const BodyId body : still_for_.indices()) {
    const BodyId root = connected_.lowest(body);
    const bool still = still_for_[body] > 0 && still_for_[body] > settings_.time - dt / 2;
    if (!still || driven_[body] || (falls_[body] && !held_[root])) restless_[root] = 1;
  }
}

/// Those that are not restless.
template <Scalar Real>
void SleepState<Real>::put_to_sleep(PerBody<Vec3<Real>>& velocity) {
  count_ = {};
  for (const BodyId body : island_.indices()) {
    if (type_[body] != BodyType::dynamic || island_[body] != awake) continue;
    const BodyId root = connected_.lowest(body);
    if (restless_[root]) {
      count_.bodies += 1;
      count_.islands += root == body;
      continue;
    }
    island_[body] = root;
    velocity[body].setZero();
  }
}

template class SleepState<float>;
template class SleepState<double>;

}  // namespace cairn
