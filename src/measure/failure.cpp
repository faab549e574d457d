// Floor 6. What no scene should show, whatever else is expected of it.
#include "measure/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/aabb.hpp"

namespace cairn {

namespace {

// As a guarded scene has it (world/last_word.hpp): what is deeper has passed half of the way to the middle.
constexpr double through_share = 0.25;
constexpr double apart_share = 0.5;
// Semi-implicit Euler by itself shows w dt / 2 of a swing's energy, and takes it back: 10 % at thirty steps a
// swing.
constexpr double gained_share = 0.25;

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

bool stands_still(const SnapshotBody& body) {
  return body.type == BodyType::static_body && !body.sensor && !body.shapes.empty();
}

bool can_fall(const Snapshot& snapshot, const SnapshotBody& body) {
  return body.type == BodyType::dynamic && !body.sensor && !body.shapes.empty() && body.gravity_scale > 0 &&
         !snapshot.gravity.isZero(0);
}

/// Against gravity.
Vec2<double> upwards(const Snapshot& snapshot) { return -snapshot.gravity.normalized(); }

bool has_floor(const Snapshot& start, const SnapshotBody& body) {
  if (!can_fall(start, body)) return false;
  const Vec2<double> up = upwards(start), along = perpendicular(up);
  const Reach height = reach_of(body, up), width = reach_of(body, along);
  return std::any_of(start.bodies.begin(), start.bodies.end(), [&](const SnapshotBody& other) {
    return stands_still(other) && may_touch(body, other) && reach_of(other, along).meets(width) &&
           reach_of(other, up).low < height.middle();
  });
}

int removed_bodies(const Snapshot& snapshot) {
  const auto is_removed = [](const SnapshotBody& body) { return body.removed; };
  return static_cast<int>(std::count_if(snapshot.bodies.begin(), snapshot.bodies.end(), is_removed));
}

std::string name_of(BodyId body, const PerBody<std::string>& names) {
  return body.index < names.size() ? names[body] : fmt::format("body {}", body.index);
}

}  // namespace

std::string failure_text(const Failure& failure, const PerBody<std::string>& names) {
  const std::string a = name_of(failure.a, names), b = name_of(failure.b, names);
  switch (failure.kind) {
    case FailureKind::went_through:
      return fmt::format("{} is {:.3g} m deep in {} after {:.3g} s, more than a quarter of the thinner one",
                         b, failure.distance, a, failure.time);
    case FailureKind::came_apart:
      return fmt::format("{} joint of {} and {} is {:.3g} m apart after {:.3g} s", failure.joint, a, b,
                         failure.distance, failure.time);
    case FailureKind::fell_out:
      return fmt::format("{} has fallen out of the scene after {:.3g} s", a, failure.time);
    case FailureKind::gained_energy:
      break;
  }
  return fmt::format("energy came from nowhere: {:.3g} % of its scale after {:.3g} s", 100 * failure.gain,
                     failure.time);
}

bool is_driven(const Scene& scene) {
  const auto moves_by_itself = [](const SceneBody& body) {
    return body.spec.type == BodyType::kinematic &&
           !(body.spec.velocity.isZero(0) && body.spec.angular_velocity == 0);
  };
  const auto switches_motor = [](const SceneEvent& event) {
    return std::holds_alternative<SwitchMotor>(event.action);
  };
  PerBody<Pose<double>> poses;
  for (const SceneBody& body : scene.bodies()) poses.push_back(body.pose);
  const auto gives_energy = [&poses](const std::shared_ptr<const Constraint>& joint) {
    RowSpecs<double> rows;
    joint->append_rows(poses, rows);
    return std::any_of(rows.begin(), rows.end(),
                       [](const RowSpec<double>& row) { return row.softness || row.speed != 0; });
  };
  return std::any_of(scene.bodies().begin(), scene.bodies().end(), moves_by_itself) ||
         std::any_of(scene.events().begin(), scene.events().end(), switches_motor) ||
         std::any_of(scene.joints().begin(), scene.joints().end(), gives_energy);
}

FailureWatch::FailureWatch(const Snapshot& start) { look_around(start); }

void FailureWatch::scene_changed(const Snapshot& now) {
  if (removed_bodies(now) == removed_) return;
  thickness_.clear();
  length_.clear();
  has_floor_.clear();
  lowest_still_.reset();
  look_around(now);
}

void FailureWatch::look_around(const Snapshot& start) {
  removed_ = removed_bodies(start);
  for (const SnapshotBody& body : start.bodies) {
    double thickness = std::numeric_limits<double>::infinity(), length = 0;
    for (const Shape<double>& shape : body.shapes) {
      const Aabb<double> box = bounding_box(shape, Pose<double>{});
      const Vec2<double> size = box.upper - box.lower;
      const bool has_thickness = size.minCoeff() > 0 && !std::holds_alternative<Chain<double>>(shape);
      if (has_thickness) thickness = std::min(thickness, size.minCoeff());
      length = std::max(length, size.maxCoeff());
    }
    thickness_.push_back(thickness);
    length_.push_back(length > 0 ? length : std::numeric_limits<double>::infinity());
    has_floor_.push_back(has_floor(start, body) ? 1 : 0);
    if (!stands_still(body) || start.gravity.isZero(0)) continue;
    const double low = reach_of(body, upwards(start)).low;
    lowest_still_ = std::min(lowest_still_.value_or(low), low);
  }
}

void FailureWatch::see(const Snapshot& now, double time) {
  if (!knows(FailureKind::came_apart)) see_joints(now, time);
  if (!knows(FailureKind::fell_out) && lowest_still_) see_falls(now, time);
}

void FailureWatch::see(const List<Overlap>& overlaps, double time) {
  if (knows(FailureKind::went_through)) return;
  for (const Overlap& overlap : overlaps) {
    if (!(overlap.depth > through_share * std::min(thickness_[overlap.a], thickness_[overlap.b]))) continue;
    failures_.push_back({.kind = FailureKind::went_through,
                         .time = time,
                         .distance = overlap.depth,
                         .a = overlap.a,
                         .b = overlap.b});
    return;
  }
}

void FailureWatch::see_gain(double gain, double time) {
  if (knows(FailureKind::gained_energy) || !(gain > gained_share)) return;
  failures_.push_back({.kind = FailureKind::gained_energy, .time = time, .gain = gain});
}

bool FailureWatch::knows(FailureKind kind) const {
  return std::any_of(failures_.begin(), failures_.end(),
                     [kind](const Failure& failure) { return failure.kind == kind; });
}

void FailureWatch::see_joints(const Snapshot& now, double time) {
  for (const SnapshotJoint& joint : now.joints) {
    if (joint.name == "gear" || joint.name == "differential") continue;
    if (!(joint.drift > apart_share * std::min(length_[joint.a], length_[joint.b]))) continue;
    failures_.push_back({.kind = FailureKind::came_apart,
                         .time = time,
                         .distance = joint.drift,
                         .a = joint.a,
                         .b = joint.b,
                         .joint = joint.name});
    return;
  }
}

void FailureWatch::see_falls(const Snapshot& now, double time) {
  const Vec2<double> up = upwards(now);
  for (const BodyId id : now.bodies.indices()) {
    if (!has_floor_[id] || !(reach_of(now.bodies[id], up).high < *lowest_still_)) continue;
    failures_.push_back({.kind = FailureKind::fell_out, .time = time, .a = id});
    return;
  }
}

}  // namespace cairn
