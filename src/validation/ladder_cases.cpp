// Floor 8. A ladder between a floor and a wall.
#include <fmt/format.h>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double ladder_length = 2;      // [m] L
const double ladder_floor_mu = 0.4;  // mu_f

/// The least angle with the floor [rad] at which a ladder stands, with this friction mu_w at the wall.
double least_ladder_angle(double wall_mu) {
  return std::atan((1 - ladder_floor_mu * wall_mu) / (2 * ladder_floor_mu));
}

/// A ladder of 1 kg at rest, its foot on the floor and its top at a wall on its left. Its own surface has
/// friction 1, so that the pair's is the square root of the other's.
Scene ladder_scene(double angle, double wall_mu) {
  Scene scene({.stabilization = {.slop = 1e-4}});
  scene.add_ground({.material = {.friction = ladder_floor_mu * ladder_floor_mu}});
  scene.add({.type = BodyType::static_body,
             .shapes = {box(1, 10)},
             .position = {-0.5, 5.5},
             .material = {.friction = wall_mu * wall_mu}});
  const double thickness = 1e-3;
  const double reach_x = (ladder_length * std::cos(angle) + thickness * std::sin(angle)) / 2;
  const double reach_y = (ladder_length * std::sin(angle) + thickness * std::cos(angle)) / 2;
  scene.add({.shapes = {box(ladder_length, thickness)},
             .position = {reach_x, reach_y},
             .angle = -angle,
             .mass = 1,
             .material = {.friction = 1}});
  return scene;
}

/// Whether one step from rest sets the ladder in motion.
bool ladder_slips(const SolverMaker<double>& make, double degrees, double wall_mu) {
  VelocityProblem<double> problem = World(ladder_scene(in_radians(degrees), wall_mu)).velocity_problem();
  make({.iterations = 2000})->solve(problem);
  return problem.velocity.back().cwiseAbs().maxCoeff() > 1e-6 * standard_gravity * standard_dt;
}

/// The way [m] of the ladder's centre in this long [s].
double ladder_way(double angle, double wall_mu, double seconds) {
  const Scene scene = ladder_scene(angle, wall_mu);
  const Snapshot end = run_scene(cairn_engine(), scene, 1000, seconds);
  return end.bodies.back().pose.position.x() - scene.bodies().back().pose.position.x();
}

/// How far a ladder of 1 kg that slips is from balance about its centre [N m], if its angle (that of a line,
/// decreasing) has the rate w [rad/s] and the acceleration a [rad/s^2]: floor N and mu_f N, wall W and mu_w
/// W.
double ladder_imbalance(double angle, double w, double a, double wall_mu) {
  const double s = std::sin(angle), c = std::cos(angle), half = ladder_length / 2;
  const double x = -half * (s * a + c * w * w), y = half * (c * a - s * w * w);  // of the centre [m/s^2]
  const double N = (y + standard_gravity - wall_mu * x) / (1 + ladder_floor_mu * wall_mu);
  const double W = x + ladder_floor_mu * N;
  const double torque = half * (c * N - s * ladder_floor_mu * N - s * W - c * wall_mu * W);
  return torque + ladder_length * ladder_length / 12 * a;
}

double ladder_acceleration(double angle, double w, double wall_mu) {
  const double at_0 = ladder_imbalance(angle, w, 0, wall_mu), at_1 = ladder_imbalance(angle, w, 1, wall_mu);
  return at_0 / (at_0 - at_1);  // the imbalance is linear in it
}

/// The way that follows from Newton's law, with steps of 0.1 ms by the midpoint rule: good to 1e-6 of it.
double ideal_ladder_way(double start, double wall_mu, double seconds) {
  const double h = 1e-4;
  double angle = start, w = 0;
  for (double t = 0; t < seconds - h / 2; t += h) {
    const double middle_w = w + h / 2 * ladder_acceleration(angle, w, wall_mu);
    const double a = ladder_acceleration(angle + h / 2 * w, middle_w, wall_mu);
    angle += h * middle_w;
    w += h * a;
  }
  return ladder_length / 2 * (std::cos(angle) - std::cos(start));
}

void add_ladder_numbers(List<Measured>& numbers, double wall_mu) {
  const double least = in_degrees(least_ladder_angle(wall_mu));
  List<double> stands, slips;
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    const Bracket found = bisected({least + 3, least - 3}, 0.001,
                                   [&](double degrees) { return ladder_slips(make, degrees, wall_mu); });
    stands.push_back(found.before);
    slips.push_back(found.after);
  }
  add_bracket(
      numbers,
      {.what = fmt::format("least angle, mu_w = {}, worst of SI and PGS: ", wall_mu),
       .formula = "tan = (1 - mu_f mu_w)/(2 mu_f)",
       .unit = "degrees",
       .expected = least,
       .tolerance = 0.022,
       .reason = "its centre is L/4000 above the edge that it stands on: up to 0.020 degrees; bisected"},
      {farthest(least, stands), farthest(least, slips)}, "it stands", "it slips");
  numbers.push_back(measured(fmt::format("way in 2 s, 0.3 degrees above the least angle, mu_w = {}", wall_mu),
                             ladder_way(in_radians(least + 0.3), wall_mu, 2), "m")
                        .zero_within(2e-4, "two contacts may sink by the slop of 1e-4 m"));
  const double ideal = ideal_ladder_way(in_radians(least - 0.3), wall_mu, 1);
  numbers.push_back(
      measured(fmt::format("way in 1 s, 0.3 degrees below the least angle, mu_w = {}", wall_mu),
               ladder_way(in_radians(least - 0.3), wall_mu, 1), "m")
          .by("Newton's law, integrated", ideal)
          .within(0.09 * ideal, "its edge shifts the 0.3 degrees by up to 0.020, and t (t + dt) is for t^2"));
}

// Floor: N up, mu_f N towards the wall; wall: W, mu_w W up. W = mu_f N, N + mu_w W = m g, and moments about
// the foot: W sin + mu_w W cos = m g cos / 2.
ValidationResult ladder(const EngineMaker&) {
  ValidationResult result;
  for (const double wall_mu : {0.0, 0.3}) add_ladder_numbers(result.numbers, wall_mu);
  return result;
}

}  // namespace

void add_ladder_cases(ValidationCases& cases) {
  cases.push_back({.id = "B12",
                   .title = "A ladder at a wall stands down to tan(angle) = (1 - mu_f mu_w) / (2 mu_f)",
                   .run = ladder});
}

}  // namespace cairn
