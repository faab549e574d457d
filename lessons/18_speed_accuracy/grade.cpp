// Exercise 18, graded: sweeps over towers of mixed masses beside sweeps with one mistake each, and the sweeps
// that Young's ω saves.
#include <fmt/format.h>

#include <numeric>

#include "exercise.cpp"

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
  sign,
  clamps_each
};

struct Known {
  Slip slip = Slip::none;
  std::string what = {};
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
      {Slip::sign, "The sign: add what is left of b − A λ."},
      {Slip::clamps_each, "A load may shrink: clamp the load, not the correction."}};
}

double updated(const List<double>& load, const List<double>& before, const List<double>& mass, int i,
               double gravity, double omega, Slip slip) {
  const double own = 1 / mass[i], below = i > 0 ? 1 / mass[i - 1] : 0;
  const double diagonal = slip == Slip::one_mass ? own : own + below;
  const bool swaps = slip == Slip::swapped && i > 0;
  double left = (i == 0 ? gravity : 0) - diagonal * load[i];
  if (i > 0) left += (swaps ? own : below) * (slip == Slip::old_loads ? before : load)[i - 1];
  if (i + 1 < load.size() && slip != Slip::no_above) left += (swaps ? below : own) * load[i + 1];
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
  for (int i = 0; i < load.size(); ++i) load[i] = updated(load, before, mass, i, gravity, omega, slip);
  return load;
}

void grade_sweep(Grade& grade, const std::string& name, const List<double>& start, double omega) {
  const List<double> mass = {2, 0.5, 2, 0.5};
  List<double> got = start;
  sweep(got, mass, 9.81, omega);
  for (int i = 0; i < start.size(); ++i) {
    const auto of = [&](Slip slip) { return reference(start, mass, 9.81, omega, slip)[i]; };
    ExpectedNumber number{.what = fmt::format("{}: load of box {} (N)", name, i + 1),
                          .value = of(Slip::none),
                          .tolerance = sweep_rounding};
    for (const Known& each : known()) number.misconceptions.push_back({of(each.slip), each.what});
    grade.number(number, got[i]);
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
  grade_sweep(grade, "2, 0.5, 2, 0.5 kg, from 0, ω = 1.5", {0, 0, 0, 0}, 1.5);
  grade_sweep(grade, "the same, from too large loads, ω = 1.7", {150, 3, 20, 40}, 1.7);
  const List<double> ten(10, 1.0);
  const double best = 2 / (1 + std::sin(std::acos(-1.0) / 20));  // D. M. Young, 1954
  grade.number({.what = "ten boxes of 1 kg, ω = 1: sweeps to 1 %",
                .value = 178,
                .tolerance = 0,
                .misconceptions = {{1000, "It never comes to the exact loads."}}},
               sweeps_to_one_percent(ten, 1));
  grade.number({.what = "ten boxes of 1 kg, the best ω: sweeps to 1 %",
                .value = 21,
                .tolerance = 0,
                .misconceptions = {{178, "As many as Gauss-Seidel: ω has no effect."}}},
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
