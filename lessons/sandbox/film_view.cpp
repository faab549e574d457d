// Where to point the camera.
#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/geometry/aabb.hpp>
#include "lessons/sandbox/scene_film.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {
namespace {

// What moves farther away than this from where it all began is not followed, so that what is left behind does
// not become a dot: the larger of
constexpr double many_extents = 3;    // of the start,
constexpr double many_bodies = 60;    // of its usual size, the median.
constexpr double flown_off = 2.5;     // times the extent of nearly all places: what is beyond is not followed
constexpr double nearly_none = 0.02;  // of all places
// In parts of the larger extent of what moves:
constexpr double near_by = 0.5;      // what does not move and is no farther off is seen,
constexpr double not_too_large = 6;  // unless it is larger than this
constexpr double strip = 0.06;       // of a floor, so much depth

/// The ends of the boxes of everything that moves, one axis apart from the other.
struct Extents {
  List<double> lower[2] = {};
  List<double> upper[2] = {};
};

void include_box(Aabb<double>& bounds, const Aabb<double>& box) {
  bounds.lower = bounds.lower.cwiseMin(box.lower);
  bounds.upper = bounds.upper.cwiseMax(box.upper);
}

/// How far a film of a run that begins so may go.
Aabb<double> followed(const Snapshot& start) {
  std::optional<Aabb<double>> bounds;
  List<double> sizes;
  for (const SnapshotBody& body : start.bodies) {
    if (body.type != BodyType::dynamic) continue;
    for (const Shape<double>& shape : body.shapes) {
      const Aabb<double> box = bounding_box(shape, body.pose);
      if (!box.lower.allFinite() || !box.upper.allFinite()) continue;
      if (!bounds) bounds = box;
      include_box(*bounds, box);
      sizes.push_back((box.upper - box.lower).maxCoeff());
    }
  }
  if (!bounds) return {};
  std::sort(sizes.begin(), sizes.end());
  const double extent = (bounds->upper - bounds->lower).maxCoeff();
  const double room = std::max(many_extents * extent, many_bodies * sizes[sizes.size() / 2]);
  return {.lower = bounds->lower.array() - room, .upper = bounds->upper.array() + room};
}

void add_moving(const Snapshot& snapshot, const Aabb<double>& limits, Extents& extents) {
  for (const SnapshotBody& body : snapshot.bodies) {
    if (body.type != BodyType::dynamic) continue;
    for (const Shape<double>& shape : body.shapes) {
      const Aabb<double> box = bounding_box(shape, body.pose);
      const bool is_followed = box.lower.allFinite() && box.upper.allFinite() &&
                               (box.lower - limits.lower).minCoeff() >= 0 &&
                               (limits.upper - box.upper).minCoeff() >= 0;
      if (!is_followed) continue;
      for (int axis = 0; axis < 2; ++axis) {
        extents.lower[axis].push_back(box.lower[axis]);
        extents.upper[axis].push_back(box.upper[axis]);
      }
    }
  }
}

double quantile(const List<double>& sorted, double share) {
  return sorted[static_cast<int>(share * (sorted.size() - 1))];
}

/// Along one axis: everything, unless a few places make it much longer than nearly all of them are.
void set_axis(Extents& extents, int axis, Aabb<double>& bounds) {
  List<double>& lower = extents.lower[axis];
  List<double>& upper = extents.upper[axis];
  std::sort(lower.begin(), lower.end());
  std::sort(upper.begin(), upper.end());
  const double from = quantile(lower, nearly_none), to = quantile(upper, 1 - nearly_none);
  const double room = 0.5 * (flown_off - 1) * (to - from);
  bounds.lower[axis] = std::max(lower.front(), from - room);
  bounds.upper[axis] = std::min(upper.back(), to + room);
}

/// What does not move is seen where it is near; of the ground, a strip below what stands on it.
void include_fixed(const Snapshot& snapshot, const Aabb<double>& moving, FilmView& view) {
  Aabb<double>& bounds = view.box;
  const Vec2<double> size = moving.upper - moving.lower;
  const double extent = std::max(size.x(), size.y());
  const double reach = near_by * extent;
  const Aabb<double> around = {moving.lower.array() - reach, moving.upper.array() + reach};
  for (const SnapshotBody& body : snapshot.bodies) {
    if (body.type == BodyType::dynamic) continue;
    for (const Shape<double>& shape : body.shapes) {
      const Aabb<double> box = bounding_box(shape, body.pose);
      if (!box.overlaps(around)) continue;
      const Vec2<double> own = box.upper - box.lower;
      // A floor may be as long as it likes: of it, only its surface matters.
      const bool is_floor =
          snapshot.gravity.y() < 0 && own.x() > size.x() && box.upper.y() <= moving.lower.y() + 0.1 * extent;
      if (is_floor) {
        view.bottom = std::min(view.bottom.value_or(box.lower.y()), box.lower.y());
        bounds.lower.y() =
            std::min(bounds.lower.y(), std::max(box.lower.y(), box.upper.y() - strip * extent));
      } else if (own.maxCoeff() <= not_too_large * extent) {
        include_box(bounds, box);
      }
    }
  }
  for (const SnapshotJoint& joint : snapshot.joints) {
    for (const Vec2<double>& point : {joint.anchor_a, joint.anchor_b}) include_box(bounds, {point, point});
    for (const Vec2<double>& point : joint.between) include_box(bounds, {point, point});
  }
}

}  // namespace

FilmView view_of(const List<SceneRun>& runs) {
  Extents extents;
  for (const SceneRun& run : runs) {
    if (run.frames.empty()) continue;
    const Aabb<double> limits = followed(run.frames.front());
    for (const Snapshot& snapshot : run.frames) add_moving(snapshot, limits, extents);
  }
  if (extents.lower[0].empty()) return {.box = {.lower = {-1, -1}, .upper = {1, 1}}};
  FilmView view;
  for (int axis = 0; axis < 2; ++axis) set_axis(extents, axis, view.box);
  const Aabb<double> moving = view.box;
  for (const SceneRun& run : runs) {
    if (!run.frames.empty()) include_fixed(run.frames.front(), moving, view);
  }
  // What reaches below the floor wants to be seen too.
  if (view.bottom && view.box.lower.y() < *view.bottom) view.bottom.reset();
  // Some room around it all, and never a view without size.
  const Vec2<double> size = view.box.upper - view.box.lower;
  const double spacing =
      std::max(view.box.lower.cwiseAbs().maxCoeff(), view.box.upper.cwiseAbs().maxCoeff()) *
      std::numeric_limits<double>::epsilon();
  const double margin = std::max({0.04 * std::max(size.x(), size.y()), 100 * spacing, 1e-6});
  view.box.lower.array() -= margin;
  view.box.upper.array() += margin;
  return view;
}

FilmView view_of(const SceneEntry& scene, const List<SceneRun>& runs) {
  const FilmView view = view_of(runs);
  if (!scene.camera) return view;
  const Vec2<double> center = scene.camera->center;
  const double wide = std::max(center.x() - view.box.lower.x(), view.box.upper.x() - center.x());
  const Vec2<double> half(std::min(wide, 8.0 / 9 * scene.camera->height), 0.5 * scene.camera->height);
  return {.box = {.lower = center - half, .upper = center + half}, .bottom = {}};
}

}  // namespace cairn::sandbox
