// Floor 8. What fields and forces do to bodies, and where paths lead them.
#include <cmath>

#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const char* const exact_sums = "the sums are exact but for their rounding";

Scene forced_box(double frequency, const ApplyForce& pull, double begin) {
  Scene scene({.gravity = {0, 0}, .dt = 1 / frequency});
  scene.add({.shapes = {box(1, 1)}, .mass = 2, .inertia = 0.5});
  scene.add({.time = begin, .action = pull});
  return scene;
}

// A step that a force begins or ends in has its share of it, so that F T is whole.
ValidationResult force(const EngineMaker& make) {
  const double newton = 4, seconds = 0.52;
  const ApplyForce pull{.body = {1}, .force = {newton, 0}, .torque = 0.25, .seconds = seconds};
  ValidationResult result;
  const Snapshot end = run_scene(make, forced_box(60, pull, 0.505), 1, 2);
  const Vec3<double>& velocity = end.bodies.back().velocity;
  result.add(measured("speed after a force that begins and ends within steps", velocity.x(), "m/s")
                 .by("F T/m", newton * seconds / 2)
                 .within(1e-13, exact_sums));
  result.add(measured("turning after its torque", velocity.z(), "rad/s")
                 .by("M T/I", 0.25 * seconds / 0.5)
                 .within(1e-13, exact_sums));
  const ApplyForce always{.body = {1}, .force = {newton, 0}};
  const auto way = [&](double frequency) {
    return run_scene(make, forced_box(frequency, always, 0), 1, 2).bodies.back().pose.position.x();
  };
  result.add(measured("way in 2 s at 60 Hz", way(60), "m")
                 .by("F t (t + dt)/(2 m)", newton * 2 * (2 + standard_dt) / 4)
                 .within(1e-12, exact_sums));
  // A body that turns once in 60 steps: forces that turn with it add up to nothing.
  Scene spun = forced_box(60, {.body = {1}, .force = {newton, 0}, .turns = true}, 0);
  spun.place({1}, {}, {0, 0, 2 * pi});
  result.add(measured("speed after a turn, of a thrust that turns with its body",
                      run_scene(make, spun, 1, 1).bodies.back().velocity.head<2>().norm(), "m/s")
                 .zero_within(1e-13, exact_sums));
  result.convergence =
      converges("way in 2 s, to F t^2/(2 m)", [&](double frequency) { return way(frequency) - newton; });
  return result;
}

const double drag = 0.5;       // [kg/m] k
const double drag_mass = 2;    // [kg]
const double drag_speed = 12;  // [m/s] v0

Scene in_air(double frequency, const Vec2<double>& gravity, const Vec2<double>& wind,
             const Vec2<double>& velocity) {
  Scene scene({.gravity = gravity, .fields = {.wind = wind}, .dt = 1 / frequency});
  scene.add(
      {.shapes = {circle(0.5)}, .velocity = velocity, .mass = drag_mass, .damping = {.quadratic = drag}});
  return scene;
}

// u = v - wind becomes u / (1 + h k u/m) in a step of h, which is where dv/dt = -(k/m) u^2 leads to. In a
// fall u = v + g h is what becomes v again: u - g h = u / (1 + h k u/m), so (k/m) u^2 = g (1 + h k u/m).
ValidationResult air(const EngineMaker& make) {
  const double seconds = 3, rate = drag / drag_mass;
  ValidationResult result;
  const double slowed = drag_speed / (1 + rate * drag_speed * seconds);
  const auto x_speed = [&](const Vec2<double>& wind, double speed) {
    return run_scene(make, in_air(60, {0, 0}, wind, {speed, 0}), 1, seconds).bodies.back().velocity.x();
  };
  result.add(measured("speed after 3 s in air at rest", x_speed({0, 0}, drag_speed), "m/s")
                 .by("v0/(1 + k v0 t/m)", slowed)
                 .within(1e-12, exact_sums));
  result.add(measured("speed after 3 s in a wind of v0, begun at rest", x_speed({drag_speed, 0}, 0), "m/s")
                 .by("v0 - v0/(1 + k v0 t/m)", drag_speed - slowed)
                 .within(1e-12, exact_sums));
  const auto last_speed = [&](double frequency) {
    const Snapshot end = run_scene(make, in_air(frequency, {0, -standard_gravity}, {0, 0}, {0, 0}), 1, 20);
    return -end.bodies.back().velocity.y();
  };
  const double share = standard_gravity * standard_dt * rate;
  const double with_gravity = (share + std::sqrt(share * share + 4 * standard_gravity * rate)) / (2 * rate);
  result.add(
      measured("last speed of a fall at 60 Hz", last_speed(60), "m/s")
          .by("u - g dt, where k u^2/m = g (1 + dt k u/m)", with_gravity - standard_gravity * standard_dt)
          .within(1e-12, "it comes nearer by exp(-2 g t/v), 1e-27 after 20 s; rounding"));
  const double ideal = std::sqrt(standard_gravity / rate);
  result.convergence = converges("last speed of a fall, to sqrt(m g/k)",
                                 [&](double frequency) { return last_speed(frequency) - ideal; });
  return result;
}

