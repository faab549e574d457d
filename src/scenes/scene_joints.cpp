// Floor 8. Joints from a scene file, and the kinds of their tables.
#include <algorithm>

#include <cairn/constraints/differential_joint.hpp>
#include <cairn/constraints/drag_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/scenes/named.hpp>
#include <cairn/scenes/scene_builder.hpp>

namespace cairn {

namespace {

Vec2<double> center_of(const SceneBuilder& builder, BodyId body) {
  return builder.scene().bodies()[body].pose.position;
}

/// [m] How far off a rope or a limit still has a row: half of the length of the bodies, where that is more
/// than half a metre.
double enough_margin(const SceneBuilder& builder) { return std::max(1.0, builder.length()) / 2; }

}  // namespace

/// What a table says of a joint of the body `b`, `a` being known.
struct ScenePair {
  SceneBuilder& builder;
  const SceneTable& table;
  std::string name = {};
  BodyId a = ground;
  BodyId b = {};

  Vec2<double> anchor() const {
    return table.has("anchor") ? table.get<Vec2<double>>("anchor") : center_of(builder, b);
  }
  template <typename Joint>
  void join(const typename Joint::Spec& spec) const {
    builder.join<Joint>(table, name, spec, value_of<JointCollision>(table.get<std::string>("collide")));
  }
};

namespace {

void join_distance(const ScenePair& pair) {
  const SceneTable& table = pair.table;
  DistanceJoint::Spec spec{.a = pair.a, .b = pair.b};
  spec.anchor_a = center_of(pair.builder, pair.a);
  spec.anchor_b = center_of(pair.builder, pair.b);
  spec.kind = value_of<DistanceJoint::Kind>(table.kind());
  if (table.kind() != "rod") spec.softness = softness_of(table);
  if (table.kind() == "spring" && !spec.softness) {
    table.refuse("softness", "given for a spring: softness = { stiffness = 50, damping = 1 }", "nothing");
  }
  if (table.kind() == "rope") spec.slack_margin = enough_margin(pair.builder);
  table.read(spec);
  pair.join<DistanceJoint>(spec);
}

/// With its place of rest.
std::optional<JointSpring> spring_of(const SceneTable& table) {
  std::optional<JointSpring> spring = part_of<JointSpring>(table, "spring");
  if (spring) spring->softness = *softness_of(table, "spring");
  return spring;
}

/// A hinge or a slider: with limits, a motor and so on.
template <typename Joint>
void join_driven(const ScenePair& pair, typename Joint::Spec spec) {
  spec.a = pair.a;
  spec.b = pair.b;
  spec.anchor = pair.anchor();
  pair.table.read(spec);
  spec.motor = part_of<typename Joint::Motor>(pair.table, "motor");
  spec.spring = spring_of(pair.table);
  pair.join<Joint>(spec);
}

void join_revolute(const ScenePair& pair) { join_driven<RevoluteJoint>(pair, {}); }

void join_prismatic(const ScenePair& pair) {
  join_driven<PrismaticJoint>(pair, {.limit_margin = enough_margin(pair.builder)});
}

void join_slot(const ScenePair& pair) {
  join_driven<PrismaticJoint>(
      pair, {.kind = PrismaticJoint::Kind::slot, .limit_margin = enough_margin(pair.builder)});
}

void join_wheel(const ScenePair& pair) {
  if (!pair.table.has("spring")) {
    pair.table.refuse("spring", "given for a wheel: spring = { frequency = 4, damping_ratio = 0.7 }",
                      "nothing");
  }
  join_driven<PrismaticJoint>(
      pair,
      {.axis = {0, 1}, .kind = PrismaticJoint::Kind::wheel, .limit_margin = enough_margin(pair.builder)});
}

void join_weld(const ScenePair& pair) {
  pair.join<WeldJoint>({.a = pair.a,
                        .b = pair.b,
                        .anchor = pair.anchor(),
                        .softness = softness_of(pair.table),
                        .bending = softness_of(pair.table, "bending")});
}

void join_gear(const ScenePair& pair) {
  GearJoint::Spec spec{.a = pair.a, .b = pair.b, .c = pair.builder.names().body(pair.table, "carrier")};
  pair.table.read(spec);
  pair.join<GearJoint>(spec);
}

void join_differential(const ScenePair& pair) {
  pair.join<DifferentialJoint>(
      {.a = pair.a, .b = pair.b, .c = pair.builder.names().body(pair.table, "case")});
}

void join_drag(const ScenePair& pair) {
  const SceneTable& table = pair.table;
  if (pair.b == ground) table.refuse("b", "a body other than the ground");
  DragJoint::Spec spec{.body = pair.b, .anchor = pair.anchor()};
  spec.softness = softness_of(table).value_or(spec.softness);
  table.read(spec);
  pair.join<DragJoint>(spec);
}

void join_friction(const ScenePair& pair) {
  FrictionJoint::Spec spec{.a = pair.a, .b = pair.b};
  if (pair.table.has("anchor")) spec.anchor = pair.anchor();
  pair.table.read(spec);
  pair.join<FrictionJoint>(spec);
}

void join_pulley(const ScenePair& rope) {
  const SceneNames& names = rope.builder.names();
  PulleyJoint::Spec spec{.slack_margin = enough_margin(rope.builder)};
  for (const SceneTable& table_of_end : rope.table.tables("ends")) {
    PulleyJoint::End end{.body = names.body(table_of_end, "body"),
                         .carrier = names.body(table_of_end, "carrier")};
    table_of_end.read(end);
    if (end.carrier == end.body) {
      table_of_end.refuse("carrier", "another body than the end's", names.of_bodies()[end.body]);
    }
    if (end.kind == PulleyJoint::Roller::drum && end.carrier == ground) {
      table_of_end.refuse("carrier", "a body that can turn for a drum", "ground");
    }
    spec.ends.push_back(end);
  }
  rope.table.read(spec);
  rope.join<PulleyJoint>(spec);
}

/// `name`: of the joint, or the beginning of the names of many.
void join_from(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  if (table.has("damping_ratio") && !table.has("frequency"))
    table.refuse("damping_ratio", "left out, or else given beside a frequency");
  const SceneTableKind& kind = scene_table_kind(table.kind());
  if (kind.name == "pulley") return kind.join({.builder = builder, .table = table, .name = name});
  const BodyId a = kind.name == "drag" ? ground : builder.names().body(table, "a");
  const bool is_row = table.get<std::string>("b").ends_with(".*");
  int count = 0;
  for (const BodyId b : builder.names().bodies(table, "b")) {
    const std::string number = is_row ? "." + std::to_string(++count) : "";
    kind.join({.builder = builder, .table = table, .name = name + number, .a = a, .b = b});
  }
}

/// The kind of table of a [[joint]] of this type, which has the keys of every joint and those of the groups.
SceneTableKind of_type(const std::string& name, List<std::string> groups, const std::string& meaning,
                       void (*join)(const ScenePair&)) {
  groups.insert(groups.begin(), "joint");
  groups.push_back("strength");
  return {name, "type = \"" + name + "\"", groups, meaning, nullptr, join};
}

/// The kind of a joint's table is its type, which has to be looked at first.
std::string joint_kind(const SceneContext& context, const SceneValue& value, const std::string& path) {
  SceneValue alone;
  alone.mark = value.mark;
  if (const SceneValue* type = value.find("type")) alone.items = {*type};
  return SceneTable(context, alone, "joint", path).get<std::string>("type");
}

}  // namespace

List<SceneTableKind> scene_joint_kinds() {
  return {
      {"bob", "[chain.bob]", {"bob", "matter"}, "Named chain.bob."},
      {"joint", "[[joint]]", {"joint"}, "Every joint has these."},
      of_type("rod", {"pair", "distance", "give"}, "A massless rod.", join_distance),
      of_type("rope", {"pair", "distance", "rope", "slack", "soft", "give"}, "A massless rope.",
              join_distance),
      of_type("spring", {"pair", "distance", "soft"}, "A spring that pulls and pushes.", join_distance),
      of_type("revolute", {"pair", "anchor", "revolute", "give"}, "A pin through two bodies.", join_revolute),
      of_type("prismatic", {"pair", "anchor", "axis", "slide", "prismatic", "give"}, "A slide along a line.",
              join_prismatic),
      of_type("slot", {"pair", "anchor", "axis", "slide", "prismatic", "give"},
              "The anchor on b runs along a line of a, and b turns freely.", join_slot),
      of_type("wheel", {"pair", "anchor", "wheel", "slide", "give"},
              "b is a wheel of a: it runs along the axis on a spring, and turns freely or by a motor.",
              join_wheel),
      of_type("weld", {"pair", "anchor", "weld", "give"}, "Two bodies as one.", join_weld),
      of_type("pulley", {"pulley", "slack", "give"}, "One rope over rollers.", join_pulley),
      of_type("gear", {"pair", "gear", "give"}, "Two wheels that roll on each other, or a wheel and a rack.",
              join_gear),
      of_type("differential", {"differential", "give"}, "a and b turn about their mean.", join_differential),
      of_type("drag", {"drag", "soft"}, "A soft pull to a fixed point, as of a hand.", join_drag),
      of_type("friction", {"pair", "anchor", "friction"}, "A table seen from above.", join_friction),
      {"motor", "motor = {...}", {"motor"}, "Of a revolute joint or a wheel. With a target it is a servo."},
      {"linear_motor",
       "motor = {...}",
       {"linear_motor"},
       "Of a prismatic joint or a slot. With a target it is a servo."},
      {"torsion_spring",
       "spring = {...}",
       {"softness", "torsion_spring"},
       "Of a revolute joint: stiffness in N m/rad and damping in N m s/rad, or a frequency as b would turn "
       "about its own centre."},
      {"slide_spring",
       "spring = {...}",
       {"softness", "slide_spring"},
       "Along the axis of a prismatic joint, a slot or a wheel."},
      {"softness",
       "softness = {...}",
       {"softness"},
       "frequency and damping_ratio, or stiffness and damping."},
      {"end", "ends = [{...}]", {"end"}, "One end of the rope of a pulley."},
  };
}

std::optional<Softness> softness_of(const SceneTable& table, const std::string& key) {
  for (const SceneTable& soft : table.tables(key)) {
    const bool swings = soft.has("frequency"), springs = soft.has("stiffness") || soft.has("damping");
    if (swings == springs || (soft.has("damping_ratio") && springs)) {
      soft.refuse("", "frequency and damping_ratio, or else stiffness and damping",
                  "neither, or some of both");
    }
    if (swings) {
      return SwingSoftness{.frequency = soft.get<double>("frequency"),
                           .damping_ratio = soft.get<double>("damping_ratio")};
    }
    return SpringSoftness{.stiffness = soft.has("stiffness") ? soft.get<double>("stiffness") : 0,
                          .damping = soft.get<double>("damping")};
  }
  return std::nullopt;
}

void build_joint(SceneBuilder& builder, const SceneContext& context, const SceneValue& value, int number) {
  const std::string path = "joint[" + std::to_string(number) + "]";
  const SceneTable table(context, value, joint_kind(context, value, path), path);
  const std::string name = builder.claim_name(table, "joint." + std::to_string(number));
  builder.later([&builder, table, name] { join_from(builder, table, name); });
}

}  // namespace cairn
