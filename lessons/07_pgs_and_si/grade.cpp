// Exercise 07, graded: one row between 2 and 0.5 kg by hand, the same where they part, and three rows swept
// by PGS and by SI.
#include "exercise.cpp"

namespace cairn::exercise07 {
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

const List<double> eta_of_three = {3, -3, 5};

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

constexpr const char* own_row = "Row i has given its η_i as well: it belongs into (26) like all the others.";

constexpr const char* sign = "The sign: (27) has ζ − j·v.";

/// Two bodies: nothing given yet, and then something.
void grade_given(Grade& grade) {
  const char* const start = "(26) begins with v̄: the bodies moved before the first push.";
  const double first = updated(0, pair(0), {0});
  const double without_own = by_matrix(triple(), 1, eta_of_three, 0, 3) + eta_of_three[1];
  const bool own_is_missing = std::abs(updated(1, triple(), eta_of_three) - without_own) <= update_rounding;
  grade.number({.what = "2 and 0.5 kg, nothing given yet: η (N)",
                .value = 20,
                .misconceptions = {{-20, sign},
                                   {0, start},
                                   {0.008, "(27) divides by Δt."},
                                   {1 / (1.5 * 0.02), "J_i M⁻¹ J_iᵀ has J_i in it twice."},
                                   {0.4, "That is an impulse: λ is a force, so divide by Δt in (27)."},
                                   {25, "J_i M⁻¹ J_iᵀ has the inverse masses in it."},
                                   {125, "Divide by J_i M⁻¹ J_iᵀ."}},
                .tolerance = update_rounding},
               first);
  grade.number({.what = "10 N given already: η (N)",
                .value = 20,
                .misconceptions = {{10, "That is the correction of (27): add it to η_i."},
                                   {30, own_is_missing
                                            ? own_row
                                            : "(26): the impulses have changed the velocities; v is not v̄."},
                                   {-470, "(26): an impulse is η Δt."},
                                   {22, "(26): an impulse changes a velocity by 1/m."},
                                   {40, "The sign in (26): a row pushes along its J."},
                                   {0, first < 0 ? sign : start}},
                .tolerance = update_rounding},
               updated(0, pair(0), {10}));
}

/// Two bodies that are to part, and two that do already.
void grade_parting(Grade& grade) {
  grade.number({.what = "with ζ = 0.2 m/s: η (N)",
                .value = 24,
                .misconceptions = {{20, "ζ is missing: the row wants j·v = ζ."},
                                   {220, "ζ is a speed, as j·v is: Δt divides both."},
                                   {16, sign}},
                .tolerance = update_rounding},
               updated(0, pair(0.2), {10}));
  Problem parting = pair(0);
  parting.start_velocity = {0, 1};
  parting.dt = 0.03;
  grade.number({.what = "parting at 1 m/s, step of 0.03 s, 10 N given: η (N)",
                .value = -0.4 / 0.03,
                .misconceptions = {{0, updated(0, pair(0), {0}) > 0
                                           ? "Before any clamp: the update itself may be negative."
                                           : ""},
                                   {-20, "The step has 0.03 s here: take problem.dt."}},
                .tolerance = update_rounding},
               updated(0, parting, {10}));
}

void grade_triple(Grade& grade) {
  const Problem problem = triple();
  const List<double>& eta = eta_of_three;
  const double alone = by_matrix(problem, 1, eta, 0, 0);
  grade.number(
      {.what = "three rows: η_2 (N)",
       .value = by_matrix(problem, 1, eta, 0, 3),
       .misconceptions = {{by_matrix(problem, 1, eta, 0, 2),
                           "The last row is missing in (26): all rows have given impulses."},
                          {by_matrix(problem, 1, eta, 1, 3),
                           "The first row is missing in (26): all rows have given impulses."},
                          {alone, "The other rows are missing in (26): all have given impulses."},
                          {by_matrix(problem, 1, eta, 0, 3) + eta[1], own_row},
                          {by_matrix(problem, 1, eta, 2, 3) + eta[1],
                           "Each row adds to the velocities of (26): the last one replaces the others."},
                          {alone + eta[1] - (eta[0] + eta[1] + eta[2]),
                           "In (26) each row pushes along its own J: J_j, and J_i in (27)."},
                          {by_matrix(problem, 1, List<double>(3, eta[1]), 0, 3),
                           "In (26) each row has its own η: η_j."}},
       .tolerance = update_rounding},
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
  return {.lesson = 7,
          .task = "The update in between, (29): the velocities from all η by (26), and then (27).",
          .file = "lessons/07_pgs_and_si/exercise.cpp",
          .hints = {"PGS has η and no velocities; SI needs velocities. Which equation makes them of η?",
                    "v̄_k, and for every row j: inverse mass k times J_jk times η_j Δt. Then j·v of row i.",
                    "new_eta = eta[i] + (zeta_i − j·v) / (sum over k of J_ik² / m_k, times Δt)."},
          .grade = [](Grade& grade) {
            grade_given(grade);
            grade_parting(grade);
            grade_triple(grade);
          }};
}

}  // namespace cairn::exercise07