const double box_density = 0.4;  // of that of the water, which is 1 kg/m^2

Scene floating(double frequency, double water_drag, double height, const Shape<double>& shape,
               double density) {
  Scene scene({.fields = {.water = Water{.drag = water_drag}}, .dt = 1 / frequency});
  scene.add({.shapes = {shape}, .position = {0, height}, .density = density});
  return scene;
}

// Half of a first kick, then whole ones: y after n steps is y0 cos(n q) with 1 - cos q = (w dt)^2 / 2.
ValidationResult water(const EngineMaker& make) {
  ValidationResult result;
  const double rest = 0.5 - box_density;
  const auto height = [&](double water_drag, double begin, const Shape<double>& shape, double density,
                          double t) {
    return run_scene(make, floating(60, water_drag, begin, shape, density), 1, t)
        .bodies.back()
        .pose.position.y();
  };
  const std::string slowed = "e^(-drag t/2), 1e-17 after 20 s; rounding";
  result.add(measured("height of a box of 1 m, 0.4 times as dense as the water",
                      height(4, 0.3, box(1, 1), box_density, 20), "m")
                 .by("1/2 - 0.4", rest)
                 .within(1e-13, slowed));
  result.add(
      measured("height of a disc half as dense as the water", height(4, 0.2, circle(0.5), 0.5, 20), "m")
          .zero_within(1e-13, slowed));
  const double begin = 0.1, square = standard_gravity / box_density;  // w^2 = rho g width / m
  const double turn = std::acos(1 - square * standard_dt * standard_dt / 2);
  result.add(measured("height of the box after 1 s, 0.1 m above its rest at first",
                      height(0, rest + begin, box(1, 1), box_density, 1), "m")
                 .by("y0 cos(n q), 1 - cos q = (w dt)^2/2, w^2 = rho g/m", rest + begin * std::cos(60 * turn))
                 .within(1e-12, exact_sums));
  result.convergence = converges(
      "height after 1 s, to y0 cos(w t)",
      [&](double frequency) {
        const Snapshot end =
            run_scene(make, floating(frequency, 0, rest + begin, box(1, 1), box_density), 1, 1);
        return end.bodies.back().pose.position.y() - rest - begin * std::cos(std::sqrt(square));
      },
      1.8, 2.2);
  return result;
}

const double orbit_radius = 10;                   // [m]
const double star_strength = 1000 * pi * pi * 4;  // [m^3/s^2]: a turn takes 1 s

Scene circling(double frequency) {
  Scene scene(
      {.gravity = {0, 0}, .fields = {.attractions = {{.strength = star_strength}}}, .dt = 1 / frequency});
  scene.add({.shapes = {circle(0.1)}, .position = {orbit_radius, 0}, .velocity = {0, 2 * pi * orbit_radius}});
  return scene;
}

/// G (m_a + m_b) = strength: they turn around each other in 1 s, too.
Scene two_stars(double frequency) {
  const double heavy = 3, light = 1, speed = 2 * pi * orbit_radius;
  Scene scene(
      {.gravity = {0, 0}, .fields = {.gravitation = star_strength / (heavy + light)}, .dt = 1 / frequency});
  scene.add({.shapes = {circle(0.1)},
             .position = {-orbit_radius / 4, 0},
             .velocity = {0, -speed / 4},
             .mass = heavy});
  scene.add({.shapes = {circle(0.1)},
             .position = {orbit_radius * 3 / 4, 0},
             .velocity = {0, speed * 3 / 4},
             .mass = light});
  return scene;
}

