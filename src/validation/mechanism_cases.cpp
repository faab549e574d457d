// Floor 8. Mechanisms, against the geometry that they are made for: B21 and B22.
#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double mechanism_beta = 0.2;

/// The error that remains where a step turns an arm a little past where its tangent goes: a point that has
/// the acceleration a [m/s^2] across a row is a dt^2 / 2 off after a step, and beta of the error goes in one.
double steady_drift(double acceleration, double dt) { return acceleration * dt * dt / (2 * mechanism_beta); }

const double crank_radius = 0.3;    // [m] r
const double crank_rod = 1;         // [m] l
const double crank_speed = 2 * pi;  // [rad/s] w

/// Bodies 1 to 3: a crank that turns at w around the origin, a rod, and a slider on the x axis.
Scene slider_crank(double frequency) {
  Scene scene({.dt = 1 / frequency,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = mechanism_beta}});
  const double r = crank_radius, l = crank_rod;
  const BodyId crank = scene.add({.type = BodyType::kinematic, .angular_velocity = crank_speed});
  const BodyId rod = scene.add({.position = {r + l / 2, 0}, .mass = 1, .inertia = l * l / 12});
  const BodyId slider = scene.add({.position = {r + l, 0}, .mass = 2, .inertia = 0.1});
  scene.join<RevoluteJoint>({.a = crank, .b = rod, .anchor = {r, 0}});
  scene.join<RevoluteJoint>({.a = rod, .b = slider, .anchor = {r + l, 0}});
  scene.join<PrismaticJoint>({.a = ground, .b = slider, .anchor = {r + l, 0}, .axis = {1, 0}});
  return scene;
}

/// Cairn with accelerated sweeps until the residual is 1e-9 m/s: plain ones would need thousands.
EngineMaker swept_until_solved() {
  return engine_of([](const SolverSettings& settings) {
    SolverSettings all = settings;
    all.tolerance = 1e-9;
    return std::make_unique<AcceleratedProjectedGaussSeidel<double>>(all);
  });
}

/// How far the slider is from r cos f + sqrt(l^2 - r^2 sin^2 f) at most, in two turns of the crank [m].
double slider_error(double frequency) {
  Motion engine(swept_until_solved(), slider_crank(frequency), 1000);
  double largest = 0;
  const int steps = static_cast<int>(std::lround(2 * frequency));
  for (int step = 0; step < steps; ++step) {
    engine.step();
    const double f = engine.angle({1}), r = crank_radius, l = crank_rod;
    const double expected = r * std::cos(f) + std::sqrt(l * l - std::pow(r * std::sin(f), 2));
    largest = std::max(largest, std::abs(engine.position({3}).x() - expected));
  }
  return largest;
}

ValidationResult slider_on_its_axis(const EngineMaker&) {
  ValidationResult result;
  result.convergence = converges("slider of a slider-crank", slider_error, 1.8, 2.2);
  // The crank's end has r w^2 and the rod turns at up to r w / l, so that l (r w / l)^2 comes on top; an
  // error of the rod counts 1 / cos of its slope, of which the sine is up to r / l.
  const double r = crank_radius, l = crank_rod;
  const double acceleration = (r + r * r / l) * crank_speed * crank_speed;
  const double slope_cosine = std::sqrt(1 - r * r / (l * l));
  for (int i = 0; i < result.convergence->dt.size(); ++i) {
    const double dt = result.convergence->dt[i];
    result.add(measured("slider's drift at " + std::to_string(std::lround(1 / dt)) + " Hz, most in two turns",
                        result.convergence->error[i], "m")
                   .by("x = r cos f + sqrt(l^2 - r^2 sin^2 f)", 0)
                   .within(steady_drift(acceleration, dt) / slope_cosine,
                           "(r + r^2/l) w^2 dt^2/(2 beta), over cos of the rod's slope"));
  }
  return result;
}

/// Peaucellier's inversor: two long bars from the origin to a and b, and four short ones that make the
/// rhombus q a r b. q goes around a circle through the origin, and r then stays on a straight line.
struct Inversor {
  double arm = 2.5;                                                         // [m]
  double side = 1.5;                                                        // [m]
  double circle = 0.7;                                                      // [m] radius
  double line() const { return (arm * arm - side * side) / (2 * circle); }  // x [m]
  Vec2<double> q(double angle) const { return {circle * (1 + std::cos(angle)), circle * std::sin(angle)}; }
  /// r, where q has gone around by the angle: the directions of q and r are half of it.
  Vec2<double> r(double angle) const { return {line(), line() * std::tan(angle / 2)}; }
};

/// The point at distances `first` from p and `second` from q, to the left of the way from p to q.
Vec2<double> meeting_point(const Vec2<double>& p, double first, const Vec2<double>& q, double second) {
  const Vec2<double> way = q - p;
  const double d = way.norm();
  const double along = (d * d + first * first - second * second) / (2 * d);
  return p + way * (along / d) + perpendicular<double>(way) * (std::sqrt(first * first - along * along) / d);
}

