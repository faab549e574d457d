// Floor 8. Chains and cradles: bodies in a row, and the joints between them.
#include <cmath>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/scenes/named.hpp>
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Where a chain runs, and what it is made of.
struct ChainPlan {
  std::string name = {};
  int n = 0;
  std::string joint = "pin";
  Vec2<double> from = {0, 0};   // [m]
  Vec2<double> along = {0, 0};  // unit vector
  double angle = 0;             // [rad] of the links
  double link = 0;              // [m] from joint to joint, or from body to body
  bool is_fastened = false;     // at its end

  bool meets() const { return joint == "pin" || joint == "weld"; }
};

ChainPlan plan_chain(const SceneTable& table, const std::string& name) {
  ChainPlan plan{.name = name, .n = table.get<int>("n"), .joint = table.get<std::string>("joint")};
  plan.from = table.get<Vec2<double>>("from");
  plan.is_fastened = table.has("b");
  if (table.has("to")) {
    for (const char* key : {"link", "angle"}) {
      if (table.has(key)) table.refuse(key, "left out where the chain has an end, to");
    }
    const Vec2<double> way = table.get<Vec2<double>>("to") - plan.from;
    if (!(way.norm() > 0)) table.refuse("to", "a point other than from", "the same");
    plan.along = way / way.norm();
    plan.angle = arc_tangent(plan.along.y(), plan.along.x());
    plan.link = way.norm() / (plan.meets() || !plan.is_fastened ? plan.n : plan.n + 1);
  } else {
    if (!table.has("link"))
      table.refuse("link", "given, or else to, so that the chain has a length", "neither");
    plan.angle = table.get<double>("angle");
    plan.along = {sine(plan.angle), -cosine(plan.angle)};
    plan.link = table.get<double>("link");
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
    place += table.get<double>("aside") * (1 - std::abs(x) / half) * perpendicular(plan.along);
  }
  return place;
}

/// Joint `number` of the chain, from 0.
std::string chain_joint_name(const ChainPlan& plan, int number) {
  return numbered(plan.name + ".joint", number);
}

/// Joins bodies `links` in a row, and its ends.
void join_chain(SceneBuilder& builder, const SceneTable& table, const ChainPlan& plan,
                const List<BodyId>& links) {
  DistanceJoint::Spec ends{.a = builder.names().body(table, "a")};
  ends.anchor_a = plan.from;
  for (int i = 0; i < plan.n; ++i) {
    if (plan.meets()) ends.anchor_a = plan.from + i * plan.link * plan.along;
    ends.b = links[i];
    ends.anchor_b = chain_place(table, plan, i);
    join_links(builder, table, chain_joint_name(plan, i), ends);
    ends.a = ends.b;
    ends.anchor_a = ends.anchor_b;
  }
  if (!plan.is_fastened) return;
  ends.b = builder.names().body(table, "b");
  ends.anchor_b = table.has("to") ? table.get<Vec2<double>>("to")
                                  : Vec2<double>(plan.from + plan.n * plan.link * plan.along);
  if (plan.meets()) ends.anchor_a = ends.anchor_b;
  join_links(builder, table, chain_joint_name(plan, plan.n), ends);
}

void build_bob(SceneBuilder& builder, const SceneTable& bob, const ChainPlan& plan, BodyId last,
               const std::string& name) {
  const double radius = bob.get<double>("radius");
  const Vec2<double> end = plan.from + plan.n * plan.link * plan.along;
  BodySpec spec = body_of(bob);
  spec.shapes = {circle(radius)};
  spec.position = end + radius * plan.along;
  spec.angle = plan.angle;
  if (bob.has("ratio")) spec.mass = bob.get<double>("ratio") * builder.scene().bodies()[last].mass;
  const BodyId body = builder.add(bob, spec, name);
  builder.later([&builder, bob, joint = chain_joint_name(plan, plan.n), last, body, end] {
    builder.join<RevoluteJoint>(bob, joint, {.a = last, .b = body, .anchor = end});
  });
}

}  // namespace

void join_links(SceneBuilder& builder, const SceneTable& table, const std::string& name,
                DistanceJoint::Spec ends) {
  const std::string joint = table.get<std::string>("joint");
  if (joint == "pin")
    return builder.join<RevoluteJoint>(table, name, {.a = ends.a, .b = ends.b, .anchor = ends.anchor_a});
  if (joint == "weld")
    return builder.join<WeldJoint>(table, name, {.a = ends.a, .b = ends.b, .anchor = ends.anchor_a});
  ends.kind = value_of<DistanceJoint::Kind>(joint);
  if (table.has("length")) ends.length = table.get<double>("length");
  if (table.has("softness")) ends.softness = softness_of(table);
  builder.join<DistanceJoint>(table, name, ends);
}

void build_cradle(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const Vec2<double> middle = table.get<Vec2<double>>("position");
  const double radius = table.get<double>("radius"), rod = table.get<double>("rod");
  const int n = table.get<int>("n");
  BodySpec spec = body_of(table);
  spec.shapes = {circle(radius)};
  for (int i = 0; i < n; ++i) {
    const Vec2<double> top(middle.x() + (2 * radius + table.get<double>("gap")) * (i - 0.5 * (n - 1)),
                           middle.y());
    const double aside = i == 0 ? table.get<double>("aside") : 0;  // [rad]
    const Vec2<double> place = top + rod * Vec2<double>(sine(aside), -cosine(aside));
    spec.position = place;
    const BodyId ball = builder.add(table, spec, numbered(name, i));
    const std::string joint = numbered(name + ".joint", i);
    builder.later([&builder, table, joint, ball, top, place] {
      builder.join<DistanceJoint>(table, joint, {.a = ground, .b = ball, .anchor_a = top, .anchor_b = place});
    });
  }
}

void build_chain(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const ChainPlan plan = plan_chain(table, name);
  BodySpec spec = body_of(table);
  spec.shapes = shape_of(table);
  if (spec.shapes.empty() && !plan.meets()) {
    table.refuse("joint", "pin or weld, unless its bodies have a shape: box, circle, ...");
  }
  if (spec.shapes.empty()) {
    const double thick = table.get<double>("thickness");
    table.guard([&] { spec.shapes = {table.has("to") ? box(plan.link, thick) : box(thick, plan.link)}; });
  }
  spec.angle = plan.angle;
  List<BodyId> links;
  for (int i = 0; i < plan.n; ++i) {
    spec.position = chain_place(table, plan, i);
    links.push_back(builder.add(table, spec, numbered(name, i)));
  }
  builder.later([&builder, table, plan, links] { join_chain(builder, table, plan, links); });
  for (const SceneTable& bob : table.tables("bob")) {
    if (!plan.meets() || plan.is_fastened)
      table.refuse("bob", "at the free end of links", "an end that is none");
    build_bob(builder, bob, plan, links.back(), name + ".bob");
  }
}

}  // namespace cairn