// Leapfrog goes round by 2 asin(w dt/2) a step, (w dt)^2/24 of it too far, where the speed is (w dt)^2/8
// less. So the orbit is wider, and its period longer by three times that: it lags by (3/8 - 1/24) (w dt)^2 of
// the way.
ValidationResult orbit(const EngineMaker& make) {
  ValidationResult result;
  const double angle = 2 * pi / 1000, lag = 20 * pi * angle * angle / 3;
  const std::string formula = "20 pi (w dt)^2/3", reason = "a thousandth: the next order is 4e-5 of it";
  const auto off = [](const Snapshot& end, BodyId body, double x) {
    return (end.bodies[body].pose.position - Vec2<double>(x, 0)).norm();
  };
  const Snapshot round = run_scene(make, circling(1000), 1, 10),
                 pair = run_scene(make, two_stars(1000), 1, 10);
  result.add(measured("how far open a circle of a radius of 1 is after ten turns",
                      off(round, {1}, orbit_radius) / orbit_radius)
                 .by(formula, lag)
                 .within_share(1e-3, reason));
  result.add(measured("the same of two bodies that attract each other",
                      off(pair, {2}, orbit_radius * 3 / 4) / orbit_radius)
                 .by("3/4 of that", 0.75 * lag)
                 .within_share(1e-3, reason));
  const SnapshotBody& body = round.bodies.back();
  result.add(measured("angular momentum for each kilogram after ten turns",
                      cross<double>(body.pose.position, body.velocity.head<2>()), "m^2/s")
                 .by("r v", 2 * pi * orbit_radius * orbit_radius)
                 .within(1e-9, "no kick along r changes it; rounding of 10,000 steps"));
  result.convergence = converges(
      "place after a turn",
      [&](double frequency) { return off(run_scene(make, circling(frequency), 1, 1), {1}, orbit_radius); },
      1.8, 2.2);
  return result;
}

const double lift_speed = 1.5;  // [m/s]

Scene on_lift(double frequency) {
  Scene scene({.dt = 1 / frequency});
  const Material rough{.friction = 0.6};
  const BodyId lift = scene.add({.type = BodyType::kinematic, .shapes = {box(6, 0.4)}, .material = rough});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.7}, .material = rough});
  const FollowPath path{
      .body = lift, .points = {{0, 0}, {1.5, 0}}, .speed = lift_speed, .kind = PathKind::to_and_fro};
  scene.add({.time = 0, .action = path});
  return scene;
}

// The box gains mu g dt a step, and goes as far as the speed that it has then: v dt/2 less behind.
ValidationResult path(const EngineMaker& make) {
  ValidationResult result;
  const double ideal = lift_speed * lift_speed / (2 * 0.6 * standard_gravity);
  const auto lag = [&](double frequency) {
    const Snapshot half = run_scene(make, on_lift(frequency), 50, 0.5);
    return half.bodies[{1}].pose.position.x() - half.bodies[{2}].pose.position.x();
  };
  result.add(measured("place of a shuttle after 3.5 s, to and fro on 1.5 m",
                      run_scene(make, on_lift(60), 50, 3.5).bodies[{1}].pose.position.x(), "m")
                 .by("v (4 T - t)", lift_speed * (4 - 3.5))
                 .within(1e-12, exact_sums));
  result.add(measured("how far a box is behind it once it keeps up", lag(60), "m")
                 .by("v^2/(2 mu g) - v dt/2", ideal - lift_speed * standard_dt / 2)
                 .within(1e-9, "50 sweeps of a contact at two points leave rounding"));
  result.convergence =
      converges("the same, to v^2/(2 mu g)", [&](double frequency) { return lag(frequency) - ideal; });
  return result;
}

}  // namespace

void add_field_cases(ValidationCases& cases) {
  const auto add = [&cases](const char* id, const char* title, ValidationResult (*run)(const EngineMaker&)) {
    cases.push_back({.id = id, .title = title, .asks = Asks::any_engine, .run = run});
  };
  add("B50", "A force F for a time T gives a speed of F T / m, whether steps divide T or not", force);
  add("B51", "Drag in air leaves v0 / (1 + k v0 t / m), and of a fall sqrt(m g / k)", air);
  add("B52", "A body in water displaces its weight, and bobs about it", water);
  add("B53", "A circle around a point that attracts closes, and so does that of two bodies", orbit);
  add("B54", "What stands on a platform that sets off at v slips v^2 / (2 mu g)", path);
}

}  // namespace cairn
