// Floor 7. From Cairn's shapes to Box2D's.
#include <cairn/reference/box2d_shapes.hpp>

#include <box2d/box2d.h>

#include <algorithm>
#include <vector>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

std::unique_ptr<b2Shape> convert(const Circle<double>& circle) {
  auto result = std::make_unique<b2CircleShape>();
  result->m_p = to_box2d(circle.center);
  result->m_radius = static_cast<float>(circle.radius);
  return result;
}

/// Its two ends, and a box between them. That is thinner than the capsule by so much that, with its skin, it
/// meets only what the ends do not.
List<std::unique_ptr<b2Shape>> parts_of(const Capsule<double>& capsule) {
  const double thinner = static_cast<double>(b2_polygonRadius) + capsule_middle_depth;
  require(capsule.radius > thinner, "Box2DWorld", "capsule radius",
          "> 0.02 m, as Box2D 2.4.1 has no capsules, and a box in one has a skin", capsule.radius);
  List<std::unique_ptr<b2Shape>> parts;
  parts.push_back(convert(Circle<double>{capsule.point1, capsule.radius}));
  parts.push_back(convert(Circle<double>{capsule.point2, capsule.radius}));
  const Vec2<double> half = (capsule.point2 - capsule.point1) / 2;
  auto middle = std::make_unique<b2PolygonShape>();
  middle->SetAsBox(static_cast<float>(half.norm()), static_cast<float>(capsule.radius - thinner),
                   to_box2d(capsule.point1 + half), static_cast<float>(std::atan2(half.y(), half.x())));
  parts.push_back(std::move(middle));
  return parts;
}

/// Fills in vertices and normals as they are: b2PolygonShape::Set would weld vertices that lie close
/// together.
std::unique_ptr<b2Shape> convert(const Polygon<double>& polygon) {
  require(polygon.radius == 0, "Box2DWorld", "polygon radius",
          "0 m, as Box2D 2.4.1 does not round the corners of polygons", polygon.radius);
  require(polygon.vertices.size() <= b2_maxPolygonVertices, "Box2DWorld", "polygon vertices",
          "at most 8, as Box2D 2.4.1 has no room for more", polygon.vertices.size());
  auto result = std::make_unique<b2PolygonShape>();
  result->m_count = polygon.vertices.size();
  b2Vec2 sum(0, 0);
  for (int i = 0; i < polygon.vertices.size(); ++i) {
    result->m_vertices[i] = to_box2d(polygon.vertices[i]);
    result->m_normals[i] = to_box2d(polygon.normals[i]);
    sum += result->m_vertices[i];
  }
  // Box2D asks for a point inside when a segment meets the polygon; mass and inertia are set apart from it.
  result->m_centroid = (1.0f / static_cast<float>(polygon.vertices.size())) * sum;
  return result;
}

std::unique_ptr<b2Shape> convert(const Segment<double>& segment) {
  auto result = std::make_unique<b2EdgeShape>();
  result->SetTwoSided(to_box2d(segment.point1), to_box2d(segment.point2));
  return result;
}

/// Of the same side: Box2D's chains have their normals on the right hand, too.
std::unique_ptr<b2Shape> convert(const Chain<double>& chain) {
  std::vector<b2Vec2> points;
  for (int i = 0; i < chain.points.size(); ++i) {
    points.push_back(to_box2d(chain.points[i]));
    const double length =
        i < chain.link_count() ? (chain.point(i + 1) - chain.point(i)).norm() : b2_linearSlop * 2.0;
    require(length > b2_linearSlop, "Box2DWorld", "chain link length",
            "> 0.005 m, the shortest in Box2D 2.4.1", length);
  }
  auto result = std::make_unique<b2ChainShape>();
  const int count = chain.points.size();
  if (chain.closed) {
    result->CreateLoop(points.data(), count);
  } else {
    result->CreateChain(points.data(), count, to_box2d(chain.before), to_box2d(chain.after));
  }
  return result;
}

}  // namespace

b2Vec2 to_box2d(const Vec2<double>& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

List<std::unique_ptr<b2Shape>> to_box2d(const Shape<double>& shape) {
  if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) return parts_of(*capsule);
  List<std::unique_ptr<b2Shape>> parts;
  std::visit(
      [&parts]<typename Held>(const Held& held) {
        if constexpr (!std::is_same_v<Held, Capsule<double>>) parts.push_back(convert(held));
      },
      shape);
  return parts;
}

}  // namespace cairn
