// Floor 7. Motors and servos in Box2D, and what it does in another way.
#include <box2d/box2d.h>

#include <set>

#include <cairn/reference/box2d_joints.hpp>

namespace cairn {

void set_motor(b2Joint& joint, const std::optional<JointMotor>& motor) {
  const float speed = motor ? static_cast<float>(motor->speed) : 0,
              most = motor ? static_cast<float>(motor->max_force) : 0;
  const auto set = [&](auto& driven) {
    driven.EnableMotor(motor.has_value());
    driven.SetMotorSpeed(speed);
    if constexpr (requires { driven.SetMaxMotorTorque(most); }) {
      driven.SetMaxMotorTorque(most);
    } else {
      driven.SetMaxMotorForce(most);
    }
  };
  if (joint.GetType() == e_revoluteJoint) set(static_cast<b2RevoluteJoint&>(joint));
  if (joint.GetType() == e_prismaticJoint) set(static_cast<b2PrismaticJoint&>(joint));
  if (joint.GetType() == e_wheelJoint) set(static_cast<b2WheelJoint&>(joint));
}

std::optional<double> servo_speed(const Constraint& joint, const BodyState<double>& state, double dt) {
  RowSpecs<double> rows;
  StatedRows<double> stated(rows, &state.inverse_mass);
  joint.write_rows(Placements<double>(state.pose), stated);
  for (const RowSpec<double>& row : rows)
    if (row.approach > 0) return servo_speed(row, dt);
  return std::nullopt;
}

List<std::string> box2d_differences(const Scene& scene) {
  std::set<std::string> names;
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) names.insert(joint->name());
  List<std::string> lines;
  const auto add_if = [&](const char* name, const char* line) {
    if (names.contains(name)) lines.push_back(line);
  };
  add_if("spring", "springs are implicit Euler in Box2D: they lose energy that Cairn's keep");
  add_if("wheel", "springs of wheels are implicit Euler in Box2D: they lose energy that Cairn's keep");
  add_if("pulley", "the rope of a pulley pushes in Box2D, too");
  add_if("rope", "the ends of a rope come no nearer than 0.005 m in Box2D");
  add_if(
      "drag",
      "a drag in Box2D has its limit in any direction, not along each axis, and slows turning by 2 % a step");
  return lines;
}

}  // namespace cairn
