// Every number of every type that a scene is made of: NaN, infinities and what is out of range are refused
// with the name of the field and the value.
#include <cairn/study/frozen/frozen_problem.hpp>
#include <cairn/math/check.hpp>
#include <cairn/scenes/solver_list.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

const double field_nan = std::numeric_limits<double>::quiet_NaN();
const double field_infinity = std::numeric_limits<double>::infinity();

/// One number of a type: the name that a refusal gives it, how to use it, and values beside NaN that are bad.
struct NumberField {
  std::string name = {};
  std::function<void(double)> use = {};
  List<double> bad = {field_infinity, -field_infinity};
};

void check_fields(const List<NumberField>& fields) {
  for (const NumberField& field : fields) {
    List<double> values = field.bad;
    values.push_back(field_nan);
    for (const double value : values) {
      CAPTURE(field.name);
      CAPTURE(value);
      const std::string message = testing::message_of([&] { field.use(value); });
      CHECK(message.find(field.name + " must be ") != std::string::npos);
      CHECK(message.find(shortest(value), message.find(", got ")) != std::string::npos);
    }
  }
}

const List<double> not_positive = {field_infinity, -field_infinity, 0.0, -1.0};
const List<double> negative = {field_infinity, -field_infinity, -1.0};

std::function<void(double)> with_settings(const std::function<void(SceneSettings&, double)>& set) {
  return [set](double value) {
    SceneSettings settings{.sleeping = Sleeping{}};
    set(settings, value);
    Scene scene(settings);
  };
}

/// A joint between two discs, or between one and the ground.
template <typename Joint>
std::function<void(double)> with_joint(const std::function<void(typename Joint::Spec&, double)>& set) {
  return [set](double value) {
    Scene scene;
    const BodyId a = scene.add({.shapes = {circle(1)}, .position = {0, 0}});
    const BodyId b = scene.add({.shapes = {circle(1)}, .position = {5, 0}});
    typename Joint::Spec spec;
    if constexpr (requires { spec.a; }) spec.a = a;
    if constexpr (requires { spec.b; }) spec.b = b;
    if constexpr (requires { spec.body; }) spec.body = b;
    if constexpr (requires { spec.ends; }) spec.ends = {{a, {0, 0}, {0, 3}}, {b, {5, 0}, {5, 3}}};
    if constexpr (requires { spec.anchor_b; }) spec.anchor_b = {5, 0};
    set(spec, value);
    scene.join<Joint>(spec);
  };
}

}  // namespace

TEST_CASE("every number of the settings of a scene is refused by name where it cannot be") {
  using S = SceneSettings;
  check_fields({
      {"gravity", with_settings([](S& s, double x) { s.gravity.x() = x; })},
      {"gravity", with_settings([](S& s, double x) { s.gravity.y() = x; })},
      {"dt", with_settings([](S& s, double x) { s.dt = x; }), not_positive},
      {"stabilization.baumgarte", with_settings([](S& s, double x) { s.stabilization.baumgarte = x; }),
       negative},
      {"stabilization.slop", with_settings([](S& s, double x) { s.stabilization.slop = x; }), negative},
      {"stabilization.max_speed",
       with_settings([](S& s, double x) { s.stabilization.max_speed = x; }),
       {0, -1}},
      {"stabilization.soft: softness frequency",
       with_settings([](S& s, double x) { s.stabilization.soft.frequency = x; }), not_positive},
      {"stabilization.soft: softness damping_ratio",
       with_settings([](S& s, double x) { s.stabilization.soft.damping_ratio = x; }), negative},
      {"stabilization.joint_soft: softness frequency",
       with_settings([](S& s, double x) { s.stabilization.joint_soft.frequency = x; }), not_positive},
      {"stabilization.joint_soft: softness damping_ratio",
       with_settings([](S& s, double x) { s.stabilization.joint_soft.damping_ratio = x; }), negative},
      {"speculative_margin", with_settings([](S& s, double x) { s.speculative_margin = x; }), negative},
      {"restitution_threshold", with_settings([](S& s, double x) { s.restitution_threshold = x; }), negative},
      {"sleeping.speed", with_settings([](S& s, double x) { s.sleeping->speed = x; }), not_positive},
      {"sleeping.angular_speed", with_settings([](S& s, double x) { s.sleeping->angular_speed = x; }),
       not_positive},
      {"sleeping.time", with_settings([](S& s, double x) { s.sleeping->time = x; }), not_positive},
  });
  CHECK_THROWS_AS(Scene({.substeps = 0}), std::invalid_argument);
  CHECK_THROWS_AS(Scene({.substeps = 1000001}), std::invalid_argument);
}

