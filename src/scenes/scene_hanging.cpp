// Floor 8. Chains and cradles: bodies in a row, and the joints between them.
#include <cmath>

#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "constraints/weld_joint.hpp"
#include "scenes/scene_builder.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

enum class ChainJoint { pin, weld, rod, rope, spring };

/// Where a chain runs, and what it is made of.
struct ChainPlan {
  std::string name = {};
  int n = 0;
  ChainJoint joint = ChainJoint::pin;
  Vec2<double> from = {0, 0};   // [m]
  Vec2<double> along = {0, 0};  // unit vector
  double angle = 0;             // [rad] of the links
  double link = 0;              // [m] from joint to joint, or from body to body
  bool is_fastened = false;     // at its end

  bool meets() const { return joint == ChainJoint::pin || joint == ChainJoint::weld; }
};

ChainPlan plan_chain(const SceneTable& table, const std::string& name) {
  ChainPlan plan{
      .name = name, .n = table.integer("n"), .joint = static_cast<ChainJoint>(table.word("joint"))};
  plan.from = table.point("from");
  plan.is_fastened = table.has("b");
  if (table.has("to")) {
    for (const char* key : {"link", "angle"}) {
      if (table.has(key)) table.refuse(key, "left out where the chain has an end, to");
    }
    const Vec2<double> way = table.point("to") - plan.from;
    if (!(way.norm() > 0)) table.refuse("to", "a point other than from", "the same");
    plan.along = way / way.norm();
    plan.angle = arc_tangent(plan.along.y(), plan.along.x());
    plan.link = way.norm() / (plan.meets() || !plan.is_fastened ? plan.n : plan.n + 1);
  } else {
    if (!table.has("link"))
      table.refuse("link", "given, or else to, so that the chain has a length", "neither");
    plan.angle = table.number("angle");
    plan.along = {sine(plan.angle), -cosine(plan.angle)};
    plan.link = table.number("link");
  }
  return plan;
}

/// Where body i of the chain is, from 0.
Vec2<double> chain_place(const SceneTable& table, const ChainPlan& plan, int i) {
  const Vec2<double> anchor = plan.from + i * plan.link * plan.along;
  if (plan.meets()) return anchor + plan.link / 2 * plan.along;
  const double half = plan.link * (plan.is_fastened ? plan.n + 1 : plan.n) / 2;
  const double x = (i + 1) * plan.link - half;  // [m] along the chain, from its middle
  Vec2<double> place = plan.from + (i + 1) * plan.link * plan.along;
  if (table.has("aside")) {
    place += table.number("aside") * (1 - std::abs(x) / half) * perpendicular(plan.along);
  }
  return place;
}

/// Joint `number` of the chain, from 0.
std::string chain_joint_name(const ChainPlan& plan, int number) {
  return plan.name + ".joint." + std::to_string(number + 1);
}

void join_chain(SceneBuilder& builder, const SceneTable& table, const ChainPlan& plan, int number, BodyId a,
                BodyId b, const Vec2<double>& anchor_a, const Vec2<double>& anchor_b) {
  const std::string name = chain_joint_name(plan, number);
  if (plan.joint == ChainJoint::pin) {
    return builder.join<RevoluteJoint>(table, name, {.a = a, .b = b, .anchor = anchor_a});
  }
  if (plan.joint == ChainJoint::weld) {
    return builder.join<WeldJoint>(table, name, {.a = a, .b = b, .anchor = anchor_a});
  }
  const DistanceJoint::Kind kinds[] = {DistanceJoint::Kind::rod, DistanceJoint::Kind::rope,
                                       DistanceJoint::Kind::spring};
  builder.join<DistanceJoint>(table, name,
                              {.a = a,
                               .b = b,
                               .anchor_a = anchor_a,
                               .anchor_b = anchor_b,
                               .length = table.has("length") ? table.number("length") : -1,
                               .kind = kinds[static_cast<int>(plan.joint) - 2],
                               .softness = softness_of(table)});
}

