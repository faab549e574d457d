// Floor 8. Coulomb friction where it has two answers: a box in a tight slot.
#include <algorithm>

#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double slot_friction = 0.5;                           // mu
const double slot_weight = standard_gravity * standard_dt;  // [N s] m g dt of 1 kg

/// Walls that press with `press` times m g dt / (2 mu), the least that can hold the box.
VelocityProblem<double> pressed_box(double press, double friction_impulse) {
  VelocityProblem<double> problem = box_in_slot(slot_friction);
  const double normal = press * slot_weight / (2 * slot_friction);
  problem.impulse = {normal, friction_impulse, normal, friction_impulse};
  return problem;
}

// A10. Without normal impulses there is no friction, and without friction nothing presses: the box falls.
// With equal normal impulses of m g dt / (2 mu) or more on both sides friction holds it.
ValidationResult two_answers(const EngineMaker&) {
  const std::string any = ": worst of 8 solvers",
                    both = ", pressed by 1 and 1.5 m g dt / 2 mu: worst of 8 solvers";
  Worst falls =
      Worst("speed from impulses 0" + any, "m/s").by("-g dt").since("exact: nothing is added to it");
  Worst cold = Worst("violation by the answer without impulses" + any, "m/s").by("0").since("exact");
  Worst stays = Worst("speed" + both, "m/s").by("0").since("64 epsilon of 1 m/s");
  Worst holds = Worst("sum of friction impulses" + both, "N s").by("m g dt").since("64 epsilon of it");
  Worst warm = Worst("violation by the answer" + both, "m/s").by("0").since("64 epsilon of 1 m/s");
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> problem = box_in_slot(slot_friction);
    make({.iterations = 50})->solve(problem);
    falls.add(-slot_weight, problem.velocity[{1}].y(), 0);
    cold.add(0, violation_by(box_in_slot(slot_friction), problem.impulse), 0);
    for (const double press : {1.0, 1.5}) {
      problem = pressed_box(press, slot_weight / 2);
      make({.iterations = 50})->solve(problem);
      stays.add(0, problem.velocity[{1}].cwiseAbs().maxCoeff(), 64 * double_epsilon);
      holds.add(slot_weight, problem.impulse[1] + problem.impulse[3], 64 * double_epsilon * slot_weight);
      warm.add(0, violation_by(box_in_slot(slot_friction), problem.impulse), 64 * double_epsilon);
    }
  }
  return {.numbers = {falls.number(), cold.number(), stays.number(), holds.number(), warm.number()}};
}

// A10
ValidationResult too_little_pressure(const EngineMaker&) {
  Worst worst = Worst("speed, pressed by p = 0.6 m g dt / 2 mu: worst of 8 solvers", "m/s")
                    .by("-g dt + 2 mu p / m")
                    .since("64 epsilon of 1 m/s");
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> problem = pressed_box(0.6, 0);
    make({.iterations = 50})->solve(problem);
    worst.add(-0.4 * slot_weight, problem.velocity[{1}].y(), 64 * double_epsilon);
  }
  return {.numbers = {worst.number()}};
}

}  // namespace

void add_slot_cases(ValidationCases& cases) {
  cases.push_back({"A10",
                   "A box in a tight slot has two answers, and the impulses at the start decide between them",
                   "derived", Asks::cairn, two_answers});
  cases.push_back({"A10b",
                   "A box that its slot presses with less than m g dt / (2 mu) is slowed down, but not held",
                   "derived", Asks::cairn, too_little_pressure});
}

}  // namespace cairn
