// Floor 8. Keys of joints.
#include "scenes/scene_schema.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

List<SceneKey> scene_pair_keys() {
  using enum SceneType;
  return {
      {"joint", "type", word, "", "required",
       "rod, rope, spring, revolute, prismatic, weld, pulley, gear, differential, drag, friction",
       "what joins the bodies"},
      {"joint", "name", text, "", "Joint.1, joint.2, ...", "", "letters, digits, _ and -"},
      {"joint", "collide", word, "", "as-usual", "as-usual, on, off",
       "whether its bodies may touch. As usual: only those of a pulley, drag or friction joint"},
      {"pair", "a", text, "", "ground", "",
       "name of a body; joined to the ground, b goes through its surface unless collide is on"},
      {"pair", "b", text, "", "required", "", "name of a body; \"row.*\": a joint for each of a row"},
      {"anchor", "anchor", point, "m", "Centre of b", "", "in the world, where the bodies begin"},
      {"distance", "anchor_a", point, "m", "Centre of a", "", "in the world, where the bodies begin"},
      {"distance", "anchor_b", point, "m", "Centre of b", "", "in the world"},
      {"distance", "length", number, "m", "As far as the anchors are apart", "> 0",
       "of the rod or spring, at rest; of a rope, taut"},
      {"give", "frequency", number, "Hz", "", "from 1e-6 to 1e6",
       "under the policy soft, in place of joint_frequency; other policies do without it"},
      {"give", "damping_ratio", number, "", "5", "from 0 to 1e30", "likewise, beside a frequency"},
      {"slack", "slack_margin", number, "m", "Where L is more than 1 m L / 2, else 0.5", ">= 0",
       "a rope with more slack has no row"},
      {"soft", "softness", table, "", "", "softness", "a spring needs it, a rope may have it"},
      {"softness", "frequency", number, "Hz", "", "from 1e-6 to 1e6", "as without damping"},
      {"softness", "damping_ratio", number, "", "0", "from 0 to 1e30", "1: fastest without overshoot"},
      {"softness", "stiffness", number, "N/m", "", "from 0 to 1e30", "force for each metre"},
      {"softness", "damping", number, "N s/m", "0", "from 0 to 1e30", "force for each m/s"},
  };
}

List<SceneKey> scene_motor_keys() {
  using enum SceneType;
  return {
      {"revolute", "lower", number, "rad", "", "", "limit of the angle of b against a, 0 at the start"},
      {"revolute", "upper", number, "rad", "", "", "the other limit"},
      {"revolute", "limit_margin", number, "rad", "0.5", ">= 0", "a limit further off has no row"},
      {"revolute", "motor", table, "", "", "motor", "turns b"},
      {"motor", "speed", number, "rad/s", "required", "", "of b, seen from a; positive: counterclockwise"},
      {"motor", "max_torque", number, "N m", "required", "> 0", "the most that it may apply"},
      {"prismatic", "axis", point, "", "[1, 0]", "", "direction of the slide, of any length but 0"},
      {"prismatic", "lower", number, "m", "", "", "limit of how far b is along, 0 at the start"},
      {"prismatic", "upper", number, "m", "", "", "the other limit"},
      {"prismatic", "limit_margin", number, "m", "Where L is more than 1 m L / 2, else 0.5", ">= 0",
       "a limit further off has no row"},
      {"prismatic", "motor", table, "", "", "linear_motor", "moves b"},
      {"linear_motor", "speed", number, "m/s", "required", "", "of b along the axis, seen from a"},
      {"linear_motor", "max_force", number, "N", "required", "> 0", "the most that it may apply"},
  };
}

List<SceneKey> scene_train_keys() {
  using enum SceneType;
  return {
      {"gear", "carrier", text, "", "ground", "", "the body that carries both axles"},
      {"gear", "radius_a", number, "m", "1", "> 0", "of wheel a; only the ratio matters"},
      {"gear", "radius_b", number, "m", "1", "> 0", "of wheel b"},
      {"gear", "mesh", word, "", "external", "external, internal", "internal: one wheel inside the other"},
      {"differential", "a", text, "", "required", "", "one shaft"},
      {"differential", "b", text, "", "required", "", "the other one"},
      {"differential", "case", text, "", "required", "", "the body between them"},
      {"pulley", "ends", tables, "", "required", "end",
       "one or more, on at most 4 bodies; carriers count, the ground does not"},
      {"pulley", "length", number, "m", "As long as it is", "> 0", "sum of all parts"},
      {"pulley", "kind", word, "", "rope", "rope, taut", "taut: pushes, too"},
      {"end", "body", text, "", "required", "", "what hangs on it"},
      {"end", "anchor", point, "m", "required", "", "on the body, in the world"},
      {"end", "roller", point, "m", "required", "", "where the rope leaves it"},
      {"end", "parts", number, "", "1", "> 0", "of rope between them: 2 in a block and tackle"},
      {"end", "carrier", text, "", "ground", "", "the body that the roller is fixed to"},
      {"end", "kind", word, "", "smooth", "smooth, drum", "drum: the rope is wound on the carrier"},
      {"drag", "b", text, "", "required", "", "the body that is dragged"},
      {"drag", "anchor", point, "m", "Centre of b", "", "in the world"},
      {"drag", "target", point, "m", "required", "", "in the world"},
      {"drag", "max_force", number, "N", "1000", "> 0", "along each axis"},
      {"friction", "max_force", number, "N", "0", ">= 0", "mu m g"},
      {"friction", "max_torque", number, "N m", "0", ">= 0", "of a disc 2 / 3 mu m g radius"},
      {"friction", "shape", word, "", "circle", "circle, square, aligned-square",
       "of the forces it may have"},
  };
}

}  // namespace

List<SceneKey> scene_joint_keys() {
  List<SceneKey> all;
  for (const auto& part : {scene_pair_keys, scene_motor_keys, scene_train_keys}) {
    for (SceneKey& key : part()) all.push_back(std::move(key));
  }
  return all;
}

}  // namespace cairn
