// Exercise 17, graded: the loads of lesson 17's tower, of one with boxes of 2 and 0.5 kg, and of one whose
// upper box is thrown off.
#include "exercise.cpp"

#include <fmt/format.h>

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
  replaces,  // the sum by the correction
  pulls,
  gravity_up,
  whole_second,
  heavy_falls,
  from_rest,  // velocities begin anew in every step
  ten_sweeps,
  last_left_out,
  jacobi,
  wrong_speed,
  own_speed,
  adds_masses,
  unit_masses,  // the divisor of boxes of 1 kg
  copied,       // the same, and impulses that change velocities by p
  multiplies,
  ground_moves,
  no_mass,
  pushes_up,
  sum_again,
  not_kept,
  at_last  // the weight of all that is above, together
};

struct Known {
  Slip slip = Slip::none;
  const char* what = "";
};

List<Known> known() {
  return {{Slip::forgets_gravity, "Without gravity nothing falls: v loses g Δt before anything else."},
          {Slip::cold, "That is the cold tower: all impulses of the last step act, before the first sweep."},
          {Slip::keeps_only, "A warm start keeps the impulses and also applies them to the velocities."},
          {Slip::gravity_last, "Gravity acts before the sweeps, or they find nothing to do."},
          {Slip::from_the_top, "Sweep from the ground up: another order leaves other loads."},
          {Slip::one_mass, "Two boxes give way: the effective mass has both in it."},
          {Slip::clamps_each, "Clamp the sum, not the correction: a contact may take back what it gave."},
          {Slip::pushes_one, "Action and reaction: the box below is pushed down."},
          {Slip::one_sweep, "That is the load after one sweep."},
          {Slip::lacks_a_sweep, "One sweep is missing."},
          {Slip::replaces, "Add the correction to the impulse: do not replace it."},
          {Slip::pulls, "A contact cannot pull: its sum is never below 0."},
          {Slip::gravity_up, "The sign: gravity takes g Δt off every velocity."},
          {Slip::whole_second, "Gravity changes a velocity by g Δt in a step."},
          {Slip::heavy_falls, "g is the same for all boxes: the mass cancels."},
          {Slip::from_rest, "A velocity goes on with what it had: take g Δt off it, do not set it."},
          {Slip::ten_sweeps, "`sweeps` says how many there are."},
          {Slip::last_left_out, "The uppermost box has a contact as well."},
          {Slip::jacobi, "That is Jacobi: each contact has to see the velocities as they are now."},
          {Slip::wrong_speed, "The sign: boxes that approach have to be pushed apart."},
          {Slip::own_speed, "j·v is the velocity of the box less that of the box below."},
          {Slip::adds_masses, "Add the inverse masses of both boxes, not the masses."},
          {Slip::unit_masses, "2 and 1 are 1/m + 1/m of boxes of 1 kg: these have masses of their own."},
          {Slip::copied, "That is the loop for boxes of 1 kg: these have masses, in 1/m + 1/m and in p / m."},
          {Slip::multiplies, "Divide by 1/m + 1/m: what yields easily needs less."},
          {Slip::ground_moves, "The ground has 1/m = 0: the lowest contact has one mass."},
          {Slip::no_mass, "An impulse changes a velocity by p / m."},
          {Slip::pushes_up, "Action and reaction: the box below is pushed down, not up."},
          {Slip::sum_again, "Apply the change of the sum: the rest was applied before."},
          {Slip::not_kept, "Note the sum: the next sweep and the next step begin with it."},
          {Slip::at_last, "That is the load that the sweeps come to at last."}};
}

void push(Tower& tower, int i, double p, Slip slip) {
  const bool massless = slip == Slip::no_mass || slip == Slip::copied;
  tower.velocity[i] += massless ? p : p / tower.mass[i];
  if (i == 0 || slip == Slip::pushes_one) return;
  const double change = massless ? p : p / tower.mass[i - 1];
  tower.velocity[i - 1] += slip == Slip::pushes_up ? change : -change;
}

/// What is divided by.
double inverse_of(const Tower& tower, int i, Slip slip) {
  const double own = tower.mass[i];
  if (slip == Slip::unit_masses || slip == Slip::copied) return i == 0 ? 1 : 2;
  if (i == 0) return slip == Slip::ground_moves ? 2 / own : 1 / own;
  const double below = tower.mass[i - 1];
  if (slip == Slip::one_mass) return 1 / own;
  return slip == Slip::adds_masses ? 1 / (own + below) : 1 / own + 1 / below;
}

void update(Tower& tower, const List<double>& seen, int i, Slip slip) {
  const double below = i > 0 && slip != Slip::own_speed ? seen[i - 1] : 0;
  const double lacking = slip == Slip::wrong_speed ? seen[i] - below : below - seen[i];
  const double inverse = inverse_of(tower, i, slip);
  double& impulse = tower.impulse[i];
  const double before = impulse,
               correction = slip == Slip::multiplies ? lacking * inverse : lacking / inverse;
  impulse = std::max(before + correction, 0.0);
  if (slip == Slip::pulls) impulse = before + correction;
  if (slip == Slip::clamps_each) impulse = before + std::max(correction, 0.0);
  if (slip == Slip::replaces) impulse = std::max(correction, 0.0);
  push(tower, i, slip == Slip::sum_again ? impulse : impulse - before, slip);
  if (slip == Slip::not_kept) impulse = before;
}

