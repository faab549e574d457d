// Every number of a scene that cannot be simulated is refused, and the message names field, rule, unit and
// value.
#include <cairn/math/check.hpp>
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double no_number = std::numeric_limits<double>::quiet_NaN();
const double unbounded = std::numeric_limits<double>::infinity();

/// One field: what the message says it must be, how to give it a value, and values that are out of range.
/// NaN and both infinities are tried for every field.
struct Field {
  std::string name = {};
  std::string rule = {};
  std::function<void(double)> use = {};
  List<double> out_of_range = {};
};

void check_refusals(const std::string& place, const List<Field>& fields) {
  for (const Field& field : fields) {
    List<double> values = {no_number, unbounded, -unbounded};
    values.insert(values.end(), field.out_of_range.begin(), field.out_of_range.end());
    for (const double value : values) {
      const std::string expected =
          place + ": " + field.name + " must be " + field.rule + ", got " + shortest(value);
      CHECK(message_of([&] { field.use(value); }) == expected);
    }
  }
}

/// The same for fields of two numbers, of which the second is bad.
void check_vector_refusals(const std::string& place, const List<Field>& fields) {
  for (const Field& field : fields) {
    for (const double value : {no_number, unbounded, -unbounded}) {
      const std::string expected =
          place + ": " + field.name + " must be " + field.rule + ", got (1, " + shortest(value) + ")";
      CHECK(message_of([&] { field.use(value); }) == expected);
    }
  }
}

void set(double& member, double value) { member = value; }
void set(std::optional<double>& member, double value) { member = value; }
void set(Vec2<double>& member, double value) { member = {1, value}; }

/// A field of a ball that is added to a scene, of settings that one is made with, and of its ground.
template <typename Member>
std::function<void(double)> of(Member BodySpec::*field) {
  return [field](double value) {
    BodySpec spec{.shapes = {circle(1)}};
    set(spec.*field, value);
    Scene().add(spec);
  };
}
template <typename Part, typename Member>
std::function<void(double)> of(Part BodySpec::*part, Member Part::*field) {
  return [part, field](double value) {
    BodySpec spec{.shapes = {circle(1)}};
    set(spec.*part.*field, value);
    Scene().add(spec);
  };
}
template <typename Member>
std::function<void(double)> of(Member SceneSettings::*field) {
  return [field](double value) {
    SceneSettings settings;
    set(settings.*field, value);
    Scene scene(settings);
  };
}
template <typename Member>
std::function<void(double)> of(Member Stabilization::*field) {
  return [field](double value) {
    SceneSettings settings;
    set(settings.stabilization.*field, value);
    Scene scene(settings);
  };
}
std::function<void(double)> of(double GroundSpec::*field) {
  return [field](double value) {
    GroundSpec spec;
    spec.*field = value;
    Scene().add_ground(spec);
  };
}
std::function<void(double)> of(Material GroundSpec::*part, double Material::*field) {
  return [part, field](double value) {
    GroundSpec spec;
    spec.*part.*field = value;
    Scene().add_ground(spec);
  };
}

Scene scene_with_two_balls() {
  Scene scene;
  scene.add({.shapes = {circle(1)}, .position = {0, 0}});
  scene.add({.shapes = {circle(1)}, .position = {5, 0}});
  return scene;
}

}  // namespace

TEST_CASE("a field of a body, of settings or of a ground that cannot be is refused by name") {
  const std::string share = "in [0, 1]", mu = "from 0 to 1e6";
  check_refusals(
      "Scene::add",
      {{"angle", "a finite number of rad", of(&BodySpec::angle)},
       {"angular_velocity", "a finite number of rad/s", of(&BodySpec::angular_velocity)},
       {"gravity_scale", "a finite number", of(&BodySpec::gravity_scale)},
       {"mass", "from 1e-15 to 1e15 kg", of(&BodySpec::mass), {0, -1, 1e-16, 1e16}},
       {"inertia", "from 1e-15 to 1e15 kg m^2", of(&BodySpec::inertia), {0, -1, 1e-16, 1e16}},
       {"density", "> 0 kg/m^2 and finite", of(&BodySpec::density), {0, -1}},
       {"friction", mu, of(&BodySpec::material, &Material::friction), {-0.1, 1.1e6}},
       {"restitution", share, of(&BodySpec::material, &Material::restitution), {-0.1, 1.0001}},
       {"surface_speed", "a finite number of m/s", of(&BodySpec::material, &Material::surface_speed)},
       {"linear_damping", ">= 0 1/s and finite", of(&BodySpec::damping, &Damping::linear), {-0.1}},
       {"angular_damping", ">= 0 1/s and finite", of(&BodySpec::damping, &Damping::angular), {-0.1}},
       {"drag", ">= 0 kg/m and finite", of(&BodySpec::damping, &Damping::quadratic), {-0.1}}});
  check_vector_refusals("Scene::add", {{"position", "finite numbers of m", of(&BodySpec::position)},
                                       {"velocity", "finite numbers of m/s", of(&BodySpec::velocity)}});
  using How = Stabilization;
  check_refusals(
      "Scene",
      {{"dt", "from 1e-12 to 1e6 s", of(&SceneSettings::dt), {0, -1, 1e-13, 1e7}},
       {"stabilization.baumgarte", ">= 0 and finite", of(&How::baumgarte), {-0.1}},
       {"stabilization.slop", ">= 0 m and finite", of(&How::slop), {-0.1}},
       {"speculative_margin", ">= 0 m and finite", of(&SceneSettings::speculative_margin), {-0.1}},
       {"restitution_threshold", ">= 0 m/s and finite", of(&SceneSettings::restitution_threshold), {-0.1}}});
  check_vector_refusals("Scene", {{"gravity", "finite numbers of m/s^2", of(&SceneSettings::gravity)}});
  check_refusals("Scene::add_ground",
                 {{"height", "a finite number of m", of(&GroundSpec::height)},
                  {"half_width", "> 0 m and finite", of(&GroundSpec::half_width), {0, -1}},
                  {"friction", mu, of(&GroundSpec::material, &Material::friction), {-0.1, 1.1e6}},
                  {"restitution", share, of(&GroundSpec::material, &Material::restitution), {-0.1, 2}},
                  {"surface_speed", "a finite number of m/s",
                   of(&GroundSpec::material, &Material::surface_speed)}});
}

