// Floor 8. One step that decides everything: sliding feet, impacts, rows in a line.
#include <algorithm>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

// A11. Friction mu m g dt at the ground, h below the centre, turns the box forward; b is half its width.
ValidationResult sliding_feet(const EngineMaker&) {
  const double b = 1, h = 0.5, fall = standard_gravity * standard_dt;
  const std::string any = ": worst of mu = 0, 0.1, 0.4 and of 5 solvers";
  const std::string reason = "each sweep leaves less than half of the error, 1000 only rounding: 1e-12 of it";
  Worst rear = Worst("impulse of the rear foot" + any, "N s").by("m g dt (1 - mu h/b) / 2").since(reason);
  Worst front = Worst("impulse of the front foot" + any, "N s").by("m g dt (1 + mu h/b) / 2").since(reason);
  Worst friction = Worst("friction of both feet" + any, "N s").by("-mu m g dt").since(reason);
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {0.0, 0.1, 0.4}) {
      VelocityProblem<double> problem = empty_problem<double>();
      const BodyId box = add_body<double>(problem, 1, (4 * b * b + 4 * h * h) / 12, {5, -fall, 0});
      for (const double x : {-b, b}) {
        const int normal = add_row(problem, floor_row(box, x));
        add_row(problem, floor_friction_row(box, -h, mu, normal));
      }
      make({.iterations = 1000})->solve(problem);
      rear.add(fall / 2 * (1 - mu * h / b), problem.impulse[0], 1e-12 * fall);
      front.add(fall / 2 * (1 + mu * h / b), problem.impulse[2], 1e-12 * fall);
      friction.add(-mu * fall, problem.impulse[1] + problem.impulse[3], 1e-12 * fall);
    }
  }
  return {.numbers = {rear.number(), front.number(), friction.number()}};
}

// A11, in a world, after half a second.
ValidationResult sliding_feet_of_a_box(const EngineMaker& make) {
  Scene scene;
  scene.add_ground({.material = {.friction = 0.4}});
  scene.add({.shapes = {box(2, 1)},
             .position = {0, 0.5},
             .velocity = {5, 0},
             .mass = 1,
             .material = {.friction = 0.4}});
  const Snapshot now = run_scene(make, scene, 100, 0.5);
  double rear = 0, front = 0;
  for (const SnapshotContact& contact : now.contacts) {
    const bool is_front = contact.position.x() > now.bodies[{1}].pose.position.x();
    (is_front ? front : rear) += contact.normal_impulse;
  }
  const double weight = standard_gravity * standard_dt;
  const std::string reason = "1e-9 of the weight: the arms of the feet change by rounding in each step";
  return {.numbers = {measured("impulse of the rear foot, h/b = 1/2, mu = 0.4", rear, "N s")
                          .by("m g dt (1 - mu h/b) / 2", 0.4 * weight)
                          .within(1e-9 * weight, reason),
                      measured("impulse of the front foot, h/b = 1/2, mu = 0.4", front, "N s")
                          .by("m g dt (1 + mu h/b) / 2", 0.6 * weight)
                          .within(1e-9 * weight, reason)}};
}

/// One step of n discs of radius 0.5 m and mass 1 kg in a row, touching, without gravity, of which the first
/// moves to the right at 1 m/s.
Snapshot struck_row_of_discs(const EngineMaker& make, int n) {
  Scene scene({.gravity = {0, 0}, .restitution_threshold = 0});
  for (int i = 0; i < n; ++i) {
    scene.add({.shapes = {circle(0.5)},
               .position = {static_cast<double>(i), 0},
               .velocity = {i == 0 ? 1.0 : 0.0, 0},
               .mass = 1,
               .material = {.friction = 0, .restitution = 1}});
  }
  // cos^2(pi / n) a sweep: for n = 5 that is 0.65, and 0.65^200 = 1e-37 leaves rounding only.
  return run_scene(make, scene, 200, standard_dt);
}

/// What the disc i of n moves at: all but the first contact keep their bodies together, as none of them
/// approach, and the first one parts them at 1 m/s.
double struck_disc_speed(int n, int i) { return i == 0 ? 2.0 / n - 1 : 2.0 / n; }

// A12
ValidationResult row_of_discs(const EngineMaker&) {
  const std::string any = ": worst of n = 2, 3, 5 and of 5 solvers";
  Worst speed = Worst("speed of a disc" + any, "m/s")
                    .by("2v/n - v for the first, 2v/n for the others")
                    .since("64 epsilon, each of which lives 1 / (1 - 0.655) sweeps");
  Worst energy = Worst("energy after the impact, over before" + any)
                     .by("1")
                     .since("the squares of five such speeds: below 1e-12");
  for (const EngineMaker& make : gauss_seidel_engines()) {
    for (const int n : {2, 3, 5}) {
      const Snapshot after = struck_row_of_discs(make, n);
      double squares = 0;
      for (int i = 0; i < n; ++i) {
        const double v = after.bodies[{i + 1}].velocity.x();
        speed.add(struck_disc_speed(n, i), v, 64 * double_epsilon / (1 - 0.655));
        squares += v * v;
      }
      energy.add(1, squares, 1e-12);
    }
  }
  return {.numbers = {speed.number(), energy.number()}};
}

