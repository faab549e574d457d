// Floor 5. What happens to a scene while it runs.
#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

namespace {

/// The velocity of a body after an impulse, which does nothing to one without mass.
Vec3<double> pushed(const SceneBody& body, const PushBody& push) {
  const Vec2<double> arm = Rotation<double>(body.pose.angle) * push.point;
  Vec3<double> velocity(body.spec.velocity.x(), body.spec.velocity.y(), body.spec.angular_velocity);
  if (body.mass > 0) velocity.head<2>() += push.impulse / body.mass;
  if (body.inertia > 0) velocity.z() += cross(arm, push.impulse) / body.inertia;
  return velocity;
}

/// Does one event to a scene.
struct SceneActor {
  Scene& scene;

  void operator()(const RemoveBody& action) const { scene.remove(action.body); }
  void operator()(const RemoveJoint& action) const { scene.remove(action.joint); }
  void operator()(const SwitchMotor& action) const { scene.change(action.joint, action.motor); }
  void operator()(const ApplyForce&) const {}  // that of each substep: Acting
  void operator()(const FollowPath&) const {}
  void operator()(const PushBody& action) const {
    const SceneBody& body = scene.bodies()[action.body];
    scene.place(action.body, body.pose, pushed(body, action));
  }
  void operator()(const ChangeBody& action) const {
    scene.change(action.body, changed(scene.bodies()[action.body].spec, action));
  }
  void operator()(const SetGravity& action) const {
    SceneSettings settings = scene.settings();
    settings.gravity = action.gravity;
    scene.set_settings(settings);
  }
  void operator()(const BreakJoint&) const {}    // Scene::do_events, which knows when
  void operator()(const CountTouches&) const {}  // Scene::do_events, where it comes about
};

void require_pushable(const Scene& scene, const PushBody& push) {
  const char* const who = "Scene::add";
  require(scene.bodies()[push.body].spec.type == BodyType::dynamic, who, "body", "a dynamic one",
          push.body.index);
  require_finite(push.impulse, who, "impulse", "N s");
  require_finite(push.point, who, "point", "m");
  const Vec3<double> velocity = pushed(scene.bodies()[push.body], push);
  require(velocity.allFinite(), who, "impulse", "one that leaves the body a finite velocity",
          push.impulse.norm());
}

void require_force(const Scene& scene, const ApplyForce& pull) {
  const char* const who = "Scene::add";
  require(scene.bodies()[pull.body].spec.type == BodyType::dynamic, who, "body", "a dynamic one",
          pull.body.index);
  require_finite(pull.force, who, "force", "N");
  require_finite(pull.torque, who, "torque", "N m");
  require_finite(pull.point, who, "point", "m");
  require(pull.seconds > 0, who, "seconds", "> 0 s", pull.seconds);
}

void require_path(const Scene& scene, const FollowPath& path) {
  const char* const who = "Scene::add";
  require(scene.bodies()[path.body].spec.type == BodyType::kinematic, who, "body", "a kinematic one",
          path.body.index);
  require(path.points.size() >= 2, who, "points", "two or more", path.points.size());
  for (const Vec2<double>& point : path.points) require_finite(point, who, "points", "m");
  require(path.speed > 0 && std::isfinite(path.speed), who, "speed", "> 0 m/s and finite", path.speed);
  require(path.length() > 0 && std::isfinite(path.length()), who, "points", "some way apart", path.length());
}

void require_touch(const Scene& scene, const TouchCondition& touch) {
  const char* const who = "Scene::add";
  require(!touch.a.empty(), who, "touch", "of at least one body", "none");
  bool is_dynamic = touch.b.empty();
  for (const List<BodyId>* bodies : {&touch.a, &touch.b}) {
    for (const BodyId body : *bodies) {
      require(body.index >= 0 && body.index < scene.bodies().size() && !scene.bodies()[body].removed, who,
              "touch", "of bodies of the scene", body.index);
      is_dynamic |= scene.bodies()[body].spec.type == BodyType::dynamic;
    }
  }
  require(is_dynamic, who, "touch", "of bodies of which one is dynamic", "none");
}

}  // namespace

BodySpec changed(BodySpec spec, const ChangeBody& change) {
  spec.velocity = change.velocity.value_or(spec.velocity);
  spec.angular_velocity = change.angular_velocity.value_or(spec.angular_velocity);
  spec.material.friction = change.friction.value_or(spec.material.friction);
  spec.material.restitution = change.restitution.value_or(spec.material.restitution);
  spec.material.surface_speed = change.surface_speed.value_or(spec.material.surface_speed);
  spec.sensor = change.sensor.value_or(spec.sensor);
  return spec;
}

