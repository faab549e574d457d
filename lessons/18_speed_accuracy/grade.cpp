// Exercise 18, graded: sweeps over towers of mixed masses beside sweeps with one mistake each, and the sweeps
// that Young's ω saves.
#include "exercise.cpp"

#include <fmt/format.h>
#include <numeric>

namespace cairn::exercise18 {
namespace {

constexpr double sweep_rounding = 1e-11;  // [N] some ten operations a row on loads of at most 200 N

/// What a wrong sweep may get wrong.
enum class Slip {
  none,
  plain,
  scales_load,
  no_clamp,
  old_loads,
  one_mass,
  undivided,
  no_above,
  swapped,
  mass_above,
  sign,
  clamps_each,
  from_the_top,
  b_everywhere,
  b_by_mass,
  b_times_mass,
  no_b,
  adds_neighbours,
  no_below,
  no_own,
  masses,
  equal_masses,
  ground_moves,
  divides_by_omega,
  omega_less_one,
  own_omega,
  last_left_out,
  at_last
};

struct Known {
  Slip slip = Slip::none;
  const char* what = "";
};

List<Known> known() {
  return {
      {Slip::plain, "That is Gauss-Seidel: nothing is relaxed."},
      {Slip::scales_load, "ω multiplies the correction, not the new load."},
      {Slip::no_clamp, "A contact cannot pull: clamp last, after ω, so that no load is below 0."},
      {Slip::old_loads, "Use the newest load of the row below: this one is from the last sweep (Jacobi)."},
      {Slip::one_mass, "A_ii has both boxes of the contact in it."},
      {Slip::undivided, "Divide by A_ii."},
      {Slip::no_above, "The load above pushes box i down: A_{i,i+1} is missing."},
      {Slip::swapped, "The row below moves the box below: mind which mass belongs to which neighbour."},
      {Slip::mass_above, "The load above acts on box i: A_{i,i+1} has 1/m_i, not the mass of the next box."},
      {Slip::sign, "The sign: add what is left of b − A λ."},
      {Slip::clamps_each, "A load may shrink: clamp the load, not the correction."},
      {Slip::from_the_top, "The order: a sweep goes from the ground up."},
      {Slip::b_everywhere, "b is gravity in row 0 alone: the boxes above fall side by side."},
      {Slip::b_by_mass, "b is an acceleration: g itself, without a mass."},
      {Slip::b_times_mass, "b is an acceleration: g itself, without a mass."},
      {Slip::no_b, "Where is b? Gravity pushes the lowest box onto the ground."},
      {Slip::adds_neighbours,
       "A_ij of neighbours is negative, and is subtracted: their loads come in with +."},
      {Slip::no_below, "The load below pushes box i − 1 up: A_{i,i−1} is missing."},
      {Slip::no_own, "What is left of row i is b_i less all of A_i λ, A_ii λ_i too."},
      {Slip::masses, "A has inverse masses: 1/m."},
      {Slip::equal_masses, "The boxes differ: the one below has its own mass."},
      {Slip::ground_moves, "The ground has 1/m = 0."},
      {Slip::divides_by_omega, "ω multiplies: more than 1 goes further than row i asks for."},
      {Slip::omega_less_one, "ω itself multiplies: with ω = 1 it is Gauss-Seidel."},
      {Slip::own_omega, "ω is that of the call."},
      {Slip::last_left_out, "The uppermost box has a row as well."},
      {Slip::at_last, "Those are the loads at last: a sweep takes one step towards them."}};
}

double updated(const List<double>& load, const List<double>& before, const List<double>& mass, int i,
               double gravity, double omega, Slip slip) {
  double own = 1 / mass[i], below = i > 0 ? 1 / mass[i - 1] : 0;
  if (slip == Slip::masses) own = mass[i], below = i > 0 ? mass[i - 1] : 0;
  if (slip == Slip::equal_masses && i > 0) below = own;
  if (slip == Slip::ground_moves && i == 0) below = own;
  if (slip == Slip::divides_by_omega) omega = 1 / omega;
  if (slip == Slip::omega_less_one) omega -= 1;
  if (slip == Slip::own_omega) omega = 1.5;
  const double diagonal = slip == Slip::one_mass ? own : own + below;
  const bool swaps = slip == Slip::swapped && i > 0;
  double left = i == 0 || slip == Slip::b_everywhere ? gravity : 0;
  if (slip == Slip::b_by_mass) left *= own;
  if (slip == Slip::b_times_mass) left /= own;
  if (slip == Slip::no_b) left = 0;
  if (slip != Slip::no_own) left -= diagonal * load[i];
  const double sign = slip == Slip::adds_neighbours ? -1 : 1;
  if (i > 0 && slip != Slip::no_below)
    left += sign * (swaps ? own : below) * (slip == Slip::old_loads ? before : load)[i - 1];
  if (i + 1 < load.size() && slip != Slip::no_above) {
    const double above = slip == Slip::mass_above ? 1 / mass[i + 1] : swaps ? below : own;
    left += sign * above * load[i + 1];
  }
  if (slip == Slip::sign) left = -left;
  const double change = slip == Slip::undivided ? left : left / diagonal;
  switch (slip) {
    case Slip::plain:
      return std::max(load[i] + change, 0.0);
    case Slip::scales_load:
      return std::max(omega * (load[i] + change), 0.0);
    case Slip::no_clamp:
      return load[i] + omega * change;
    case Slip::clamps_each:
      return load[i] + std::max(omega * change, 0.0);
    default:
      return std::max(load[i] + omega * change, 0.0);
  }
}

List<double> reference(List<double> load, const List<double>& mass, double gravity, double omega, Slip slip) {
  const List<double> before = load;
  const int boxes = load.size(), swept = slip == Slip::last_left_out ? boxes - 1 : boxes;
  for (int k = 0; k < swept; ++k) {
    const int i = slip == Slip::from_the_top ? boxes - 1 - k : k;
    load[i] = updated(load, before, mass, i, gravity, omega, slip);
  }
  double weight = 0;
  for (int i = boxes - 1; i >= 0 && slip == Slip::at_last; --i) load[i] = weight += mass[i] * gravity;
  return load;
}

struct Start {
  std::string name = {};
  List<double> load = {};
  double omega = 1;
};

const List<double> mixed = {4, 0.5, 2, 0.5};

List<double> answered(const Start& start) {
  List<double> load = start.load;
  sweep(load, mixed, 9.81, start.omega);
  return load;
}

/// Whether a mistake explains all loads: by chance others give one of them, and a gap that does nothing some.
bool explains(const Start& start, Slip slip) {
  const List<double> expected = reference(start.load, mixed, 9.81, start.omega, slip), got = answered(start);
  for (int i = 0; i < got.size(); ++i) {
    if (!(std::abs(got[i] - expected[i]) <= sweep_rounding)) return false;
  }
  return true;
}

void grade_sweeps(Grade& grade, const List<Start>& starts) {
  List<Known> wrong;
  const bool does_nothing =
      std::all_of(starts.begin(), starts.end(), [](const Start& s) { return answered(s) == s.load; });
  for (const Known& each : known()) {
    const bool is_it =
        std::all_of(starts.begin(), starts.end(), [&each](const Start& s) { return explains(s, each.slip); });
    if (is_it && !does_nothing) wrong.push_back(each);
  }
  for (const Start& start : starts) {
    const List<double> right = reference(start.load, mixed, 9.81, start.omega, Slip::none),
                       got = answered(start);
    for (int i = 0; i < got.size(); ++i) {
      ExpectedNumber number{.what = fmt::format("{}: load of box {} (N)", start.name, i + 1),
                            .value = right[i],
                            .tolerance = sweep_rounding};
      for (const Known& each : wrong) number.misconceptions.push_back({got[i], each.what});
      grade.number(number, got[i]);
    }
  }
}

/// Sweeps until no load is wrong by more than 1 % of the lowest.
int sweeps_to_one_percent(const List<double>& mass, double omega) {
  const double weight = 10 * std::accumulate(mass.begin(), mass.end(), 0.0);
  List<double> load(mass.size(), 0.0);
  for (int k = 1; k <= 1000; ++k) {
    sweep(load, mass, 10, omega);
    double exact = weight, worst = 0;
    for (int i = 0; i < mass.size(); ++i) {
      worst = std::max(worst, std::abs(load[i] - exact));
      exact -= 10 * mass[i];
    }
    if (worst <= 0.01 * weight) return k;
  }
  return 1000;
}

void grade_all(Grade& grade) {
  grade_sweeps(grade, {{"4, 0.5, 2, 0.5 kg, from 0, ω = 1.5", {0, 0, 0, 0}, 1.5},
                       {"the same, from too large loads, ω = 1.7", {150, 3, 20, 40}, 1.7}});
  const List<double> ten(10, 1.0);
  const bool starts = answered({.load = {0, 0, 0, 0}})[0] > 0;
  const double best = 2 / (1 + std::sin(std::acos(-1.0) / 20));  // D. M. Young, 1954
  grade.number({.what = "ten boxes of 1 kg, ω = 1: sweeps to 1 %",
                .value = 178,
                .misconceptions = {{1000, starts ? "It never comes to the exact loads." : ""}},
                .tolerance = 0},
               sweeps_to_one_percent(ten, 1));
  grade.number({.what = "ten boxes of 1 kg, the best ω: sweeps to 1 %",
                .value = 21,
                .misconceptions = {{178, "As many as Gauss-Seidel: ω has no effect."}},
                .tolerance = 0},
               sweeps_to_one_percent(ten, best));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 18,
          .task = "A sweep of SOR over a tower with boxes of any masses.",
          .file = "lessons/18_speed_accuracy/exercise.cpp",
          .hints = {"What is left of row i: b_i less the three terms A_{ij} λ_j, with the newest loads.",
                    "The correction is that over A_ii. ω multiplies it, and nothing else.",
                    "load[i] = max(load[i] + omega * left / (1/m_i + 1/m_below), 0)."},
          .grade = grade_all};
}

}  // namespace cairn::exercise18
