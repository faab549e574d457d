// Floor 7. Events in Box2D.
#include <cairn/reference/box2d_events.hpp>

#include <box2d/box2d.h>

#include <cairn/math/check.hpp>
#include <cairn/reference/box2d_shapes.hpp>
#include <cairn/world/plan.hpp>

namespace cairn {

void check_event(const SceneEvent& event) {
  require(!event.touch, "Box2DWorld", "event", "one with a time: it waits for no touch", "one of a touch");
  const auto* const change = std::get_if<ChangeBody>(&event.action);
  require(!change || !(change->surface_speed || change->sensor), "Box2DWorld", "event",
          "without surface_speed and sensor, which it takes over for good", "one of them");
}

void check_surfaces(const Scene& scene) {
  const Plan plan = make_plan(scene);
  require(!plan.extras.static_friction, "Box2DWorld", "static_friction",
          "that of sliding, as Box2D has one coefficient", "more");
  require(!plan.extras.impact_sequence, "Box2DWorld", "impacts", "at once, as Box2D has no other law",
          "a sequence");
  require(!plan.extras.rolling_resistance, "Box2DWorld", "rolling_resistance", "0, as Box2D 2.4.1 has none",
          "more");
}

void check_strengths(const SceneJoints& joints) {
  for (int i = 0; i < joints.size(); ++i)
    require(!joints.hold(i).strength.is_finite(), "Box2DWorld", "break_force",
            "left out, as break_torque: its joints do not break", "one of them");
}

void change_body(b2Body& body, const Material& material, const ChangeBody& change) {
  if (change.velocity) body.SetLinearVelocity(to_box2d(*change.velocity));
  if (change.angular_velocity) body.SetAngularVelocity(static_cast<float>(*change.angular_velocity));
  for (b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext()) {
    fixture->SetFriction(static_cast<float>(material.friction));
    fixture->SetRestitution(static_cast<float>(material.restitution));
  }
  for (b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next) {
    edge->contact->ResetFriction();
    edge->contact->ResetRestitution();
  }
  body.SetAwake(true);
}

}  // namespace cairn
