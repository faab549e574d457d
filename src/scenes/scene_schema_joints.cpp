// Floor 8. Keys of joints.
#include <cairn/constraints/drag_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_field.hpp>

namespace cairn {

List<SceneKey> scene_pair_keys() {
  using enum SceneType;
  List<std::string> types;
  for (const SceneTableKind& kind : scene_joint_kinds())
    if (kind.join != nullptr) types.push_back(kind.name);
  return {
      {"joint", "type", one_of(types), "", "", "what joins the bodies", "required"},
      {"joint", "name", text, "", "", "letters, digits, _ and -", "Joint.1, joint.2, ..."},
      {"joint", "collide", field_of(JointCollision::as_usual), "", "",
       "whether its bodies may touch. As usual: only those of a pulley, drag or friction joint"},
      {"pair", "a", text, "", "",
       "name of a body; joined to the ground, b goes through its surface unless collide is on", "ground"},
      {"pair", "b", text, "", "", "name of a body; \"row.*\": a joint for each of a row", "required"},
      {"anchor", "anchor", point, "m", "", "in the world, where the bodies begin", "Centre of b"},
      {"distance", "anchor_a", &DistanceJoint::Spec::anchor_a, "m", "",
       "in the world, where the bodies begin", "Centre of a"},
      {"distance", "anchor_b", &DistanceJoint::Spec::anchor_b, "m", "", "in the world", "Centre of b"},
      {"distance", "length", &DistanceJoint::Spec::length, "m", "> 0",
       "of the rod or spring, at rest; of a rope, taut", "As far as the anchors are apart"},
      {"give", "frequency", number, "Hz", "from 1e-6 to 1e6",
       "under the policy soft, in place of joint_frequency; other policies do without it"},
      {"give", "damping_ratio", number, "", "from 0 to 1e30", "likewise, beside a frequency", "5"},
      {"strength", "break_force", &JointStrength::force, "N", "> 0",
       "breaks above this force on its second body, the mean of a step", "Never"},
      {"strength", "break_torque", &JointStrength::torque, "N m", "> 0",
       "likewise, about where it is fastened there; not of pulleys and differentials", "Never"},
      {"slack", "slack_margin", members(&DistanceJoint::Spec::slack_margin, &PulleyJoint::Spec::slack_margin),
       "m", ">= 0", "a rope with more slack has no row", "Where L is more than 1 m L / 2, else 0.5"},
      {"soft", "softness", table, "", "softness", "a spring needs it, a rope may have it"},
      {"rope", "least", &DistanceJoint::Spec::least, "m", ">= 0", "the ends come no nearer to each other"},
      {"weld", "softness", table, "", "softness", "its place gives way like a spring", "Rigid"},
      {"weld", "bending", table, "", "softness",
       "its angle gives way: stiffness in N m/rad, damping in N m s/rad", "Rigid"},
      {"softness", "frequency", number, "Hz", "from 1e-6 to 1e6", "as without damping"},
      {"softness", "damping_ratio", number, "", "from 0 to 1e30", "1: fastest without overshoot", "0"},
      {"softness", "stiffness", number, "N/m", "from 0 to 1e30", "force for each metre"},
      {"softness", "damping", number, "N s/m", "from 0 to 1e30", "force for each m/s", "0"},
  };
}

List<SceneKey> scene_motor_keys() {
  using enum SceneType;
  return {
      {"revolute", "lower", &RevoluteJoint::Spec::lower, "rad", "",
       "limit of the angle of b against a, 0 at the start"},
      {"revolute", "upper", &RevoluteJoint::Spec::upper, "rad", "", "the other limit"},
      {"revolute", "limit_margin", &RevoluteJoint::Spec::limit_margin, "rad", ">= 0",
       "a limit further off has no row"},
      {"revolute", "motor", table, "", "motor", "turns b"},
      {"revolute", "spring", table, "", "torsion_spring", "turns b back to its place of rest"},
      {"revolute", "ratchet", &RevoluteJoint::Spec::ratchet, "rad", "",
       "of a tooth: b turns one way only, counterclockwise if it is positive, and is held at every tooth"},
      {"motor", "speed", members(&RevoluteJoint::Motor::speed, &PrismaticJoint::Motor::speed), "rad/s", "",
       "of b, seen from a; positive: counterclockwise. With a target the most", "required"},
      {"motor", "max_torque", members(&RevoluteJoint::Motor::max_torque, &PrismaticJoint::Motor::max_force),
       "N m", "> 0", "the most that it may apply", "required"},
      {"motor", "target", members(&RevoluteJoint::Motor::target, &PrismaticJoint::Motor::target), "rad", "",
       "angle of b against a, 0 at the start, that it turns to and holds against any load below max_torque"},
      {"motor", "rate", members(&RevoluteJoint::Motor::rate, &PrismaticJoint::Motor::rate), "1/s", "> 0",
       "near the target: its speed for each rad that is missing"},
      {"torsion_spring", "rest", &JointSpring::rest, "rad", "",
       "angle of b against a, 0 at the start, where it does not push"},
      {"axis", "axis", &PrismaticJoint::Spec::axis, "", "", "direction of the slide, of any length but 0"},
      {"wheel", "axis", &PrismaticJoint::Spec::axis, "", "", "of the spring, of any length but 0",
       "Up, [0, 1]"},
      {"wheel", "motor", table, "", "motor", "turns b"},
      {"slide", "lower", &PrismaticJoint::Spec::lower, "m", "",
       "limit of how far b is along, 0 at the start"},
      {"slide", "upper", &PrismaticJoint::Spec::upper, "m", "", "the other limit"},
      {"slide", "limit_margin", &PrismaticJoint::Spec::limit_margin, "m", ">= 0",
       "a limit further off has no row", "Where L is more than 1 m L / 2, else 0.5"},
      {"slide", "spring", table, "", "slide_spring", "along the axis; a wheel needs one"},
      {"prismatic", "motor", table, "", "linear_motor", "moves b"},
      {"prismatic", "ratchet", &PrismaticJoint::Spec::ratchet, "m", "",
       "of a tooth: b slides one way only, along the axis if it is positive, and is held at every tooth"},
      {"linear_motor", "speed", &PrismaticJoint::Motor::speed, "m/s", "",
       "of b along the axis, seen from a. With a target the most", "required"},
      {"linear_motor", "max_force", &PrismaticJoint::Motor::max_force, "N", "> 0",
       "the most that it may apply", "required"},
      {"linear_motor", "target", &PrismaticJoint::Motor::target, "m", "",
       "how far b is along, 0 at the start, that it goes to and holds against any load below max_force"},
      {"linear_motor", "rate", &PrismaticJoint::Motor::rate, "1/s", "> 0",
       "near the target: its speed for each m that is missing"},
      {"slide_spring", "rest", &JointSpring::rest, "m", "", "how far b is along where it does not push"},
  };
}

List<SceneKey> scene_train_keys() {
  using enum SceneType;
  return {
      {"gear", "carrier", text, "", "", "the body that carries both axles", "ground"},
      {"gear", "radius_a", &GearJoint::Spec::radius_a, "m", "> 0", "of wheel a; only the ratio matters"},
      {"gear", "radius_b", &GearJoint::Spec::radius_b, "m", "> 0", "of wheel b, if it is one"},
      {"gear", "mesh", &GearJoint::Spec::mesh, "", "",
       "internal: one wheel inside the other; rack: b slides"},
      {"gear", "axis", &GearJoint::Spec::axis, "", "",
       "the way that a rack goes as a turns counterclockwise"},
      {"differential", "a", text, "", "", "one shaft", "required"},
      {"differential", "b", text, "", "", "the other one", "required"},
      {"differential", "case", text, "", "", "the body between them", "required"},
      {"pulley", "ends", tables, "", "end",
       "one or more, on at most 4 bodies; carriers count, the ground does not", "required"},
      {"pulley", "length", &PulleyJoint::Spec::length, "m", "> 0", "sum of all parts", "As long as it is"},
      {"pulley", "kind", &PulleyJoint::Spec::kind, "", "", "taut: pushes, too"},
      {"end", "body", text, "", "", "what hangs on it", "required"},
      {"end", "anchor", &PulleyJoint::End::anchor, "m", "", "on the body, in the world", "required"},
      {"end", "roller", &PulleyJoint::End::roller, "m", "", "where the rope leaves it", "required"},
      {"end", "parts", &PulleyJoint::End::parts, "", "> 0", "of rope between them: 2 in a block and tackle"},
      {"end", "carrier", text, "", "", "the body that the roller is fixed to", "ground"},
      {"end", "kind", &PulleyJoint::End::kind, "", "", "drum: the rope is wound on the carrier"},
      {"drag", "b", text, "", "", "the body that is dragged", "required"},
      {"drag", "anchor", point, "m", "", "in the world", "Centre of b"},
      {"drag", "target", &DragJoint::Spec::target, "m", "", "in the world", "required"},
      {"drag", "max_force", &DragJoint::Spec::max_force, "N", "> 0", "along each axis"},
      {"friction", "max_force", &FrictionJoint::Spec::max_force, "N", ">= 0", "mu m g"},
      {"friction", "max_torque", &FrictionJoint::Spec::max_torque, "N m", ">= 0",
       "of a disc 2 / 3 mu m g radius"},
      {"friction", "shape", &FrictionJoint::Spec::shape, "", "", "of the forces it may have"},
  };
}

}  // namespace cairn
