// Exercise 08, graded: one row between 2 and 0.5 kg by hand, and three rows swept by PGS and by SI.
#include <algorithm>
#include <cmath>

#include "exercise.cpp"

namespace cairn::exercise08 {
namespace {

constexpr double update_rounding =
    1e-11;  // of forces below 1000, after 30 row updates of some ten operations

/// One row between bodies of 2 and 0.5 kg; the second comes down on the first at 1 m/s.
Problem pair(double zeta) {
  return {.J = {{-1, 1}}, .inverse_mass = {0.5, 2}, .start_velocity = {0, -1}, .zeta = {zeta}, .dt = 0.02};
}

/// Three bodies with two numbers each, and three rows that all touch the second one.
Problem triple() {
  return {.J = {{1, 0.5, -1, 0, 0, 0}, {0, 0, 1, -0.5, -1, 0.25}, {0, 1, 0.5, 1, 0, -1}},
          .inverse_mass = {1, 2, 0.5, 3, 1, 4},
          .start_velocity = {0.5, -1, 0.25, 0, 1, -0.5},
          .zeta = {0, 0.1, -0.2},
          .dt = 0.02};
}

/// J_i M⁻¹ J_jᵀ.
double entry(const Problem& problem, int i, int j) {
  double sum = 0;
  for (int k = 0; k < problem.inverse_mass.size(); ++k)
    sum += problem.J[i][k] * problem.inverse_mass[k] * problem.J[j][k];
  return sum;
}

double speed_of(const Problem& problem, int i, const List<double>& velocity) {
  double sum = 0;
  for (int k = 0; k < velocity.size(); ++k) sum += problem.J[i][k] * velocity[k];
  return sum;
}

/// (28), as if the rows from `first` up to `end` alone had given anything.
double by_matrix(const Problem& problem, int i, const List<double>& eta, int first, int end) {
  double rest = (problem.zeta[i] - speed_of(problem, i, problem.start_velocity)) / problem.dt;
  for (int j = first; j < end; ++j) {
    if (j != i) rest -= entry(problem, i, j) * eta[j];
  }
  return rest / entry(problem, i, i);
}

/// Sequential impulses: all λ [N] after so many sweeps.
List<double> by_velocities(const Problem& problem, int sweeps) {
  List<double> velocity = problem.start_velocity, lambda(problem.J.size(), 0);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < lambda.size(); ++i) {
      const double impulse =
          (problem.zeta[i] - speed_of(problem, i, velocity)) / entry(problem, i, i);  // (22) times Δt
      lambda[i] += impulse / problem.dt;
      for (int k = 0; k < velocity.size(); ++k)
        velocity[k] += problem.inverse_mass[k] * problem.J[i][k] * impulse;
    }
  }
  return lambda;
}

void grade_pair(Grade& grade) {
  grade.number({.what = "2 and 0.5 kg, nothing given yet: η (N)",
                .value = 20,
                .tolerance = update_rounding,
                .misconceptions = {{-20, "The sign: (27) has ζ − j·v."},
                                   {0.4, "That is an impulse: λ is a force, so divide by Δt in (27)."},
                                   {25, "J_i M⁻¹ J_iᵀ has the inverse masses in it."},
                                   {125, "Divide by J_i M⁻¹ J_iᵀ."}}},
               updated(0, pair(0), {0}));
  grade.number({.what = "10 N given already: η (N)",
                .value = 20,
                .tolerance = update_rounding,
                .misconceptions = {{10, "That is the correction of (27): add it to η_i."},
                                   {30, "(26): the impulses have changed the velocities; v is not v̄."},
                                   {-470, "(26): an impulse is η Δt."},
                                   {22, "(26): an impulse changes a velocity by 1/m."},
                                   {40, "The sign in (26): a row pushes along its J."},
                                   {0, "(26) begins with v̄: the bodies moved before the first push."}}},
               updated(0, pair(0), {10}));
  grade.number(
      {.what = "with ζ = 0.2 m/s: η (N)",
       .value = 24,
       .tolerance = update_rounding,
       .misconceptions = {{20, "ζ is missing: the row wants j·v = ζ."}, {16, "The sign: (27) has ζ − j·v."}}},
      updated(0, pair(0.2), {10}));
}

void grade_triple(Grade& grade) {
  const Problem problem = triple();
  const List<double> eta = {3, -2, 5};
  grade.number({.what = "three rows: η_2 (N)",
                .value = by_matrix(problem, 1, eta, 0, 3),
                .tolerance = update_rounding,
                .misconceptions = {{by_matrix(problem, 1, eta, 0, 2),
                                    "The last row is missing in (26): all rows have given impulses."},
                                   {by_matrix(problem, 1, eta, 1, 3),
                                    "The first row is missing in (26): all rows have given impulses."},
                                   {by_matrix(problem, 1, eta, 0, 0),
                                    "The other rows are missing in (26): all have given impulses."}}},
               updated(1, problem, eta));
  List<double> swept(3, 0);
  for (int sweep = 0; sweep < 10; ++sweep) {
    for (int i = 0; i < 3; ++i) swept[i] = updated(i, problem, swept);
  }
  const List<double> wanted = by_velocities(problem, 10);
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const double off = std::abs(swept[i] - wanted[i]);
    worst = std::isnan(off) ? off : std::max(worst, off);
  }
  grade.number(
      {.what = "10 sweeps: largest difference from SI (N)", .value = 0, .tolerance = update_rounding}, worst);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 8,
          .task = "The update in between, (29): the velocities from all η by (26), and then (27).",
          .file = "lessons/08_same_thing_twice/exercise.cpp",
          .hints = {"PGS has η and no velocities; SI needs velocities. Which equation makes them of η?",
                    "v̄_k, and for every row j: inverse mass k times J_jk times η_j Δt. Then j·v of row i.",
                    "new_eta = eta[i] + (zeta_i − j·v) / (sum over k of J_ik² / m_k, times Δt)."},
          .grade = [](Grade& grade) {
            grade_pair(grade);
            grade_triple(grade);
          }};
}

}  // namespace cairn::exercise08
