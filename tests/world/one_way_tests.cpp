// Bodies that hold off only what comes from one side.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double g = 10;           // [m/s^2]
const double top = 2;          // [m] of the platform
const double thickness = 0.4;  // [m] of it

/// A platform 4 m wide on the ground's scene, and bodies that are thrown through it.
struct Platform {
  explicit Platform(const SceneSettings& settings = {}, const Vec2<double>& one_way = {0, 1},
                    BodyType type = BodyType::static_body)
      : scene(settings) {
    scene.add_ground();
    shelf = scene.add({.type = type,
                       .shapes = {box(4, thickness)},
                       .position = {0, top - thickness / 2},
                       .filter = {.one_way = one_way}});
  }
  BodyId throw_up(const Shape<double>& shape, double half_height, double speed, double x = 0,
                  double turning = 0) {
    return scene.add({.shapes = {shape},
                      .position = {x, half_height},
                      .velocity = {0, speed},
                      .angular_velocity = turning});
  }

  Scene scene;
  BodyId shelf;
};

/// The same without the platform.
Scene without_shelf(Platform platform) {
  platform.scene.remove(platform.shelf);
  return platform.scene;
}

List<SceneSettings> step_settings() {
  return {{},
          {.substeps = 4},
          {.substeps = 4, .contact_search = ContactSearch::every_step},
          {.contact_search = ContactSearch::when_moved},
          {.sleeping = Sleeping{}}};
}

}  // namespace

TEST_CASE("what comes from below passes as if nothing were there, and what comes down lands") {
  for (const SceneSettings& settings : step_settings()) {
    Platform platform(settings);
    const BodyId ball = platform.throw_up(circle(0.3), 0.3, 9);
    const BodyId crate = platform.throw_up(box(0.6, 0.6), 0.3, 9, 1.2);
    World<double> world(platform.scene), free(without_shelf(platform));
    CHECK(go_on_alike(world, free, 60));  // up to 4.35 m, and on the way back
    CHECK(pose_of(world, ball).position.y() > top + 0.3);
    take_steps(world, 200);
    // Where it rests it may sink in by the slop, 5 mm.
    CHECK(std::abs(pose_of(world, ball).position.y() - (top + 0.3)) <= 0.006);
    CHECK(std::abs(pose_of(world, crate).position.y() - (top + 0.3)) <= 0.006);
    CHECK(std::abs(pose_of(world, crate).angle) <= 0.006 / 0.6);
  }
}

TEST_CASE("marbles and boulders pass and land as what is a metre long") {
  for (const double scale : {1e-3, 1e-2, 1e2, 1e3}) {
    CAPTURE(scale);
    const double root = std::sqrt(scale);  // times and speeds go with it under the same gravity
    Scene scene({.dt = root / 60});
    scene.add({.type = BodyType::static_body,
               .shapes = {box(4 * scale, thickness * scale)},
               .position = {0, (top - thickness / 2) * scale},
               .filter = {.one_way = {0, scale}}});
    const BodyId ball = scene.add({.shapes = {circle(0.3 * scale)}, .velocity = {0, 9 * root}});
    const BodyId crate = scene.add({.shapes = {box(0.6 * scale, 0.6 * scale)},
                                    .position = {scale, 0},
                                    .velocity = {0, 9 * root},
                                    .density = 100});
    World<double> world = world_after(scene, 55);
    const double height = 9 * 55 / 60.0 - g * 55 * 56 / 7200.0;  // v t - g dt^2 n (n + 1) / 2
    CHECK(pose_of(world, ball).position.y() == doctest::Approx(height * scale).epsilon(1e-11));
    take_steps(world, 200);
    for (const BodyId body : {ball, crate})
      CHECK(std::abs(pose_of(world, body).position.y() / scale - (top + 0.3)) <= 0.011);
  }
}

TEST_CASE("a body that turns round halfway through falls back as it came") {
  for (const SceneSettings& settings : step_settings()) {
    // Its centre comes up to top - thickness / 2: v^2 = 2 g h; and a box that turns on its way.
    Platform platform(settings);
    platform.throw_up(circle(0.3), 0.3, std::sqrt(2 * g * (top - thickness / 2 - 0.3)));
    platform.throw_up(box(0.7, 0.5), 0.5, std::sqrt(2 * g * (top - 0.5)), 1.4, 3);
    World<double> world(platform.scene), free(without_shelf(platform));
    CHECK(go_on_alike(world, free, 70));
  }
}