TEST_CASE("every number of a field, a force and a path is refused by name where it cannot be") {
  using S = SceneSettings;
  const auto with_water = [](const std::function<void(Water&, double)>& set) {
    return with_settings([set](S& s, double x) { set(s.fields.water.emplace(), x); });
  };
  const auto with_star = [](const std::function<void(Attraction&, double)>& set) {
    return with_settings([set](S& s, double x) { set(s.fields.attractions.emplace_back(), x); });
  };
  const auto with_force = [](const std::function<void(ApplyForce&, double)>& set) {
    return [set](double value) {
      Scene scene;
      ApplyForce pull{.body = scene.add({.shapes = {circle(1)}})};
      set(pull, value);
      scene.add({.time = 0, .action = pull});
    };
  };
  const auto with_path = [](const std::function<void(FollowPath&, double)>& set) {
    return [set](double value) {
      Scene scene;
      FollowPath path{.body = scene.add({.type = BodyType::kinematic}), .points = {{0, 0}, {1, 0}}};
      set(path, value);
      scene.add({.time = 0, .action = path});
    };
  };
  check_fields({
      {"wind", with_settings([](S& s, double x) { s.fields.wind.x() = x; })},
      {"gravitation", with_settings([](S& s, double x) { s.fields.gravitation = x; }), negative},
      {"attraction.point", with_star([](Attraction& star, double x) { star.point.y() = x; })},
      {"attraction.strength", with_star([](Attraction& star, double x) { star.strength = x; })},
      {"attraction.radius", with_star([](Attraction& star, double x) { star.radius = x; }), negative},
      {"water.level", with_water([](Water& water, double x) { water.level = x; })},
      {"water.density", with_water([](Water& water, double x) { water.density = x; }), not_positive},
      {"water.drag", with_water([](Water& water, double x) { water.drag = x; }), negative},
      {"water.flow", with_water([](Water& water, double x) { water.flow.x() = x; })},
      {"force", with_force([](ApplyForce& pull, double x) { pull.force.x() = x; })},
      {"torque", with_force([](ApplyForce& pull, double x) { pull.torque = x; })},
      {"point", with_force([](ApplyForce& pull, double x) { pull.point.y() = x; })},
      {"seconds", with_force([](ApplyForce& pull, double x) { pull.seconds = x; }), {0, -1}},
      {"points", with_path([](FollowPath& path, double x) { path.points[1].y() = x; })},
      {"speed", with_path([](FollowPath& path, double x) { path.speed = x; }), not_positive},
  });
}

