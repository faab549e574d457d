// Exercise 08, graded: three rows, swept by PGS with the answer and by SI with velocities.
#include <cmath>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise08 {
namespace {

using Matrix = List<List<double>>;

constexpr double sweep_rounding = 1e-14;  // of impulses near 1 after 30 row updates of ten operations each

// Three bodies with two numbers each, and three rows that all touch the second one.
const Matrix rows = {{1, 0.5, -1, 0, 0, 0}, {0, 0, 1, -0.5, -1, 0.25}, {0, 1, 0.5, 1, 0, -1}};
const List<double> inverse_mass = {1, 2, 0.5, 3, 1, 4};  // [1/kg]
const List<double> start = {0.5, -1, 0.25, 0, 1, -0.5};  // [m/s]

double speed_of(int row, const List<double>& velocity) {
  double sum = 0;
  for (int k = 0; k < velocity.size(); ++k) sum += rows[row][k] * velocity[k];
  return sum;
}

Matrix system_matrix() {
  Matrix a(3, List<double>(3, 0));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < start.size(); ++k) a[i][j] += rows[i][k] * inverse_mass[k] * rows[j][k];
    }
  }
  return a;
}

/// Sequential impulses: impulses after so many sweeps.
List<double> by_velocities(int sweeps) {
  const Matrix a = system_matrix();
  List<double> velocity = start, impulse(3, 0);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < 3; ++i) {
      const double correction = -speed_of(i, velocity) / a[i][i];
      impulse[i] += correction;
      for (int k = 0; k < start.size(); ++k) velocity[k] += inverse_mass[k] * rows[i][k] * correction;
    }
  }
  return impulse;
}

List<double> by_answer(Answer answer, int sweeps) {
  const Matrix a = system_matrix();
  List<double> impulse(3, 0);
  const List<double> change = {-speed_of(0, start), -speed_of(1, start), -speed_of(2, start)};
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < 3; ++i) impulse[i] = answer(i, a, change, impulse);
  }
  return impulse;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const Matrix two = {{2, 1}, {1, 4}};
  grade.number(
      {.what = "A = (2 1; 1 4), b dt = (3, 5), eta = (0, 0): eta_0 (N s)",
       .value = 1.5,
       .tolerance = sweep_rounding,
       .misconceptions = {{3, "Divide by A_ii."}, {-1.5, "The sign: A eta = b dt."}, {6, "Divide by A_ii."}}},
      answer(0, two, {3, 5}, {0, 0}));
  grade.number({.what = "the same with eta = (1, 0.5): eta_1 (N s)",
                .value = 1,
                .tolerance = sweep_rounding,
                .misconceptions = {{0.5, "That is the correction of SI: PGS gives the new value itself."},
                                   {1.5, "The other rows push as well: take A_ij eta_j off."},
                                   {1.25, "The other rows push as well: take A_ij eta_j off."}}},
               answer(1, two, {3, 5}, {1, 0.5}));
  for (const int sweeps : {1, 10}) {
    const List<double> wanted = by_velocities(sweeps), got = by_answer(answer, sweeps);
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
      const double off = std::abs(got[i] - wanted[i]);
      worst = std::isnan(off) || off > worst ? off : worst;
    }
    grade.number({.what = sweeps == 1 ? "1 sweep: largest difference from SI (N s)"
                                      : "10 sweeps: largest difference from SI (N s)",
                  .tolerance = sweep_rounding},
                 worst);
  }
}

Exercise exercise() {
  return {
      .lesson = 8,
      .task = "A row update of PGS, equation (28). SI does the same with velocities: the two are compared.",
      .file = "lessons/08_same_thing_twice/exercise.cpp",
      .hints = {"Row i of A eta = b dt, with all impulses but eta_i as they are. Solve it for eta_i.",
                "Take the sum of A_ij eta_j over the other rows j off b_i dt.",
                "eta_i = (b_i dt - sum over j != i of A_ij eta_j) / A_ii."},
      .grade = [](Grade& marks) { grade(marks, row_update); }};
}

}  // namespace cairn::exercise08
