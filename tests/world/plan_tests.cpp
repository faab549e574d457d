// What a scene needs, what is left out of its steps, and what the plan says about it.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A falling disc on the ground that needs as little as can be: no friction, no rotation.
Scene plain_scene(double friction_of_ground, double friction_of_disc) {
  Scene scene({.warm_start = false});
  scene.add_ground({.material = {.friction = friction_of_ground}});
  scene.add({.shapes = {circle(0.5)},
             .position = {0, 0.5},
             .material = {.friction = friction_of_disc},
             .fixed_rotation = true});
  return scene;
}

/// A scene in which everything occurs.
Scene rich_scene() {
  Scene scene(
      {.substeps = 2, .stabilization = {.policy = StabilizationPolicy::soft}, .sleeping = Sleeping{}});
  scene.add_ground({.material = {.friction = 0.5}});
  const BodyId bar =
      scene.add({.shapes = {box(1, 1), circle(1, {1, 0})}, .position = {0, 3}, .damping = {.angular = 0.1}});
  scene.add({.shapes = {capsule({0, 0}, {1, 0}, 0.2)}, .position = {0, 5}, .material = {.restitution = 0.5}});
  scene.add({.type = BodyType::static_body, .shapes = {segment({-5, 0}, {-5, 5})}});
  scene.join<RevoluteJoint>({.a = ground, .b = bar, .anchor = {0, 4}});
  return scene;
}

bool says(const Plan& plan, const std::string& text) { return explain(plan).find(text) != std::string::npos; }

int friction_rows(const World<double>& world) {
  int count = 0;
  for (const ConstraintRow<double>& row : world.last_step().problem.rows) count += row.bounds.is_friction();
  return count;
}

}  // namespace

TEST_CASE("a plan counts bodies, shapes and joints, and lists the kinds of shapes") {
  const Plan plan = make_plan(rich_scene());
  CHECK(plan.size.bodies == 4);
  CHECK(plan.size.dynamic_bodies == 2);
  CHECK(plan.size.turning_bodies == 2);
  CHECK(plan.size.colliders == 5);
  CHECK(plan.size.joints == 1);
  CHECK(plan.size.shape_kinds == List<std::string>{"capsule", "circle", "polygon", "segment"});
  CHECK(plan.broadphase == BroadphaseKind::all_pairs);
  CHECK(plan.collision);
  CHECK(plan.gravity);
  CHECK(plan.damping);
  CHECK(plan.friction);
  CHECK(plan.restitution);
  CHECK(plan.settings.warm_start);
  CHECK_FALSE(says(plan, "left out"));
}

TEST_CASE("the explanation of a plan says what is there") {
  const Plan plan = make_plan(rich_scene());
  CHECK(says(plan, "2 dynamic of 4; 6 velocities a step"));
  CHECK(says(plan, "all pairs of boxes, 5 shapes (capsule, circle, polygon, segment)"));
  CHECK(says(plan, "one row a contact point, where mu > 0"));
}

TEST_CASE("everything that a scene does without is left out, and the explanation says so") {
  Scene scene({.gravity = {0, 0}, .warm_start = false});
  scene.add({.shapes = {circle(1)}, .fixed_rotation = true});
  const Plan plan = make_plan(scene);
  for (const char* part : {"collision", "joints", "friction", "restitution", "gravity", "damping", "rotation",
                           "warm start", "substeps", "second solve"}) {
    const std::string text = explain(plan);
    const std::size_t begin = text.find(std::string("  ") + part);
    REQUIRE(begin != std::string::npos);
    const std::string line = text.substr(begin, text.find('\n', begin) - begin);
    CHECK(line.find("left out") != std::string::npos);
  }
  CHECK_FALSE(plan.collision);
  CHECK_FALSE(plan.friction);
  CHECK_FALSE(plan.gravity);
  CHECK(plan.size.turning_bodies == 0);
}

TEST_CASE("no friction row is written where mu is 0 on either side, and one a contact point elsewhere") {
  struct Case {
    double ground;
    double disc;
    int rows;
  };
  for (const Case& row : {Case{0, 0.5, 0}, Case{0.5, 0, 0}, Case{0, 0, 0}, Case{0.5, 0.5, 1}}) {
    World world(plain_scene(row.ground, row.disc));
    const StepReport report = take_steps(world, 1);
    CHECK(report.contacts == 1);
    CHECK(friction_rows(world) == row.rows);
    CHECK(report.rows == 1 + row.rows);
    CHECK(make_plan(world.scene()).friction == (row.rows > 0));
    CHECK(says(make_plan(world.scene()), "no friction rows") == (row.rows == 0));
  }
}

TEST_CASE("a scene in which nothing can meet has no contacts, even where shapes overlap") {
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}});
  scene.add({.type = BodyType::kinematic, .shapes = {box(1, 1)}});
  World world(scene);
  CHECK(take_steps(world, 1).rows == 0);
  CHECK_FALSE(make_plan(world.scene()).collision);
  CHECK(says(make_plan(world.scene()), "nothing can meet"));
}

TEST_CASE("many shapes are sorted, few are compared each with each") {
  Scene scene;
  for (int i = 0; i < 100; ++i) scene.add({.shapes = {circle(0.4)}, .position = {static_cast<double>(i), 0}});
  CHECK(make_plan(scene).broadphase == BroadphaseKind::grid);
  CHECK(says(make_plan(scene), "grid of cells"));
}

TEST_CASE("bodies whose rotation is fixed are counted, and never turn") {
  Scene scene;
  scene.add_ground({.material = {.friction = 1}});
  const BodyId sledge = scene.add({.shapes = {box(1, 4)},
                                   .position = {0, 2},
                                   .velocity = {3, 0},
                                   .material = {.friction = 1},
                                   .fixed_rotation = true});
  scene.add({.shapes = {circle(1)}, .position = {5, 1}});
  World<double> world = world_after(scene, 30);
  CHECK(world.bodies().pose[sledge].angle == 0);
  CHECK(says(make_plan(world.scene()), "left out for 1 of 2 dynamic bodies: 1/I is 0"));
  CHECK(says(make_plan(world.scene()), "2 dynamic of 3; 5 velocities a step"));
}

TEST_CASE("collision is left out where the categories of all bodies that could meet exclude each other") {
  const auto collides = [](const BodySpec& one, const BodySpec& other) {
    Scene scene;
    scene.add(one);
    scene.add(other);
    return make_plan(scene).collision;
  };
  const BodySpec any = {.shapes = {circle(0.5)}};
  const BodySpec link = {.shapes = {circle(0.5)}, .filter = {.category = 2, .collides_with = ~2u}};
  BodySpec wall = any, post = link;
  wall.type = post.type = BodyType::static_body;
  CHECK(collides(any, any));
  CHECK(collides(any, link));
  CHECK(collides(wall, link));
  CHECK_FALSE(collides(link, link));
  CHECK_FALSE(collides(post, link));
  CHECK_FALSE(collides(wall, post));
}
