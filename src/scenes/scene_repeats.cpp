// Floor 8. Stacks, pyramids, rows, piles: one table, many bodies.
#include <algorithm>
#include <cmath>

#include <cairn/scenes/scene_builder.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// What a stack, a pyramid or a pile is made of.
struct SceneBlock {
  double width = 0;   // [m]
  double height = 0;  // [m]
};

/// @throws std::invalid_argument unless the table has a box or a circle.
SceneBlock block_of(const SceneTable& table) {
  for (const char* key : {"capsule", "polygon", "segment", "chain"}) {
    if (table.has(key)) table.refuse(key, "a box or a circle in a " + table.kind(), key);
  }
  if (shape_of(table).empty())
    table.refuse("", "made of something: give box = [width, height] or circle", "neither");
  if (table.has("circle")) return {2 * table.get<double>("circle"), 2 * table.get<double>("circle")};
  const double rim = 2 * table.get<double>("radius");
  return {table.get<Vec2<double>>("box").x() + rim, table.get<Vec2<double>>("box").y() + rim};
}

/// Shapes that differ from body to body: larger by `more` [m].
Shape<double> larger_block(const SceneTable& table, double more) {
  if (table.has("circle")) return circle(table.get<double>("circle") + more);
  const Vec2<double> size = table.get<Vec2<double>>("box");
  return box(size.x() + more, size.y() + more, table.get<double>("radius"));
}

void join_neighbours(SceneBuilder& builder, const SceneTable& table, const std::string& name, BodyId a,
                     BodyId b) {
  const PerBody<SceneBody>& bodies = builder.scene().bodies();
  DistanceJoint::Spec ends{.a = a, .b = b};
  ends.anchor_a = bodies[a].pose.position;
  ends.anchor_b = bodies[b].pose.position;
  if (table.get<std::string>("joint") != "rod") ends.anchor_a = (ends.anchor_a + ends.anchor_b) / 2;
  join_links(builder, table, name, ends);
}

/// Joins each of `bodies`, n to a row, to the next one of its row, and to that of the next row.
void join_row(SceneBuilder& builder, const SceneTable& table, const std::string& name,
              const List<BodyId>& bodies, int n) {
  int count = 0;
  const auto join = [&](BodyId a, BodyId b) {
    join_neighbours(builder, table, numbered(name + ".joint", count++), a, b);
  };
  for (int i = 0; i < bodies.size(); ++i) {
    if ((i + 1) % n != 0) join(bodies[i], bodies[i + 1]);
    if (i + n < bodies.size()) join(bodies[i], bodies[i + n]);
  }
}

}  // namespace

void build_link(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const Vec2<double> from = table.get<Vec2<double>>("from"), to = table.get<Vec2<double>>("to");
  const Vec2<double> half = (to - from) / 2;
  BodySpec spec = body_of(table);
  spec.position = (from + to) / 2;
  table.guard([&] { spec.shapes = {capsule(-half, half, table.get<double>("radius"))}; });
  builder.add(table, spec, name);
}

void build_stack(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const SceneBlock block = block_of(table);
  const Vec2<double> foot = table.get<Vec2<double>>("position");
  const double offset = table.get<double>("offset");
  BodySpec spec = body_of(table);
  spec.shapes = shape_of(table);
  for (int i = 0; i < table.get<int>("n"); ++i) {
    spec.position = {foot.x() + (i % 2 == 0 ? -offset : offset),
                     foot.y() + block.height / 2 + i * block.height};
    builder.add(table, spec, numbered(name, i));
  }
}

void build_pyramid(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const SceneBlock block = block_of(table);
  const Vec2<double> foot = table.get<Vec2<double>>("position");
  const double spacing = table.has("spacing") ? table.get<double>("spacing") : block.width + 0.1;
  const int rows = table.get<int>("n");
  BodySpec spec = body_of(table);
  spec.shapes = shape_of(table);
  int count = 0;
  for (int level = 0; level < rows; ++level) {
    for (int i = 0; i < rows - level; ++i) {
      spec.position = {foot.x() + spacing * (i + 0.5 * (level - rows + 1)),
                       foot.y() + block.height / 2 + level * block.height};
      builder.add(table, spec, numbered(name, count++));
    }
  }
}

void build_row(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  if (table.has("first") == table.has("position")) {
    table.refuse("first", "given, or else position, and not both", table.has("first") ? "both" : "neither");
  }
  const int n = table.get<int>("n"), every = table.get<int>("every");
  const Vec2<double> step = table.get<Vec2<double>>("step"), row_step = table.get<Vec2<double>>("row_step");
  const Vec2<double> stagger = table.get<Vec2<double>>("stagger");
  const Vec2<double> start = table.get<Vec2<double>>(table.has("first") ? "first" : "position");
  const double middle = table.has("first") ? 0 : 0.5 * (n - 1);
  const List<SceneTable> other = table.tables("other");
  if ((every > 0) == other.empty())
    table.refuse("other", "given together with every, as every says how often");
  BodySpec spec = body_of(table);
  const List<Shape<double>> usual = shape_of(table);
  const List<Shape<double>> rare = other.empty() ? usual : shape_of(other[0]);
  List<BodyId> bodies;
  for (int row = 0; row < table.get<int>("rows"); ++row) {
    for (int i = 0; i < n; ++i) {
      spec.position = start + (i - middle) * step + row * row_step;
      if (row % 2 == 1) spec.position += stagger;
      spec.shapes = every > 0 && (row + i) % every == 0 ? rare : usual;
      bodies.push_back(builder.add(table, spec, numbered(name, bodies.size())));
    }
  }
  if (table.get<std::string>("joint") == "none") return;
  builder.later([&builder, table, name, bodies, n] { join_row(builder, table, name, bodies, n); });
}

void build_pile(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  block_of(table);
  // Multiples of the golden ratio, less whole numbers: evenly spread, and never twice the same.
  const double golden = (std::sqrt(5.0) - 1) / 2;
  const Vec2<double> first = table.get<Vec2<double>>("first"), step = table.get<Vec2<double>>("step");
  const double jitter = table.get<double>("jitter"), spread = table.get<double>("spread");
  const int columns = table.get<int>("columns"), seed = table.get<int>("seed");
  BodySpec spec = body_of(table);
  for (int i = 0; i < table.get<int>("n"); ++i) {
    const double turns = (seed + i) * golden;
    const double share = turns - std::floor(turns);
    spec.position = {first.x() + step.x() * (i % columns) + jitter * (2 * share - 1),
                     first.y() + step.y() * (i / columns)};
    table.guard([&] { spec.shapes = {larger_block(table, spread * share)}; });
    builder.add(table, spec, numbered(name, i));
  }
}

}  // namespace cairn
