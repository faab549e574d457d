// Where static shapes make one surface, a body slides over their seams as over one shape.
#include "world/grounds.hpp"

namespace cairn {

using namespace testing;

namespace {

using namespace seams;

const List<Making> all_makings = {Making::tiles, Making::segments, Making::chain};

struct SeamRun {
  Making making = Making::tiles;
  NamedPolicy policy = {};
  Shape<double> shape = box(1, 1);
  double speed = 5;       // [m/s]
  int rate = 60;          // [1/s]
  double way = 0.6;       // [m]
  double friction = 0;    // mu
  bool rolls = false;     // without slipping
  bool is_first = false;  // the body comes before the ground
};

/// The velocity at the end. The body begins 4 mm deep, within the slop, with its front and its middle
/// 10 mm before seams, which are 0.25 m apart.
Vec3<double> velocity_after(const SeamRun& run, Solver<double>& solver) {
  Scene scene(seam_settings(run.policy, run.rate));
  const double radius = 0.5;
  const BodySpec body{.shapes = {run.shape},
                      .position = {-0.76, radius - 0.004},
                      .velocity = {run.speed, 0},
                      .angular_velocity = run.rolls ? -run.speed / radius : 0,
                      .material = {.friction = run.friction}};
  if (run.is_first) scene.add(body);
  add_track(scene, run.making, level_points(16, 0.25), run.friction);
  if (!run.is_first) scene.add(body);
  World<double> world(scene);
  const int steps = static_cast<int>(std::ceil(run.way / run.speed * run.rate));
  for (int i = 0; i < steps; ++i) world.step(solver);
  return world.bodies().velocity[run.is_first ? BodyId{1} : BodyId{scene.bodies().size() - 1}];
}

/// [1] No row of level ground has a part along it: what is lost are roundings of a few hundred steps.
constexpr double seam_rounding = 1e-12;

}  // namespace

TEST_CASE("a box keeps its speed over the tiles of a platform that moves") {
  for (const Vec2<double>& speed : List<Vec2<double>>{{0, 0.5}, {-2, 0}, {1, -0.5}}) {
    List<Shape<double>> tiles;
    for (int i = 0; i < 16; ++i) tiles.push_back(moved(box(0.5, 0.5), {0.5 * i, 0}));
    Scene scene({.gravity = {0, 0}});
    scene.add({.type = BodyType::kinematic, .shapes = tiles, .velocity = speed, .material = {.friction = 0}});
    const Vec2<double> own = speed + Vec2<double>(4, 0);
    scene.add({.shapes = {box(0.8, 0.4)},
               .position = {0, 0.25 + 0.2 - 0.004},
               .velocity = own,
               .material = {.friction = 0}});
    World<double> world = world_after(std::move(scene), 60);
    CAPTURE(speed.x());
    CAPTURE(speed.y());
    CHECK(world.bodies().velocity[{2}].x() == doctest::Approx(own.x()).epsilon(seam_rounding));
    CHECK(std::abs(world.bodies().velocity[{2}].z()) < seam_rounding);
  }
}

TEST_CASE("a box and a disc keep their speed over level seams under every solver and policy") {
  const List<NamedSolver> solvers = seam_solvers();
  for (const Making making : all_makings) {
    for (const NamedPolicy& policy : seam_policies()) {
      for (const NamedSolver& named : solvers) {
        for (const int rate : {60, 240, 960, 3840}) {
          CAPTURE(name_of(making));
          CAPTURE(policy.name);
          CAPTURE(named.name);
          CAPTURE(rate);
          SeamRun run{.making = making, .policy = policy, .rate = rate, .way = rate > 240 ? 0.08 : 0.6};
          CHECK(std::abs(velocity_after(run, *named.solver).x() / run.speed - 1) < seam_rounding);
          run.shape = circle(0.5);
          CHECK(std::abs(velocity_after(run, *named.solver).x() / run.speed - 1) < seam_rounding);
        }
      }
    }
  }
}

TEST_CASE("a box keeps any speed over seams, whether it or the ground is the first body") {
  SequentialImpulse<double> solver;
  for (const Making making : all_makings) {
    for (const double speed : {1.5, 3.0, 20.0}) {
      for (const bool is_first : {false, true}) {
        CAPTURE(name_of(making));
        CAPTURE(speed);
        CAPTURE(is_first);
        SeamRun run{.making = making, .speed = speed, .way = 1.5, .is_first = is_first};
        CHECK(std::abs(velocity_after(run, solver).x() / speed - 1) < seam_rounding);
        run.rate = 240;
        CHECK(std::abs(velocity_after(run, solver).x() / speed - 1) < seam_rounding);
      }
    }
  }
}

TEST_CASE("a disc that rolls without slipping over seams goes on rolling") {
  SequentialImpulse<double> solver;
  for (const Making making : all_makings) {
    CAPTURE(name_of(making));
    const SeamRun run{.making = making, .shape = circle(0.5), .way = 1.5, .friction = 0.6, .rolls = true};
    const Vec3<double> velocity = velocity_after(run, solver);
    // As it begins 4 mm deep, it rolls on an arm of 0.496 m: friction may even that out, by a share of
    // 0.004 / 0.5 / 3 (two thirds of a slip stay in the speed of a disc), and no more.
    CHECK(std::abs(velocity.x() / run.speed - 1) < 0.004 / 0.5 / 3);
    CHECK(std::abs(velocity.z() * 0.5 / run.speed + 1) < 2 * 0.004 / 0.5);
  }
}

TEST_CASE("seams stay smooth where tiles overlap, leave a gap of 0.1 mm, or differ in depth and width") {
  for (const int rate : {60, 240}) {
    for (const double gap : {0.0001, 0.0, -0.1}) {
      CAPTURE(rate);
      CAPTURE(gap);
      Scene scene({.dt = 1.0 / rate});
      for (int i = 0; i < 8; ++i) {
        const double depth = 0.5 + 0.4 * (i % 3), width = 0.6;
        scene.add(still(moved(box(width, depth), {-1 + i * (width + gap), -depth / 2})));
      }
      const BodyId body = scene.add({.shapes = {box(1, 1)}, .position = {-0.5, 0.496}, .velocity = {5, 0}});
      const World<double> world = world_after(scene, rate / 2);
      CHECK(std::abs(world.bodies().velocity[body].x() / 5 - 1) < seam_rounding);
      CHECK(world.bodies().pose[body].position.y() == doctest::Approx(0.5).epsilon(0.01));
    }
  }
}

TEST_CASE_TEMPLATE(
    "seams that are level but for roundings carry in every scalar, however long the pieces are", Real, float,
    double) {
  // Angles from far below to just above what counts as one direction; a point in a body's frame is as exact.
  for (const double off : {0.0, 1e-16, 1e-12, 1e-8, 1e-7, 2e-6}) {
    for (const Making making : {Making::segments, Making::chain}) {
      for (const Shape<double>& shape : {Shape<double>(box(1, 1)), Shape<double>(circle(0.5))}) {
        CAPTURE(off);
        CAPTURE(name_of(making));
        CAPTURE(shape_name(shape));
        Scene scene;
        add_track(scene, making, {{-60, off}, {-0.4, 0}, {0, off}, {0.4, -off}, {0.8, 0}, {60, off}});
        const BodyId body = scene.add(
            {.shapes = {shape}, .position = {-1, 0.497}, .velocity = {5, 0}, .material = {.friction = 0}});
        World<Real> world(scene);
        SequentialImpulse<Real> solver;
        double lowest = 1;
        for (int i = 0; i < 60; ++i) {
          world.step(solver);
          lowest = std::min(lowest, static_cast<double>(world.bodies().pose[body].position.y()));
        }
        // Within the slop of 5 mm; a step without a contact would fall by g dt^2 = 2.8 mm from 3 mm on, and
        // its speed would take it on in the next.
        CHECK(lowest > 0.5 - 0.0052);
        CHECK(static_cast<double>(world.bodies().velocity[body].x()) == doctest::Approx(5).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("a step of 0.2 m between tiles stops a box that cannot tip") {
  SequentialImpulse<double> solver;
  for (const int rate : {60, 240, 960}) {
    CAPTURE(rate);
    Scene scene({.dt = 1.0 / rate});
    for (int i = 0; i < 6; ++i) {
      const double top = i < 4 ? 0 : 0.2;  // from x = 2 m on
      scene.add(still(moved(box(1, 1 + top), {-1.5 + i, (top - 1) / 2})));
    }
    const BodyId body = scene.add({.shapes = {box(1, 1)},
                                   .position = {0.5, 0.496},
                                   .velocity = {3, 0},
                                   .material = {.friction = 0},
                                   .fixed_rotation = true});
    World<double> world(scene);
    double farthest = 0;
    for (int i = 0; i < rate; ++i) {
      world.step(solver);
      farthest = std::max(farthest, world.bodies().pose[body].position.x());
    }
    // Its front reaches the step at x = 2 m. It sees it 20 mm before, and goes no farther than a step's way.
    CHECK(farthest > 1.48);
    CHECK(farthest < 1.5 + 3.0 / rate);
    CHECK(world.bodies().velocity[body].x() <= 0);
    CHECK(world.bodies().pose[body].position.y() < 0.51);
  }
}

TEST_CASE("what another body is not to meet does not smooth the edge of what it meets") {
  Scene scene({.dt = 1.0 / 240});
  scene.add(still(moved(box(4, 1), {-2, -0.5})));            // up to x = 0
  BodySpec other = still(moved(box(4, 1.2), {2, -0.4}));     // higher by 0.2 m
  BodySpec between = still(moved(box(4, 1.2), {-2, -0.4}));  // level with it, and not met
  between.filter.category = 2;
  scene.add(other);
  scene.add(between);
  const BodyId body = scene.add({.shapes = {box(1, 1)},
                                 .position = {-1.5, 0.5},
                                 .velocity = {3, 0},
                                 .material = {.friction = 0},
                                 .fixed_rotation = true,
                                 .filter = {.collides_with = 1}});
  CHECK(pose_of(world_after(scene, 240), body).position.x() < -0.49);
}

TEST_CASE("nothing falls through a block of tiles, however deep it is put") {
  for (const double depth : {0.0, 0.1, 0.3, 0.6}) {
    for (const double x : {0.0, 0.5, 0.02}) {  // over a tile, over a seam, and beside one
      for (const Shape<double>& shape :
           {Shape<double>(box(0.02, 0.4)), Shape<double>(box(0.4, 0.02)), Shape<double>(circle(0.2)),
            Shape<double>(polygon({{0, -0.3}, {0.05, 0.3}, {-0.05, 0.3}}))}) {
        CAPTURE(depth);
        CAPTURE(x);
        CAPTURE(shape_name(shape));
        Scene scene({.dt = 1.0 / 120});
        for (int i = 0; i < 7; ++i) {
          for (int k = 0; k < 2; ++k) scene.add(still(moved(box(1, 1), {i - 3.0, -0.5 - k})));
        }
        const BodyId body = scene.add({.shapes = {shape},
                                       .position = {x, 0.2 - depth},
                                       .material = {.friction = 0.5},
                                       .fixed_rotation = true});
        CHECK(pose_of(world_after(scene, 240), body).position.y() > -0.6);
      }
    }
  }
}

}  // namespace cairn