/// Joins bodies `links` in a row, and its ends.
void join_chain_bodies(SceneBuilder& builder, const SceneTable& table, const ChainPlan& plan,
                       const List<BodyId>& links) {
  BodyId before = builder.names().body(table, "a");
  Vec2<double> anchor = plan.from;
  for (int i = 0; i < plan.n; ++i) {
    const BodyId next = links[i];
    if (plan.meets()) anchor = plan.from + i * plan.link * plan.along;
    const Vec2<double> place = chain_place(table, plan, i);
    join_chain(builder, table, plan, i, before, next, anchor, place);
    before = next;
    anchor = place;
  }
  if (!plan.is_fastened) return;
  const Vec2<double> end =
      table.has("to") ? table.point("to") : Vec2<double>(plan.from + plan.n * plan.link * plan.along);
  join_chain(builder, table, plan, plan.n, before, builder.names().body(table, "b"),
             plan.meets() ? end : anchor, end);
}

void build_bob(SceneBuilder& builder, const SceneTable& bob, const ChainPlan& plan, BodyId last,
               const std::string& name) {
  const double radius = bob.number("radius");
  const Vec2<double> end = plan.from + plan.n * plan.link * plan.along;
  BodySpec spec = matter_of(bob);
  spec.shapes = {circle(radius)};
  spec.position = end + radius * plan.along;
  spec.angle = plan.angle;
  if (bob.has("ratio")) spec.mass = bob.number("ratio") * builder.scene().bodies()[last].mass;
  const BodyId body = builder.add(bob, spec, name);
  builder.later([&builder, bob, joint = chain_joint_name(plan, plan.n), last, body, end] {
    builder.join<RevoluteJoint>(bob, joint, {.a = last, .b = body, .anchor = end});
  });
}

}  // namespace

void build_cradle(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const Vec2<double> middle = table.point("position");
  const double radius = table.number("radius"), rod = table.number("rod");
  const int n = table.integer("n");
  BodySpec spec = matter_of(table);
  spec.shapes = {circle(radius)};
  for (int i = 0; i < n; ++i) {
    const Vec2<double> top(middle.x() + (2 * radius + table.number("gap")) * (i - 0.5 * (n - 1)), middle.y());
    const double aside = i == 0 ? table.number("aside") : 0;  // [rad]
    const Vec2<double> place = top + rod * Vec2<double>(sine(aside), -cosine(aside));
    spec.position = place;
    const BodyId ball = builder.add(table, spec, name + "." + std::to_string(i + 1));
    const std::string joint = name + ".joint." + std::to_string(i + 1);
    builder.later([&builder, table, joint, ball, top, place] {
      builder.join<DistanceJoint>(table, joint, {.a = ground, .b = ball, .anchor_a = top, .anchor_b = place});
    });
  }
}

void build_chain(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const ChainPlan plan = plan_chain(table, name);
  BodySpec spec = matter_of(table);
  spec.shapes = shape_of(table);
  if (spec.shapes.empty() && !plan.meets()) {
    table.refuse("joint", "pin or weld, unless its bodies have a shape: box, circle, ...");
  }
  if (spec.shapes.empty()) {
    const double thick = table.number("thickness");
    table.guard([&] { spec.shapes = {table.has("to") ? box(plan.link, thick) : box(thick, plan.link)}; });
  }
  spec.angle = plan.angle;
  List<BodyId> links;
  for (int i = 0; i < plan.n; ++i) {
    spec.position = chain_place(table, plan, i);
    links.push_back(builder.add(table, spec, name + "." + std::to_string(i + 1)));
  }
  builder.later([&builder, table, plan, links] { join_chain_bodies(builder, table, plan, links); });
  for (const SceneTable& bob : table.tables("bob")) {
    if (!plan.meets() || plan.is_fastened)
      table.refuse("bob", "at the free end of links", "an end that is none");
    build_bob(builder, bob, plan, links.back(), name + ".bob");
  }
}

}  // namespace cairn