TEST_CASE("every number of a pin, a slide and a weld is refused by name where it cannot be") {
  using Pin = RevoluteJoint;
  using Slide = PrismaticJoint;
  check_fields({
      {"anchor", with_joint<WeldJoint>([](WeldJoint::Spec& s, double x) { s.anchor.x() = x; })},
      {"anchor", with_joint<Pin>([](Pin::Spec& s, double x) { s.anchor.x() = x; })},
      {"lower", with_joint<Pin>([](Pin::Spec& s, double x) { s.lower = x; })},
      {"upper", with_joint<Pin>([](Pin::Spec& s, double x) { s.upper = x; })},
      {"limit_margin", with_joint<Pin>([](Pin::Spec& s, double x) { s.limit_margin = x; }), negative},
      {"motor speed", with_joint<Pin>([](Pin::Spec& s, double x) {
         s.motor = {{x, 1}};
       })},
      {"motor max_torque", with_joint<Pin>([](Pin::Spec& s, double x) {
         s.motor = {{1, x}};
       }),
       not_positive},
      {"anchor", with_joint<Slide>([](Slide::Spec& s, double x) { s.anchor.y() = x; })},
      {"axis",
       with_joint<Slide>([](Slide::Spec& s, double x) {
         s.axis = {x, 0};
       }),
       {field_infinity, 0}},
      {"lower", with_joint<Slide>([](Slide::Spec& s, double x) { s.lower = x; })},
      {"upper", with_joint<Slide>([](Slide::Spec& s, double x) { s.upper = x; })},
      {"limit_margin", with_joint<Slide>([](Slide::Spec& s, double x) { s.limit_margin = x; }), negative},
      {"motor speed", with_joint<Slide>([](Slide::Spec& s, double x) {
         s.motor = {{x, 1}};
       })},
      {"motor max_force", with_joint<Slide>([](Slide::Spec& s, double x) {
         s.motor = {{1, x}};
       }),
       not_positive},
  });
}

TEST_CASE("every number of a rod, a spring, a rope and a wheel is refused by name where it cannot be") {
  using Rod = DistanceJoint;
  using Rope = PulleyJoint;
  const auto spring = [](const std::function<void(SpringSoftness&, double)>& set) {
    return with_joint<Rod>([set](Rod::Spec& s, double x) {
      SpringSoftness softness{.stiffness = 1, .damping = 1};
      set(softness, x);
      s.kind = Rod::Kind::spring;
      s.softness = softness;
    });
  };
  check_fields({
      {"anchor_a", with_joint<Rod>([](Rod::Spec& s, double x) { s.anchor_a.x() = x; })},
      {"anchor_b", with_joint<Rod>([](Rod::Spec& s, double x) { s.anchor_b.y() = x; })},
      {"length", with_joint<Rod>([](Rod::Spec& s, double x) { s.length = x; }), {field_infinity, 0}},
      {"slack_margin", with_joint<Rod>([](Rod::Spec& s, double x) { s.slack_margin = x; }), negative},
      {"softness stiffness", spring([](SpringSoftness& s, double x) { s.stiffness = x; }), negative},
      {"softness damping", spring([](SpringSoftness& s, double x) { s.damping = x; }), negative},
      {"end anchor", with_joint<Rope>([](Rope::Spec& s, double x) { s.ends[0].anchor.x() = x; })},
      {"end roller", with_joint<Rope>([](Rope::Spec& s, double x) { s.ends[1].roller.y() = x; })},
      {"end parts", with_joint<Rope>([](Rope::Spec& s, double x) { s.ends[0].parts = x; }), not_positive},
      {"length", with_joint<Rope>([](Rope::Spec& s, double x) { s.length = x; }), {field_infinity, 0}},
      {"slack_margin", with_joint<Rope>([](Rope::Spec& s, double x) { s.slack_margin = x; }), negative},
      {"radius_a", with_joint<GearJoint>([](GearJoint::Spec& s, double x) { s.radius_a = x; }), not_positive},
      {"radius_b", with_joint<GearJoint>([](GearJoint::Spec& s, double x) { s.radius_b = x; }), not_positive},
  });
}

TEST_CASE("every number of a dragging spring and of friction on a table is refused by name") {
  using Drag = DragJoint;
  using Table = FrictionJoint;
  check_fields({
      {"anchor", with_joint<Drag>([](Drag::Spec& s, double x) { s.anchor.x() = x; })},
      {"target", with_joint<Drag>([](Drag::Spec& s, double x) { s.target.y() = x; })},
      {"max_force", with_joint<Drag>([](Drag::Spec& s, double x) { s.max_force = x; }), not_positive},
      {"softness frequency", with_joint<Drag>([](Drag::Spec& s, double x) {
         s.softness = SwingSoftness{x, 1};
       }),
       not_positive},
      {"softness damping_ratio", with_joint<Drag>([](Drag::Spec& s, double x) {
         s.softness = SwingSoftness{1, x};
       }),
       negative},
      {"anchor",
       with_joint<Table>([](Table::Spec& s, double x) { s.anchor = Vec2<double>(x, 0), s.max_force = 1; })},
      {"max_force", with_joint<Table>([](Table::Spec& s, double x) { s.max_force = x; }), negative},
      {"max_torque", with_joint<Table>([](Table::Spec& s, double x) { s.max_torque = x; }), negative},
  });
}

