// Floor 8. Bodies and their shapes from a scene file.
#include <cairn/scenes/scene_builder.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// The key of the one shape that a table has; "": none.
std::string shape_key(const SceneTable& table) {
  std::string found;
  for (const char* key : {"box", "circle", "capsule", "polygon", "segment", "chain"}) {
    if (!table.has(key)) continue;
    if (!found.empty())
      table.refuse(key, "the only shape; for several there is shapes = [{...}, {...}]",
                   "a " + found + " beside it");
    found = key;
  }
  return found;
}

ChainEnds chain_ends(const SceneTable& table) {
  ChainEnds ends{.closed = table.get<bool>("closed")};
  if (!table.has("ghosts")) return ends;
  const List<Vec2<double>> ghosts = table.get<List<Vec2<double>>>("ghosts");
  if (ghosts.size() != 2) table.refuse("ghosts", "two points [[x, y], [x, y]], before and after the chain");
  ends.before = ghosts[0];
  ends.after = ghosts[1];
  return ends;
}

/// One that is rounded must be convex: rounded pieces would lie over each other.
List<Shape<double>> make_scene_polygon(const SceneTable& table) {
  const List<Vec2<double>> points = table.get<List<Vec2<double>>>("polygon");
  const double radius = table.get<double>("radius");
  List<Shape<double>> pieces;
  table.guard([&] { pieces = outline(points); });
  if (radius == 0) return pieces;
  if (pieces.size() > 1)
    table.refuse("radius", "left out of a polygon that is not convex; each of several shapes may have one");
  table.guard([&] { pieces = {polygon(points, radius)}; });
  return pieces;
}

Shape<double> make_scene_shape(const SceneTable& table, const std::string& key) {
  const double radius = table.get<double>("radius");
  if (key == "circle") return circle(table.get<double>("circle"));
  if (key == "box")
    return box(table.get<Vec2<double>>("box").x(), table.get<Vec2<double>>("box").y(), radius);
  const List<Vec2<double>> points = table.get<List<Vec2<double>>>(key);
  if (key == "chain") return chain(points, chain_ends(table));
  if (points.size() != 2) table.refuse(key, "two points [[x, y], [x, y]]");
  if (key == "segment") return segment(points[0], points[1]);
  return capsule(points[0], points[1], radius);
}

void build_body(SceneBuilder& builder, const SceneTable& table, int number) {
  BodySpec spec = body_of(table);
  spec.shapes = shape_of(table);
  if (!spec.shapes.empty() && table.has("shapes")) {
    table.refuse("shapes", "the only shapes, without a shape beside them");
  }
  for (const SceneTable& part : table.tables("shapes")) {
    const List<Shape<double>> shape = shape_of(part);
    if (shape.empty())
      part.refuse("", "a shape: box, circle, capsule, polygon, segment or chain", "none of them");
    const bool is_moved = part.has("offset") || part.has("turn");
    for (const Shape<double>& piece : shape) {
      spec.shapes.push_back(
          is_moved ? moved(piece, part.get<Vec2<double>>("offset"), part.get<double>("turn")) : piece);
    }
  }
  builder.add(table, spec,
              table.has("name") ? builder.claim_name(table, "") : "body." + std::to_string(number));
}

}  // namespace

BodySpec body_of(const SceneTable& table) {
  BodySpec spec;
  table.read(spec);
  return spec;
}

List<Shape<double>> shape_of(const SceneTable& table) {
  const std::string key = shape_key(table);
  for (const char* of_chain : {"closed", "ghosts"}) {
    if (table.has(of_chain) && key != "chain") table.refuse(of_chain, "beside a chain");
  }
  if (table.has("radius") && (key.empty() || key == "circle" || key == "segment" || key == "chain")) {
    table.refuse("radius", "beside a box, capsule or polygon; a disc is circle = its radius");
  }
  List<Shape<double>> shapes;
  if (key == "polygon") {
    shapes = make_scene_polygon(table);
  } else if (!key.empty()) {
    table.guard([&] { shapes.push_back(make_scene_shape(table, key)); });
  }
  return shapes;
}

void read_contacts(SceneBuilder& builder, const SceneTable& file) {
  for (const SceneTable& table : file.tables("contact")) {
    PairMaterial pair;
    table.read(pair);
    if (!pair.friction && !pair.static_friction && !pair.restitution)
      table.refuse("", "one with friction, static_friction or restitution", "none of them");
    pair.a = builder.names().bodies(table, "a");
    pair.b = builder.names().bodies(table, "b");
    builder.add(table, pair);
  }
}

void build_bodies(SceneBuilder& builder, const SceneTable& table, int number) {
  if (table.kind() == "body") return build_body(builder, table, number);
  scene_table_kind(table.kind()).build(builder, table, builder.claim_name(table, table.kind()));
}

}  // namespace cairn
