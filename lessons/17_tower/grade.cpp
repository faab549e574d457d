// Exercise 17, graded: the loads of lesson 17's tower, and of one with boxes of 2 and 0.5 kg.
#include <fmt/format.h>

#include "exercise.cpp"

namespace cairn::exercise17 {
namespace {

constexpr double printed = 6e-5;  // [N] the loads of Box2D are known to four decimals

/// What a wrong step may get wrong.
enum class Slip {
  none,
  forgets_gravity,
  cold,          // no warm start, and impulses from 0
  keeps_only,    // keeps the impulses, and does not apply them
  gravity_last,  // after the sweeps
  from_the_top,  // sweeps from the top down
  one_mass,      // the effective mass of the upper box alone
  clamps_each,   // the correction, not the sum
  pushes_one,    // the upper box only
  one_sweep,
  lacks_a_sweep,
  replaces  // the sum by the correction
};

struct Known {
  Slip slip = Slip::none;
  std::string what = {};
};

List<Known> known() {
  return {{Slip::forgets_gravity, "Without gravity nothing falls: v loses g Δt before anything else."},
          {Slip::cold, "That is the cold tower: begin with the impulses of the last step."},
          {Slip::keeps_only, "A warm start keeps the impulses and also applies them to the velocities."},
          {Slip::gravity_last, "Gravity acts before the sweeps, or they find nothing to do."},
          {Slip::from_the_top, "Sweep from the ground up: another order leaves other loads."},
          {Slip::one_mass, "Two boxes give way: the effective mass has both in it."},
          {Slip::clamps_each, "Clamp the sum, not the correction: a contact may take back what it gave."},
          {Slip::pushes_one, "Action and reaction: the box below is pushed down."},
          {Slip::one_sweep, "That is the load after one sweep."},
          {Slip::lacks_a_sweep, "One sweep is missing."},
          {Slip::replaces, "Add the correction to the impulse: do not replace it."}};
}

void push(Tower& tower, int i, double p, Slip slip) {
  tower.velocity[i] += p / tower.mass[i];
  if (i > 0 && slip != Slip::pushes_one) tower.velocity[i - 1] -= p / tower.mass[i - 1];
}

void update(Tower& tower, int i, Slip slip) {
  const double below = i > 0 ? tower.velocity[i - 1] : 0;
  const double inverse = 1 / tower.mass[i] + (i > 0 && slip != Slip::one_mass ? 1 / tower.mass[i - 1] : 0);
  double& impulse = tower.impulse[i];
  const double before = impulse, correction = (below - tower.velocity[i]) / inverse;
  impulse = std::max(before + correction, 0.0);
  if (slip == Slip::clamps_each) impulse = before + std::max(correction, 0.0);
  if (slip == Slip::replaces) impulse = std::max(correction, 0.0);
  push(tower, i, impulse - before, slip);
}

void reference(Tower& tower, double gravity, double dt, int sweeps, Slip slip) {
  const int boxes = tower.mass.size();
  const double fall = slip == Slip::forgets_gravity ? 0 : gravity * dt;
  if (slip != Slip::gravity_last) {
    for (double& v : tower.velocity) v -= fall;
  }
  for (int i = 0; i < boxes; ++i) {
    if (slip == Slip::cold) tower.impulse[i] = 0;
    if (slip != Slip::keeps_only) push(tower, i, tower.impulse[i], slip);
  }
  if (slip == Slip::one_sweep) sweeps = 1;
  if (slip == Slip::lacks_a_sweep) sweeps -= 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int k = 0; k < boxes; ++k) update(tower, slip == Slip::from_the_top ? boxes - 1 - k : k, slip);
  }
  if (slip == Slip::gravity_last) {
    for (double& v : tower.velocity) v -= fall;
  }
}

struct Case {
  std::string name = {};
  List<double> mass = {};
  double gravity = 10;
  double dt = 0.02;
  int sweeps = 10;

  Tower start() const {
    return {
        .mass = mass, .velocity = List<double>(mass.size(), 0.0), .impulse = List<double>(mass.size(), 0.0)};
  }
};

/// The load under a box after so many steps, with one mistake.
double load(const Case& each, int box, int steps, Slip slip) {
  Tower tower = each.start();
  for (int k = 0; k < steps; ++k) reference(tower, each.gravity, each.dt, each.sweeps, slip);
  return tower.impulse[box] / each.dt;
}

double answered(const Case& each, int box, int steps) {
  Tower tower = each.start();
  for (int k = 0; k < steps; ++k) step(tower, each.gravity, each.dt, each.sweeps);
  return tower.impulse[box] / each.dt;
}

void grade_load(Grade& grade, const Case& each, int box, int steps, double value) {
  ExpectedNumber number{.what = fmt::format("{}, step {}: load under box {} (N)", each.name, steps, box + 1),
                        .value = value,
                        .tolerance = printed};
  for (const Known& wrong : known()) {
    number.misconceptions.push_back({load(each, box, steps, wrong.slip), wrong.what});
  }
  grade.number(number, answered(each, box, steps));
}

void grade_all(Grade& grade) {
  const Case ten{.name = "ten boxes of 1 kg", .mass = List<double>(10, 1.0)};
  const List<double> box2d = {35.2394, 64.9840, 94.1659, 133.5060, 96.1557};  // Box2D 2.4.1
  const List<int> steps = {1, 2, 3, 5, 10};
  for (int i = 0; i < steps.size(); ++i) grade_load(grade, ten, 0, steps[i], box2d[i]);
  const Case mixed{
      .name = "2, 0.5, 2 and 0.5 kg", .mass = {2, 0.5, 2, 0.5}, .gravity = 9.81, .dt = 0.01, .sweeps = 4};
  // The load on the ground is the same from the ground up and from the top down; that on top is not.
  for (const int box : {0, 3}) grade_load(grade, mixed, box, 2, load(mixed, box, 2, Slip::none));
  grade_load(grade, mixed, 0, 1000, 5 * 9.81);  // at last its weight
}

}  // namespace

Exercise exercise() {
  return {.lesson = 17,
          .task = "A step of a tower: gravity, warm start, sweeps. Its loads are those of Box2D.",
          .file = "lessons/17_tower/exercise.cpp",
          .hints = {"Write a lambda push(i, p): box i gets p, and the box below loses it.",
                    "Gravity for all; push(i, tower.impulse[i]) for all; then the sweeps.",
                    "In a sweep: correction = (v_below - v_i) / (1/m_i + 1/m_below); clamp the sum, push the "
                    "difference. The ground has v = 0 and 1/m = 0."},
          .grade = grade_all};
}

}  // namespace cairn::exercise17
