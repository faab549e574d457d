// Floor 8. Keys of bodies and shapes, and the kinds of tables.
#include "scenes/scene_schema.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

List<SceneTableKind> scene_setting_kinds() {
  return {
      {"scene", "the file itself", {"scene"}, "Keys before the first table."},
      {"numbers", "[numbers]", {}, "Your own: any name = a number or a sum, for sums further down."},
      {"ground", "[ground]", {"ground"}, "Body 0, named ground, is always there; this gives it a surface."},
      {"camera", "[camera]", {"camera"}, "Without it a picture shows everything."},
      {"step", "[step]", {"pace", "step"}, "How the scene steps."},
      {"stabilization", "[step.stabilization]", {"stabilization"}, "Also as [recommended.stabilization]."},
      {"sleeping", "[step.sleeping]", {"sleeping"}, "When bodies fall asleep."},
      {"recommended", "[recommended]", {"recommended", "pace"}, "A key that is left out is as in [step]."},
      {"event", "[[event]]", {"event"}, "One of remove, push and motor; more at one time are more events."},
      {"expect", "[expect]", {"expect"}, "A key that is left out expects nothing."},
      {"expected place",
       "[[expect.body]]",
       {"expected place"},
       "Where a body should be at the end; not beside stands."},
      {"body",
       "[[body]]",
       {"body", "motion", "shape", "matter"},
       "One shape as a key, or several as shapes."},
      {"shape", "shapes = [{...}]", {"shape", "place"}, "One of several shapes of a body."},
  };
}

List<SceneTableKind> scene_repeat_kinds() {
  return {
      {"link", "[[link]]", {"repeat", "link", "matter"}, "A capsule between two points."},
      {"stack",
       "[[stack]]",
       {"repeat", "stack", "shape", "matter"},
       "Bodies stack.1, stack.2, ..., upwards."},
      {"pyramid", "[[pyramid]]", {"repeat", "pyramid", "shape", "matter"}, "From the left, row by row."},
      {"row", "[[row]]", {"repeat", "row", "motion", "shape", "matter"}, "Row by row, each from its first."},
      {"pile", "[[pile]]", {"repeat", "pile", "shape", "matter"}, "Row by row, from the lowest."},
      {"arch", "[[arch]]", {"repeat", "arch", "matter"}, "From the right foot to the left."},
      {"dominoes", "[[dominoes]]", {"repeat", "dominoes", "matter"}, "From the left."},
      {"cards", "[[cards]]", {"repeat", "cards", "matter"}, "Storey by storey, each pair from the left."},
      {"cradle", "[[cradle]]", {"repeat", "cradle", "matter"}, "From the left; they hang from the ground."},
      {"chain", "[[chain]]", {"repeat", "chain", "shape", "matter"}, "From its beginning to its end."},
      {"bob", "[chain.bob]", {"bob", "matter"}, "Named chain.bob."},
  };
}

List<SceneTableKind> scene_joint_kinds() {
  return {
      {"joint", "[[joint]]", {"joint"}, "Every joint has these."},
      {"rod", "type = \"rod\"", {"joint", "pair", "distance", "give"}, "A massless rod."},
      {"rope", "type = \"rope\"", {"joint", "pair", "distance", "slack", "soft", "give"}, "A massless rope."},
      {"spring",
       "type = \"spring\"",
       {"joint", "pair", "distance", "soft"},
       "A spring that pulls and pushes."},
      {"revolute",
       "type = \"revolute\"",
       {"joint", "pair", "anchor", "revolute", "give"},
       "A pin through two bodies."},
      {"prismatic",
       "type = \"prismatic\"",
       {"joint", "pair", "anchor", "prismatic", "give"},
       "A slide along a line."},
      {"weld", "type = \"weld\"", {"joint", "pair", "anchor", "give"}, "Two bodies as one."},
      {"pulley", "type = \"pulley\"", {"joint", "pulley", "slack", "give"}, "One rope over rollers."},
      {"gear", "type = \"gear\"", {"joint", "pair", "gear", "give"}, "Two wheels that roll on each other."},
      {"differential",
       "type = \"differential\"",
       {"joint", "differential", "give"},
       "a and b turn about their mean."},
      {"drag", "type = \"drag\"", {"joint", "drag", "soft"}, "A soft pull to a fixed point, as of a hand."},
      {"friction",
       "type = \"friction\"",
       {"joint", "pair", "anchor", "friction"},
       "A table seen from above."},
      {"motor", "motor = {...}", {"motor"}, "Of a revolute joint."},
      {"linear_motor", "motor = {...}", {"linear_motor"}, "Of a prismatic joint."},
      {"softness",
       "softness = {...}",
       {"softness"},
       "frequency and damping_ratio, or stiffness and damping."},
      {"end", "ends = [{...}]", {"end"}, "One end of the rope of a pulley."},
  };
}

}  // namespace

