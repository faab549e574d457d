// Floor 5. Fields, forces and paths.
#include <cairn/world/acting.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/geometry/immersion.hpp>

namespace cairn {

namespace {

template <Scalar Real>
Pose<double> in_double(const Pose<Real>& pose) {
  return {pose.position.template cast<double>(), static_cast<double>(pose.angle)};
}

/// Adds what an impulse at a place does to a body.
template <Scalar Real>
void push(const BodyState<Real>& state, BodyId body, const Vec2<double>& impulse, double turn,
          PerBody<Vec3<Real>>& velocity) {
  const Vec3<double> by(impulse.x(), impulse.y(), turn);
  velocity[body] += by.cwiseProduct(state.inverse_mass[body].template cast<double>()).template cast<Real>();
}

/// [m] Of a disc of the same area.
double disc_radius(const SceneBody& body) { return std::sqrt(body.area / pi); }

/// The u' of (M + s D) u' = M u, where -D u are the force and the torque with which drag acts on every part
/// of an area that moves with u = (v, w). D is symmetric and takes energy from every motion. @param s
/// [kg/m^2]
Vec3<double> slowed(const Vec3<double>& u, const Vec3<double>& inverse_mass, double s,
                    const AreaMoments& part) {
  const Vec2<double> arm = perpendicular(part.first), v = u.head<2>();
  const double own = 1 + s * part.area * inverse_mass.x();
  const Vec2<double> of_turning = s * inverse_mass.x() / own * arm, turns = s * inverse_mass.z() * arm;
  const double w =
      (u.z() - turns.dot(v) / own) / (1 + s * inverse_mass.z() * part.polar - turns.dot(of_turning));
  const Vec2<double> slow = v / own - w * of_turning;
  return {slow.x(), slow.y(), w};
}

bool has_drag(const SceneBody& body) {
  return body.spec.damping.quadratic > 0 && body.spec.type == BodyType::dynamic;
}

}  // namespace

template <Scalar Real>
Acting<Real>::Acting(const Scene& scene) : scene_(scene) {
  const Fields& fields = scene.settings().fields;
  centred_ = fields.water || !fields.attractions.empty() || fields.gravitation != 0;
  for (const BodyId body : scene.bodies().indices()) {
    if (scene.bodies()[body].spec.type == BodyType::dynamic) bodies_.push_back(body);
  }
  for (const SceneEvent& event : scene.events()) {
    if (std::holds_alternative<ApplyForce>(event.action) && !event.touch) forces_.push_back(event);
    if (!std::holds_alternative<FollowPath>(event.action)) continue;
    paths_.push_back(event);
    if (event.touch) paths_.back().time = std::numeric_limits<double>::infinity();  // not known yet
  }
}

template <Scalar Real>
bool Acting<Real>::is_needed(const Scene& scene) {
  const auto lasts = [](const SceneEvent& event) { return is_lasting(event.action); };
  const Fields& fields = scene.settings().fields;
  return fields.water || !fields.attractions.empty() || fields.gravitation != 0 ||
         std::any_of(scene.events().begin(), scene.events().end(), lasts) ||
         std::any_of(scene.bodies().begin(), scene.bodies().end(), has_drag);
}

template <Scalar Real>
void Acting<Real>::add(const BodyState<Real>& state, SubstepTime now, double seconds,
                       PerBody<Vec3<Real>>& velocity) const {
  add_pulls(state, static_cast<double>(kick(now, static_cast<Real>(seconds))), velocity);
  add_forces(state, now, seconds, velocity);
  if (scene_.settings().fields.water) act_in_water(state, now, seconds, velocity);
  slow_in_air(state, seconds, velocity);
}

template <Scalar Real>
void Acting<Real>::add_pulls(const BodyState<Real>& state, double seconds,
                             PerBody<Vec3<Real>>& velocity) const {
  const Fields& fields = scene_.settings().fields;
  const auto place = [&](BodyId body) -> Vec2<double> {
    return state.pose[body].position.template cast<double>();
  };
  const auto speed_up = [&](BodyId body, const Vec2<double>& acceleration) {
    velocity[body].template head<2>() += (seconds * acceleration).template cast<Real>();
  };
  for (const BodyId body : bodies_) {
    for (const Attraction& star : fields.attractions)
      speed_up(body, attraction(star.point - place(body), star.strength, star.radius));
  }
  if (fields.gravitation == 0) return;
  for (int i = 0; i < bodies_.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const SceneBody &a = scene_.bodies()[bodies_[i]], &b = scene_.bodies()[bodies_[k]];
      const Vec2<double> pull = attraction(place(bodies_[k]) - place(bodies_[i]), fields.gravitation,
                                           disc_radius(a) + disc_radius(b));
      speed_up(bodies_[i], b.mass * pull);
      speed_up(bodies_[k], -a.mass * pull);
    }
  }
}

