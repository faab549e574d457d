// Scenes of all sizes behave alike: what was not said follows from the bodies, and is scaled as they are.
#include "testing.hpp"
#include <cairn/world/scene_length.hpp>

using namespace cairn;

namespace {

/// By how much lengths and times are longer than usual: powers of two, so that no number is rounded.
struct Scale {
  double length = 1;
  double time = 1;

  SceneSettings settings(const Vec2<double>& gravity) const {
    return {.gravity = gravity * (length / (time * time)), .dt = time / 60};
  }
  Vec2<double> at(double x, double y) const { return {x * length, y * length}; }
  Vec2<double> speed(double x, double y) const { return at(x, y) / time; }
};

/// A pyramid on which a box falls askew.
Scene scaled_boxes(const Scale& scale) {
  Scene scene(scale.settings({0, -10}));
  scene.add_ground({.half_width = 50 * scale.length, .thickness = scale.length});
  const SharedList<Shape<double>> square = {box(scale.length, scale.length)};
  for (int row = 0; row < 4; ++row) {
    for (int i = 0; i < 4 - row; ++i)
      scene.add({.shapes = square, .position = scale.at(1.0625 * i + 0.53125 * row, 0.5 + row)});
  }
  scene.add({.shapes = square,
             .position = scale.at(1.25, 6),
             .angle = 0.5,
             .velocity = scale.speed(0.5, -3),
             .angular_velocity = 1 / scale.time});
  return scene;
}

/// Links on pins, with a ball on a rope at their end, let go level over the ground.
Scene scaled_chain(const Scale& scale) {
  Scene scene(scale.settings({0, -10}));
  scene.add_ground({.height = -3 * scale.length, .half_width = 50 * scale.length, .thickness = scale.length});
  BodyId last = ground;
  for (int i = 0; i < 8; ++i) {
    const BodyId link =
        scene.add({.shapes = {box(scale.length, scale.length / 2)}, .position = scale.at(i + 0.5, 0)});
    scene.join<RevoluteJoint>({.a = last, .b = link, .anchor = scale.at(i, 0)});
    last = link;
  }
  const BodyId ball = scene.add({.shapes = {circle(scale.length / 2)}, .position = scale.at(9, 0)});
  scene.join<DistanceJoint>({.a = last,
                             .b = ball,
                             .anchor_a = scale.at(8, 0),
                             .anchor_b = scale.at(9, 0),
                             .kind = DistanceJoint::Kind::rope,
                             .slack_margin = scale.length / 2});
  return scene;
}

/// A ball that bounces over the ground, between walls.
Scene scaled_ball(const Scale& scale) {
  Scene scene(scale.settings({0, -10}));
  scene.add_ground({.half_width = 50 * scale.length, .thickness = scale.length});
  for (const double x : {-2.0, 2.0})
    scene.add({.type = BodyType::static_body,
               .shapes = {box(scale.length, 8 * scale.length)},
               .position = scale.at(x, 4)});
  scene.add({.shapes = {circle(scale.length / 2)},
             .position = scale.at(0, 2),
             .velocity = scale.speed(1.5, 0),
             .material = {.restitution = 0.75}});
  return scene;
}

/// Of a run of two of its seconds.
template <typename Solver>
PerBody<Pose<double>> poses_after(Scene (*make)(const Scale&), const Scale& scale) {
  World<double> world(make(scale));
  Solver solver({.iterations = 10});
  take_steps(world, solver, 120);
  return world.bodies().pose;
}

template <typename Solver>
void require_same(Scene (*make)(const Scale&), const Scale& scale) {
  CAPTURE(scale.length);
  CAPTURE(scale.time);
  const PerBody<Pose<double>> usual = poses_after<Solver>(make, {}),
                              scaled = poses_after<Solver>(make, scale);
  for (const BodyId body : usual.indices()) {
    REQUIRE(scaled[body].position == usual[body].position * scale.length);
    REQUIRE(scaled[body].angle == usual[body].angle);
  }
}

template <typename Solver>
void require_same_at_all_sizes(Scene (*make)(const Scale&)) {
  for (int k = -10; k <= 10; ++k) {
    require_same<Solver>(make, {.length = std::ldexp(1.0, k)});  // gravity as the lengths
    if (k % 2 == 0)
      require_same<Solver>(make, {.length = std::ldexp(1.0, k), .time = std::ldexp(1.0, k / 2)});
  }
}

}  // namespace

