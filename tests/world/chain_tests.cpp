// Chains: one side, smooth corners, ends that go on, and bodies that carry them.
#include "world/grounds.hpp"

namespace cairn {
namespace {

using namespace seams;
using namespace testing;

constexpr double bowl_radius = 5;  // [m]

/// An arc of `corners` equal turns, from `angle` [rad] left of its lowest point to there, and level beyond.
List<Vec2<double>> bowl_points(int corners, double angle) {
  List<Vec2<double>> points;
  for (int i = 0; i <= corners; ++i) {
    const double at = angle * (1 - i / static_cast<double>(corners));
    points.push_back({-bowl_radius * std::sin(at), bowl_radius * (1 - std::cos(at))});
  }
  points.push_back({30, 0});
  return points;
}

/// The speed on the level over sqrt(2 g h), of a body that slides down a bowl from its edge.
double kept_speed(Making making, int rate, int corners, const NamedPolicy& policy, Solver<double>& solver) {
  const double angle = 0.8, radius = 0.2, gravity = 10;
  Scene scene(seam_settings(policy, rate));
  add_track(scene, making, bowl_points(corners, angle));
  const Vec2<double> along(std::cos(angle), -std::sin(angle));
  const Vec2<double> start = bowl_points(corners, angle)[0] + 0.05 * along + radius * perpendicular(along);
  const BodyId body = scene.add({.shapes = {circle(radius)}, .position = start, .material = {.friction = 0}});
  World<double> world(scene);
  for (int i = 0; i < 3 * rate / 2; ++i) world.step(solver);
  CHECK(world.bodies().pose[body].position.x() > 0);
  return world.bodies().velocity[body].x() / std::sqrt(2 * gravity * (start.y() - radius));
}

/// [m] Over the nearest link of a line, on the right hand of who walks along it; negative on the left hand.
double height_over(const List<Vec2<double>>& line, const Vec2<double>& point) {
  double height = 0, nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i + 1 < line.size(); ++i) {
    const Vec2<double> way = (line[i + 1] - line[i]).normalized(), arm = point - line[i];
    const double along = std::clamp(way.dot(arm), 0.0, (line[i + 1] - line[i]).norm());
    const double distance = (arm - along * way).norm();
    if (distance < nearest) nearest = distance, height = -cross<double>(way, arm);
  }
  return height;
}

/// At a chain, at 20 m/s towards its corner at the origin.
Scene shot_at(const Shape<double>& shape, const Shape<double>& target, const Vec2<double>& from) {
  Scene scene;
  scene.add(still(target, 0.3));
  scene.add({.shapes = {shape}, .position = from, .velocity = -20 * from.normalized()});
  return scene;
}

}  // namespace

TEST_CASE("a disc that slides down a bowl of links keeps its energy but for its corners and its steps") {
  // At a corner of d rad the speed across the next link goes: a share of 1 - cos(d). All corners together,
  // taken at the final speed, take angle^2 / (2 corners) of it; and as a step goes straight as well, all
  // steps on the bowl take angle^2 / (2 steps). It takes more than a quarter of a swing, (pi / 2) sqrt(R /
  // g).
  const double angle = 0.8, quarter = pi / 2 * std::sqrt(bowl_radius / 10);
  for (const Making making : {Making::segments, Making::chain}) {
    for (const NamedPolicy& policy : seam_policies()) {
      for (const NamedSolver& named : seam_solvers()) {
        if (making == Making::segments && named.name != "si") continue;
        for (const int rate : {60, 240}) {
          const int corners = rate / 4;
          CAPTURE(name_of(making));
          CAPTURE(policy.name);
          CAPTURE(named.name);
          CAPTURE(rate);
          const double kept = kept_speed(making, rate, corners, policy, *named.solver);
          CHECK(kept > 1 - angle * angle / 2 * (1.0 / corners + 1 / (quarter * rate)));
          CHECK(kept < 1);
        }
      }
    }
  }
}

TEST_CASE("the finer the bowl and the steps, the less a disc loses in it: as one over their number") {
  SequentialImpulse<double> solver;
  const double coarse = 1 - kept_speed(Making::chain, 960, 15, {}, solver);
  const double fine = 1 - kept_speed(Making::chain, 3840, 60, {}, solver);
  CHECK(coarse / fine == doctest::Approx(4).epsilon(0.15));
}

TEST_CASE("nothing falls through a chain at 20 m/s, neither on a link nor in a corner nor at a point") {
  struct Target {
    List<Vec2<double>> line = {};
    List<double> starts = {};  // [m] to the left and right of the corner, 4 m above it, on the free side
  };
  const List<Target> targets = {{{{9, 0}, {0, 0}, {-9, 0}}, {-1, -0.1, 0, 0.3}},    // level
                                {{{9, 9}, {0, 0}, {-9, 9}}, {-1, -0.1, 0, 0.3}},    // a valley
                                {{{9, 2}, {0, 0}, {-9, 2}}, {-1, -0.1, 0, 0.3}},    // a wide one
                                {{{9, -9}, {0, 0}, {-9, -9}}, {-1, -0.1, 0, 0.3}},  // a ridge
                                {{{2, 9}, {0, 0}, {-2, 9}}, {-0.2, 0, 0.1}},        // a cleft
                                {{{0, 9}, {0, 0}, {-9, 0}}, {-3, -1, -0.6}}};       // a wall on the right
  const List<Shape<double>> bodies = {box(0.5, 0.5), box(1, 0.02), circle(0.1),
                                      capsule({-0.2, 0}, {0.2, 0}, 0.1)};
  for (const Target& target : targets) {
    for (const Shape<double>& body : bodies) {
      for (const double start : target.starts) {
        World<double> world = world_after(shot_at(body, chain(target.line), {start, 4}), 60);
        const Vec2<double> place = world.bodies().pose[{2}].position;
        CAPTURE(target.line[0].x());
        CAPTURE(target.line[0].y());
        CAPTURE(shape_name(body));
        CAPTURE(start);
        CHECK(height_over(target.line, place) > 0);
      }
    }
  }
}