TEST_CASE("every number of a solver's settings is refused by name, whichever solver it is") {
  for (const SolverEntry& entry : solver_entries()) {
    CAPTURE(entry.name);
    const auto with_sweeps = [&](const std::function<void(SolverSettings&, double)>& set) {
      return [&entry, set](double value) {
        SolverSettings settings;
        set(settings, value);
        make_solver<double>(entry.name, settings);
      };
    };
    check_fields(
        {{"tolerance", with_sweeps([](SolverSettings& s, double x) { s.tolerance = x; }), negative},
         {"time_budget", with_sweeps([](SolverSettings& s, double x) { s.time_budget = x; }), negative},
         {"relaxation", with_sweeps([](SolverSettings& s, double x) { s.relaxation = x; }), {0, -1, 2}}});
    CHECK_THROWS_AS(make_solver<double>(entry.name, {.iterations = -1}), std::invalid_argument);
    CHECK_THROWS_AS(make_solver<double>(entry.name, {.patience = -1}), std::invalid_argument);
  }
}

TEST_CASE("bounds of a frozen row that only huge impulses keep are refused by name") {
  const auto of_problem = [](const std::function<void(VelocityProblem<double>&, double)>& set) {
    return [set](double value) {
      VelocityProblem<double> problem;
      problem.velocity = {{0, 0, 0}, {0, 0, 0}};
      problem.inverse_mass = {{0, 0, 0}, {1, 1, 1}};
      problem.rows.push_back({.a = ground, .b = {1}, .jacobian_b = {1, 0, 0}});
      problem.impulse = {0};
      problem.blocks = {{0, 1}};
      check(problem, "a test");  // is one, as it is
      set(problem, value);
      check(problem, "a test");
    };
  };
  check_fields({{"rows[0].bounds.lower",
                 of_problem([](auto& problem, double x) { problem.rows[0].bounds.lower = x; }),
                 {1e31, 1e308, field_infinity}},
                {"rows[0].bounds.upper",
                 of_problem([](auto& problem, double x) { problem.rows[0].bounds.upper = x; }),
                 {-1e31, -1e308, -field_infinity}}});
}

TEST_CASE("whoever gives a type another field is reminded of the tables above") {
  // These lines compile for as many fields as there are names.
  const auto& [gravity, fields, dt, substeps, stabilization, warm_start, search, margin, threshold, rows,
               mixing, impacts, sleeping] = SceneSettings{};
  const auto& [wind, water, attractions, gravitation] = fields;
  const auto& [level, water_density, water_drag, flow] = Water{};
  const auto& [point, strength, radius] = Attraction{};
  const auto& [policy, baumgarte, slop, max_speed, soft, joint_soft] = stabilization;
  const auto& [iterations, tolerance, budget, order, seed, relaxation, patience] = SolverSettings{};
  const auto& [type, shapes, position, angle, velocity, turning, mass, inertia, density, material, damping,
               scale, fixed, sensor, filter] = BodySpec{};
  const auto& [friction, held, rebound, rolling, running] = material;
  const auto& [drag, turning_drag, air_drag] = damping;
  const auto& [category, collides, one_way] = filter;
  CHECK(substeps == 1);
  CHECK_FALSE(max_speed);
  CHECK(iterations == 10);
  CHECK(patience == 0);
  CHECK(density == 1);
  CHECK(friction > rebound);
  CHECK(running == 0);
  CHECK(drag == turning_drag);
  CHECK(air_drag == rolling);
  CHECK(water_density > radius);
  CHECK(gravitation == strength);
  CHECK(category != collides);
}
