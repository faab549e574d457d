// Looking ahead: nothing is found too late, nothing is stopped that would have missed, and what all bodies do
// alike costs nothing.
#include <random>

#include "world/overlaps.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// [m] The deepest that a body gets in another in so many steps.
double deepest_in(World<double>& world, int steps) {
  NewtonSolver<double> solver;
  double deepest = 0;
  for (int i = 0; i < steps; ++i) {
    world.step(solver);
    for (int a = 1; a < world.scene().bodies().size(); ++a) {
      for (int b = a + 1; b < world.scene().bodies().size(); ++b)
        deepest = std::max(deepest, overlap(world, {a}, {b}));
    }
  }
  return deepest;
}

BodySpec floor_of(double width) {
  return {.type = BodyType::static_body, .shapes = {box(width, 1)}, .position = {0, -0.5}};
}

constexpr double most_overlap = 1.1 * 0.005;  // [m] the slop of bodies of 0.1 m and more, and a tenth of it

}  // namespace

TEST_CASE("a disc that falls on a floor never sinks in, however fast, in whatever search and substeps") {
  for (const ContactSearch search : every_search) {
    for (const int substeps : {1, 4}) {
      for (const double speed : {1.0, 6.3, 40.0, 1e3, 1e5}) {
        Scene scene({.substeps = substeps, .contact_search = search});
        scene.add(floor_of(40));
        scene.add({.shapes = {circle(0.1)}, .position = {0, 2.1}, .velocity = {0.1 * speed, -speed}});
        World<double> world(std::move(scene));
        CAPTURE(static_cast<int>(search));
        CAPTURE(substeps);
        CAPTURE(speed);
        CHECK(deepest_in(world, 20) < std::max(1e-6, 1e-9 * speed));
      }
    }
  }
}

TEST_CASE("a box that falls on a floor, however turned, sinks in by the slop at most") {
  for (const double speed : {2.0, 5.0, 10.0, 20.0}) {
    for (int n = 0; n < 16; ++n) {
      Scene scene;
      scene.add(floor_of(40));
      scene.add(
          {.shapes = {box(1, 1)}, .position = {0, 1 + 0.02 * n}, .angle = 0.1 * n, .velocity = {0, -speed}});
      World<double> world(std::move(scene));
      CAPTURE(speed);
      CAPTURE(n);
      CHECK(deepest_in(world, 60) < most_overlap);
    }
  }
}

TEST_CASE("a bar that turns by a radian in a step does not pass a post") {
  for (const double turn : {3.0, 20.0, 60.0}) {
    Scene scene({.gravity = {0, 0}});
    scene.add({.type = BodyType::static_body, .shapes = {circle(0.05)}, .position = {2.5, 1.5}});
    scene.add({.shapes = {box(6, 0.05)}, .angular_velocity = turn, .mass = 1});
    World<double> world(std::move(scene));
    CAPTURE(turn);
    CHECK(deepest_in(world, 30) < most_overlap);
    // It is at the post, or back from it, and never beyond: at asin(0.075 / 2.915) before its direction.
    CHECK(world.bodies().velocity[{2}].z() < turn);
  }
}

TEST_CASE("what is set moving within a step meets the next body in that step") {
  // Pucks 62 mm apart, of which the first is hit at 8 m/s: it goes on by up to 133 mm in the step.
  for (const double restitution : {0.0, 0.9}) {
    for (int start = 0; start < 8; ++start) {
      Scene scene({.gravity = {0, 0}});
      const BodySpec puck{
          .shapes = {circle(0.4)}, .mass = 1, .material = {.friction = 0, .restitution = restitution}};
      for (int i = 0; i < 4; ++i) {
        BodySpec next = puck;
        next.position = {0.862 * i, 0};
        scene.add(next);
      }
      BodySpec first = puck;
      first.position = {-1 - start / 60.0, 0.1};
      first.velocity = {8, 0};
      scene.add(first);
      World<double> world(std::move(scene));
      CAPTURE(restitution);
      CAPTURE(start);
      CHECK(deepest_in(world, 12) < most_overlap);
    }
  }
}