TEST_CASE("anchors and lengths of joints that cannot be are refused by name") {
  const auto rod = [](const DistanceJoint::Spec& spec) { scene_with_two_balls().join<DistanceJoint>(spec); };
  const auto pin = [](const RevoluteJoint::Spec& spec) { scene_with_two_balls().join<RevoluteJoint>(spec); };
  check_vector_refusals("DistanceJoint", {{"anchor_a", "finite numbers of m",
                                           [&](double x) {
                                             rod({.a = {1}, .b = {2}, .anchor_a = {1, x}});
                                           }},
                                          {"anchor_b", "finite numbers of m", [&](double x) {
                                             rod({.a = {1}, .b = {2}, .anchor_b = {1, x}});
                                           }}});
  check_refusals("DistanceJoint", {{"length", "a finite number of m", [&](double x) {
                                      rod({.a = {1}, .b = {2}, .anchor_b = {1, 0}, .length = x});
                                    }}});
  check_vector_refusals("RevoluteJoint", {{"anchor", "finite numbers of m", [&](double x) {
                                             pin({.a = {1}, .b = {2}, .anchor = {1, x}});
                                           }}});
  CHECK(message_of([&] {
          rod({.a = {1}, .b = {2}, .anchor_b = {1, 0}, .length = 0});
        }) == "DistanceJoint: length must be > 0 m, got 0");
  CHECK(message_of([&] { rod({.a = {1}, .b = {2}}); }) == "DistanceJoint: length must be > 0 m, got 0");
}

TEST_CASE("a joint needs two different bodies of the scene, of which one can move") {
  const auto pin = [](BodyId a, BodyId b) { scene_with_two_balls().join<RevoluteJoint>({.a = a, .b = b}); };
  CHECK(message_of([&] { pin({1}, {1}); }) == "RevoluteJoint: b must be another body than a, got 1");
  CHECK(message_of([&] { pin({3}, {1}); }) == "Scene::join: a must be the id of a body of this scene, got 3");
  CHECK(message_of([&] { pin({1}, {-1}); }) ==
        "Scene::join: b must be the id of a body of this scene, got -1");
  CHECK(message_of([] { Scene().join(nullptr); }) == "Scene::join: joint must be a constraint, got nullptr");
  Scene scene;
  const BodyId lift = scene.add({.type = BodyType::kinematic, .shapes = {circle(1)}});
  CHECK(message_of([&] { scene.join<RevoluteJoint>({.a = ground, .b = lift}); }) ==
        "Scene::join: bodies must be at least one that can move, got 0, 1");
}

TEST_CASE("a dynamic body needs a mass and an inertia, from its shapes or of its own") {
  const Shape<double> line = segment({0, 0}, {1, 0});
  CHECK(message_of([] { Scene().add(BodySpec{}); }) ==
        "Scene::add: shapes must be of some area for a dynamic body without a mass of its own, got 0");
  CHECK(message_of([&] { Scene().add({.shapes = {line}, .mass = 1}); }) ==
        "Scene::add: inertia must be given for a dynamic body whose shapes have no area, unless its rotation "
        "is "
        "fixed, got 0");
  Scene scene;
  CHECK_NOTHROW(scene.add({.shapes = {line}, .mass = 1, .fixed_rotation = true}));
  CHECK_NOTHROW(scene.add({.shapes = {line}, .mass = 1, .inertia = 2}));
  CHECK_NOTHROW(scene.add({.type = BodyType::static_body, .shapes = {line}}));
  CHECK(message_of([&] {
          scene.add({.type = BodyType::static_body, .shapes = {line}, .velocity = {3, 4}});
        }) == "Scene::add: velocity must be 0 for a static body, got 5");
}

TEST_CASE("a world refuses steps and velocities that cannot be, and bodies that cannot have them") {
  Scene scene = scene_with_two_balls();
  const BodyId wall = scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}});
  World world(scene);
  check_refusals("World::set_dt",
                 {{"dt", "from 1e-12 to 1e6 s", [&](double x) { world.set_dt(x); }, {0, -1, 1e7}}});
  check_refusals("World::set_velocity", {{"angular velocity", "a finite number of rad/s", [&](double x) {
                                            world.set_velocity({1}, {0, 0, x});
                                          }}});
  check_vector_refusals("World::set_velocity", {{"velocity", "finite numbers of m/s", [&](double x) {
                                                   world.set_velocity({1}, {1, x, 0});
                                                 }}});
  CHECK(message_of([&] {
          world.set_velocity(ground, {0, 0, 0});
        }) == "World::set_velocity: body must be the id of a body other than the ground, got 0");
  CHECK(message_of([&] {
          world.set_velocity({7}, {0, 0, 0});
        }) == "World::set_velocity: body must be the id of a body other than the ground, got 7");
  CHECK(message_of([&] {
          world.set_velocity(wall, {0, 0, 0});
        }) == "World::set_velocity: body must be one that is not static, got 3");
}

TEST_CASE("a refused body leaves the scene as it was") {
  Scene scene;
  CHECK_THROWS_AS(scene.add({.shapes = {circle(1)}, .density = -1}), std::invalid_argument);
  CHECK(scene.bodies().size() == 1);
}