TEST_CASE("what lies on it presses it as it would any platform, however deep, after edits too") {
  const auto pressed = [](const Vec2<double>& one_way) {
    Platform platform({}, one_way);
    for (int i = 0; i < 3; ++i) {
      platform.scene.add(
          {.shapes = {box(1, 1)}, .position = {0, top + 0.5 + i}, .density = i == 2 ? 20.0 : 1});
    }
    return World<double>(platform.scene);
  };
  World<double> world = pressed({0, 1}), usual = pressed({0, 0});
  SequentialImpulse<double> few({.iterations = 2});  // which lets it sink in
  double deepest = 0;
  for (int i = 0; i < 300; ++i) {
    if (i % 50 == 0) world.edit([](Scene&) {});
    world.step(few);
    usual.step(few);
    deepest = std::max(deepest, top + 0.5 - pose_of(world, {2}).position.y());
  }
  CHECK(go_alike(world, usual));
  CHECK(deepest > 0.0051);  // more than the slop, up to which it would be taken in anew
}

TEST_CASE("worlds that were copied or edited while a body passes go on alike") {
  Platform platform;
  platform.throw_up(circle(0.3), 0.3, std::sqrt(2 * g * (top - 0.4)));
  World<double> world = world_after(platform.scene, 22);
  World<double> copy = world, edited = world;
  edited.edit([](Scene&) {});
  CHECK(go_on_alike(world, copy, 1));
  take_steps(edited, 1);
  CHECK(go_alike(world, edited));
  CHECK(go_on_alike(world, edited, 80));
}

TEST_CASE("a step that is not done leaves who passes as it was") {
  class Stops final : public SolveObserver<double> {
   public:
    void before_solve(const VelocityProblem<double>&) override {
      if (++solves == 5) throw std::runtime_error("enough");
    }
    int solves = 0;
  };
  Platform platform({.dt = 0.2, .substeps = 8});
  platform.throw_up(circle(0.3), 0.3, std::sqrt(2 * g * (top - 0.5)));
  World<double> world(platform.scene), free(without_shelf(platform));
  SequentialImpulse<double> solver({.iterations = 10});
  for (int i = 0; i < 5; ++i) {
    Stops stops;
    CHECK_THROWS_AS(world.step(solver, &stops), std::runtime_error);
    CHECK(go_on_alike(world, free, 1));
  }
}

TEST_CASE("what comes from the side or begins within passes, and the direction turns with the body") {
  Platform platform({.gravity = {0, 0}});
  const BodyId aside =
      platform.scene.add({.shapes = {circle(0.3)}, .position = {-4, top - 0.1}, .velocity = {2, 0}});
  const BodyId within = platform.scene.add({.shapes = {circle(0.3)}, .position = {1, top - 0.2}});
  World<double> world = world_after(platform.scene, 120);
  CHECK(pose_of(world, aside).position.x() == doctest::Approx(0).epsilon(1e-12));
  CHECK(pose_of(world, within).position == Vec2<double>(1, top - 0.2));

  // A door in a wall that opens to the right: [0, 1] of a body that is turned by -90 degrees.
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body,
             .shapes = {box(4, 0.2)},
             .angle = -pi / 2,
             .filter = {.one_way = {0, 3}}});
  const BodyId from_left = scene.add({.shapes = {circle(0.3)}, .position = {-2, 1}, .velocity = {3, 0}});
  const BodyId from_right = scene.add({.shapes = {circle(0.3)}, .position = {2, -1}, .velocity = {-3, 0}});
  const World<double> door = world_after(scene, 120);
  CHECK(pose_of(door, from_left).position.x() == doctest::Approx(4).epsilon(1e-12));
  CHECK(pose_of(door, from_right).position.x() == doctest::Approx(0.4).epsilon(1e-3));
}

