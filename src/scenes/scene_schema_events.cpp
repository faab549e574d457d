// Floor 8. Keys of what happens while a scene runs, and of where it should end.
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_field.hpp>
#include <cairn/scenes/scene_list.hpp>

namespace cairn {

List<SceneKey> scene_event_keys() {
  using enum SceneType;
  return {
      {"event", "time", number, "s", ">= 0",
       "carried out before the first step that begins at this time or later"},
      {"waiting", "touch", text, "", "",
       "in place of a time: name of a body, or \"row.*\"; when it begins to touch, or a sensor is entered"},
      {"waiting", "leave", text, "", "", "likewise: when it no longer touches, or a sensor is left"},
      {"waiting", "by", text, "", "", "what touches or leaves it: name of a body, or \"row.*\"", "Anything"},
      {"waiting", "delay", number, "s", ">= 0", "after the end of the step that saw it", "0"},
      {"event", "times", integer, "", "from 1 to 1000000000", "that it happens at most", "Each time"},
      {"event", "remove", text, "", "", "name of a body, which takes its joints along, or of a joint"},
      {"event", "break", text, "", "", "name of a joint; pictures go on to show its ends"},
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
      {"event", "change", text, "", "", "name of a body that gets other values of the keys below"},
      {"event", "velocity", &ChangeBody::velocity, "m/s", "", "of the centre of mass", "As before"},
      {"event", "angular_velocity", &ChangeBody::angular_velocity, "rad/s", "", "counterclockwise",
       "As before"},
      {"event", "friction", &ChangeBody::friction, "", "from 0 to 1e6", "mu", "As before"},
      {"event", "restitution", &ChangeBody::restitution, "", "from 0 to 1", "e", "As before"},
      {"event", "surface_speed", &ChangeBody::surface_speed, "m/s", "", "of a belt", "As before"},
      {"event", "sensor", &ChangeBody::sensor, "", "", "is seen to touch, and does not push", "As before"},
      {"event", "gravity", point, "m/s^2", "", "of the scene from then on"},
      {"event", "count", text, "", "", "name of a counter, to which each touch adds 1"},
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
