// Floor 5. Changing a world while it runs.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include <cairn/world/world.hpp>

namespace cairn {

namespace {

bool same_motion(const SceneBody& one, const SceneBody& other) {
  return one.spec.velocity == other.spec.velocity && one.spec.angular_velocity == other.spec.angular_velocity;
}

bool same_place(const SceneBody& one, const SceneBody& other) {
  return one.pose.position == other.pose.position && one.pose.angle == other.pose.angle;
}

/// For each collider of the scene before, its number now; -1 where its shape is gone or another one. Never
/// descending.
List<int> numbers_now(const Scene& before, const Scene& now) {
  List<int> numbers;
  int next = 0;
  for (const BodyId id : before.bodies().indices()) {
    const List<Shape<double>>&old = before.bodies()[id].spec.shapes, &shapes = now.bodies()[id].spec.shapes;
    for (int i = 0; i < old.size(); ++i) {
      const bool is_same = &shapes == &old || (i < shapes.size() && shapes[i] == old[i]);
      for (int piece = 0; piece < piece_count(old[i]); ++piece) numbers.push_back(is_same ? next++ : -1);
      if (!is_same && i < shapes.size()) next += piece_count(shapes[i]);
    }
    for (int i = old.size(); i < shapes.size(); ++i) next += piece_count(shapes[i]);
  }
  return numbers;
}

/// [s] Until when events are due; none where none is.
std::optional<double> due_time(const Scene& scene, const Clock& clock) {
  // A sum of n steps is off by fewer than n roundings of itself.
  const double until = clock.time * (1 + clock.steps * std::numeric_limits<double>::epsilon());
  for (const SceneEvent& event : scene.events()) {
    if (event.touch || event.time > until) break;
    if (!is_lasting(event.action)) return until;
  }
  return {};
}

/// The scene with its bodies standing and moving as they do now.
template <Scalar Real>
Scene as_it_stands(Scene scene, const BodyState<Real>& state) {
  for (const BodyId body : state.pose.indices()) {
    const SceneBody& known = scene.bodies()[body];
    if (known.spec.type == BodyType::static_body) continue;
    const Pose<Real>& pose = state.pose[body];
    scene.place(body, {pose.position.template cast<double>(), static_cast<double>(pose.angle)},
                state.velocity[body].template cast<double>());
  }
  return scene;
}

/// After a change of the scene `was`, wakes what has changed, and what touched it or was held by it.
template <Scalar Real>
void wake_changed(const Scene& was, const Scene& is, const ContactCache<Real>& contacts,
                  SleepState<Real>& sleep) {
  if (!(is.settings() == was.settings())) {
    for (const BodyId body : was.bodies().indices()) sleep.wake(body);
    return;
  }
  const auto has_changed = [&](BodyId body) {
    const SceneBody &before = was.bodies()[body], &now = is.bodies()[body];
    return !(before.spec == now.spec && same_place(before, now));
  };
  for (const BodyId body : was.bodies().indices()) {
    if (has_changed(body)) sleep.wake(body);
  }
  contacts.for_each_touch([&](BodyId a, BodyId b) {
    if (has_changed(a)) sleep.wake(b);
    if (has_changed(b)) sleep.wake(a);
  });
  const auto wake_ends = [&](const SceneJoints& joints, const SceneJoints& others) {
    for (int i = 0; i < joints.size(); ++i) {
      const std::optional<int> k = others.number_of(joints.id(i));
      if (k && others[*k] == joints[i] && others.hold(*k) == joints.hold(i)) continue;
      for (const Attachment& end : joints[i]->attachments()) sleep.wake(end.body);
    }
  };
  wake_ends(was.joints(), is.joints());
  wake_ends(is.joints(), was.joints());
}

}  // namespace

/// This world as it would go on after a change of its scene.
template <Scalar Real>
World<Real> World<Real>::after(const std::function<void(Scene&)>& change) {
  const Scene then = as_it_stands(*model_.scene, state_);
  Scene edited = then;
  {
    const Occupation::Scope scope(occupation_, "World::edit");
    change(edited);
  }
  if (!model_.scene) throw std::logic_error("World::edit: its world must not be moved away from within");
  World next(std::move(edited));
  next.carry_over(*this, then);
  return next;
}

template <Scalar Real>
void World<Real>::edit(const std::function<void(Scene&)>& change) {
  occupation_.refuse("World::edit");
  *this = after(change);
}

/// This world as it would go on after the events that are due; none where none is.
template <Scalar Real>
std::optional<World<Real>> World<Real>::after_events() {
  const std::optional<double> until = due_time(*model_.scene, clock_);
  if (!until) return {};
  return after([until](Scene& scene) { scene.do_events(*until); });
}

template <Scalar Real>
bool do_events(World<Real>& world) {
  const std::optional<double> until = due_time(world.scene(), world.clock());
  if (until) world.edit([until](Scene& scene) { scene.do_events(*until); });
  return until.has_value();
}

/// Takes over what `before`, whose scene was `then`, has that the scene of this world left alone.
template <Scalar Real>
void World<Real>::carry_over(const World& before, const Scene& then) {
  const bool keeps_dt = model_.scene->settings().dt == then.settings().dt;
  clock_ = {before.clock_.time, before.clock_.steps, keeps_dt ? before.clock_.dt : clock_.dt};
  for (const BodyId body : then.bodies().indices()) {
    const SceneBody &was = then.bodies()[body], &is = model_.scene->bodies()[body];
    if (is.removed) continue;
    if (same_place(was, is)) state_.pose[body] = before.state_.pose[body];
    if (same_motion(was, is)) state_.velocity[body] = before.state_.velocity[body];
  }
  hand_ = before.hand_.in(*model_.scene);
  watch_ = before.watch_.in(*model_.scene);
  joints_.carry_over(before.joints_, then, now());
  contacts_.carry_over(before.contacts_, numbers_now(*before.model_.scene, *model_.scene), now());
  if (!sleep_ || !before.sleep_) return;
  sleep_->carry_over(*before.sleep_);
  wake_changed(then, *model_.scene, before.contacts_, *sleep_);
}

template <Scalar Real>
void World<Real>::move_hand(const HandInput& input) {
  occupation_.refuse("World::move_hand");
  PerBody<Pose<double>> poses;
  if (input.kind == HandInput::Kind::grab) {
    for (const Pose<Real>& pose : state_.pose)
      poses.push_back({pose.position.template cast<double>(), static_cast<double>(pose.angle)});
  }
  hand_.move(input, clock_.steps, *model_.scene, poses);
  if (input.kind == HandInput::Kind::grab) joints_.forget_hand();
}

template bool do_events(World<float>&);
template bool do_events(World<double>&);

template class World<float>;
template class World<double>;

}  // namespace cairn
