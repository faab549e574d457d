// Floor 6. Penetration, drift, cone violation.
#include <cairn/measure/violation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <cairn/collision/broadphase.hpp>
#include <cairn/collision/collide.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

bool is_apart(const Snapshot& snapshot, BodyId first, BodyId second) {
  const std::pair<BodyId, BodyId> bodies = std::minmax(first, second);
  return std::binary_search(snapshot.apart.begin(), snapshot.apart.end(), bodies);
}

/// A shape of a body, or a link of one that is a chain.
struct Piece {
  BodyId body = {};
  Shape<double> shape = {};
  std::optional<Neighbours<double>> around = {};  // of a link
};

void add_pieces(BodyId body, const Shape<double>& shape, List<Piece>& pieces) {
  const auto* chain = std::get_if<Chain<double>>(&shape);
  if (chain == nullptr) {
    const Piece whole{.body = body, .shape = shape};
    pieces.push_back(whole);
    return;
  }
  for (int i = 0; i < chain->link_count(); ++i) {
    pieces.push_back(
        {body, Segment<double>{chain->point(i), chain->point(i + 1)}, link_neighbours(*chain, i)});
  }
}

// From where to where a shape reaches along a direction [m]; a line has no thickness that anything could be
// in by a share of.
double width_along(const Circle<double>& circle, const Vec2<double>&) { return 2 * circle.radius; }

double width_along(const Capsule<double>& capsule, const Vec2<double>& direction) {
  return std::abs(direction.dot(capsule.point2 - capsule.point1)) + 2 * capsule.radius;
}

double width_along(const Polygon<double>& polygon, const Vec2<double>& direction) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2<double>& vertex : polygon.vertices) {
    low = std::min(low, direction.dot(vertex));
    high = std::max(high, direction.dot(vertex));
  }
  return high - low + 2 * polygon.radius;
}

double width_along(const Segment<double>&, const Vec2<double>&) {
  return std::numeric_limits<double>::infinity();
}

double width_along(const Chain<double>&, const Vec2<double>&) {
  return std::numeric_limits<double>::infinity();
}

/// Of a piece along a unit vector of the world.
double thickness_along(const Snapshot& snapshot, const Piece& piece, const Vec2<double>& normal) {
  const Frame<double> frame = snapshot.bodies[piece.body].pose;
  const Vec2<double> direction = frame.rotation.transposed_times(normal);
  return std::visit([&](const auto& shape) { return width_along(shape, direction); }, piece.shape);
}

/// The deepest point of two shapes, if it is deeper than `worst`.
void keep_deeper(const Snapshot& snapshot, const Piece& one, const Piece& other, Overlap& worst) {
  const BodyId a = one.body, b = other.body;
  const NeighboursOf<double> around = {one.around ? &*one.around : nullptr,
                                       other.around ? &*other.around : nullptr};
  const Manifold<double> manifold =
      collide(one.shape, snapshot.bodies[a].pose, other.shape, snapshot.bodies[b].pose, 0.0, around);
  for (int k = 0; k < manifold.count; ++k) {
    const double depth = -manifold.points[k].separation;
    if (!(depth > worst.depth)) continue;
    const double thickness = std::min(thickness_along(snapshot, one, manifold.normal),
                                      thickness_along(snapshot, other, manifold.normal));
    worst = {.depth = depth,
             .a = a,
             .b = b,
             .normal = manifold.normal,
             .position = manifold.points[k].position,
             .thickness = thickness,
             .one_sided = one.around || other.around};
  }
}

}  // namespace

List<Overlap> overlaps(const Snapshot& snapshot) {
  List<Piece> items;
  List<Aabb<double>> boxes;
  List<char> movable;
  for (const BodyId id : snapshot.bodies.indices()) {
    const SnapshotBody& body = snapshot.bodies[id];
    if (body.sensor) continue;
    for (const Shape<double>& shape : body.shapes) {
      add_pieces(id, shape, items);
      movable.resize(items.size(), body.type == BodyType::dynamic ? 1 : 0);
    }
  }

  for (const Piece& item : items) boxes.push_back(bounding_box(item.shape, snapshot.bodies[item.body].pose));
  List<Overlap> found;
  Broadphase<double> broadphase(BroadphaseKind::grid);
  for (const auto& [i, j] : broadphase.pairs(boxes, movable)) {
    const Piece& a = items[i];
    const Piece& b = items[j];
    const SnapshotBody& body_a = snapshot.bodies[a.body];
    const SnapshotBody& body_b = snapshot.bodies[b.body];
    if (a.body == b.body || !may_touch(body_a.filter, body_b.filter) || is_apart(snapshot, a.body, b.body))
      continue;
    Overlap overlap;
    keep_deeper(snapshot, a, b, overlap);
    if (overlap.depth > 0) found.push_back(overlap);
  }
  return found;
}

Overlap deepest_of(const List<Overlap>& overlaps) {
  Overlap worst;
  for (const Overlap& overlap : overlaps) {
    if (overlap.depth > worst.depth) worst = overlap;
  }
  return worst;
}

Overlap deepest_overlap(const Snapshot& snapshot) { return deepest_of(overlaps(snapshot)); }

double worst_penetration(const Snapshot& snapshot) { return deepest_overlap(snapshot).depth; }

Overlap deepest_in_ground(const Snapshot& snapshot) {
  Overlap worst;
  for (const auto& [first, second] : snapshot.apart) {
    if (first != ground) break;  // pairs are sorted
    List<Piece> surfaces, pieces;
    for (const Shape<double>& surface : snapshot.bodies[ground].shapes) add_pieces(ground, surface, surfaces);
    for (const Shape<double>& shape : snapshot.bodies[second].shapes) add_pieces(second, shape, pieces);
    for (const Piece& surface : surfaces) {
      for (const Piece& piece : pieces) keep_deeper(snapshot, surface, piece, worst);
    }
  }
  return worst;
}

double worst_joint_drift(const Snapshot& snapshot) {
  double worst = 0;
  for (const SnapshotJoint& joint : snapshot.joints) worst = std::max(worst, joint.drift);
  return worst;
}

double worst_cone_violation(const Snapshot& snapshot) {
  double worst = 0;
  for (const SnapshotContact& contact : snapshot.contacts) {
    worst = std::max(worst, std::abs(contact.friction_impulse) - contact.friction * contact.normal_impulse);
  }
  return worst;
}

double normal_impulse_between(const Snapshot& snapshot, BodyId first, BodyId second) {
  double sum = 0;
  for (const SnapshotContact& contact : snapshot.contacts) {
    const bool forward = contact.a == first && contact.b == second;
    const bool backward = contact.a == second && contact.b == first;
    if (forward || backward) sum += contact.normal_impulse;
  }
  return sum;
}

double largest_velocity_gap(const Snapshot& first, const Snapshot& second) {
  require(first.bodies.size() == second.bodies.size(), "largest_velocity_gap", "second",
          "a snapshot of equally many bodies", static_cast<double>(second.bodies.size()));
  double gap = 0;
  for (const BodyId body : first.bodies.indices()) {
    gap = std::max(gap, (first.bodies[body].velocity - second.bodies[body].velocity).cwiseAbs().maxCoeff());
  }
  return gap;
}

}  // namespace cairn