const List<SceneTableKind>& scene_table_kinds() {
  static const List<SceneTableKind> kinds = [] {
    List<SceneTableKind> all;
    for (const auto& part : {scene_setting_kinds, scene_repeat_kinds, scene_joint_kinds}) {
      for (SceneTableKind& kind : part()) all.push_back(std::move(kind));
    }
    return all;
  }();
  return kinds;
}

List<SceneKey> scene_body_keys() {
  using enum SceneType;
  return {
      {"body", "name", text, "", "Body.1, body.2, ...", "", "letters, digits, _ and -"},
      {"body", "position", point, "m", "[0, 0]", "", "of the frame that the shapes are given in"},
      {"body", "shapes", tables, "", "", "shape", "several shapes"},
      {"body", "displaced", point, "m", "[0, 0]", "",
       "moved by this once its joints are made: they begin with an error"},
      {"body", "displaced_angle", number, "rad", "0", "", "turned likewise, about the centre of mass"},
      {"motion", "angle", number, "rad", "0", "", "counterclockwise; also \"30 deg\""},
      {"motion", "velocity", point, "m/s", "[0, 0]", "", "of the centre of mass"},
      {"motion", "angular_velocity", number, "rad/s", "0", "", "counterclockwise"},
      {"shape", "box", point, "m", "", "> 0", "width and height"},
      {"shape", "circle", number, "m", "", "> 0", "radius of a disc"},
      {"shape", "capsule", points, "m", "", "", "two points; radius is needed too"},
      {"shape", "polygon", points, "m", "", "", "3 to 16 corners, convex"},
      {"shape", "segment", points, "m", "", "", "two points: a line without mass, for scenery"},
      {"shape", "chain", points, "m", "", "", "ground of any form, solid on the left hand; not dynamic"},
      {"shape", "closed", flag, "", "false", "", "of a chain: its last point is linked to the first"},
      {"shape", "ghosts", points, "m", "", "", "of an open chain: where it comes from and goes on to"},
      {"shape", "radius", number, "m", "0", ">= 0", "of a capsule; rounds a box or polygon outwards"},
      {"place", "offset", point, "m", "[0, 0]", "", "from the body's frame"},
      {"place", "turn", number, "rad", "0", "", "before it is moved"},
      {"matter", "type", word, "", "dynamic", "dynamic, static, kinematic", "static never moves"},
      {"matter", "density", number, "kg/m^2", "1", "> 0", "used if no mass is given"},
      {"matter", "mass", number, "kg", "Density times area", "from 1e-15 to 1e15", "in place of density"},
      {"matter", "inertia", number, "kg m^2", "Of the shapes", "from 1e-15 to 1e15", "about the centre"},
      {"matter", "friction", number, "", "0.6", "from 0 to 1e6", "mu; two surfaces: sqrt(mu_a mu_b)"},
      {"matter", "restitution", number, "", "0", "from 0 to 1", "e; two surfaces: the larger one"},
      {"matter", "linear_damping", number, "1/s", "0", ">= 0", "slows its motion"},
      {"matter", "angular_damping", number, "1/s", "0", ">= 0", "slows its turning"},
      {"matter", "gravity_scale", number, "", "1", "", "0: floats"},
      {"matter", "fixed_rotation", flag, "", "false", "", "never turns"},
      {"matter", "sensor", flag, "", "false", "", "is seen to touch, and does not push"},
      {"matter", "fast", flag, "", "false", "",
       "says nothing: of older files, in which few bodies looked ahead"},
      {"matter", "category", integer, "", "1", "from 0 to 4294967295", "bits: what it is"},
      {"matter", "collides_with", integer, "", "4294967295", "from 0 to 4294967295", "bits: with what"},
  };
}

}  // namespace cairn
