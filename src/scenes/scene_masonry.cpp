// Floor 8. Arches, dominoes and houses of cards: one table, many bodies.
#include <cmath>

#include <cairn/scenes/scene_builder.hpp>

namespace cairn {

void build_arch(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const double radius = table.get<double>("radius"), thickness = table.get<double>("thickness");
  const double inner = radius - thickness / 2, outer = radius + thickness / 2;
  if (!(inner > 0)) table.refuse("thickness", "less than twice the radius");
  const int stones = table.get<int>("n");
  BodySpec spec = body_of(table);
  spec.position = table.get<Vec2<double>>("position");
  for (int i = 0; i < stones; ++i) {
    const double from = i * pi / stones, to = (i + 1) * pi / stones;  // [rad]
    const Vec2<double> start(cosine(from), sine(from)), end(cosine(to), sine(to));
    table.guard([&] { spec.shapes = {polygon({inner * start, outer * start, outer * end, inner * end})}; });
    builder.add(table, spec, numbered(name, i));
  }
}

void build_dominoes(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const Vec2<double> foot = table.get<Vec2<double>>("position"), size = table.get<Vec2<double>>("box");
  const double lean = table.get<double>("lean"), step = table.get<double>("step");
  const int n = table.get<int>("n");
  BodySpec spec = body_of(table);
  table.guard([&] { spec.shapes = {box(size.x(), size.y())}; });
  for (int i = 0; i < n; ++i) {
    const double x = foot.x() + step * (i - 0.5 * (n - 1));
    spec.position = {x, foot.y() + size.y() / 2};
    spec.angle = i == 0 ? -lean : 0;
    if (i == 0) {  // turned about its lower right corner
      const Vec2<double> from_corner(-size.x() / 2, size.y() / 2);
      spec.position = Vec2<double>(x + size.x() / 2, foot.y()) + Rotation<double>(-lean) * from_corner;
    }
    builder.add(table, spec, numbered(name, i));
  }
}

void build_cards(SceneBuilder& builder, const SceneTable& table, const std::string& name) {
  const Vec2<double> foot = table.get<Vec2<double>>("position"), card = table.get<Vec2<double>>("card");
  const double lean = table.get<double>("lean"), board = table.get<double>("board");
  const double thick = card.x(), height = card.y(), c = cosine(lean), s = sine(lean);
  const double half_pair = height * s + thick * c;  // [m] from the middle of a pair to its outermost point
  const double pitch = 2 * half_pair + 0.1;
  const int storeys = table.get<int>("n");
  BodySpec spec = body_of(table);
  int count = 0;
  const auto add = [&](double width, double high, const Vec2<double>& center, double angle) {
    spec.position = center;
    spec.angle = angle;
    table.guard([&] { spec.shapes = {box(width, high)}; });
    builder.add(table, spec, numbered(name, count++));
  };
  double base = foot.y();
  for (int storey = 0; storey < storeys; ++storey) {
    const int pairs = storeys - storey;
    for (int i = 0; i < pairs; ++i) {
      const double middle = foot.x() + pitch * (i - 0.5 * (pairs - 1));
      for (const double side : {-1.0, 1.0}) {
        // The upper inner corner is at the middle, the lower one on that side at `base`.
        add(thick, height,
            {middle + side * (thick * c + height * s) / 2, base + (thick * s + height * c) / 2}, side * lean);
      }
    }
    base += thick * s + height * c;
    add(pitch * (pairs - 1) + 0.6 * height, board, {foot.x(), base + board / 2}, 0);
    base += board;
  }
}

}  // namespace cairn
