// Floor 8. What happens while a scene runs, and where it should end, from its file.
#include <algorithm>
#include <limits>
#include <map>

#include <cairn/math/check.hpp>
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// The keys that only one kind of event has.
const std::map<std::string, List<std::string>>& event_keys() {
  static const std::map<std::string, List<std::string>> keys = {
      {"remove", {}},
      {"push", {"impulse", "point"}},
      {"motor", {"speed", "max_torque", "max_force", "target", "off"}}};
  return keys;
}

/// Which of them a table is. @throws std::invalid_argument unless it is one, with keys of that one alone.
std::string event_kind(const SceneTable& table) {
  std::string kinds;
  for (const auto& [kind, keys] : event_keys()) {
    if (table.has(kind)) kinds += (kinds.empty() ? "" : " and ") + kind;
  }
  if (!event_keys().contains(kinds))
    table.refuse("", "one of remove, push and motor", kinds.empty() ? "none of them" : kinds);
  for (const auto& [kind, keys] : event_keys()) {
    for (const std::string& key : keys) {
      if (kind != kinds && table.has(key)) table.refuse(key, "left out of an event without " + kind);
    }
  }
  return kinds;
}

/// Reads events in the order of their times, and knows what those before have left of the scene.
class EventReader {
 public:
  explicit EventReader(SceneBuilder& builder) : builder_(builder), then_(builder.scene()) {}

  void read(const SceneTable& table) {
    const std::string kind = event_kind(table);
    const SceneAction action = kind == "remove" ? removal(table)
                               : kind == "push" ? push(table)
                                                : motor(table);
    const SceneEvent event{.time = table.get<double>("time"), .action = action};
    builder_.add(table, event);
    then_.add({.time = 0, .action = action});
    then_.do_events(0);
  }

 private:
  SceneAction removal(const SceneTable& table) const {
    const std::variant<BodyId, JointId> found = builder_.names().body_or_joint(table, "remove");
    if (std::holds_alternative<JointId>(found)) return RemoveJoint{.joint = joint(table, "remove")};
    const BodyId body = standing_body(table, "remove");
    if (body == ground) table.refuse("remove", "the name of a body other than the ground, or of a joint");
    return RemoveBody{.body = body};
  }

  SceneAction push(const SceneTable& table) const {
    const BodyId body = standing_body(table, "push");
    const SceneBody& pushed = then_.bodies()[body];
    if (pushed.spec.type != BodyType::dynamic) table.refuse("push", "the name of a dynamic body");
    if (!table.has("impulse")) table.refuse("impulse", "given for a push: impulse = [1, 0]");
    const Pose<double>& begins = builder_.poses()[body];
    const Vec2<double> point = table.has("point") ? table.get<Vec2<double>>("point") : begins.position;
    return PushBody{
        .body = body, .impulse = table.get<Vec2<double>>("impulse"), .point = begins.local(point)};
  }

  SceneAction motor(const SceneTable& table) {
    const JointId id = joint(table, "motor");
    const Constraint& joint = *then_.joints()[*then_.joints().number_of(id)];
    if (joint.motor()) motors_[id] = *joint.motor();
    if (!motors_.contains(id)) table.refuse("motor", "the name of a joint with a motor");
    const bool turns = joint.traits().turns;
    const std::string most = turns ? "max_torque" : "max_force", other = turns ? "max_force" : "max_torque";
    if (table.has(other)) table.refuse(other, most + " for a " + joint.name() + " joint");
    const bool changes = table.has("speed") || table.has(most) || table.has("target");
    if (table.get<bool>("off") == changes)
      table.refuse("off", "true, or else there is a speed, a target or a " + most,
                   changes ? "both" : "neither");
    if (!changes) return SwitchMotor{.joint = id};
    if (table.has("speed")) motors_[id].speed = table.get<double>("speed");
    if (table.has("target")) motors_[id].target = table.get<double>("target");
    if (table.has(most)) motors_[id].max_force = table.get<double>(most);
    return SwitchMotor{.joint = id, .motor = motors_[id]};
  }

  BodyId standing_body(const SceneTable& table, const std::string& key) const {
    const BodyId body = builder_.names().body(table, key);
    if (then_.bodies()[body].removed) refuse_removed(table, key);
    return body;
  }

  JointId joint(const SceneTable& table, const std::string& key) const {
    const JointId id = builder_.names().joint(table, key);
    if (!then_.joints().number_of(id)) refuse_removed(table, key);
    return id;
  }

  [[noreturn]] void refuse_removed(const SceneTable& table, const std::string& key) const {
    table.refuse(key, "the name of what no event before has removed");
  }

  SceneBuilder& builder_;
  Scene then_;
  std::map<JointId, JointMotor> motors_ = {};  // the last ones, of those that rest too
};

}  // namespace

void build_events(SceneBuilder& builder, const SceneTable& file) {
  List<SceneTable> events = file.tables("event");
  if (events.empty()) return;
  const double end = file.get<double>("seconds");
  for (const SceneTable& event : events) {
    if (event.get<double>("time") < end) continue;
    event.refuse("time", "before the end of the scene, which is at " + shortest(end) + " s");
  }
  std::stable_sort(events.begin(), events.end(), [](const SceneTable& one, const SceneTable& other) {
    return one.get<double>("time") < other.get<double>("time");
  });
  EventReader reader(builder);
  for (const SceneTable& event : events) reader.read(event);
}

List<ExpectedPlace> expected_places(const SceneBuilder& builder, const SceneTable& file) {
  List<ExpectedPlace> places;
  for (const SceneTable& expect : file.tables("expect")) {
    const List<SceneTable> bodies = expect.tables("body");
    if (bodies.empty()) continue;
    if (expect.has("stands")) expect.refuse("stands", "left out where bodies have places to end in");
    Scene end = builder.scene();
    end.do_events(std::numeric_limits<double>::infinity());
    for (const SceneTable& table : bodies) {
      const BodyId body = builder.names().body(table, "name");
      if (end.bodies()[body].removed) table.refuse("name", "the name of a body that no event removes");
      places.push_back({.body = body});
      table.read(places.back());
    }
  }
  return places;
}

}  // namespace cairn