struct InversorScene {
  Scene scene;
  BodyId crank = {};  // with q at its end
  BodyId r = {};
};

/// The crank starts at -60 degrees and turns at 1 rad/s.
InversorScene inversor_scene(const Inversor& inversor, double frequency) {
  Scene scene({.gravity = {0, 0},
               .dt = 1 / frequency,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = mechanism_beta}});
  const double start = -pi / 3, s = inversor.side;
  const Vec2<double> q = inversor.q(start), r = inversor.r(start), o(0, 0);
  const Vec2<double> a = meeting_point(o, inversor.arm, q, s), b = meeting_point(q, s, o, inversor.arm);
  const BodyId crank = scene.add(
      {.type = BodyType::kinematic, .position = {inversor.circle, 0}, .angle = start, .angular_velocity = 1});
  const auto bead = [&scene](const Vec2<double>& place) {
    return scene.add({.position = place, .mass = 1, .fixed_rotation = true});
  };
  const BodyId body_a = bead(a), body_b = bead(b), body_r = bead(r);
  const auto bar = [&scene](BodyId first, const Vec2<double>& from, BodyId second, const Vec2<double>& to) {
    scene.join<DistanceJoint>({.a = first, .b = second, .anchor_a = from, .anchor_b = to});
  };
  bar(ground, o, body_a, a);
  bar(ground, o, body_b, b);
  bar(crank, q, body_a, a);
  bar(crank, q, body_b, b);
  bar(body_a, a, body_r, r);
  bar(body_b, b, body_r, r);
  return {scene, crank, body_r};
}

struct InversorError {
  double across = 0;    // [m] from the line, the most
  double along = 0;     // [m] from where r should be on it, at the end
  double expected = 0;  // [m] of along
};

/// While the crank turns from -60 to 60 degrees.
InversorError inversor_error(const EngineMaker& make, double frequency) {
  const Inversor inversor;
  const InversorScene made = inversor_scene(inversor, frequency);
  Motion motion(make, made.scene, 200);  // the cold first step needs about that many
  InversorError result;
  const int steps = static_cast<int>(std::lround(2 * pi / 3 * frequency));
  for (int step = 0; step < steps; ++step) {
    motion.step();
    const double angle = motion.angle(made.crank);
    const Vec2<double> error = motion.position(made.r) - inversor.r(angle);
    result.across = std::max(result.across, std::abs(error.x()));
    result.along = error.y();
    // The second derivative of tan(t / 2).
    const double t = std::tan(angle / 2);
    result.expected = -steady_drift(inversor.line() * (1 + t * t) * t / 2, 1 / frequency);
  }
  return result;
}

ValidationResult straight_line(const EngineMaker& make) {
  ValidationResult result;
  // Along an exact motion d^2 C / dt^2 = j a + v H v = 0. A step adds v H v dt^2 / 2 to C and takes beta C,
  // so that C = -j a dt^2 / (2 beta): every point is off by -a dt^2 / (2 beta), and on a line a lies along
  // it. C follows 1 / beta - 1/2 = 4.5 steps late, which leaves another order of dt across.
  result.convergence = converges(
      "distance of Peaucellier's point from its line",
      [&make](double frequency) { return inversor_error(make, frequency).across; }, 2.8, 3.2);
  for (const double frequency : {240.0, 480.0}) {
    const InversorError got = inversor_error(make, frequency);
    const std::string when = " at " + std::to_string(std::lround(frequency)) + " Hz";
    result.add(measured("off the line at most, in 120 degrees of the crank" + when, got.across, "m")
                   .by("x = (L^2 - s^2)/(2 c)", 0)
                   .within(1.5 * 4.5 * std::sqrt(3.0) / frequency * std::abs(got.expected),
                           "1.5 times 4.5 steps of the growth of the drift along it, sqrt 3 a second"));
    // At 60 degrees a grows by sqrt(3) of itself a second.
    result.add(measured("drift along the line at 60 degrees" + when, got.along, "m")
                   .by("-a dt^2/(2 beta)", got.expected)
                   .within(1.5 * 4.5 * std::sqrt(3.0) / frequency * std::abs(got.expected),
                           "1.5 times 4.5 steps that the drift is late, growing by sqrt 3 a second"));
  }
  return result;
}

}  // namespace

void add_mechanism_cases(ValidationCases& cases) {
  cases.push_back({.id = "B21",
                   .title = "A slider-crank's slider is where the crank puts it, with a drift of order dt^2",
                   .run = slider_on_its_axis});
  cases.push_back({.id = "B22",
                   .title = "Peaucellier's seven bars turn a circle into a straight line",
                   .source = "C.-N. Peaucellier, 1864; drift derived",
                   .asks = Asks::any_engine,
                   .run = straight_line});
}

}  // namespace cairn
