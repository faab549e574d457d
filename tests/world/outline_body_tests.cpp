// Bodies whose outline is not convex: their pieces are one surface.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

using Points = List<Vec2<double>>;

const Points ell = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
// A flat top over three teeth: its pieces meet in seams under the top.
const Points table = {{0, 0}, {1, 0}, {1, 1}, {3, 1}, {3, 0}, {4, 0},
                      {4, 1}, {6, 1}, {6, 0}, {7, 0}, {7, 2}, {0, 2}};

SharedList<Shape<double>> shapes_of(const Points& points) { return outline(points); }

}  // namespace

TEST_CASE("what slides over a seam of two pieces meets no edge, on what stands and on what moves") {
  for (const BodyType type : {BodyType::static_body, BodyType::dynamic}) {
    for (const bool is_disc : {true, false}) {
      CAPTURE(is_disc);
      Scene scene;
      scene.add_ground({.material = {.friction = 0}});
      scene.add({.type = type, .shapes = shapes_of(table), .density = 1000, .material = {.friction = 0}});
      scene.add({.shapes = {is_disc ? Shape<double>(circle(0.25)) : Shape<double>(box(0.5, 0.5))},
                 .position = {0.5, 2.25},
                 .velocity = {3, 0},
                 .material = {.friction = 0}});
      World<double> world(scene);
      SequentialImpulse<double> solver({.iterations = 50});
      for (int i = 0; i < 110; ++i) {
        world.step(solver);
        // An edge of 1e-6 that it met would throw it up and stop it.
        CHECK(std::abs(velocity_of(world, {2}).y()) <= 1e-6);
      }
      CHECK(velocity_of(world, {2}).x() == doctest::Approx(3).epsilon(1e-9));
      CHECK(std::abs(pose_of(world, {2}).position.y() - 2.25) <= 0.01);
    }
  }
}

TEST_CASE("an L stands while its centre of mass is over its foot, and tips when it is not") {
  // Its centre is at x = 1; a foot of this width under its left end.
  for (const double foot : {0.9, 1.1}) {
    Scene scene;
    scene.add({.type = BodyType::static_body, .shapes = {box(2, 1)}, .position = {foot - 1, -0.5}});
    scene.add({.shapes = shapes_of(ell)});
    World<double> world(scene);
    take_steps(world, 120, 50);
    const double turned = pose_of(world, {2}).angle;
    if (foot > 1) CHECK(std::abs(turned) <= 1e-3);
    if (foot < 1) CHECK(turned < -0.2);
  }
}

TEST_CASE("a hook hangs on a bar") {
  // A C that is open to the right, with its upper arm over a bar of radius 0.1.
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {circle(0.1)}, .position = {0.6, 1.5}});
  const BodyId hook = scene.add({.shapes = shapes_of({{0, 0},
                                                      {1, 0},
                                                      {1, 0.4},
                                                      {0.4, 0.4},
                                                      {0.4, 1.6},
                                                      {0.8, 1.6},
                                                      {0.8, 1.3},
                                                      {1.2, 1.3},
                                                      {1.2, 2},
                                                      {0, 2}}),
                                 .position = {0, 0.01},
                                 .damping = {.linear = 1, .angular = 2}});
  World<double> world(scene);
  take_steps(world, 600, 30);
  // It hangs still, with its centre of mass under the bar.
  const Pose<double>& pose = pose_of(world, hook);
  CHECK(pose.position.y() > 0.3);
  CHECK(std::abs(pose.position.x() - 0.6) <= 0.12);
  CHECK(velocity_of(world, hook).norm() <= 0.01);
}

TEST_CASE("pieces keep what shapes keep: a copy, another place, and no neighbours of other bodies") {
  Scene scene;
  const BodyId one = scene.add({.shapes = shapes_of(ell), .position = {5, 5}, .angle = 1});
  CHECK(std::get<Polygon<double>>(scene.bodies()[one].spec.shapes[0]).is_piece);
  CHECK(explain(make_plan(scene)).find("cut into 2 of these shapes") != std::string::npos);
  CHECK(make_plan(Scene()).size.pieces == 0);
  World<double> world(scene);
  CHECK(world.scene().bodies()[one].spec.shapes.size() == 2);
  CHECK(scene.bodies()[one].mass == doctest::Approx(6));
}
