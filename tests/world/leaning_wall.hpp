// A wall whose contacts come and go, and its steps with rows and without.
#pragma once

#include "testing.hpp"

namespace cairn::testing {

/// A wall that leans, with smooth boxes and discs in it, on ground that slopes: it slides, tips and falls.
inline Scene leaning_wall(const SceneSettings& settings) {
  Scene scene(settings);
  scene.add_ground({.material = {.friction = 0.5}});
  scene.add({.type = BodyType::static_body, .shapes = {box(8.0, 1.0)}, .position = {6, 0}, .angle = 0.3});
  for (int i = 0; i < 60; ++i) {
    const Vec2<double> position = {0.99 * (i % 10) + 0.15 * (i / 10), 2.5 + 0.95 * (i / 10)};
    const bool is_disc = i % 7 == 3;
    BodySpec body = {
        .position = position, .angle = 0.02 * (i % 3), .material = {.friction = i % 5 == 0 ? 0.0 : 0.4}};
    if (is_disc) {
      body.shapes = {circle(0.45)};
    } else {
      body.shapes = {box(0.9, 0.9)};
    }
    scene.add(body);
  }
  return scene;
}

/// Does nothing; but whoever observes a solve sees rows.
template <Scalar Real>
class Onlooker final : public SolveObserver<Real> {};

template <Scalar Real>
void check_same_record(const StepRecord<Real>& one, const StepRecord<Real>& other) {
  check_same_problem(one.problem, other.problem);
  CHECK(one.is_new == other.is_new);
  CHECK(one.problem.blocks.size() == other.problem.blocks.size());
  const List<Contact<Real>>&contacts = one.problem.contacts, &others = other.problem.contacts;
  REQUIRE(contacts.size() == others.size());
  for (int i = 0; i < contacts.size(); ++i) {
    const Manifold<Real>&manifold = contacts[i].manifold, &expected = others[i].manifold;
    CHECK(manifold.collider_a == expected.collider_a);
    CHECK(manifold.collider_b == expected.collider_b);
    CHECK(manifold.normal == expected.normal);
    REQUIRE(manifold.count == expected.count);
    for (int k = 0; k < manifold.count; ++k) {
      CHECK(manifold.points[k].position == expected.points[k].position);
      CHECK(manifold.points[k].separation == expected.points[k].separation);
      CHECK(manifold.points[k].feature == expected.points[k].feature);
    }
  }
}

/// Two worlds take the same steps: one with contacts as they are, where its solver takes them so, and one
/// with rows in every step, for it is observed.
template <Scalar Real>
struct WithRowsAndWithout {
  World<Real> world, observed;
  WideSequentialImpulse<Real> wide, watched;
  SequentialImpulse<Real> plain{{.iterations = 4}};
  Onlooker<Real> onlooker;

  explicit WithRowsAndWithout(const Scene& scene, const SolverSettings& settings = {.iterations = 4},
                              Momentum momentum = Momentum::none, LaneSet set = widest_lane_set())
      : world(scene), observed(scene), wide(settings, momentum, set), watched(wide) {}

  template <typename Change>
  void change(const Change& change) {
    change(world);
    change(observed);
  }
  /// Whether it was done. `by_rows`: by a solver that takes no contacts.
  bool step(bool by_rows = false) {
    const auto solver = [&](WideSequentialImpulse<Real>& in_lanes) -> Solver<Real>& {
      if (by_rows) return plain;
      return in_lanes;
    };
    const StepReport expected = observed.step(solver(watched), &onlooker);
    const StepReport report = world.step(solver(wide));
    CHECK(report.rows == expected.rows);
    CHECK(report.contacts == expected.contacts);
    CHECK(report.too_deep == expected.too_deep);
    CHECK(report.sweeps == expected.sweeps);
    CHECK(report.solve.stop == expected.solve.stop);
    CHECK(report.not_finite == expected.not_finite);
    return !report.not_finite;
  }
  void steps(int count) {
    for (int step_number = 0; step_number < count; ++step_number) step();
  }
  void check_alike() {
    CHECK(same_motion(world, observed));
    check_same_record(with_rows(world), with_rows(observed));
  }
  void check_alike_ahead() {
    check_alike();
    CHECK(world.velocity_problem().impulse == observed.velocity_problem().impulse);
  }
};

}  // namespace cairn::testing
