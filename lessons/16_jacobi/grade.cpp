// Exercise 16, graded: a box on one foot, on three, and on nine, beside sweeps with one mistake each.
#include <numeric>

#include "exercise.cpp"

namespace cairn::exercise16 {
namespace {

constexpr double sweep_rounding = 1e-13;  // some ten operations a foot on numbers below 10

/// What a wrong sweep may get wrong.
enum class Slip {
  none,
  in_turn,
  whole,
  half,
  twice,
  clamps_each,
  pulls,
  no_arm,
  no_turn,
  multiplies,
  sign,
  replaces
};

struct Known {
  Slip slip = Slip::none;
  std::string what = {};
};

List<Known> known() {
  return {{Slip::in_turn, "All feet look at the same velocities: apply nothing before each has looked."},
          {Slip::whole, "With ω = 1 all feet together take back more than what is wrong."},
          {Slip::half, "ω = 1/2 is not right for any number of feet."},
          {Slip::twice, "ω = 2/k is the edge: all k feet together may take back twice what is wrong."},
          {Slip::clamps_each, "Clamp the sum, not the correction: a foot may take back what it gave."},
          {Slip::pulls, "A foot cannot pull: its sum is never below 0."},
          {Slip::no_arm, "A foot at the side also turns the box: j M⁻¹ jᵀ has a part x²."},
          {Slip::no_turn, "The impulse of a foot at x also changes the rotation, by x times it."},
          {Slip::multiplies, "Divide the speed by j M⁻¹ jᵀ, do not multiply."},
          {Slip::sign, "The sign: a foot pushes up where its point comes down."},
          {Slip::replaces, "Add to what the foot has given: do not replace it."}};
}

double corrected(const Box& box, const Foot& foot, double omega, Slip slip) {
  const double arm = slip == Slip::no_arm ? 0 : foot.x * foot.x * box.inverse_inertia;
  const double inverse = box.inverse_mass + arm, jv = box.up + foot.x * box.turn;
  double correction = omega * (slip == Slip::multiplies ? -jv * inverse : -jv / inverse);
  if (slip == Slip::sign) correction = -correction;
  if (slip == Slip::clamps_each) return foot.impulse + std::max(correction, 0.0);
  const double sum = (slip == Slip::replaces ? 0 : foot.impulse) + correction;
  return slip == Slip::pulls ? sum : std::max(sum, 0.0);
}

void act(Box& box, Foot& foot, double sum, Slip slip) {
  const double given = sum - foot.impulse;
  foot.impulse = sum;
  box.up += box.inverse_mass * given;
  if (slip != Slip::no_turn) box.turn += box.inverse_inertia * foot.x * given;
}

struct Stand {
  Box box = {};
  List<Foot> feet = {};
};

Stand reference(Stand stand, Slip slip) {
  const double share = slip == Slip::twice ? 2.0 / stand.feet.size() : 1.0 / stand.feet.size();
  const double omega = slip == Slip::whole ? 1 : slip == Slip::half ? 0.5 : share;
  const Box before = stand.box;
  for (Foot& foot : stand.feet) {
    act(stand.box, foot, corrected(slip == Slip::in_turn ? stand.box : before, foot, omega, slip), slip);
  }
  return stand;
}

Stand answered(Stand stand) {
  sweep(stand.box, stand.feet);
  return stand;
}

void grade_stand(Grade& grade, const std::string& name, const Stand& start) {
  struct Part {
    std::string what = {};
    double (*of)(const Stand&) = nullptr;
  };
  const Stand right = reference(start, Slip::none), got = answered(start);
  for (const Part& part :
       {Part{"impulse of the first foot (N s)", [](const Stand& s) { return s.feet[0].impulse; }},
        Part{"impulse of the last foot (N s)", [](const Stand& s) { return s.feet.back().impulse; }},
        Part{"box upwards (m/s)", [](const Stand& s) { return s.box.up; }},
        Part{"box turns (rad/s)", [](const Stand& s) { return s.box.turn; }}}) {
    ExpectedNumber number{
        .what = name + ": " + part.what, .value = part.of(right), .tolerance = sweep_rounding};
    for (const Known& each : known())
      number.misconceptions.push_back({part.of(reference(start, each.slip)), each.what});
    grade.number(number, part.of(got));
  }
}

/// The feet carry the box at last, whatever their places: together they give its momentum m v.
void grade_end(Grade& grade, int count) {
  Stand stand{.box = {.inverse_mass = 0.5, .inverse_inertia = 2, .up = -1}};
  for (int i = 0; i < count; ++i) stand.feet.push_back({.x = -0.5 + 1.0 * i / (count - 1)});
  for (int k = 0; k < 400; ++k) stand = answered(stand);
  const double sum = std::accumulate(stand.feet.begin(), stand.feet.end(), 0.0,
                                     [](double all, const Foot& foot) { return all + foot.impulse; });
  grade.number({.what = std::to_string(count) + " feet, after 400 sweeps: sum of impulses (N s)",
                .value = 2,
                .tolerance = 1e-6,  // the tilt decays slowest, by 1 - 6 mean of x² or less a sweep
                .misconceptions = {{0, "It never comes to rest: at the end of this sweep no foot pushes."}}},
               sum);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 16,
          .task = "A sweep of damped Jacobi, with a damping that converges for any number of feet.",
          .file = "lessons/16_jacobi/exercise.cpp",
          .hints = {"Two loops: in the first, each foot finds its new sum and keeps it; nothing changes yet.",
                    "What do k equal feet do if each corrects the whole error? k times too much.",
                    "ω = 1 / k. New sum: max(sum - ω (up + x turn) / (1/m + x²/I), 0)."},
          .grade = [](Grade& grade) {
            const Box falls{.inverse_mass = 0.5, .inverse_inertia = 2, .up = -1, .turn = 0.3};
            grade_stand(grade, "2 kg, one foot", {falls, {{.x = 0.2}}});
            grade_stand(grade, "2 kg, three feet", {falls, {{.x = -0.5}, {.x = 0.1}, {.x = 0.4}}});
            grade_stand(grade, "2 kg, two feet that have pushed", {falls, {{-0.4, 0.2}, {0.3, 0.1}}});
            const Box rises{.inverse_mass = 2, .inverse_inertia = 12, .up = 1.5, .turn = -1};
            grade_stand(grade, "0.5 kg thrown up", {rises, {{-0.5, 0.1}, {-0.1, 0.4}, {0.3, 0.2}}});
            for (const int feet : {2, 9}) grade_end(grade, feet);
          }};
}

}  // namespace cairn::exercise16