TEST_CASE("a box slides from a floor onto one-way tiles that are flush with it") {
  Scene scene;
  scene.add({.type = BodyType::static_body,
             .shapes = {box(4, 1)},
             .position = {-2, -0.5},
             .material = {.friction = 0}});
  for (int i = 0; i < 6; ++i) {
    scene.add({.type = BodyType::static_body,
               .shapes = {box(1, 0.3)},
               .position = {0.5 + i, -0.15},
               .material = {.friction = 0},
               .filter = {.one_way = {0, 1}}});
  }
  const BodyId sled = scene.add({.shapes = {box(0.8, 0.5)}, .position = {-2, 0.25}, .velocity = {3, 0}});
  const World<double> world = world_after(scene, 120);
  CHECK(pose_of(world, sled).position.x() == doctest::Approx(4).epsilon(1e-2));
  CHECK(pose_of(world, sled).position.y() > 0.24);
  CHECK(std::abs(pose_of(world, sled).angle) < 1e-3);
}

TEST_CASE("what falls fast is held, whatever the step; what flies up fast passes within one") {
  for (const double speed : {10.0, 100.0, 1000.0}) {
    Platform platform({.gravity = {0, 0}});
    const BodyId down =
        platform.scene.add({.shapes = {circle(0.1)}, .position = {-1, 50}, .velocity = {0, -speed}});
    const BodyId up =
        platform.scene.add({.shapes = {circle(0.1)}, .position = {1, 0.2}, .velocity = {0, speed}});
    World<double> world(platform.scene);
    World<float> coarse(platform.scene);
    take_steps(world, 400);
    take_steps(coarse, 400);
    CHECK(pose_of(world, down).position.y() >= top + 0.09);
    CHECK(pose_of(coarse, down).position.y() >= top + 0.09);
    CHECK(pose_of(world, up).position.y() == doctest::Approx(0.2 + speed * 400 / 60).epsilon(1e-12));
  }
}

TEST_CASE("a one-way lift carries up what lies on it, and passes what hangs in its way") {
  Platform platform({}, {0, 1}, BodyType::kinematic);
  const BodyId crate = platform.scene.add({.shapes = {box(0.6, 0.6)}, .position = {-1, top + 0.3}});
  const BodyId lamp = platform.scene.add({.type = BodyType::dynamic,
                                          .shapes = {circle(0.2)},
                                          .position = {1, 3},
                                          .mass = 1,
                                          .gravity_scale = 0});
  const BodyId below =
      platform.scene.add({.shapes = {circle(0.2)}, .position = {1, 1}, .mass = 1, .gravity_scale = 0});
  platform.scene.change(platform.shelf, [&] {
    BodySpec spec = platform.scene.bodies()[platform.shelf].spec;
    spec.velocity = {0, -1};
    return spec;
  }());
  World<double> world = world_after(platform.scene, 60);  // down by 1 m: past what hangs below
  CHECK(pose_of(world, below).position == Vec2<double>(1, 1));
  CHECK(std::abs(pose_of(world, crate).position.y() - (top - 1 + 0.3)) <= 0.01);
  world.set_velocity(platform.shelf, {0, 1, 0});
  take_steps(world, 30);
  CHECK(std::abs(pose_of(world, crate).position.y() - (top - 0.5 + 0.3)) <= 0.01);
  CHECK(pose_of(world, lamp).position == Vec2<double>(1, 3));
}

TEST_CASE("passing is no overlap, and a scene without it plans nothing for it") {
  Platform platform;
  platform.throw_up(circle(0.3), 0.3, 9);
  World<double> world(platform.scene);
  double deepest = 0;
  for (int i = 0; i < 100; ++i) {
    take_steps(world, 1);
    deepest = std::max(deepest, worst_penetration(snapshot(world)));
  }
  CHECK(deepest < 0.01);
  CHECK(make_plan(platform.scene).extras.one_way);
  CHECK_FALSE(make_plan(without_shelf(platform)).extras.one_way);
  CHECK_THROWS_AS(platform.scene.add({.shapes = {circle(1)},
                                      .filter = {.one_way = {std::numeric_limits<double>::infinity(), 0}}}),
                  std::invalid_argument);
}
