// Floor 8. Keys of what happens while a scene runs, and of where it should end.
#include "scenes/scene_schema.hpp"
#include "math/list.hpp"

namespace cairn {

List<SceneKey> scene_event_keys() {
  using enum SceneType;
  return {
      {"event", "time", number, "s", "required", ">= 0",
       "carried out before the first step that begins at this time or later"},
      {"event", "remove", text, "", "", "", "name of a body, which takes its joints along, or of a joint"},
      {"event", "push", text, "", "", "", "name of a dynamic body that gets an impulse"},
      {"event", "impulse", point, "N s", "", "", "of a push, along the axes of the world"},
      {"event", "point", point, "m", "Centre of the body", "",
       "of a push: in the world, where the body begins; it goes and turns with the body"},
      {"event", "motor", text, "", "", "", "name of a joint with a motor"},
      {"event", "speed", number, "rad/s or m/s", "As before", "", "of the motor"},
      {"event", "max_torque", number, "N m", "As before", "> 0", "of the motor of a revolute joint"},
      {"event", "max_force", number, "N", "As before", "> 0", "of the motor of a prismatic joint"},
      {"event", "off", flag, "", "false", "", "the motor rests, until an event gives it a speed"},
      {"expected place", "name", text, "", "required", "", "of a body"},
      {"expected place", "position", point, "m", "required", "", "of its centre of mass"},
      {"expected place", "within", number, "m", "required", "> 0", "how far off it may be"},
  };
}

}  // namespace cairn
