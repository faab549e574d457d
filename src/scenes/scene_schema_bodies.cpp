// Floor 8. Keys of bodies and shapes, and the kinds of tables that are no joints.
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/scenes/scene_field.hpp>

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
      {"water", "[water]", {"water"}, "Fills all that is below its level."},
      {"attraction", "", {"attraction"}, "Pulls all dynamic bodies towards a point."},
      {"force", "", {"lasting", "waiting", "force"}, "On a dynamic body."},
      {"path",
       "",
       {"lasting", "waiting", "path"},
       "Of a kinematic body, along straight lines; one that waits begins once."},
      {"event",
       "",
       {"waiting", "event"},
       "One of remove, break, push, motor, change, gravity and count; more at one time are more events."},
      {"contact", "", {"contact"}, "What two bodies, or rows of them, have where they touch."},
      {"expect", "[expect]", {"expect"}, "A key that is left out expects nothing."},
      {"expected place",
       "[[expect.body]]",
       {"expected place"},
       "Where a body should be at the end; not beside stands."},
      {"body", "", {"body", "motion", "shape", "matter"}, "One shape as a key, or several as shapes."},
      {"shape", "shapes = [{...}]", {"shape", "place"}, "One of several shapes of a body."},
  };
}

/// All have a name, keys of their own and what bodies are made of; some have more.
List<SceneTableKind> scene_repeat_kinds() {
  List<SceneTableKind> kinds = {
      {"link", "", {}, "A capsule between two points.", build_link},
      {"stack", "", {"shape"}, "Boxes or discs stack.1, stack.2, ..., upwards.", build_stack},
      {"pyramid", "", {"shape"}, "Boxes or discs from the left, row by row.", build_pyramid},
      {"row", "", {"motion", "shape", "strength"}, "Row by row, each from its first.", build_row},
      {"pile", "", {"shape"}, "Boxes or discs, row by row, from the lowest.", build_pile},
      {"arch", "", {}, "From the right foot to the left.", build_arch},
      {"dominoes", "", {}, "From the left.", build_dominoes},
      {"cards", "", {}, "Storey by storey, each pair from the left.", build_cards},
      {"cradle", "", {}, "From the left; they hang from the ground.", build_cradle},
      {"chain", "", {"shape", "strength"}, "From its beginning to its end.", build_chain},
  };
  for (SceneTableKind& kind : kinds) {
    kind.groups.insert(kind.groups.begin(), {"repeat", kind.name});
    kind.groups.push_back("matter");
  }
  return kinds;
}

}  // namespace

const List<SceneTableKind>& scene_table_kinds() {
  static const List<SceneTableKind> kinds = [] {
    List<SceneTableKind> all;
    for (const auto& part : {scene_setting_kinds, scene_repeat_kinds, scene_joint_kinds}) {
      for (const SceneTableKind& kind : part()) {
        all.push_back(kind);
        if (kind.heading.empty()) all.back().heading = "[[" + kind.name + "]]";
      }
    }
    return all;
  }();
  return kinds;
}

List<SceneKey> scene_body_keys() {
  using enum SceneType;
  return {
      {"body", "name", text, "", "", "letters, digits, _ and -", "Body.1, body.2, ..."},
      {"body", "position", &BodySpec::position, "m", "", "of the frame that the shapes are given in"},
      {"body", "shapes", tables, "", "shape", "several shapes"},
      {"body", "displaced", point, "m", "",
       "moved by this once its joints are made: they begin with an error", "[0, 0]"},
      {"body", "displaced_angle", number, "rad", "", "turned likewise, about the centre of mass", "0"},
      {"motion", "angle", &BodySpec::angle, "rad", "", "counterclockwise; also \"30 deg\""},
      {"motion", "velocity", &BodySpec::velocity, "m/s", "", "of the centre of mass"},
      {"motion", "angular_velocity", &BodySpec::angular_velocity, "rad/s", "", "counterclockwise"},
      {"shape", "box", point, "m", "> 0", "width and height"},
      {"shape", "circle", number, "m", "> 0", "radius of a disc"},
      {"shape", "capsule", points, "m", "", "two points; radius is needed too"},
      {"shape", "polygon", points, "m", "", "3 to 500 corners of an outline that does not cross itself"},
      {"shape", "segment", points, "m", "", "two points: a line without mass, for scenery"},
      {"shape", "chain", points, "m", "", "ground of any form, solid on the left hand; not dynamic"},
      {"shape", "closed", flag, "", "", "of a chain: its last point is linked to the first", "false"},
      {"shape", "ghosts", points, "m", "", "of an open chain: where it comes from and goes on to"},
      {"shape", "radius", number, "m", ">= 0", "of a capsule; rounds a box or convex polygon outwards", "0"},
      {"place", "offset", point, "m", "", "from the body's frame", "[0, 0]"},
      {"place", "turn", number, "rad", "", "before it is moved", "0"},
      {"matter", "type", &BodySpec::type, "", "", "static never moves"},
      {"matter", "density", &BodySpec::density, "kg/m^2", "> 0", "used if no mass is given"},
      {"matter", "mass", &BodySpec::mass, "kg", "from 1e-15 to 1e15", "in place of density",
       "Density times area"},
      {"matter", "inertia", &BodySpec::inertia, "kg m^2", "from 1e-15 to 1e15", "about the centre",
       "Of the shapes"},
      {"matter", "friction", nested(&BodySpec::material, &Material::friction), "", "from 0 to 1e6",
       "mu; two surfaces: by friction_mixing"},
      {"matter", "static_friction", nested(&BodySpec::material, &Material::static_friction), "",
       "from 0 to 1e6", "of surfaces that stick, at least friction", "That of friction"},
      {"matter", "restitution", nested(&BodySpec::material, &Material::restitution), "", "from 0 to 1",
       "e; two surfaces: by restitution_mixing"},
      {"matter", "rolling_resistance", nested(&BodySpec::material, &Material::rolling_resistance), "m",
       ">= 0", "a moment resists rolling, this times the load; of two the larger"},
      {"matter", "surface_speed", nested(&BodySpec::material, &Material::surface_speed), "m/s", "",
       "of a belt: to the right where it faces up"},
      {"matter", "linear_damping", nested(&BodySpec::damping, &Damping::linear), "1/s", ">= 0",
       "slows its motion"},
      {"matter", "angular_damping", nested(&BodySpec::damping, &Damping::angular), "1/s", ">= 0",
       "slows its turning"},
      {"matter", "drag", nested(&BodySpec::damping, &Damping::quadratic), "kg/m", ">= 0",
       "of the air: this times the square of its speed against the wind, rho c_d A / 2"},
      {"matter", "gravity_scale", &BodySpec::gravity_scale, "", "", "0: floats"},
      {"matter", "fixed_rotation", &BodySpec::fixed_rotation, "", "", "never turns"},
      {"matter", "sensor", &BodySpec::sensor, "", "", "is seen to touch, and does not push"},
      {"matter", "fast", flag, "", "", "says nothing: of older files, in which few bodies looked ahead",
       "false"},
      {"matter", "one_way", nested(&BodySpec::filter, &CollisionFilter::one_way), "", "",
       "a direction, which turns with it: it holds off only what comes from there. Not of dynamic bodies"},
      {"matter", "category", nested(&BodySpec::filter, &CollisionFilter::category), "",
       "from 0 to 4294967295", "bits: what it is"},
      {"matter", "collides_with", nested(&BodySpec::filter, &CollisionFilter::collides_with), "",
       "from 0 to 4294967295", "bits: with what"},
  };
}

}  // namespace cairn
