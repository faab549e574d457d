// Floor 6. What falls, and whether there is anything to land on.
#include <algorithm>
#include <limits>
#include <optional>

#include <cairn/dynamics/connected_bodies.hpp>
#include <cairn/geometry/aabb.hpp>
#include <cairn/measure/failure.hpp>

namespace cairn {

namespace {

// So many of its lengths a body falls before its fall is one for ever: 100 m of a box of 1 m, which takes 4.5
// s on Earth.
constexpr double far_lengths = 100;
constexpr double never = std::numeric_limits<double>::infinity();

/// From where to where a body reaches along a direction.
struct Reach {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool meets(const Reach& other) const { return low <= other.high && other.low <= high; }
  double middle() const { return (low + high) / 2; }
};

/// By the boxes around its shapes [m].
Reach reach_of(const SnapshotBody& body, const Vec2<double>& direction) {
  Reach reach;
  for (const Shape<double>& shape : body.shapes) {
    const Aabb<double> box = bounding_box(shape, body.pose);
    const double middle = direction.dot(box.lower + box.upper) / 2;
    const double half = direction.cwiseAbs().dot(box.upper - box.lower) / 2;
    reach.low = std::min(reach.low, middle - half);
    reach.high = std::max(reach.high, middle + half);
  }
  return reach;
}

bool is_solid(const SnapshotBody& body) { return !body.removed && !body.sensor && !body.shapes.empty(); }

bool stands_still(const SnapshotBody& body) { return is_solid(body) && body.type == BodyType::static_body; }

bool can_fall(const SnapshotBody& body) {
  return is_solid(body) && body.type == BodyType::dynamic && body.gravity_scale > 0;
}

/// Against gravity, where there is any.
Vec2<double> upwards(const Snapshot& snapshot) { return -snapshot.gravity.normalized(); }

bool has_floor(const Snapshot& start, const SnapshotBody& body) {
  if (!can_fall(body) || start.gravity.isZero(0)) return false;
  const Vec2<double> up = upwards(start), along = perpendicular(up);
  const Reach height = reach_of(body, up), width = reach_of(body, along);
  return std::any_of(start.bodies.begin(), start.bodies.end(), [&](const SnapshotBody& other) {
    return stands_still(other) && may_touch(body.filter, other.filter) &&
           reach_of(other, along).meets(width) && reach_of(other, up).low < height.middle();
  });
}

/// Bodies that joints tie to each other, in one group with all that gravity does not move.
class HeldBodies {
 public:
  explicit HeldBodies(const Snapshot& now) {
    connected_.begin(now.bodies.size());
    for (const BodyId id : now.bodies.indices())
      if (!can_fall(now.bodies[id])) connected_.connect(id, ground);
    for (const SnapshotJoint& joint : now.joints) {
      if (!joint.traits.holds_points) continue;
      connected_.connect(joint.a, joint.b);
      if (joint.traits.is_over_ground) connected_.connect(joint.b, ground);
    }
  }

  bool holds(BodyId body) { return connected_.lowest(body) == ground; }

 private:
  ConnectedBodies connected_;
};

/// Whether something that moves by itself is below that height, and may catch what falls.
bool is_caught(const Snapshot& now, double height) {
  return std::any_of(now.bodies.begin(), now.bodies.end(), [&](const SnapshotBody& body) {
    return is_solid(body) && body.type == BodyType::kinematic && reach_of(body, upwards(now)).low < height;
  });
}

}  // namespace

void FailureWatch::note_floors(const Snapshot& start) {
  has_floor_ = {};
  below_since_ = {};
  Reach still, moving;
  for (const SnapshotBody& body : start.bodies) {
    has_floor_.push_back(has_floor(start, body) ? 1 : 0);
    below_since_.push_back(never);
    if (start.gravity.isZero(0) || (!stands_still(body) && !can_fall(body))) continue;
    const Reach height = reach_of(body, upwards(start));
    Reach& all = stands_still(body) ? still : moving;
    all = {.low = std::min(all.low, height.low), .high = std::max(all.high, height.high)};
  }
  lowest_ = still.low <= still.high ? still.low : moving.low;
}

void FailureWatch::see_begin(const Snapshot& start) {
  const SnapshotBody& floor = start.bodies[ground];
  if (ends_are_stated_ || start.gravity.isZero(0) || !stands_still(floor)) return;
  const Vec2<double> up = upwards(start), along = perpendicular(up);
  const double top = reach_of(floor, up).high;
  std::optional<HeldBodies> held;
  for (const BodyId id : start.bodies.indices()) {
    const SnapshotBody& body = start.bodies[id];
    if (!can_fall(body) || has_floor_[id] || !may_touch(body.filter, floor.filter)) continue;
    const double high = reach_of(body, up).high;
    if (!(high < top) || !reach_of(body, along).meets(reach_of(floor, along))) continue;
    if (!held) held.emplace(start);
    if (is_caught(start, high) || held->holds(id)) continue;
    failures_.push_back({.kind = FailureKind::began_below, .distance = top - high, .a = id});
    return;
  }
}

void FailureWatch::see_falls(const Snapshot& now, double time) {
  if (now.gravity.isZero(0)) return;
  const Vec2<double> up = upwards(now);
  std::optional<HeldBodies> held;
  const bool may_fall =
      ends_are_stated_ || knows(FailureKind::began_below) || knows(FailureKind::falls_for_ever);
  for (const BodyId id : now.bodies.indices()) {
    if (!can_fall(now.bodies[id])) continue;
    const double high = reach_of(now.bodies[id], up).high;
    if (!(high < lowest_)) {
      below_since_[id] = never;
      continue;
    }
    below_since_[id] = std::min(below_since_[id], time);
    if (has_floor_[id]) {
      if (!knows(FailureKind::fell_out))
        failures_.push_back({.kind = FailureKind::fell_out, .time = time, .a = id});
      continue;
    }
    if (may_fall || !(lowest_ - high > far_lengths * length_[id]) || is_caught(now, high)) continue;
    if (!held) held.emplace(now);
    if (held->holds(id)) continue;
    failures_.push_back({.kind = FailureKind::falls_for_ever,
                         .time = time,
                         .since = below_since_[id],
                         .distance = lowest_ - high,
                         .a = id});
    return;
  }
}

}  // namespace cairn
