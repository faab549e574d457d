// Lesson 04. The second visit: a contact may take back what it gave.
// A box lands on two feet. Sequential impulses stop the left foot, then the right one, and that makes the
// left one rise: it has given too much. A contact must not pull, so something has to be clamped at 0; the
// question is what. We land the box twice: with each push clamped, and with the sum of a foot's pushes
// clamped (Algorithm 1). Only one of the two lets it stand.
#include "lesson.hpp"

#include "lessons/kit/words.hpp"

namespace {

using namespace cairn;
using namespace cairn::feet;

// [visit]
/// One visit to one foot. problem.impulse holds p, what each foot has given in total.
Visit visit(int sweep, int foot, Clamped clamped, VelocityProblem<double>& problem) {
  const ConstraintRow<double>& row = problem.rows[foot];
  double& p = problem.impulse[foot];
  const double jv = row_velocity(problem, row);
  const double asked = (row.bias - jv) * effective_mass(problem, row);  // (22) times Δt; below 0: take back
  Visit visit{.sweep = sweep, .foot = foot, .jv = jv, .asked = asked};
  visit.before = {problem.impulse[0], problem.impulse[1]};

  const double before = p;
  if (clamped == Clamped::increment) p = before + std::max(asked, 0.0);  // wrong: nothing is ever taken back
  if (clamped == Clamped::sum) p = std::max(before + asked, 0.0);        // right
  apply_impulse(problem, row, p - before);

  visit.after = {problem.impulse[0], problem.impulse[1]};
  return visit;
}
// [/visit]

Landing land(const Pair& feet, const FeetSettings& settings, Clamped clamped) {
  VelocityProblem<double> problem = landing_problem(feet, settings.speed);
  Landing landing{.clamped = clamped};
  for (int sweep = 1; sweep <= settings.sweeps; ++sweep) {
    for (int foot = 0; foot < 2; ++foot) landing.visits.push_back(visit(sweep, foot, clamped, problem));
  }
  landing.impulse = {problem.impulse[0], problem.impulse[1]};
  landing.velocity = problem.velocity[{1}];
  for (int foot = 0; foot < 2; ++foot)
    landing.foot_velocity[foot] = row_velocity(problem, problem.rows[foot]);
  return landing;
}

BoxRun land_in_both_ways(const Pair& feet, const FeetSettings& settings) {
  BoxRun box = box_at(feet, settings);
  for (const Clamped clamped : {Clamped::increment, Clamped::sum})
    box.by(clamped) = land(feet, settings, clamped);
  return box;
}

FeetRun land_everywhere(const FeetSettings& settings) {
  FeetRun run{.settings = settings, .box = land_in_both_ways({-settings.foot, settings.foot}, settings)};
  for (int k = 1; k <= 50; ++k) {
    const double foot = 0.01 * k;
    run.spreads.push_back(spread_of(land_in_both_ways({-foot, foot}, settings), settings.speed));
  }
  follow_in_a_world(run);
  return run;
}

void run(Lesson& lesson) {
  const FeetRun all = land_everywhere(
      {.foot = lesson.real("foot"), .speed = lesson.real("speed"), .sweeps = lesson.whole("sweeps")});
  tell_scene(lesson, all);
  constexpr int page_width = 104;  // columns
  if (question_of(all) == card().question) {
    lesson.predict();
  } else {
    lesson.print(wrapped("QUESTION " + question_of(all), page_width, 9));
  }
  tell_visits(lesson, all);
  tell_landings(lesson, all);
  tell_motion(lesson, all);
  const Visit& second = all.box.by(Clamped::sum).visits[2];
  lesson.answer({second.after[0]}, 0.03 * second.after[0],
                second.given() < 0
                    ? "It takes back: it gave too much before the other foot had its turn. "
                      "The sum stays positive, so the foot does not pull."
                    : "It gives more: with feet this far out, each push makes the other foot sink.");
  check_claims(lesson, all);
  lesson.film(feet_shots(all));
  lesson.data(table_of(all));
  List<double> numbers;
  for (const Landing& landing : all.box.landings)
    numbers.insert(numbers.end(), landing.impulse.begin(), landing.impulse.end());
  lesson.fingerprint(numbers);
}

}  // namespace

int main(int argc, char** argv) { return run_lesson(card(), run, argc, argv); }