void reference(Tower& tower, double gravity, double dt, int sweeps, Slip slip) {
  const int boxes = tower.mass.size();
  double fall = slip == Slip::forgets_gravity ? 0 : gravity * dt;
  if (slip == Slip::gravity_up) fall = -fall;
  if (slip == Slip::whole_second) fall = gravity;
  for (int i = 0; i < boxes && slip != Slip::gravity_last; ++i) {
    if (slip == Slip::from_rest) tower.velocity[i] = 0;
    tower.velocity[i] -= slip == Slip::heavy_falls ? fall * tower.mass[i] : fall;
  }
  for (int i = 0; i < boxes; ++i) {
    if (slip == Slip::cold) tower.impulse[i] = 0;
    if (slip != Slip::keeps_only) push(tower, i, tower.impulse[i], slip);
  }
  if (slip == Slip::one_sweep) sweeps = 1;
  if (slip == Slip::lacks_a_sweep) sweeps -= 1;
  if (slip == Slip::ten_sweeps) sweeps = 10;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const List<double> before = tower.velocity;
    for (int k = 0; k < (slip == Slip::last_left_out ? boxes - 1 : boxes); ++k) {
      update(tower, slip == Slip::jacobi ? before : tower.velocity,
             slip == Slip::from_the_top ? boxes - 1 - k : k, slip);
    }
  }
  if (slip == Slip::gravity_last) {
    for (double& v : tower.velocity) v -= fall;
  }
  if (slip != Slip::at_last) return;
  double weight = 0;
  for (int i = boxes - 1; i >= 0; --i) {
    tower.velocity[i] = 0;
    tower.impulse[i] = weight += tower.mass[i] * gravity * dt;
  }
}

struct Case {
  std::string name = {};
  List<double> mass = {};
  double gravity = 10;
  double dt = 0.02;
  int sweeps = 10;
  double thrown = 0;  // [m/s] upwards: the uppermost box, at the beginning

  Tower start() const {
    Tower tower{
        .mass = mass, .velocity = List<double>(mass.size(), 0.0), .impulse = List<double>(mass.size(), 0.0)};
    tower.velocity.back() = thrown;
    return tower;
  }
};

const Case ten{.name = "ten boxes of 1 kg", .mass = List<double>(10, 1.0)};
const Case mixed{
    .name = "2, 0.5, 2 and 0.5 kg", .mass = {2, 0.5, 2, 0.5}, .gravity = 9.81, .dt = 0.01, .sweeps = 4};
const Case parted{.name = "2 and 0.5 kg, thrown off",
                  .mass = {2, 0.5},
                  .gravity = 9.81,
                  .dt = 0.01,
                  .sweeps = 4,
                  .thrown = 1};

/// After so many steps, with one mistake.
Tower stepped(const Case& each, int steps, Slip slip) {
  Tower tower = each.start();
  for (int k = 0; k < steps; ++k) reference(tower, each.gravity, each.dt, each.sweeps, slip);
  return tower;
}

Tower answered(const Case& each, int steps) {
  Tower tower = each.start();
  for (int k = 0; k < steps; ++k) step(tower, each.gravity, each.dt, each.sweeps);
  return tower;
}

double load(const Case& each, int box, int steps, Slip slip) {
  return stepped(each, steps, slip).impulse[box] / each.dt;
}

bool are_near(const List<double>& a, const List<double>& b) {
  for (int i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i] - b[i]) <= 1e-9 * (1 + std::abs(a[i])))) return false;
  }
  return true;
}

/// The mistakes that explain all impulses and all velocities: others that give the same load by chance do
/// not.
List<Known> explanations() {
  List<Known> found;
  for (const Known& wrong : known()) {
    bool explains = true;
    for (const Case& each : {ten, mixed, parted}) {
      for (int steps = 1; steps <= 3; ++steps) {
        const Tower expected = stepped(each, steps, wrong.slip), got = answered(each, steps);
        explains =
            explains && are_near(expected.impulse, got.impulse) && are_near(expected.velocity, got.velocity);
      }
    }
    if (explains) found.push_back(wrong);
  }
  return found;
}

void grade_load(Grade& grade, const List<Known>& wrong, const Case& each, int box, int steps, double value) {
  ExpectedNumber number{.what = fmt::format("{}, step {}: load under box {} (N)", each.name, steps, box + 1),
                        .value = value,
                        .tolerance = printed};
  const double got = answered(each, steps).impulse[box] / each.dt;
  for (const Known& mistake : wrong) number.misconceptions.push_back({got, mistake.what});
  grade.number(number, got);
}

void grade_all(Grade& grade) {
  const List<Known> wrong = explanations();
  const List<double> box2d = {35.2394, 64.9840, 94.1659, 133.5060, 96.1557};  // Box2D 2.4.1
  const List<int> steps = {1, 2, 3, 5, 10};
  for (int i = 0; i < steps.size(); ++i) grade_load(grade, wrong, ten, 0, steps[i], box2d[i]);
  // The load on the ground is the same from the ground up and from the top down; that on top is not.
  for (const int box : {0, 3}) grade_load(grade, wrong, mixed, box, 2, load(mixed, box, 2, Slip::none));
  grade_load(grade, wrong, mixed, 0, 1000, 5 * 9.81);  // at last its weight
  // In the first sweep the upper box rests on the lower one, which the ground has stopped; then it leaves.
  grade_load(grade, wrong, parted, 1, 1, load(parted, 1, 1, Slip::none));
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
