// Floor 8. Joints from a scene file.
#include <algorithm>
#include <map>

#include "constraints/differential_joint.hpp"
#include "constraints/distance_joint.hpp"
#include "constraints/drag_joint.hpp"
#include "constraints/friction_joint.hpp"
#include "constraints/gear_joint.hpp"
#include "constraints/prismatic_joint.hpp"
#include "constraints/pulley_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "constraints/weld_joint.hpp"
#include "scenes/scene_builder.hpp"

namespace cairn {

namespace {

JointCollision collision_of(const SceneTable& table) {
  const JointCollision choices[] = {JointCollision::as_usual, JointCollision::on, JointCollision::off};
  return choices[table.word("collide")];
}

std::optional<double> number_if_given(const SceneTable& table, const std::string& key) {
  if (!table.has(key)) return std::nullopt;
  return table.number(key);
}

Vec2<double> anchor_or_center(const SceneBuilder& builder, const SceneTable& table, const std::string& key,
                              BodyId body) {
  return table.has(key) ? table.point(key) : builder.scene().bodies()[body].pose.position;
}

/// [m] How far off a rope or a limit still has a row: half of the length of the bodies, where that is more
/// than half a metre.
double margin_or_enough(const SceneBuilder& builder, const SceneTable& table, const std::string& key) {
  return table.has(key) ? table.number(key) : std::max(1.0, builder.length()) / 2;
}

/// What a table says of a joint of the body `b`, `a` being known.
struct ScenePair {
  SceneBuilder& builder;
  const SceneTable& table;
  std::string name = {};
  BodyId a = ground;
  BodyId b = {};

