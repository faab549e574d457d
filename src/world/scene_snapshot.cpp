// Floor 5. From a scene to plain values.
#include <cairn/world/scene_snapshot.hpp>

#include <cmath>
#include <map>

#include <cairn/constraints/springs.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

template <Scalar Real>
BodyState<Real> state_of(const Scene& scene) {
  BodyState<Real> state;
  const int count = scene.bodies().size();
  state.pose.reserve(count);
  for (PerBody<Vec3<Real>>* each : {&state.velocity, &state.inverse_mass}) each->reserve(count);
  for (const SceneBody& body : scene.bodies()) {
    const BodySpec& spec = body.spec;
    state.pose.push_back(
        {.position = body.pose.position.template cast<Real>(), .angle = static_cast<Real>(body.pose.angle)});
    state.velocity.push_back({static_cast<Real>(spec.velocity.x()), static_cast<Real>(spec.velocity.y()),
                              static_cast<Real>(spec.angular_velocity)});
    const Real inverse_mass = body.mass > 0 ? static_cast<Real>(1 / body.mass) : Real(0);
    const Real inverse_inertia = body.inertia > 0 ? static_cast<Real>(1 / body.inertia) : Real(0);
    state.inverse_mass.push_back({inverse_mass, inverse_mass, inverse_inertia});
  }
  return state;
}

SnapshotBody snapshot_body(const SceneBody& body, const Pose<double>& pose, const Vec3<double>& velocity) {
  return {.type = body.spec.type,
          .pose = pose,
          .velocity = velocity,
          .mass = body.mass,
          .inertia = body.inertia,
          .gravity_scale = body.spec.gravity_scale,
          .removed = body.removed,
          .sensor = body.spec.sensor,
          .filter = body.spec.filter,
          .surface_speed = body.spec.material.surface_speed,
          .shapes = body.spec.shapes};
}

void add_actions(const Scene& scene, Snapshot& snapshot) {
  for (const SceneEvent& event : scene.events()) {
    if (const auto* const path = std::get_if<FollowPath>(&event.action)) {
      snapshot.paths.push_back({.body = path->body, .points = path->points});
      if (path->kind == PathKind::round) snapshot.paths.back().points.push_back(path->points.front());
    }
    const auto* const pull = std::get_if<ApplyForce>(&event.action);
    if (pull == nullptr || event.touch) continue;
    if (snapshot.time < event.time || snapshot.time >= event.time + pull->seconds) continue;
    const Pose<double>& pose = snapshot.bodies[pull->body].pose;
    snapshot.forces.push_back({.body = pull->body,
                               .point = pose.world(pull->point),
                               .force = pull->in_world(Rotation<double>(pose.angle)),
                               .torque = pull->torque});
  }
}

template <Scalar Real>
SnapshotJoint snapshot_joint(const Constraint& joint, const BodyState<Real>& state) {
  const List<Attachment> places = joint.attachments();
  const auto world_point = [&state](const Attachment& place) -> Vec2<double> {
    Pose<Real> pose = state.pose[place.body];
    if (!place.turns) pose.angle = 0;
    return pose.world(place.anchor.template cast<Real>()).template cast<double>();
  };
  SnapshotJoint result{
      .name = joint.name(), .traits = joint.traits(), .a = places.front().body, .b = places.back().body};
  result.anchor_a = world_point(places.front());
  result.anchor_b = world_point(places.back());
  for (int i = 1; i + 1 < places.size(); ++i) result.between.push_back(world_point(places[i]));
  for (const Attachment& end : joint.groove()) result.groove.push_back(world_point(end));
  RowSpecs<Real> specs;
  joint.append_rows(state.pose, specs);
  double sum = 0;
  for (const RowSpec<Real>& spec : specs) {
    sum += static_cast<double>(violation(spec) * violation(spec));
    result.energy += spring_energy(spec, state.inverse_mass);
  }
  result.drift = std::sqrt(sum);
  return result;
}

template <Scalar Real>
void add_occurrences(const Scene& scene, const BodyState<Real>& state, Snapshot& snapshot) {
  for (const BrokenJoint& broken : scene.joints().broken()) {
    snapshot.broken.push_back({.joint = snapshot_joint(*broken.joint, state),
                               .time = broken.time,
                               .force = broken.force,
                               .torque = broken.torque});
    snapshot.broken.back().joint.id = broken.id;
  }
  std::map<std::string, int> counts;
  for (const SceneEvent& event : scene.events()) {
    if (const auto* counted = std::get_if<CountTouches>(&event.action))
      counts[counted->counter] += counted->count;
  }
  for (const auto& [name, count] : counts) snapshot.counters.push_back({name, count});
}

Snapshot snapshot(const Scene& scene) {
  const SceneSettings& settings = scene.settings();
  Snapshot result{
      .dt = settings.dt / settings.substeps, .gravity = settings.gravity, .fields = settings.fields};
  result.apart = scene.joints().apart();
  const BodyState<double> state = state_of<double>(scene);
  for (const BodyId body : scene.bodies().indices())
    result.bodies.push_back(snapshot_body(scene.bodies()[body], state.pose[body], state.velocity[body]));
  add_actions(scene, result);
  for (int i = 0; i < scene.joints().size(); ++i) {
    result.joints.push_back(snapshot_joint(*scene.joints()[i], state));
    result.joints.back().id = scene.joints().id(i);
  }
  add_occurrences(scene, state, result);
  return result;
}

template BodyState<float> state_of(const Scene&);
template BodyState<double> state_of(const Scene&);
template void add_occurrences(const Scene&, const BodyState<float>&, Snapshot&);
template void add_occurrences(const Scene&, const BodyState<double>&, Snapshot&);
template SnapshotJoint snapshot_joint(const Constraint&, const BodyState<float>&);
template SnapshotJoint snapshot_joint(const Constraint&, const BodyState<double>&);

}  // namespace cairn
