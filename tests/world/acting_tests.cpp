// Fields, forces and paths: what closed forms (cairn validate, B50 to B54) do not ask.
#include "geometry/random_shapes.hpp"
#include <cairn/measure/energy.hpp>
#include <cairn/world/scene_snapshot.hpp>
#include "sleeping_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A box in a sea of the density 1 that tugs, wind and a star act on; a shuttle carries another.
Scene everything() {
  Scene scene({.fields = {.wind = {3, 0},
                          .water = Water{.level = 0, .density = 1, .drag = 2, .flow = {0.5, 0}},
                          .attractions = {{.point = {20, 5}, .strength = 30, .radius = 1}}},
               .substeps = 3});
  const BodyId boat = scene.add({.shapes = {box(2, 0.6)}, .density = 0.4, .damping = {.quadratic = 0.1}});
  scene.add(
      {.time = 0.1, .action = ApplyForce{.body = boat, .force = {0, 1}, .point = {1, 0}, .seconds = 0.35}});
  const BodyId shuttle =
      scene.add({.type = BodyType::kinematic, .shapes = {box(3, 0.4)}, .position = {8, 1}});
  scene.add({.shapes = {box(0.5, 0.5)}, .position = {8, 1.45}});
  scene.add({.time = 0.2,
             .action = FollowPath{
                 .body = shuttle, .points = {{8, 1}, {9, 1}, {9, 2}}, .speed = 2, .kind = PathKind::round}});
  return scene;
}

}  // namespace

TEST_CASE("the force of a field is what its potential energy loses on the way, however a body stands") {
  test::Random random(3);
  for (int trial = 0; trial < 40; ++trial) {
    Scene scene({.fields = {.water = Water{.density = 2},
                            .attractions = {{.point = {0.4, -2}, .strength = 7, .radius = 1}},
                            .gravitation = 3},
                 .dt = 1e-6});
    const Shape<double> shape = test::random_shape(trial % 4, random);
    const BodyId body =
        scene.add({.shapes = {shape}, .position = random.point(0.4), .angle = random.uniform(-pi, pi)});
    scene.add({.shapes = {circle(0.2)}, .position = {6, 1}, .mass = 5});
    const World<double> world = world_after(scene, 1);
    const SceneBody& it = scene.bodies()[body];
    // The first step of leapfrog has half of a kick.
    const Vec3<double> force =
        velocity_of(world, body).cwiseProduct(Vec3<double>(it.mass, it.mass, it.inertia)) / 0.5e-6;
    const double h = 1e-5;
    for (int k = 0; k < 3; ++k) {
      const auto energy = [&](double side) {
        Scene moved = scene;
        const Vec2<double> offset(k == 0 ? side : 0, k == 1 ? side : 0);
        displace(moved, body, offset, k == 2 ? side : 0);
        return potential_energy(snapshot(moved));
      };
      CAPTURE(trial);
      CAPTURE(k);
      // Central differences are off by h^2 of third derivatives, below 1e3, and by rounding over h.
      CHECK(std::abs(force[k] + (energy(h) - energy(-h)) / (2 * h)) < 1e-6);
    }
  }
}

TEST_CASE(
    "a world with fields, forces and paths is a value: copies, edits and failed steps have the same bits") {
  const Scene scene = everything();
  World<double> one(scene);
  take_steps(one, 40);
  World<double> other = one;
  other.edit([](Scene&) {});
  take_steps(one, 40);
  take_steps(other, 40);
  CHECK(same_motion(one, other));

  struct Thrower : SolveObserver<double> {
    void after_sweep(int, const VelocityProblem<double>&) override { throw std::runtime_error("no"); }
  };
  World<double> tried(scene);
  take_steps(tried, 17);
  const PerBody<Vec3<double>> before = tried.bodies().velocity;
  SequentialImpulse<double> solver({.iterations = 10});
  Thrower thrower;
  CHECK_THROWS_AS(tried.step(solver, &thrower), std::runtime_error);
  CHECK(tried.bodies().velocity == before);
  take_steps(tried, 63);
  CHECK(same_motion(one, tried));
}

