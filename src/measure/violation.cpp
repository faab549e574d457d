// Floor 6. Penetration, drift, cone violation.
#include "measure/violation.hpp"

#include <algorithm>
#include <cmath>

#include "collision/broadphase.hpp"
#include "collision/collide.hpp"
#include "math/check.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

bool is_apart(const Snapshot& snapshot, BodyId first, BodyId second) {
  const std::pair<BodyId, BodyId> bodies = std::minmax(first, second);
  return std::binary_search(snapshot.apart.begin(), snapshot.apart.end(), bodies);
}

/// The deepest point of two shapes, if it is deeper than `worst`.
void keep_deeper(const Snapshot& snapshot, BodyId a, const Shape<double>& shape_a, BodyId b,
                 const Shape<double>& shape_b, Overlap& worst) {
  const Manifold<double> manifold =
      collide(shape_a, snapshot.bodies[a].pose, shape_b, snapshot.bodies[b].pose, 0.0);
  for (int k = 0; k < manifold.count; ++k) {
    const double depth = -manifold.points[k].separation;
    if (depth > worst.depth) worst = {.depth = depth, .a = a, .b = b};
  }
}

}  // namespace

List<Overlap> overlaps(const Snapshot& snapshot) {
  struct Item {
    BodyId body;
    const Shape<double>* shape;
  };
  List<Item> items;
  List<Aabb<double>> boxes;
  List<char> movable;
  for (const BodyId id : snapshot.bodies.indices()) {
    const SnapshotBody& body = snapshot.bodies[id];
    if (body.sensor) continue;
    for (const Shape<double>& shape : body.shapes) {
      items.push_back({id, &shape});
      boxes.push_back(bounding_box(shape, body.pose));
      movable.push_back(body.type == BodyType::dynamic ? 1 : 0);
    }
  }

  List<Overlap> found;
  Broadphase<double> broadphase(BroadphaseKind::grid);
  for (const auto& [i, j] : broadphase.pairs(boxes, movable)) {
    const Item& a = items[i];
    const Item& b = items[j];
    const SnapshotBody& body_a = snapshot.bodies[a.body];
    const SnapshotBody& body_b = snapshot.bodies[b.body];
    if (a.body == b.body || !may_touch(body_a, body_b) || is_apart(snapshot, a.body, b.body)) continue;
    Overlap overlap;
    keep_deeper(snapshot, a.body, *a.shape, b.body, *b.shape, overlap);
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
    for (const Shape<double>& surface : snapshot.bodies[ground].shapes) {
      for (const Shape<double>& shape : snapshot.bodies[second].shapes)
        keep_deeper(snapshot, ground, surface, second, shape, worst);
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
