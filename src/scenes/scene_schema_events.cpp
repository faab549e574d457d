// Floor 8. Keys of what happens while a scene runs, and of where it should end.
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_field.hpp>
#include <cairn/scenes/scene_list.hpp>

namespace cairn {

List<SceneKey> scene_event_keys() {
  using enum SceneType;
  return {
      {"event", "time", number, "s", ">= 0",
       "carried out before the first step that begins at this time or later", "required"},
      {"event", "remove", text, "", "", "name of a body, which takes its joints along, or of a joint"},
      {"event", "push", text, "", "", "name of a dynamic body that gets an impulse"},
      {"event", "impulse", point, "N s", "", "of a push, along the axes of the world"},
      {"event", "point", point, "m", "",
       "of a push: in the world, where the body begins; it goes and turns with the body",
       "Centre of the body"},
      {"event", "motor", text, "", "", "name of a joint with a motor"},
      {"event", "speed", number, "rad/s or m/s", "", "of the motor", "As before"},
      {"event", "target", number, "rad or m", "", "of the motor, which is a servo then", "As before"},
      {"event", "max_torque", number, "N m", "> 0", "of the motor of a revolute joint or a wheel",
       "As before"},
      {"event", "max_force", number, "N", "> 0", "of the motor of a prismatic joint or a slot", "As before"},
      {"event", "off", flag, "", "", "the motor rests, until an event gives it a speed", "false"},
      {"contact", "a", text, "", "", "name of a body, or \"row.*\": all of a row", "required"},
      {"contact", "b", text, "", "", "the same of what it touches", "required"},
      {"contact", "friction", &PairMaterial::friction, "", "from 0 to 1e6", "mu of the two",
       "By friction_mixing"},
      {"contact", "static_friction", &PairMaterial::static_friction, "", "from 0 to 1e6",
       "mu_s of the two, at least friction", "That of friction, if given, else by friction_mixing"},
      {"contact", "restitution", &PairMaterial::restitution, "", "from 0 to 1", "e of the two",
       "By restitution_mixing"},
      {"expected place", "name", text, "", "", "of a body", "required"},
      {"expected place", "position", &ExpectedPlace::position, "m", "", "of its centre of mass", "required"},
      {"expected place", "within", &ExpectedPlace::within, "m", "> 0", "how far off it may be", "required"},
  };
}

}  // namespace cairn