TEST_CASE("in single precision fields act alike, to its rounding") {
  const World<double> fine = world_after(everything(), 60);
  const World<float> coarse = world_after<float>(everything(), 60);
  for (const BodyId body : fine.bodies().pose.indices()) {
    // 60 steps of 3 substeps, each of which rounds numbers below 10 some ten times.
    CHECK((pose_of(fine, body).position - pose_of(coarse, body).position.cast<double>()).norm() < 1e-4);
  }
}

TEST_CASE("a force wakes what sleeps when it begins, and a shuttle that sets off what stands on it") {
  Scene scene({.sleeping = usual_sleeping});
  scene.add_ground();
  const BodyId pushed = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 1});
  const BodyId shuttle =
      scene.add({.type = BodyType::kinematic, .shapes = {box(2, 0.2)}, .position = {5, 2}});
  const BodyId carried = scene.add({.shapes = {box(1, 1)}, .position = {5, 2.6}});
  scene.add({.time = 2, .action = ApplyForce{.body = pushed, .force = {20, 0}}});
  scene.add({.time = 2, .action = FollowPath{.body = shuttle, .points = {{5, 2}, {9, 2}}, .speed = 1}});
  World<double> world(scene);
  take_steps(world, 119);
  CHECK_FALSE(world.is_awake(pushed));
  CHECK_FALSE(world.is_awake(carried));
  take_steps(world, 61);
  CHECK(world.is_awake(pushed));
  // 20 N against friction of 6 N for a second: 14 t (t + dt)/2.
  CHECK(pose_of(world, pushed).position.x() == doctest::Approx(14 * (1 + 1.0 / 60) / 2).epsilon(0.02));
  CHECK(pose_of(world, shuttle).position.x() == doctest::Approx(6).epsilon(0.02));
  CHECK(velocity_of(world, carried).x() == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("what nothing holds does not fall asleep in a field, however weak it is") {
  for (const Fields& fields :
       {Fields{.attractions = {{.point = {9, 0}, .strength = 1e-3}}}, Fields{.gravitation = 1e-3},
        Fields{.water = Water{.drag = 1, .flow = {1e-4, 0}}}}) {
    Scene scene({.gravity = {0, 0}, .fields = fields, .sleeping = usual_sleeping});
    const BodyId one = scene.add({.shapes = {circle(0.5)}, .position = {0, -2}});
    scene.add({.shapes = {circle(0.5)}, .position = {5, -2}});
    World<double> world(scene);
    take_steps(world, 240);
    CHECK(world.is_awake(one));
    CHECK(velocity_of(world, one).x() > 0);
  }
}

TEST_CASE("drag never turns a velocity around, however strong it is, at every size and mass") {
  for (const double size : {1e-3, 1.0, 1e3}) {
    for (const double density : {1.0, 1e3}) {
      Scene scene({.gravity = {0, 0}, .fields = {.water = Water{.density = 1e3, .drag = 1e9}}});
      const BodyId body = scene.add({.shapes = {box(size, size / 3)},
                                     .position = {0, 0.1 * size},
                                     .angle = 0.4,
                                     .velocity = {3 * size, -2 * size},
                                     .angular_velocity = 5,
                                     .density = density,
                                     .damping = {.quadratic = 1e9 * size}});
      const double before = kinetic_energy(snapshot(scene));
      const World<double> world = world_after(scene, 1);
      const Snapshot now = snapshot(world);
      CHECK(kinetic_energy(now) < before);
      CHECK(velocity_of(world, body).x() >= -1e-3 * size);
      CHECK(velocity_of(world, body).y() <= 1e-3 * size);
    }
  }
}

TEST_CASE("a path goes to its end, to and fro, or round") {
  const auto place = [](PathKind kind, double seconds) {
    return FollowPath{.body = {1}, .points = {{0, 0}, {3, 0}, {3, 4}}, .speed = 2, .kind = kind}.place(
        seconds);
  };
  for (const PathKind kind : {PathKind::once, PathKind::to_and_fro, PathKind::round}) {
    CHECK(place(kind, -1) == Vec2<double>(0, 0));
    CHECK(place(kind, 1) == Vec2<double>(2, 0));
    CHECK(place(kind, 2.5) == Vec2<double>(3, 2));
  }
  CHECK(place(PathKind::once, 100) == Vec2<double>(3, 4));
  CHECK(place(PathKind::to_and_fro, 4) == Vec2<double>(3, 3));    // 8 m, of which one back
  CHECK(place(PathKind::to_and_fro, 7.5) == Vec2<double>(1, 0));  // 15 m of a round of 14
  CHECK((place(PathKind::round, 6) - Vec2<double>(0, 0)).norm() < 1e-14);
  CHECK((place(PathKind::round, 4.75) - Vec2<double>(1.5, 2)).norm() < 1e-14);
}

TEST_CASE("what cannot be pushed or led is refused, with its field") {
  Scene scene;
  const BodyId box_id = scene.add({.shapes = {box(1, 1)}}), lift = scene.add({.type = BodyType::kinematic});
  const auto refusal = [&](const SceneAction& action) -> std::string {
    try {
      scene.add({.time = 0, .action = action});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(ApplyForce{.body = lift}).find("body must be a dynamic one") != std::string::npos);
  CHECK(refusal(ApplyForce{.body = box_id, .force = {nan, 0}}).find("force must be") != std::string::npos);
  CHECK(refusal(ApplyForce{.body = box_id, .seconds = 0}).find("seconds must be > 0 s") != std::string::npos);
  CHECK(
      refusal(FollowPath{.body = box_id, .points = {{0, 0}, {1, 0}}}).find("body must be a kinematic one") !=
      std::string::npos);
  CHECK(refusal(FollowPath{.body = lift, .points = {{0, 0}}}).find("points must be two or more") !=
        std::string::npos);
  CHECK(refusal(FollowPath{.body = lift, .points = {{1, 0}, {1, 0}}}).find("points must be some way apart") !=
        std::string::npos);
  CHECK(refusal(FollowPath{.body = lift, .points = {{0, 0}, {1, 0}}, .speed = 0})
            .find("speed must be > 0 m/s") != std::string::npos);
  CHECK(scene.events().empty());
  CHECK_THROWS_AS(Scene({.fields = {.gravitation = -1}}), std::invalid_argument);
  CHECK_THROWS_AS(Scene({.fields = {.water = Water{.density = 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(Scene({.fields = {.wind = {nan, 0}}}), std::invalid_argument);
}

TEST_CASE(
    "what lasts stays among the events until its body is gone, and events of an instant come when they are "
    "due") {
  Scene scene;
  const BodyId body = scene.add({.shapes = {box(1, 1)}});
  scene.add({.time = 0, .action = ApplyForce{.body = body, .force = {1, 0}}});
  scene.add({.time = 0.5, .action = PushBody{.body = body, .impulse = {0, 3}}});
  World<double> world(scene);
  take_steps(world, 60);
  CHECK(world.scene().events().size() == 1);
  CHECK(velocity_of(world, body).y() == doctest::Approx(3 - 10));
  world.edit([body](Scene& edited) { edited.remove(body); });
  CHECK(world.scene().events().empty());
}

TEST_CASE("a scene without fields, forces and paths has nothing of them") {
  Scene scene;
  scene.add({.shapes = {box(1, 1)}});
  CHECK_FALSE(Acting<double>::is_needed(scene));
  CHECK(make_plan(scene).size.acting.empty());
  CHECK(explain(make_plan(scene)).find("also") == std::string::npos);
  CHECK(explain(make_plan(everything()))
            .find("also          1 force, 1 attraction, water, 1 body with drag in the air, 1 path") !=
        std::string::npos);
}

TEST_CASE("a snapshot has the ways of what is led, back to the first point where one goes round") {
  const Snapshot now = snapshot(everything());
  REQUIRE(now.paths.size() == 1);
  CHECK(now.paths[0].points == List<Vec2<double>>{{8, 1}, {9, 1}, {9, 2}, {8, 1}});
  CHECK(snapshot(world_after(everything(), 3)).paths[0].points == now.paths[0].points);
}
