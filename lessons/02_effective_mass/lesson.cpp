// Lesson 02. One row, one push. A row knows in which direction it may push, j, and what it wants, j·v = ζ.
// How hard it has to push depends on the effective mass, 1 / (j M⁻¹ jᵀ). That is not simply a mass, because a
// body that is pushed off-centre also turns. With that number one push puts the row right: (19)-(23).
// A box falls on a peg at three places; we push by hand, and let the library's solver push.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::one_push;

constexpr double peg_radius = 0.1;  // [m]

/// The box with its underside at y = 0, upon the top of a peg at x. A peg without mass cannot be moved.
Scene peg_scene(const PegSettings& settings, double x, double peg_mass, double friction) {
  Scene scene({.gravity = {0, 0}, .dt = settings.dt});
  BodySpec peg{.type = BodyType::static_body,
               .shapes = {circle(peg_radius)},
               .position = {x, -peg_radius},
               .material = {.friction = friction}};
  if (peg_mass > 0) {
    peg.type = BodyType::dynamic;
    peg.mass = peg_mass;
  }
  scene.add(peg);
  scene.add({.shapes = {box(1, 1)},
             .position = {0, 0.5},
             .velocity = {0, -settings.speed},
             .mass = settings.mass,
             .material = {.friction = friction}});
  return scene;
}

/// What one push of this row does to its two bodies.
HandPush push_by_hand(const VelocityProblem<double>& problem, const ConstraintRow<double>& row) {
  const Vec3<double>& j_a = row.jacobian_a;  // three numbers of the peg, three of the box
  const Vec3<double>& j_b = row.jacobian_b;
  const Vec3<double>& w_a = problem.inverse_mass[row.a];  // their parts of the diagonal of M⁻¹ (17)
  const Vec3<double>& w_b = problem.inverse_mass[row.b];
  HandPush push{.v_a = problem.velocity[row.a], .v_b = problem.velocity[row.b]};  // v₁ (16)
  // [push]
  const double inverse_mass = j_a.dot(w_a.cwiseProduct(j_a)) + j_b.dot(w_b.cwiseProduct(j_b));  // j M⁻¹ jᵀ
  const double jv = j_a.dot(push.v_a) + j_b.dot(push.v_b);
  const double lambda = (row.bias - jv) / (inverse_mass * problem.dt);  // (22): row.bias is ζ
  push.impulse = lambda * problem.dt;
  push.v_a += w_a.cwiseProduct(j_a * push.impulse);  // (21) p = jᵀ λ Δt and (19) v₂ = v₁ + M⁻¹ p
  push.v_b += w_b.cwiseProduct(j_b * push.impulse);
  // [/push]
  return push;
}

Push push_at(const PegSettings& settings, double x, double peg_mass) {
  World<double> world(peg_scene(settings, x, peg_mass, 0));
  const VelocityProblem<double> problem = world.velocity_problem();
  Push push{
      .x = x, .row = problem.rows.at(0), .before = snapshot(world), .inverse_mass = problem.inverse_mass};
  push.by_hand = push_by_hand(problem, push.row);
  push.by_matrices = system_matrices(problem).A(0, 0);
  push.inverse = inverse_effective_mass(problem, push.row);
  push.rate_before = row_velocity(problem, push.row);

  SequentialImpulse<double> solver({.iterations = 1});
  world.step(solver);
  const VelocityProblem<double>& solved = world.last_step().problem;
  push.impulse = solved.impulse.at(0);
  push.rate_after = row_velocity(solved, push.row);
  push.after = push.before;
  for (const BodyId body : push.after.bodies.indices())
    push.after.bodies[body].velocity = solved.velocity[body];
  return push;
}

Pushes push_everywhere(const PegSettings& settings) {
  Pushes all{.settings = settings};
  for (const double x : {0.0, 0.5 * settings.x, settings.x}) all.at.push_back(push_at(settings, x, 0));
  all.mirrored = push_at(settings, -settings.x, 0);
  for (const double mass : {0.0, 60.0, 6.0, 1.0, 0.1})
    all.others.push_back({.mass = mass, .effective = 1 / push_at(settings, 0, mass).inverse});
  const VelocityProblem<double> rough = World<double>(peg_scene(settings, 0, 0, 0.5)).velocity_problem();
  all.sideways = effective_mass(rough, rough.rows.at(1));
  return all;
}

void run(Lesson& lesson) {
  const Pushes all = push_everywhere({.mass = lesson.real("mass"),
                                      .speed = lesson.real("speed"),
                                      .dt = lesson.real("dt"),
                                      .x = lesson.real("x")});
  print_scene(lesson, all.settings);
  lesson.predict();
  lesson.print();
  print_pair(lesson, all);
  print_places(lesson, all);
  const double right = all.at.back().impulse;
  lesson.answer({right}, 0.02 * right,
                "Less: an off-centre push also turns the box, so the effective mass there is smaller.");
  check_row(lesson, all);
  check_motion(lesson, all);
  check_others(lesson, all);
  lesson.film(peg_shots(all));
  lesson.data(places_table(all));
  lesson.fingerprint(all.at.back().after);
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(card(), run, argc, argv); }
