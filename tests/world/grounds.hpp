// Grounds of one form in several makings, solvers and policies: what tests of seams go through.
#pragma once

#include "testing.hpp"

namespace cairn::seams {

/// How ground is put together.
enum class Making { tiles, segments, chain };

inline const char* name_of(Making making) {
  return making == Making::tiles ? "tiles" : making == Making::segments ? "segments" : "chain";
}

inline BodySpec still(const Shape<double>& shape, double friction = 0) {
  return {.type = BodyType::static_body, .shapes = {shape}, .material = {.friction = friction}};
}

/// Ground whose surface goes through these points, from left to right; as tiles, which are 1 m thick, only
/// where it is level.
inline void add_track(Scene& scene, Making making, const List<Vec2<double>>& points, double friction = 0) {
  if (making == Making::chain) {
    scene.add(still(chain({points.rbegin(), points.rend()}), friction));
    return;
  }
  for (int i = 0; i + 1 < points.size(); ++i) {
    const Vec2<double>&from = points[i], &to = points[i + 1];
    if (making == Making::segments) {
      scene.add(still(segment(from, to), friction));
    } else {
      const Vec2<double> middle = (from + to) / 2 - Vec2<double>(0, 0.5);
      scene.add(still(moved(box(to.x() - from.x(), 1), middle), friction));
    }
  }
}

/// Points of a level line from x = -2 m on.
inline List<Vec2<double>> level_points(int count, double length) {
  List<Vec2<double>> points;
  for (int i = 0; i <= count; ++i) points.push_back({-2 + i * length, 0});
  return points;
}

struct NamedSolver {
  std::string name = {};
  std::unique_ptr<Solver<double>> solver = {};
};

inline List<NamedSolver> seam_solvers() {
  List<NamedSolver> solvers;
  solvers.push_back({"si", std::make_unique<SequentialImpulse<double>>()});
  solvers.push_back({"pgs", std::make_unique<ProjectedGaussSeidel<double>>()});
  solvers.push_back({"block", std::make_unique<BlockSequentialImpulse<double>>()});
  solvers.push_back({"newton", std::make_unique<NewtonSolver<double>>()});
  solvers.push_back({"wide", std::make_unique<WideSequentialImpulse<double>>()});
  return solvers;
}

struct NamedPolicy {
  std::string name = {};
  StabilizationPolicy policy = StabilizationPolicy::baumgarte;
  int substeps = 1;
};

inline const List<NamedPolicy>& seam_policies() {
  static const List<NamedPolicy> policies = {{"baumgarte"},
                                             {"split impulse", StabilizationPolicy::split_impulse},
                                             {"soft", StabilizationPolicy::soft, 4},
                                             {"none", StabilizationPolicy::none}};
  return policies;
}

inline SceneSettings seam_settings(const NamedPolicy& policy, int rate) {
  SceneSettings settings{.dt = 1.0 / rate, .substeps = policy.substeps};
  settings.stabilization.policy = policy.policy;
  return settings;
}

}  // namespace cairn::seams
