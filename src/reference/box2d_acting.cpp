// Floor 7. Forces, fields and paths for Box2D.
#include <cairn/reference/box2d_acting.hpp>

#include <box2d/box2d.h>

#include <cairn/reference/box2d_shapes.hpp>
#include <cairn/world/acting.hpp>
#include <cairn/world/scene_snapshot.hpp>

namespace cairn {

void act_on(const PerBody<b2Body*>& bodies, const Scene& scene, int steps) {
  if (!Acting<double>::is_needed(scene)) return;
  const Acting<double> acting(scene);
  const SubstepTime now{
      .begin = steps * scene.settings().dt, .length = scene.settings().dt, .is_first = steps == 0};
  BodyState<double> state = state_of<double>(scene);
  for (const BodyId id : bodies.indices()) {
    const b2Vec2 center = bodies[id]->GetWorldCenter(), velocity = bodies[id]->GetLinearVelocity();
    state.pose[id] = {.position = {center.x, center.y}, .angle = static_cast<double>(bodies[id]->GetAngle())};
    state.velocity[id] = {velocity.x, velocity.y, bodies[id]->GetAngularVelocity()};
  }
  const PerBody<Vec3<double>> before = state.velocity;
  const double early =
      now.length - acting.kick(now, now.length);  // gravity that Box2D adds and Cairn does not
  for (const BodyId id : bodies.indices()) {
    if (scene.bodies()[id].spec.type == BodyType::dynamic)
      state.velocity[id].head<2>() -=
          early * scene.bodies()[id].spec.gravity_scale * scene.settings().gravity;
  }
  acting.lead(now, state);
  acting.add(state, now, now.length, state.velocity);
  for (const BodyId id : bodies.indices()) {
    const Vec3<double>& velocity = state.velocity[id];
    if (velocity == before[id]) continue;
    bodies[id]->SetLinearVelocity(to_box2d(velocity.head<2>()));
    bodies[id]->SetAngularVelocity(static_cast<float>(velocity.z()));
  }
}

}  // namespace cairn
