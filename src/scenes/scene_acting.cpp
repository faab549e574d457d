// Floor 8. Fields, forces and paths from a scene file.
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/scenes/scene_field.hpp>

namespace cairn {

List<SceneKey> scene_acting_keys() {
  using enum SceneType;
  return {
      {"water", "level", &Water::level, "m", "", "of its surface"},
      {"water", "density", &Water::density, "kg/m^2", "> 0", "of which what it displaces weighs", "required"},
      {"water", "drag", &Water::drag, "1/s", ">= 0", "how fast a body of its density loses velocity in it"},
      {"water", "flow", &Water::flow, "m/s", "", "its velocity"},
      {"attraction", "point", &Attraction::point, "m", "", "towards which it pulls"},
      {"attraction", "strength", &Attraction::strength, "m^3/s^2", "",
       "G M: the acceleration is this / r^2; negative: pushes away", "required"},
      {"attraction", "radius", &Attraction::radius, "m", ">= 0", "nearer, it falls off in proportion to r"},
      {"lasting", "body", text, "", "", "name of a body; \"row.*\": one for each of a row", "required"},
      {"lasting", "time", number, "s", ">= 0", "when it begins", "0"},
      {"force", "times", integer, "", "from 1 to 1000000000", "that a touch brings it at most", "Each time"},
      {"force", "force", &ApplyForce::force, "N", "", "along the axes of the world"},
      {"force", "torque", &ApplyForce::torque, "N m", "", "counterclockwise"},
      {"force", "point", point, "m", "",
       "in the world, where the body begins; it goes and turns with the body", "Centre of the body"},
      {"force", "turns", &ApplyForce::turns, "", "",
       "the force turns with the body, as that of an engine does"},
      {"force", "seconds", &ApplyForce::seconds, "s", "> 0", "for so long", "For ever"},
      {"path", "points", points, "m", "", "where its position goes, from where the body begins", "required"},
      {"path", "speed", &FollowPath::speed, "m/s", "> 0", "along the path", "required"},
      {"path", "kind", &FollowPath::kind, "", "", "how it goes on at the last point"},
  };
}

namespace {

void require_type(const SceneBuilder& builder, const SceneTable& table, BodyId body, BodyType type) {
  if (builder.scene().bodies()[body].spec.type != type)
    table.refuse("body", "the name of a " + word_of(type) + " body");
}

void add_force(SceneBuilder& builder, const SceneTable& table, BodyId body) {
  require_type(builder, table, body, BodyType::dynamic);
  const Pose<double>& begins = builder.poses()[body];
  ApplyForce pull{.body = body};
  table.read(pull);
  if (table.has("point")) pull.point = begins.local(table.get<Vec2<double>>("point"));
  if (pull.turns) pull.force = Rotation<double>(begins.angle).transposed_times(pull.force);
  SceneEvent event = event_of(builder, table);
  event.action = pull;
  builder.add(table, event);
}

void add_path(SceneBuilder& builder, const SceneTable& table, BodyId body) {
  require_type(builder, table, body, BodyType::kinematic);
  FollowPath path{.body = body};
  table.read(path);
  const SceneBody& it = builder.scene().bodies()[body];
  path.points = {it.pose.position};
  for (const Vec2<double>& point : table.get<List<Vec2<double>>>("points"))
    path.points.push_back(it.pose.position + point - it.spec.position);
  SceneEvent event = event_of(builder, table);
  event.action = path;
  if (event.touch) event.times = 1;
  builder.add(table, event);
}

}  // namespace

Fields fields_of(const SceneTable& file, Fields fields) {
  fields.water = part_of<Water>(file, "water");
  for (const SceneTable& table : file.tables("attraction")) table.read(fields.attractions.emplace_back());
  return fields;
}

void build_acting(SceneBuilder& builder, const SceneTable& file) {
  for (const SceneTable& table : file.tables("force")) {
    if (!table.has("force") && !table.has("torque")) table.refuse("", "given a force or a torque", "neither");
    for (const BodyId body : builder.names().bodies(table, "body")) add_force(builder, table, body);
  }
  for (const SceneTable& table : file.tables("path")) {
    for (const BodyId body : builder.names().bodies(table, "body")) add_path(builder, table, body);
  }
}

}  // namespace cairn