void Scene::add(const SceneEvent& event) {
  const char* const who = "Scene::add";
  require(event.time >= 0 && std::isfinite(event.time), who, "time", "finite and >= 0 s", event.time);
  require(event.times.value_or(1) > 0, who, "times", "> 0", event.times.value_or(1));
  if (event.touch) require_touch(*this, *event.touch);
  require(event.touch || !std::holds_alternative<CountTouches>(event.action), who, "count",
          "beside a touch that is waited for", "none");
  if (const auto* removal = std::get_if<RemoveBody>(&event.action))
    require_changeable(*this, removal->body, who);
  if (const auto* removal = std::get_if<RemoveJoint>(&event.action)) number_of(removal->joint, who);
  if (const auto* broken = std::get_if<BreakJoint>(&event.action)) number_of(broken->joint, who);
  if (const auto* push = std::get_if<PushBody>(&event.action)) {
    require_changeable(*this, push->body, who);
    require_pushable(*this, *push);
  }
  if (const auto* pull = std::get_if<ApplyForce>(&event.action)) {
    require_changeable(*this, pull->body, who);
    require_force(*this, *pull);
  }
  if (const auto* path = std::get_if<FollowPath>(&event.action)) {
    require_changeable(*this, path->body, who);
    require_path(*this, *path);
    require(!event.touch || event.times == 1, who, "times", "1 of a path that waits for a touch",
            event.times.value_or(0));
  }
  // Refused now, and not when it is to be done:
  if (const auto* other = std::get_if<SwitchMotor>(&event.action))
    (void)with_motor(other->joint, other->motor, who);
  Scene then = *this;
  if (const auto* change = std::get_if<ChangeBody>(&event.action)) SceneActor{then}(*change);
  if (const auto* other = std::get_if<SetGravity>(&event.action)) SceneActor{then}(*other);
  schedule(event);
}

/// Puts it where it belongs in events().
void Scene::schedule(const SceneEvent& event) {
  const auto later = [](const SceneEvent& one, const SceneEvent& other) {
    if (one.touch || other.touch) return !one.touch && other.touch;
    return one.time < other.time;
  };
  events_.insert(std::upper_bound(events_.begin(), events_.end(), event, later), event);
}

bool Scene::do_events(double until) {
  bool any = false;
  const auto due = [until](const SceneEvent& event) {
    return !event.touch && event.time <= until && !is_lasting(event.action);
  };
  while (true) {
    const auto next = std::find_if(events_.begin(), events_.end(), due);
    if (next == events_.end()) return any;
    const SceneEvent event = *next;
    events_.erase(next);
    if (const auto* how = std::get_if<BreakJoint>(&event.action)) {
      joints_.remove(number_of(how->joint, "Scene::do_events"),
                     {.time = event.time, .force = how->force, .torque = how->torque});
      forget_events();
    } else {
      std::visit(SceneActor{*this}, event.action);
    }
    any = true;
  }
}

void Scene::do_events(const List<int>& met, double time) {
  List<SceneEvent> due;
  for (const int number : met) {
    SceneEvent& event = events_[number];
    if (event.times == 0) continue;
    if (event.times) event.times = *event.times - 1;
    if (auto* count = std::get_if<CountTouches>(&event.action)) {
      count->count += 1;
    } else {
      due.push_back({.time = time + event.time, .action = event.action});
    }
  }
  erase_if(events_, [time](const SceneEvent& event) {
    const auto* const pull = std::get_if<ApplyForce>(&event.action);
    if (pull != nullptr && !event.touch && event.time + pull->seconds <= time) return true;  // it is over
    return event.times == 0 && !std::holds_alternative<CountTouches>(event.action);
  });
  for (const SceneEvent& event : due) schedule(event);
}

/// Those of bodies and joints that are no longer there.
void Scene::forget_events() {
  const auto are_gone = [&](const List<BodyId>& some) {
    return std::all_of(some.begin(), some.end(), [&](BodyId body) { return bodies()[body].removed; });
  };
  const auto is_there = [&]<typename Action>(const Action& action) {
    if constexpr (requires { action.body; }) return !bodies()[action.body].removed;
    if constexpr (requires { action.joint; }) return joints_.number_of(action.joint).has_value();
    return true;
  };
  erase_if(events_, [&](const SceneEvent& event) {
    if (std::holds_alternative<CountTouches>(event.action)) return false;
    const bool can_touch =
        !event.touch || !(are_gone(event.touch->a) || (!event.touch->b.empty() && are_gone(event.touch->b)));
    return !can_touch || !std::visit(is_there, event.action);
  });
}

}  // namespace cairn
