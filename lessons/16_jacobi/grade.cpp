// Exercise 16, graded: a box on one foot, on three, and on nine, beside sweeps with one mistake each.
#include "exercise.cpp"

#include <numeric>

namespace cairn::exercise16 {
namespace {

constexpr double sweep_rounding = 1e-13;  // some ten operations a foot on numbers below 10

/// What a wrong sweep may get wrong.
enum class Slip {
  none,
  in_turn,
  whole,
  half,
  fixed_omega,
  fixed_in_turn,
  twice,
  clamps_each,
  pulls,
  no_arm,
  no_turn,
  multiplies,
  sign,
  replaces,
  whole_number,
  not_noted,
  not_applied,
  sum_again,
  damps_last,
  damps_sum,
  no_mass,
  no_spin,
  turns_back,
  turns_by_mass,
  arm_once,
  last_left_out
};

struct Known {
  Slip slip = Slip::none;
  const char* what = "";
};

List<Known> known() {
  return {
      {Slip::in_turn, "All feet look at the same velocities: apply nothing before each has looked."},
      {Slip::whole, "With ω = 1 all feet together take back more than what is wrong."},
      {Slip::half, "ω = 1/2 is not right for any number of feet."},
      {Slip::fixed_omega, "A fixed ω such as 0.3 fits one number of feet: let it depend on feet.size()."},
      {Slip::fixed_in_turn,
       "Two things: all feet look at the same velocities, and ω depends on the number of feet."},
      {Slip::twice, "ω = 2/k is the edge: all k feet together may take back twice what is wrong."},
      {Slip::clamps_each, "Clamp the sum, not the correction: a foot may take back what it gave."},
      {Slip::pulls, "A foot cannot pull: its sum is never below 0."},
      {Slip::no_arm, "A foot at the side also turns the box: j M⁻¹ jᵀ has a part x²."},
      {Slip::no_turn, "The impulse of a foot at x also changes the rotation, by x times it."},
      {Slip::multiplies, "Divide the speed by j M⁻¹ jᵀ, do not multiply."},
      {Slip::sign, "The sign: a foot pushes up where its point comes down."},
      {Slip::replaces, "Add to what the foot has given: do not replace it."},
      {Slip::whole_number, "1 / feet.size() is a division of whole numbers, and 0 for more than one: 1.0."},
      {Slip::not_noted, "The box was pushed, and the feet's impulses do not know of it."},
      {Slip::not_applied, "The sums have changed, and the box has not: the difference acts on it."},
      {Slip::sum_again, "Apply the change of the sum: the old one has acted before."},
      {Slip::damps_last, "The share is that of the correction: clamp behind it, not before."},
      {Slip::damps_sum, "The share is that of the correction, not of what was given before."},
      {Slip::no_mass, "An impulse changes the velocity by 1/m."},
      {Slip::no_spin, "The point above a foot moves with the turning as well: up + x turn."},
      {Slip::turns_back, "A push at the right turns the box counter-clockwise: the sign of x counts."},
      {Slip::turns_by_mass, "The rotation has 1/I, not 1/m."},
      {Slip::arm_once, "x comes in twice: once in j, once in jᵀ."},
      {Slip::last_left_out, "The last foot had no turn."}};
}

double corrected(const Box& box, const Foot& foot, double omega, Slip slip) {
  const double twice = slip == Slip::arm_once ? std::abs(foot.x) : foot.x * foot.x;
  const double arm = slip == Slip::no_arm ? 0 : twice * box.inverse_inertia;
  const double turn = slip == Slip::no_spin ? 0 : box.turn;
  const double inverse = box.inverse_mass + arm, jv = box.up + foot.x * turn;
  double correction = omega * (slip == Slip::multiplies ? -jv * inverse : -jv / inverse);
  if (slip == Slip::sign) correction = -correction;
  if (slip == Slip::damps_last) {
    return foot.impulse + omega * (std::max(foot.impulse - jv / inverse, 0.0) - foot.impulse);
  }
  if (slip == Slip::damps_sum) return std::max(omega * (foot.impulse - jv / inverse), 0.0);
  if (slip == Slip::clamps_each) return foot.impulse + std::max(correction, 0.0);
  const double sum = (slip == Slip::replaces ? 0 : foot.impulse) + correction;
  return slip == Slip::pulls ? sum : std::max(sum, 0.0);
}

void act(Box& box, Foot& foot, double sum, Slip slip) {
  const double given = slip == Slip::sum_again ? sum : sum - foot.impulse;
  if (slip != Slip::not_noted) foot.impulse = sum;
  if (slip == Slip::not_applied) return;
  box.up += (slip == Slip::no_mass ? 1 : box.inverse_mass) * given;
  double turn = (slip == Slip::turns_by_mass ? box.inverse_mass : box.inverse_inertia) * foot.x * given;
  if (slip == Slip::turns_back) turn = -turn;
  if (slip != Slip::no_turn) box.turn += turn;
}

struct Stand {
  Box box = {};
  List<Foot> feet = {};
};

Stand reference(Stand stand, Slip slip) {
  double omega = 1.0 / stand.feet.size();
  if (slip == Slip::twice) omega *= 2;
  if (slip == Slip::whole) omega = 1;
  if (slip == Slip::half) omega = 0.5;
  if (slip == Slip::fixed_omega || slip == Slip::fixed_in_turn) omega = 0.3;
  const bool in_turn = slip == Slip::in_turn || slip == Slip::fixed_in_turn;
  if (slip == Slip::whole_number && stand.feet.size() > 1) omega = 0;
  const Box before = stand.box;
  for (Foot& foot : stand.feet) {
    if (slip == Slip::last_left_out && &foot == &stand.feet.back()) break;
    act(stand.box, foot, corrected(in_turn ? stand.box : before, foot, omega, slip), slip);
  }
  return stand;
}

Stand answered(Stand stand) {
  sweep(stand.box, stand.feet);
  return stand;
}

struct Part {
  std::string what = {};
  double (*of)(const Stand&) = nullptr;
};

List<Part> parts() {
  return {{"impulse of the first foot (N s)", [](const Stand& s) { return s.feet[0].impulse; }},
          {"impulse of the last foot (N s)", [](const Stand& s) { return s.feet.back().impulse; }},
          {"box upwards (m/s)", [](const Stand& s) { return s.box.up; }},
          {"box turns (rad/s)", [](const Stand& s) { return s.box.turn; }}};
}

bool are_near(const Stand& a, const Stand& b) {
  for (const Part& part : parts()) {
    if (!(std::abs(part.of(a) - part.of(b)) <= sweep_rounding)) return false;
  }
  return true;
}

/// What a wrong sweep of this stand comes from: a mistake that explains all of its numbers. A gap that does
/// nothing makes none.
List<Known> explanations(const Stand& start) {
  List<Known> found;
  if (are_near(answered(start), start)) return found;
  for (const Known& each : known()) {
    if (are_near(reference(start, each.slip), answered(start))) found.push_back(each);
  }
  return found;
}

struct NamedStand {
  std::string name = {};
  Stand start = {};
};

/// A mistake that explains every stand has the word; where there is none, one that explains this stand.
void grade_stands(Grade& grade, const List<NamedStand>& stands) {
  List<Known> everywhere;
  for (const Known& each : known()) {
    const bool explains = std::all_of(stands.begin(), stands.end(), [&each](const NamedStand& stand) {
      return are_near(reference(stand.start, each.slip), answered(stand.start));
    });
    if (explains) everywhere.push_back(each);
  }
  for (const NamedStand& stand : stands) {
    const Stand right = reference(stand.start, Slip::none), got = answered(stand.start);
    for (const Part& part : parts()) {
      ExpectedNumber number{
          .what = stand.name + ": " + part.what, .value = part.of(right), .tolerance = sweep_rounding};
      for (const Known& each : everywhere.empty() ? explanations(stand.start) : everywhere)
        number.misconceptions.push_back({part.of(reference(stand.start, each.slip)), each.what});
      grade.number(number, part.of(got));
    }
  }
}

/// The feet carry the box at last, whatever their places: together they give its momentum m v.
void grade_end(Grade& grade, int count) {
  Stand stand{.box = {.inverse_mass = 0.5, .inverse_inertia = 2, .up = -1}};
  for (int i = 0; i < count; ++i) stand.feet.push_back({.x = -0.5 + 1.0 * i / (count - 1)});
  const bool gives = answered(stand).feet[0].impulse > 0;
  for (int k = 0; k < 400; ++k) stand = answered(stand);
  const double sum = std::accumulate(stand.feet.begin(), stand.feet.end(), 0.0,
                                     [](double all, const Foot& foot) { return all + foot.impulse; });
  grade.number(
      {
          .what = std::to_string(count) + " feet, after 400 sweeps: sum of impulses (N s)",
          .value = 2,
          .misconceptions = {{0, gives ? "It never comes to rest: at the end of this sweep no foot pushes."
                                       : ""}},
          .tolerance = 1e-6  // the tilt decays slowest, by 1 - 6 mean of x² or less a sweep
      },
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
            const Box rises{.inverse_mass = 2, .inverse_inertia = 12, .up = 1.5, .turn = -1};
            grade_stands(grade, {{"2 kg, one foot", {falls, {{.x = 0.2}}}},
                                 {"2 kg, three feet", {falls, {{.x = -0.5}, {.x = 0.1}, {.x = 0.4}}}},
                                 {"2 kg, two feet that have pushed", {falls, {{-0.4, 0.2}, {0.3, 0.1}}}},
                                 {"0.5 kg thrown up", {rises, {{-0.5, 0.1}, {-0.1, 0.4}, {0.3, 0.2}}}}});
            for (const int feet : {2, 9}) grade_end(grade, feet);
          }};
}

}  // namespace cairn::exercise16