/// [s] For how long a force acts within some seconds of a substep.
template <Scalar Real>
double Acting<Real>::share(const SceneEvent& event, SubstepTime now, double seconds) const {
  const double begin = centred_ ? now.begin - seconds / 2 : now.begin;
  const double ends = event.time + std::get<ApplyForce>(event.action).seconds;
  return std::max(0.0, std::min(begin + seconds, ends) - std::max(begin, event.time));
}

template <Scalar Real>
void Acting<Real>::add_forces(const BodyState<Real>& state, SubstepTime now, double seconds,
                              PerBody<Vec3<Real>>& velocity) const {
  for (const SceneEvent& event : forces_) {
    const auto& pull = std::get<ApplyForce>(event.action);
    const double time = share(event, now, seconds);
    if (!(time > 0)) continue;
    const Rotation<double> rotation(static_cast<double>(state.pose[pull.body].angle));
    const Vec2<double> force = pull.in_world(rotation);
    push(state, pull.body, time * force, time * (pull.torque + cross<double>(rotation * pull.point, force)),
         velocity);
  }
}

/// m v' = m v - t k |u| u', u = v - wind: without other forces these are the velocities that the law itself
/// leads to, dv/dt = -(k/m) v^2 giving v / (1 + k v t / m).
template <Scalar Real>
void Acting<Real>::slow_in_air(const BodyState<Real>& state, double seconds,
                               PerBody<Vec3<Real>>& velocity) const {
  const Vec2<double>& wind = scene_.settings().fields.wind;
  for (const BodyId body : bodies_) {
    const SceneBody& it = scene_.bodies()[body];
    if (!has_drag(it)) continue;
    const Vec2<double> against = velocity[body].template head<2>().template cast<double>() - wind;
    const double rate =
        it.spec.damping.quadratic * against.norm() * static_cast<double>(state.inverse_mass[body].x());
    velocity[body].template head<2>() = (wind + against / (1 + seconds * rate)).template cast<Real>();
  }
}

template <Scalar Real>
void Acting<Real>::act_in_water(const BodyState<Real>& state, SubstepTime now, double seconds,
                                PerBody<Vec3<Real>>& velocity) const {
  const SceneSettings& settings = scene_.settings();
  const Water& water = *settings.fields.water;
  const Vec2<double> up = up_direction(settings.gravity);
  for (const BodyId body : bodies_) {
    const AreaMoments part =
        immersed(scene_.bodies()[body].spec.shapes, in_double(state.pose[body]), up, water.level);
    if (!(part.area > 0)) continue;
    const double time = static_cast<double>(kick(now, static_cast<Real>(seconds)));
    const Vec2<double> lift = -time * water.density * settings.gravity;  // for each square metre
    push(state, body, part.area * lift, cross<double>(part.first, lift), velocity);
    if (!(water.drag > 0)) continue;
    const Vec3<double> flow(water.flow.x(), water.flow.y(), 0);
    const Vec3<double> inverse_mass = state.inverse_mass[body].template cast<double>();
    const Vec3<double> before = velocity[body].template cast<double>() - flow;
    velocity[body] = (flow + slowed(before, inverse_mass, seconds * water.drag * water.density, part))
                         .template cast<Real>();
  }
}

template <Scalar Real>
void Acting<Real>::lead(SubstepTime now, BodyState<Real>& state) const {
  for (const SceneEvent& event : paths_) {
    const auto& path = std::get<FollowPath>(event.action);
    const Vec2<double> goal = path.place(now.begin + now.length - event.time);
    const Vec2<double> way = goal - state.pose[path.body].position.template cast<double>();
    state.velocity[path.body].template head<2>() = (way / now.length).template cast<Real>();
  }
}

template <Scalar Real>
void Acting<Real>::find_changes(SubstepTime now, const std::function<void(BodyId)>& wake) const {
  for (const SceneEvent& event : forces_) {
    const auto& pull = std::get<ApplyForce>(event.action);
    for (const double time : {event.time, event.time + pull.seconds}) {
      if (now.begin <= time && time < now.begin + now.length) wake(pull.body);
    }
  }
}

template class Acting<float>;
template class Acting<double>;

}  // namespace cairn
