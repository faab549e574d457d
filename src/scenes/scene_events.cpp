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
      {"break", {}},
      {"push", {"impulse", "point"}},
      {"motor", {"speed", "max_torque", "max_force", "target", "off"}},
      {"change", {"velocity", "angular_velocity", "friction", "restitution", "surface_speed", "sensor"}},
      {"gravity", {}},
      {"count", {}}};
  return keys;
}

/// Which of them a table is. @throws std::invalid_argument unless it is one, with keys of that one alone.
std::string event_kind(const SceneTable& table) {
  std::string kinds;
  for (const auto& [kind, keys] : event_keys()) {
    if (table.has(kind)) kinds += (kinds.empty() ? "" : " and ") + kind;
  }
  if (!event_keys().contains(kinds))
    table.refuse("", "one of remove, break, push, motor, change, gravity and count",
                 kinds.empty() ? "none of them" : kinds);
  for (const auto& [kind, keys] : event_keys()) {
    for (const std::string& key : keys) {
      if (kind != kinds && table.has(key)) table.refuse(key, "left out of an event without " + kind);
    }
  }
  return kinds;
}

/// Reads events in the order of their times, and knows what those before have left of the scene. Those that
/// wait for a touch come last, and may happen to all that was there at the start.
class EventReader {
 public:
  explicit EventReader(SceneBuilder& builder) : builder_(builder), then_(builder.scene()) {}

  void read(const SceneTable& table) {
    SceneEvent event = event_of(builder_, table);
    if (!event.touch && !table.has("time"))
      table.refuse("", "begun by a time, or else by a touch or a leave", "none");
    if (event.touch) then_ = builder_.scene();
    event.action = read_action(table);
    builder_.add(table, event);
    if (event.touch) return;
    then_.add({.time = 0, .action = event.action});
    then_.do_events(0);
  }

 private:
  SceneAction read_action(const SceneTable& table) {
    const std::string kind = event_kind(table);
    if (kind == "remove") return removal(table);
    if (kind == "push") return push(table);
    if (kind == "motor") return motor(table);
    if (kind == "change") return change(table);
    if (kind == "break") return BreakJoint{.joint = joint(table, "break")};
    if (kind == "gravity") return SetGravity{.gravity = table.get<Vec2<double>>("gravity")};
    if (!table.has("touch") && !table.has("leave"))
      table.refuse("count", "beside a touch or a leave that it counts");
    return CountTouches{.counter = SceneNames::given(table, "count")};
  }

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

  SceneAction change(const SceneTable& table) const {
    const BodyId body = standing_body(table, "change");
    if (body == ground) table.refuse("change", "the name of a body other than the ground");
    ChangeBody change{.body = body};
    table.read(change);
    const List<std::string>& keys = event_keys().at("change");
    const auto is_given = [&table](const std::string& key) { return table.has(key); };
    if (std::none_of(keys.begin(), keys.end(), is_given))
      table.refuse("change", "beside a velocity, a friction or another value that it gets", "none of them");
    return change;
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

SceneEvent event_of(const SceneBuilder& builder, const SceneTable& table) {
  int found = 0;
  for (const char* key : {"time", "touch", "leave"}) found += table.has(key);
  if (found > 1) table.refuse("", "begun by a time, or else by a touch or a leave", "several");
  if (!table.has("touch") && !table.has("leave")) {
    for (const char* key : {"by", "delay", "times"}) {
      if (table.has(key)) table.refuse(key, "left out without a touch or a leave");
    }
    return {.time = table.has("time") ? table.get<double>("time") : 0};
  }
  const bool begins = table.has("touch");
  SceneEvent event{.time = table.get<double>("delay"),
                   .touch = TouchCondition{
                       .a = builder.names().bodies(table, begins ? "touch" : "leave"),
                       .change = begins ? TouchCondition::Change::begins : TouchCondition::Change::ends}};
  if (table.has("by")) event.touch->b = builder.names().bodies(table, "by");
  if (table.has("times")) event.times = table.get<int>("times");
  return event;
}

void build_events(SceneBuilder& builder, const SceneTable& file) {
  List<SceneTable> events = file.tables("event");
  if (events.empty()) return;
  const double end = file.get<double>("seconds");
  for (const SceneTable& event : events) {
    if (!event.has("time") || event.get<double>("time") < end) continue;
    event.refuse("time", "before the end of the scene, which is at " + shortest(end) + " s");
  }
  const auto time_of = [](const SceneTable& event) {
    return event.has("time") ? event.get<double>("time") : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(events.begin(), events.end(), [&](const SceneTable& one, const SceneTable& other) {
    return time_of(one) < time_of(other);
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