// A12
ValidationResult row_of_five_discs(const EngineMaker& make) {
  const Snapshot after = struck_row_of_discs(make, 5);
  ValidationResult result;
  for (int i = 0; i < 5; ++i) {
    result.add(measured("speed of disc " + std::to_string(i + 1) + " of 5",
                        after.bodies[{i + 1}].velocity.x(), "m/s")
                   .by(i == 0 ? "2v/n - v" : "2v/n", struck_disc_speed(5, i))
                   .within(64 * double_epsilon / (1 - 0.655),
                           "64 epsilon, each of which lives 1 / (1 - 0.655) sweeps"));
  }
  return result;
}

// Of the disc that hits the ground aslant.
const double glance_fall = 4;                         // [m/s] v_n
const double glance_mu = 0.5, glance_e = 0.5;         // friction, restitution
const double glance_radius = 0.4;                     // [m]
const List<double> glance_speeds = {3.0, 6.0, 12.0};  // [m/s] u: it grips, just grips, slips

/// How much of u friction takes: a third if it can, when the disc rolls off.
double glance_change(double u) { return std::min(u / 3, glance_mu * (1 + glance_e) * glance_fall); }

/// The numbers of a bounce to the right at u [m/s].
void add_glance(double u, const Vec3<double>& velocity, const std::string& about, double tolerance,
                ValidationResult& result) {
  const std::string at = "at u = " + std::to_string(std::lround(u)) + " m/s" + about;
  const std::string limit = " min(u/3, mu (1+e) v_n)";
  const std::string reason = "the rows do not act on each other: rounding of 12 m/s";
  result.add(measured("speed " + at, velocity.x(), "m/s")
                 .by("u -" + limit, u - glance_change(u))
                 .within(tolerance, reason));
  result.add(measured("spin " + at, velocity.z(), "rad/s")
                 .by("-2/R" + limit, -2 * glance_change(u) / glance_radius)
                 .within(tolerance / glance_radius, reason));
  result.add(measured("rise " + at, velocity.y(), "m/s")
                 .by("e v_n", glance_e * glance_fall)
                 .within(tolerance, reason));
}

// A14. The contact point of a disc without spin slides at u. An impulse P of friction takes P/m off the speed
// and 3 P/m off the sliding; P is at most mu (1 + e) m v_n.
ValidationResult glance_of_a_disc(const EngineMaker&) {
  ValidationResult result;
  for (const double u : glance_speeds) {
    Vec3<double> worst = {0, 0, 0};
    double largest = -1;
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      VelocityProblem<double> problem = empty_problem<double>();
      const BodyId disc = add_body<double>(problem, 2, glance_radius * glance_radius, {u, -glance_fall, 0});
      ConstraintRow<double> normal = floor_row<double>(disc, 0);
      normal.bias = glance_e * glance_fall;
      const int place = add_row(problem, normal);
      add_row(problem, floor_friction_row(disc, -glance_radius, glance_mu, place));
      make({.iterations = 1})->solve(problem);
      const Vec3<double> expected(u - glance_change(u), glance_e * glance_fall,
                                  -2 * glance_change(u) / glance_radius);
      const double error = (problem.velocity[{1}] - expected).norm();
      if (error <= largest) continue;
      largest = error;
      worst = problem.velocity[{1}];
    }
    add_glance(u, worst, ": worst of 5 solvers", 16 * double_epsilon * 12, result);
  }
  return result;
}

// A14, in a world.
ValidationResult glance_in_a_world(const EngineMaker& make) {
  ValidationResult result;
  for (const double u : glance_speeds) {
    Scene scene({.gravity = {0, 0}});
    scene.add_ground({.material = {.friction = glance_mu}});
    // It touches where the step begins: a gap C would change the arm of friction to R + C / 2.
    scene.add({.shapes = {circle(glance_radius)},
               .position = {0, glance_radius},
               .velocity = {u, -glance_fall},
               .material = {.friction = glance_mu, .restitution = glance_e}});
    const Snapshot end = run_scene(make, scene, 10, 0.25);  // it leaves in the first step, and flies on
    add_glance(u, end.bodies[{1}].velocity, "", 1e-12 * 12, result);
  }
  return result;
}

}  // namespace

void add_impact_cases(ValidationCases& cases) {
  cases.push_back({"A11", "A sliding box has (1 + mu h / b) / 2 of its weight on its front foot", "statics",
                   Asks::cairn, sliding_feet});
  cases.push_back({"A11b", "A box that slides through a world has 0.6 of its weight on its front foot",
                   "statics", Asks::any_engine, sliding_feet_of_a_box});
  cases.push_back({"A12",
                   "Of n elastic discs in a row, all but the one that struck leave with 2 / n of its speed",
                   "derived", Asks::cairn, row_of_discs});
  cases.push_back({"A12b", "An elastic disc that hits four in a row flies back at 3/5 of its speed",
                   "derived", Asks::any_engine, row_of_five_discs});
  cases.push_back(
      {"A14", "A disc that hits the ground without spin rolls off if u <= 3 mu (1 + e) v_n, and else slips",
       "R. L. Garwin, 1969", Asks::cairn, glance_of_a_disc});
  cases.push_back({"A14b",
                   "In a world a disc bounces with the speed and the spin that one step of algebra gives",
                   "R. L. Garwin, 1969", Asks::any_engine, glance_in_a_world});
}

}  // namespace cairn
