// A wall whose contacts come and go, and its steps with rows and without.
#pragma once

#include <doctest/doctest.h>

#include "solvers/wide/wide_sequential_impulse.hpp"
#include "world/world.hpp"

namespace cairn::testing {

/// A wall that leans, with smooth boxes and discs in it, on ground that slopes: it slides, tips and falls.
inline Scene leaning_wall(const SceneSettings& settings) {
  Scene scene(settings);
  scene.add_ground({.friction = 0.5});
  scene.add({.type = BodyType::static_body, .shapes = {box(8.0, 1.0)}, .position = {6, 0}, .angle = 0.3});
  for (int i = 0; i < 60; ++i) {
    const Vec2<double> position = {0.99 * (i % 10) + 0.15 * (i / 10), 2.5 + 0.95 * (i / 10)};
    const bool is_disc = i % 7 == 3;
    BodySpec body = {.position = position, .angle = 0.02 * (i % 3), .friction = i % 5 == 0 ? 0.0 : 0.4};
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
void check_same(const World<Real>& one, const World<Real>& other) {
  for (const BodyId body : one.bodies().pose.indices()) {
    CHECK(one.bodies().velocity[body] == other.bodies().velocity[body]);
    CHECK(one.bodies().pose[body].position == other.bodies().pose[body].position);
    CHECK(one.bodies().pose[body].angle == other.bodies().pose[body].angle);
  }
}

template <Scalar Real>
void check_same_record(const StepRecord<Real>& one, const StepRecord<Real>& other) {
  REQUIRE(one.problem.row_count() == other.problem.row_count());
  CHECK(one.problem.impulse == other.problem.impulse);
  CHECK(one.problem.velocity == other.problem.velocity);
  CHECK(one.problem.dt == other.problem.dt);
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
  for (int i = 0; i < one.problem.row_count(); ++i) {
    const ConstraintRow<Real>&row = one.problem.rows[i], &expected = other.problem.rows[i];
    CHECK(row.key == expected.key);
    CHECK(row.a == expected.a);
    CHECK(row.b == expected.b);
    CHECK(row.jacobian_a == expected.jacobian_a);
    CHECK(row.jacobian_b == expected.jacobian_b);
    CHECK(row.bias == expected.bias);
    CHECK(row.softness == expected.softness);
    CHECK(row.bounds.normal_row == expected.bounds.normal_row);
    CHECK(row.bounds.friction == expected.bounds.friction);
  }
}

template <Scalar Real>
void check_steps(const Scene& scene, const SolverSettings& settings, Momentum momentum, LaneSet set) {
  World<Real> world(scene), observed(scene);
  WideSequentialImpulse<Real> solver(settings, momentum, set), watched(solver);
  Onlooker<Real> onlooker;
  for (int step = 0; step < 90; ++step) {
    const StepReport report = world.step(solver);
    const StepReport expected = observed.step(watched, &onlooker);
    CHECK(report.rows == expected.rows);
    CHECK(report.contacts == expected.contacts);
    CHECK(report.sweeps == expected.sweeps);
    CHECK(report.solve.stop == expected.solve.stop);
    if (step % 9 == 0) check_same_record(with_rows(world), with_rows(observed));
  }
  CHECK(world.last_step().problem.contacts.size() > 40);
  check_same(world, observed);
}

}  // namespace cairn::testing