TEST_CASE("layers that land one after the other in a step do not sink into each other") {
  for (const bool is_upside_down : {false, true}) {  // in the order of their ids, or against it
    Scene scene;
    scene.add(floor_of(40));
    for (int i = 0; i < 6; ++i) {
      const int place = is_upside_down ? 5 - i : i;
      scene.add({.shapes = {box(1, 1)},
                 .position = {0, 0.57 + 1.03 * place},
                 .velocity = {0, -10},
                 .fixed_rotation = true});
    }
    World<double> world(std::move(scene));
    CAPTURE(is_upside_down);
    CHECK(deepest_in(world, 30) < most_overlap);
  }
}

TEST_CASE("boxes that come together within the time meet, and overlap in what the crowd sees of them") {
  Scene scene;
  for (int i = 0; i < 60; ++i) {
    const Shape<double> shape =
        i % 2 == 0 ? Shape<double>(box(0.2 + 0.02 * i, 0.3)) : Shape<double>(circle(0.2));
    scene.add({.shapes = {shape}, .position = {i % 10, 2 * (i / 10)}});
  }
  const List<Collider<double>> colliders = make_colliders<double>(scene);
  std::mt19937 engine(7);
  const auto number = [&engine] { return static_cast<double>(engine()) / 4294967296.0 - 0.5; };
  const double time = 0.1;
  int meetings = 0;
  for (const double crowd : {0.0, 1e3}) {
    LookAhead<double> outlook;
    SweptBoxes<double> boxes(colliders.size());
    PerBody<Vec3<double>> velocity(scene.bodies().size(), Vec3<double>::Zero());
    PerBody<Frame<double>> now, then;
    for (const BodyId body : scene.bodies().indices()) {
      velocity[body] = {crowd + 20 * number(), -crowd + 20 * number(), 5 * number()};
      now.push_back(scene.bodies()[body].pose);
    }
    boxes.follow_crowd(colliders, velocity, time);
    outlook.begin(time, velocity);
    boxes.find(colliders, now, 0, outlook, -1);
    for (int k = 0; k <= 50; ++k) {
      then.clear();
      for (const BodyId body : scene.bodies().indices()) {
        const Pose<double>& pose = scene.bodies()[body].pose;
        const double t = time * k / 50;
        then.push_back(
            Pose<double>{pose.position + t * velocity[body].head<2>(), pose.angle + t * velocity[body].z()});
      }
      for (int i = 0; i < colliders.size(); ++i) {
        for (int j = i + 1; j < colliders.size(); ++j) {
          const Aabb<double> a = bounding_box(*colliders[i].form->shape, then[colliders[i].body]);
          const Aabb<double> b = bounding_box(*colliders[j].form->shape, then[colliders[j].body]);
          if (!a.overlaps(b)) continue;
          ++meetings;
          CHECK(boxes.meet(i, j));
          CHECK(boxes.boxes()[i].overlaps(boxes.boxes()[j]));
        }
      }
    }
  }
  CHECK(meetings > 100);
}

TEST_CASE("a block that falls freely has the contacts that it has at rest, and keeps its manifolds") {
  const auto block = [](double speed) {
    Scene scene({.gravity = {0, 0}, .contact_search = ContactSearch::when_moved});
    for (int i = 0; i < 64; ++i) {
      scene.add({.shapes = {box(0.2, 0.2)},
                 .position = {0.2 * (i % 8), 0.2 * (i / 8)},
                 .velocity = {3 * speed, -speed}});
    }
    return World<double>(std::move(scene));
  };
  World<double> resting = block(0);
  SequentialImpulse<double> solver;
  const int contacts = resting.step(solver).contacts;
  for (const double speed : {1.0, 20.0, 1e3}) {
    World<double> falling = block(speed);
    for (int i = 0; i < 20; ++i) CHECK(falling.step(solver).contacts == contacts);
  }
}

TEST_CASE("what turns together as one does not come closer") {
  Scene scene({.gravity = {0, 0}});
  const double turn = 30;  // [rad/s]
  for (const Vec2<double>& place : List<Vec2<double>>{{0, 0}, {3, 1}}) {
    const Vec2<double> speed = cross<double>(turn, place);
    scene.add({.shapes = {box(1, 0.5)}, .position = place, .velocity = speed, .angular_velocity = turn});
  }
  const List<Collider<double>> colliders = make_colliders<double>(scene);
  World<double> world(scene);
  LookAhead<double> outlook;
  outlook.begin(1, world.bodies().velocity);
  CHECK(outlook.travel(colliders[0], colliders[1], world.bodies().pose) < 1e-12);
}