TEST_CASE("boxes of 1 mm to 1 km have the same bits, scaled") {
  require_same_at_all_sizes<SequentialImpulse<double>>(scaled_boxes);
  require_same_at_all_sizes<WideSequentialImpulse<double>>(scaled_boxes);
}

TEST_CASE("a chain and a rope of links of 1 mm to 1 km have the same bits, scaled") {
  require_same_at_all_sizes<SequentialImpulse<double>>(scaled_chain);
  require_same_at_all_sizes<BlockSequentialImpulse<double>>(scaled_chain);
}

TEST_CASE("a ball of 1 mm to 1 km bounces by the same bits, scaled") {
  require_same_at_all_sizes<SequentialImpulse<double>>(scaled_ball);
}

TEST_CASE("the length of a scene is the median root of the areas of what can move, as a power of two") {
  const auto length_of = [](const List<double>& sides) {
    Scene scene;
    scene.add_ground();
    for (const double side : sides) scene.add({.shapes = {box(side, side)}});
    return scene_length(scene);
  };
  CHECK(length_of({}) == 1);
  CHECK(length_of({1}) == 1);
  CHECK(length_of({0.71}) == 1);
  CHECK(length_of({0.7}) == 0.5);
  CHECK(length_of({1.41}) == 1);
  CHECK(length_of({1.42}) == 2);
  CHECK(length_of({0.01, 1, 1000}) == 1);
  CHECK(length_of({0.01, 0.01, 1, 1000}) == 0.0078125);
  Scene discs;
  discs.add({.shapes = {circle(0.5)}});  // sqrt(pi) / 2 = 0.89
  CHECK(scene_length(discs) == 1);
}

TEST_CASE("bodies of 1 m have the lengths that are written at the settings; what is stated stays") {
  Scene scene;
  scene.add({.shapes = {box(1, 1)}});
  SceneSettings full = full_settings(scene);
  CHECK(full.speculative_margin == 0.02);
  CHECK(full.restitution_threshold == 0.5);
  CHECK(full.stabilization.slop == 0.005);
  CHECK(full.stabilization.max_speed == 4);
  scene.set_settings({.gravity = {0, 0}, .stabilization = {.slop = 0.25}, .speculative_margin = 0.125});
  full = full_settings(scene);
  CHECK(full.speculative_margin == 0.125);
  CHECK(full.stabilization.slop == 0.25);
  CHECK(full.restitution_threshold == 0);
}

TEST_CASE("what falls in 24 substeps is the unit of length of smaller bodies") {
  Scene marble;
  marble.add({.shapes = {circle(0.004)}});
  CHECK(unit_length(marble) == doctest::Approx(300 * 10.0 / 3600).epsilon(1e-12));
  marble.set_settings({.dt = 1.0 / 4096});
  CHECK(unit_length(marble) == 0.0078125);
  marble.set_settings({.gravity = {0, 0}});
  CHECK(unit_length(marble) == 0.0078125);
}

TEST_CASE("an elastic ball that nothing pulls is not stopped by a wall, however slow it is") {
  for (const double speed : {0.4, 1e-3, 1e-6}) {
    Scene scene({.gravity = {0, 0}});
    scene.add({.type = BodyType::static_body, .shapes = {box(1, 3)}, .position = {2, 0}});
    scene.add({.shapes = {circle(0.5)},
               .position = {0.99, 0},
               .velocity = {speed, 0},
               .material = {.restitution = 1}});
    World<double> world(scene);
    world.set_dt(0.001 / speed);  // a millimetre a step
    take_steps(world, 20);
    CHECK(world.bodies().velocity[{2}].x() == doctest::Approx(-speed).epsilon(1e-12));
  }
}
