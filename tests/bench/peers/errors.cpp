// Overlaps, gaps and ways, from the poses alone.
#include "errors.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cairn/measure/violation.hpp>
#include <cairn/world/world.hpp>

namespace cairn::bench {

namespace {

const double far_off = 1e4;  // [m]: no scene is as large

double widest_gap(const Scene& scene, const PerBody<Pose<double>>& poses) {
  RowSpecs<double> rows;
  double widest = 0;
  for (const auto& joint : scene.joints()) {
    rows.clear();
    joint->append_rows(poses, rows);
    double sum = 0;
    for (const RowSpec<double>& row : rows) {
      if (row.bounds.is_equality()) sum += row.error * row.error;
    }
    widest = std::max(widest, std::sqrt(sum));
  }
  return widest;
}

/// More pairs than Cairn looks at are those of a scene that has fallen in on itself.
double overlap_of(const Snapshot& now, bool& exploded) {
  try {
    return worst_penetration(now);
  } catch (const std::length_error&) {
    exploded = true;
    return 0;
  }
}

}  // namespace

Ruler::Ruler(const PeerScene& entry, const Scene& scene)
    : entry_(entry), scene_(scene), start_(snapshot(World<double>(scene))), now_(start_) {
  for (const BodyId body : start_.bodies.indices()) {
    if (start_.bodies[body].type != BodyType::dynamic) continue;
    const bool higher = start_.bodies[body].pose.position.y() > start_.bodies[top_].pose.position.y();
    if (top_ == ground || higher) top_ = body;
  }
}

Errors Ruler::errors(const Engine& engine) {
  const PerBody<Pose<double>> poses = engine.poses();
  const BodyId loose = {poses.size() - entry_.loose};
  Errors result;
  for (const BodyId body : poses.indices()) {
    const Vec2<double>& place = poses[body].position;
    if (!(place.norm() < far_off) || !std::isfinite(poses[body].angle)) {
      result.exploded = true;
      return result;
    }
    now_.bodies[body].pose = poses[body];
    const double aside = std::abs(place.x() - start_.bodies[body].pose.position.x());
    if (body < loose) result.aside = std::max(result.aside, aside);
    const bool moves = start_.bodies[body].type == BodyType::dynamic;
    if (moves && entry_.outside && entry_.outside(place)) result.outside += 1;
  }
  result.sinking = start_.bodies[top_].pose.position.y() - poses[top_].position.y();
  result.overlap = overlap_of(now_, result.exploded);
  result.gap = widest_gap(scene_, poses);
  return result;
}

}  // namespace cairn::bench