TEST_CASE("what comes from the solid side of a chain goes through it, and stands on it when it comes back") {
  Scene scene;
  scene.add(still(chain({{2, 0}, {0, 0}, {-2, 0}})));
  const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = {0.5, -1}, .velocity = {0, 6}});
  World<double> world(scene);
  SequentialImpulse<double> solver;
  double highest = -1;
  for (int i = 0; i < 180; ++i) {
    world.step(solver);
    highest = std::max(highest, world.bodies().pose[ball].position.y());
  }
  // It rises to v^2 / (2 g) = 1.8 m over its start, less half a step's g dt v = 0.05 m; a little more where
  // the chain takes hold of it as it passes: 5 percent of its size.
  CHECK(highest > 0.7);
  CHECK(highest < 0.85);
  CHECK(world.bodies().pose[ball].position.y() == doctest::Approx(0.1).epsilon(0.06));
}

TEST_CASE("a room is a closed chain that runs clockwise, a block one that runs counter-clockwise") {
  const List<Vec2<double>> room = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
  Scene inside({.gravity = {0, -10}});
  inside.add(still(chain(room, {.closed = true}), 0.3));
  for (int i = 0; i < 4; ++i)
    inside.add({.shapes = {box(0.3, 0.3)}, .position = {0.4 * i - 0.6, 0.2 * i}, .velocity = {9, 5}});
  World<double> world = world_after(inside, 120);
  for (int i = 0; i < 4; ++i) CHECK(world.bodies().pose[{2 + i}].position.cwiseAbs().maxCoeff() < 0.86);

  Scene outside;
  outside.add(still(chain({room.rbegin(), room.rend()}, {.closed = true}), 0.3));
  const BodyId body = outside.add({.shapes = {box(0.3, 0.3)}, .position = {0.2, 1.5}});
  CHECK(pose_of(world_after(outside, 120), body).position.y() == doctest::Approx(1.15).epsilon(0.006));
}

TEST_CASE("a chain on a kinematic body carries what stands on it over its corners") {
  Scene scene;
  const BodyId lift = scene.add({.type = BodyType::kinematic,
                                 .shapes = {chain({{3, 0}, {0.3, 0}, {0, 0}, {-0.3, 0}, {-3, 0}})},
                                 .velocity = {1, 0.5}});
  const BodyId body = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {1, 0.5}});
  World<double> world(scene);
  NewtonSolver<double> solver;
  for (int i = 0; i < 60; ++i) world.step(solver);
  const Vec2<double> apart = world.bodies().pose[body].position - world.bodies().pose[lift].position;
  CHECK(apart.x() == doctest::Approx(0).epsilon(1e-9));
  CHECK(apart.y() == doctest::Approx(0.5).epsilon(0.011));  // the slop
}

TEST_CASE("a disc that rolls off the end of a chain goes on as the points behind it say") {
  const auto place_after = [](const ChainEnds& ends) {
    Scene scene({.dt = 1.0 / 960});
    scene.add(still(chain({{0, 0}, {-4, 0}}, ends)));
    scene.add(
        {.shapes = {circle(0.5)}, .position = {-0.5, 0.5}, .velocity = {1, 0}, .material = {.friction = 0}});
    return pose_of(world_after(scene, 960), {2});
  };
  // It comes to the end after 0.5 s. Straight on, it then falls freely: g t^2 / 2 = 1.25 m, x = 0.5 m.
  const Pose<double> straight = place_after({});
  CHECK(straight.position.x() == doctest::Approx(0.5).epsilon(1e-6));
  CHECK(straight.position.y() == doctest::Approx(0.5 - 1.25).epsilon(0.01));
  // Around a corner that is there, it rolls over the end and is pushed away by it.
  const Pose<double> around = place_after({.before = Vec2<double>(0, -1)});
  CHECK(around.position.x() > 0.5 + 0.1);
  CHECK(around.position.y() > straight.position.y() + 0.1);
}

TEST_CASE("a chain is refused on a dynamic body") {
  Scene scene;
  const BodySpec spec{.shapes = {box(1, 1), chain({{1, 0}, {0, 0}})}, .mass = 1};
  CHECK_THROWS_WITH(scene.add(spec),
                    "Scene::add: shapes[1] must be no chain on a dynamic body: chains are for static and "
                    "kinematic ones, got a chain");
}

TEST_CASE("a world whose tiles are changed goes on as one that was made so") {
  Scene scene;
  const BodyId first = scene.add(still(moved(box(2, 1), {-1, -0.5})));
  const BodyId second = scene.add(still(moved(box(2, 1), {1, -0.5})));
  scene.add(
      {.shapes = {box(1, 1)}, .position = {-0.9, 0.5}, .velocity = {2, 0}, .material = {.friction = 0}});
  World<double> world(scene);
  SequentialImpulse<double> solver;
  for (int i = 0; i < 20; ++i) world.step(solver);
  World<double> twin = world;
  twin.edit([&](Scene& edited) { edited.remove(second); });
  twin.edit([&](Scene& edited) { displace(edited, first, {0, 0}); });
  for (int i = 0; i < 30; ++i) world.step(solver), twin.step(solver);
  CHECK(world.bodies().velocity[{3}].x() == doctest::Approx(2).epsilon(1e-12));
  CHECK(twin.bodies().pose[{3}].position.y() < 0.45);  // it falls where the second tile was
}

}  // namespace cairn
