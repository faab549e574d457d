// Floor 6. What no scene should show, whatever else is expected of it.
#include <cairn/measure/failure.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <cairn/geometry/aabb.hpp>

namespace cairn {

namespace {

// What is deeper has passed half of the way to the middle.
constexpr double through_share = 0.25;
constexpr double apart_share = 0.5;
// Semi-implicit Euler by itself shows w dt / 2 of a swing's energy, and takes it back: 10 % at thirty steps a
// swing.
constexpr double gained_share = 0.25;
// A joint that is off by a twentieth of a body is off to the eye. The slowest of the usual policies, a share
// of 0.2 a step at 60 Hz, leaves 1e-6 of an error after a second: what has not even halved is not taken back.
constexpr double off_share = 0.05;
constexpr double off_seconds = 1;

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
    case FailureKind::stayed_off:
      return fmt::format("{} joint of {} and {} ends {:.3g} m off, as it was from {:.3g} s on", failure.joint,
                         a, b, failure.distance, failure.since);
    case FailureKind::began_below:
      return fmt::format("{} begins {:.3g} m below the top of the ground, with nothing to land on", a,
                         failure.distance);
    case FailureKind::falls_for_ever:
      return fmt::format(
          "{} falls for ever: from {:.3g} s on there was nothing to land on, and after {:.3g} s "
          "it is {:.3g} m further down",
          a, failure.since, failure.time, failure.distance);
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
  const auto runs = [](const SceneBody& body) { return body.spec.material.surface_speed != 0; };
  const auto drives = [](const SceneEvent& event) {
    const auto* const change = std::get_if<ChangeBody>(&event.action);
    const bool moves = change && (change->velocity || change->angular_velocity || change->surface_speed);
    return moves || std::holds_alternative<SwitchMotor>(event.action) || is_lasting(event.action);
  };
  PerBody<Pose<double>> poses;
  for (const SceneBody& body : scene.bodies()) poses.push_back(body.pose);
  const auto gives_energy = [&poses](const std::shared_ptr<const Constraint>& joint) {
    RowSpecs<double> rows;
    joint->append_rows(poses, rows);
    return std::any_of(rows.begin(), rows.end(), [](const RowSpec<double>& row) { return row.speed != 0; });
  };
  const Fields& fields = scene.settings().fields;
  return !fields.wind.isZero(0) || (fields.water && !fields.water->flow.isZero(0)) ||
         std::any_of(scene.bodies().begin(), scene.bodies().end(), moves_by_itself) ||
         std::any_of(scene.bodies().begin(), scene.bodies().end(), runs) ||
         std::any_of(scene.events().begin(), scene.events().end(), drives) ||
         std::any_of(scene.joints().begin(), scene.joints().end(), gives_energy);
}

FailureWatch::FailureWatch(const Snapshot& start, bool ends_are_stated) : ends_are_stated_(ends_are_stated) {
  for (const SnapshotBody& body : start.bodies) before_.push_back(body.pose);
  look_around(start);
  see_begin(start);
  see_errors(start, 0);
}

void FailureWatch::scene_changed(const Snapshot& now) {
  errors_.clear();  // joints may have gone
  if (removed_bodies(now) == removed_) return;
  length_.clear();
  look_around(now);
}

void FailureWatch::look_around(const Snapshot& start) {
  removed_ = removed_bodies(start);
  for (const SnapshotBody& body : start.bodies) {
    double length = 0;
    for (const Shape<double>& shape : body.shapes) {
      const Aabb<double> box = bounding_box(shape, Pose<double>{});
      length = std::max(length, (box.upper - box.lower).maxCoeff());
    }
    length_.push_back(length > 0 ? length : std::numeric_limits<double>::infinity());
  }
  note_floors(start);
}

void FailureWatch::see(const Snapshot& now, double time) {
  if (!knows(FailureKind::came_apart)) see_joints(now, time);
  see_errors(now, time);
  see_falls(now, time);
}

void FailureWatch::end(const Snapshot& now, double time) {
  if (knows(FailureKind::came_apart)) return;
  Failure worst;
  for (int i = 0; i < std::min(errors_.size(), now.joints.size()); ++i) {
    const SnapshotJoint& joint = now.joints[i];
    const bool lasts = errors_[i].largest > 0 && time - errors_[i].since >= off_seconds;
    if (!lasts || !(joint.drift > worst.distance)) continue;
    worst = {.kind = FailureKind::stayed_off,
             .time = time,
             .since = errors_[i].since,
             .distance = joint.drift,
             .a = joint.a,
             .b = joint.b,
             .joint = joint.name};
  }
  if (worst.distance > 0) failures_.push_back(worst);
}

void FailureWatch::see(const List<Overlap>& overlaps, const Snapshot& now, double time) {
  for (const Overlap& overlap : overlaps) {
    if (knows(FailureKind::went_through)) break;
    if (!(overlap.depth > through_share * overlap.thickness)) continue;
    if (overlap.one_sided && !goes_deeper(overlap, now)) continue;  // it has come from behind
    failures_.push_back({.kind = FailureKind::went_through,
                         .time = time,
                         .distance = overlap.depth,
                         .a = overlap.a,
                         .b = overlap.b});
  }
  for (const BodyId body : now.bodies.indices()) before_[body] = now.bodies[body].pose;
}

/// Whether the two have come nearer to each other, at the point where they are deepest.
bool FailureWatch::goes_deeper(const Overlap& overlap, const Snapshot& now) const {
  const auto was_at = [&](BodyId body) {
    return before_[body].world(now.bodies[body].pose.local(overlap.position));
  };
  return overlap.normal.dot(was_at(overlap.b) - was_at(overlap.a)) > 0;
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
    if (!joint.traits.holds_points) continue;
    if (!(joint.drift > apart_share * shorter(joint))) continue;
    failures_.push_back({.kind = FailureKind::came_apart,
                         .time = time,
                         .distance = joint.drift,
                         .a = joint.a,
                         .b = joint.b,
                         .joint = joint.name});
    return;
  }
}

void FailureWatch::see_errors(const Snapshot& now, double time) {
  errors_.resize(now.joints.size());
  for (int i = 0; i < now.joints.size(); ++i) {
    const SnapshotJoint& joint = now.joints[i];
    JointError& error = errors_[i];
    if (!joint.traits.holds_points || !(joint.drift > off_share * shorter(joint))) {
      error = {};
    } else if (joint.drift < error.largest / 2 || error.largest == 0) {
      error = {.since = time, .largest = joint.drift};
    } else {
      error.largest = std::max(error.largest, joint.drift);
    }
  }
}

double FailureWatch::shorter(const SnapshotJoint& joint) const {
  return std::min(length_[joint.a], length_[joint.b]);
}

}  // namespace cairn
