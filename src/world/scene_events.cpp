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
  void operator()(const PushBody& action) const {
    const SceneBody& body = scene.bodies()[action.body];
    scene.place(action.body, body.pose, pushed(body, action));
  }
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

}  // namespace

void Scene::add(const SceneEvent& event) {
  const char* const who = "Scene::add";
  require(event.time >= 0 && std::isfinite(event.time), who, "time", "finite and >= 0 s", event.time);
  if (const auto* removal = std::get_if<RemoveBody>(&event.action))
    require_changeable(*this, removal->body, who);
  if (const auto* removal = std::get_if<RemoveJoint>(&event.action)) number_of(removal->joint, who);
  if (const auto* push = std::get_if<PushBody>(&event.action)) {
    require_changeable(*this, push->body, who);
    require_pushable(*this, *push);
  }
  // Refused now, and not when it is to be done:
  if (const auto* other = std::get_if<SwitchMotor>(&event.action))
    (void)with_motor(other->joint, other->motor, who);
  const auto later = [](double time, const SceneEvent& other) { return time < other.time; };
  events_.insert(std::upper_bound(events_.begin(), events_.end(), event.time, later), event);
}

bool Scene::do_events(double until) {
  bool any = false;
  while (!events_.empty() && events_.front().time <= until) {
    const SceneEvent event = events_.front();
    events_.erase(events_.begin());
    std::visit(SceneActor{*this}, event.action);
    any = true;
  }
  return any;
}

/// Those of bodies and joints that are no longer there.
void Scene::forget_events() {
  const auto is_there = [&]<typename Action>(const Action& action) {
    if constexpr (requires { action.body; })
      return !bodies()[action.body].removed;
    else
      return joints_.number_of(action.joint).has_value();
  };
  erase_if(events_, [&](const SceneEvent& event) { return !std::visit(is_there, event.action); });
}

}  // namespace cairn