  Vec2<double> anchor() const { return anchor_or_center(builder, table, "anchor", b); }
  template <typename Joint>
  void join(const typename Joint::Spec& spec) const {
    builder.join<Joint>(table, name, spec, collision_of(table));
  }
};

void join_distance(const ScenePair& pair) {
  const std::map<std::string, DistanceJoint::Kind> kinds = {{"rod", DistanceJoint::Kind::rod},
                                                            {"rope", DistanceJoint::Kind::rope},
                                                            {"spring", DistanceJoint::Kind::spring}};
  const SceneTable& table = pair.table;
  DistanceJoint::Spec spec{.a = pair.a, .b = pair.b};
  spec.anchor_a = anchor_or_center(pair.builder, table, "anchor_a", pair.a);
  spec.anchor_b = anchor_or_center(pair.builder, table, "anchor_b", pair.b);
  spec.length = number_if_given(table, "length").value_or(-1);
  spec.kind = kinds.at(table.kind());
  if (table.kind() != "rod") spec.softness = softness_of(table);
  if (table.kind() == "spring" && !spec.softness) {
    table.refuse("softness", "given for a spring: softness = { stiffness = 50, damping = 1 }", "nothing");
  }
  if (table.kind() == "rope") spec.slack_margin = margin_or_enough(pair.builder, table, "slack_margin");
  pair.join<DistanceJoint>(spec);
}

/// Of a hinge or a slider.
template <typename Spec>
void read_limits(const SceneTable& table, Spec& spec) {
  spec.lower = number_if_given(table, "lower");
  spec.upper = number_if_given(table, "upper");
}

void join_revolute(const ScenePair& pair) {
  const SceneTable& table = pair.table;
  RevoluteJoint::Spec spec{.a = pair.a, .b = pair.b, .anchor = pair.anchor()};
  read_limits(table, spec);
  spec.limit_margin = table.number("limit_margin");
  for (const SceneTable& motor : table.tables("motor")) {
    spec.motor =
        RevoluteJoint::Motor{.speed = motor.number("speed"), .max_torque = motor.number("max_torque")};
  }
  pair.join<RevoluteJoint>(spec);
}

void join_prismatic(const ScenePair& pair) {
  const SceneTable& table = pair.table;
  PrismaticJoint::Spec spec{.a = pair.a, .b = pair.b, .anchor = pair.anchor(), .axis = table.point("axis")};
  read_limits(table, spec);
  spec.limit_margin = margin_or_enough(pair.builder, table, "limit_margin");
  for (const SceneTable& motor : table.tables("motor")) {
    spec.motor =
        PrismaticJoint::Motor{.speed = motor.number("speed"), .max_force = motor.number("max_force")};
  }
  pair.join<PrismaticJoint>(spec);
}

void join_weld(const ScenePair& pair) {
  pair.join<WeldJoint>({.a = pair.a, .b = pair.b, .anchor = pair.anchor()});
}

void join_gear(const ScenePair& pair) {
  const GearJoint::Mesh meshes[] = {GearJoint::Mesh::external, GearJoint::Mesh::internal};
  const SceneTable& table = pair.table;
  pair.join<GearJoint>({.a = pair.a,
                        .b = pair.b,
                        .c = pair.builder.names().body(table, "carrier"),
                        .radius_a = table.number("radius_a"),
                        .radius_b = table.number("radius_b"),
                        .mesh = meshes[table.word("mesh")]});
}

void join_differential(const ScenePair& pair) {
  pair.join<DifferentialJoint>(
      {.a = pair.a, .b = pair.b, .c = pair.builder.names().body(pair.table, "case")});
}

void join_drag(const ScenePair& pair) {
  const SceneTable& table = pair.table;
  if (pair.b == ground) table.refuse("b", "a body other than the ground");
  DragJoint::Spec spec{.body = pair.b, .anchor = pair.anchor(), .target = table.point("target")};
  spec.softness = softness_of(table).value_or(spec.softness);
  spec.max_force = table.number("max_force");
  pair.join<DragJoint>(spec);
}

void join_friction(const ScenePair& pair) {
  const FrictionShape shapes[] = {FrictionShape::circle, FrictionShape::square,
                                  FrictionShape::aligned_square};
  const SceneTable& table = pair.table;
  FrictionJoint::Spec spec{.a = pair.a, .b = pair.b};
  if (table.has("anchor")) spec.anchor = table.point("anchor");
  spec.max_force = table.number("max_force");
  spec.max_torque = table.number("max_torque");
  spec.shape = shapes[table.word("shape")];
  pair.join<FrictionJoint>(spec);
}

void join_pulley(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  PulleyJoint::Spec spec;
  for (const SceneTable& end : table.tables("ends")) {
    const BodyId body = builder.names().body(end, "body"), carrier = builder.names().body(end, "carrier");
    if (carrier == body)
      end.refuse("carrier", "another body than the end's", builder.names().of_bodies()[carrier]);
    const bool on_drum = end.word("kind") == 1;
    if (on_drum && carrier == ground) end.refuse("carrier", "a body that can turn for a drum", "ground");
    spec.ends.push_back({.body = body,
                         .anchor = end.point("anchor"),
                         .roller = end.point("roller"),
                         .parts = end.number("parts"),
                         .carrier = carrier,
                         .kind = on_drum ? PulleyJoint::Roller::drum : PulleyJoint::Roller::smooth});
  }
  spec.length = number_if_given(table, "length").value_or(-1);
  spec.kind = table.word("kind") == 0 ? PulleyJoint::Kind::rope : PulleyJoint::Kind::taut;
  spec.slack_margin = margin_or_enough(builder, table, "slack_margin");
  builder.join<PulleyJoint>(table, name, spec, collision_of(table));
}

using ScenePairJoiner = void (*)(const ScenePair&);

/// `name`: of the joint, or the beginning of the names of many.
void join_from(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  static const std::map<std::string, ScenePairJoiner> joiners = {
      {"rod", join_distance},      {"rope", join_distance}, {"spring", join_distance},
      {"revolute", join_revolute}, {"weld", join_weld},     {"prismatic", join_prismatic},
      {"gear", join_gear},         {"drag", join_drag},     {"differential", join_differential},
      {"friction", join_friction}};
  if (table.has("damping_ratio") && !table.has("frequency"))
    table.refuse("damping_ratio", "left out, or else given beside a frequency");
  if (table.kind() == "pulley") return join_pulley(builder, table, name);
  const BodyId a = table.kind() == "drag" ? ground : builder.names().body(table, "a");
  const bool is_row = table.text("b").ends_with(".*");
  int count = 0;
  for (const BodyId b : builder.names().bodies(table, "b")) {
    const std::string number = is_row ? "." + std::to_string(++count) : "";
    joiners.at(table.kind())({.builder = builder, .table = table, .name = name + number, .a = a, .b = b});
  }
}

/// The kind of a joint's table is its type, which has to be looked at first.
std::string joint_kind(const SceneContext& context, const SceneValue& value, const std::string& path) {
  SceneValue alone;
  alone.mark = value.mark;
  if (const SceneValue* type = value.find("type")) alone.items = {*type};
  return SceneTable(context, alone, "joint", path).text("type");
}

}  // namespace

std::optional<Softness> softness_of(const SceneTable& table) {
  for (const SceneTable& soft : table.tables("softness")) {
    const bool swings = soft.has("frequency"), springs = soft.has("stiffness") || soft.has("damping");
    if (swings == springs || (soft.has("damping_ratio") && springs)) {
      soft.refuse("", "frequency and damping_ratio, or else stiffness and damping",
                  "neither, or some of both");
    }
    if (swings) {
      return SwingSoftness{.frequency = soft.number("frequency"),
                           .damping_ratio = soft.number("damping_ratio")};
    }
    return SpringSoftness{.stiffness = soft.has("stiffness") ? soft.number("stiffness") : 0,
                          .damping = soft.number("damping")};
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
