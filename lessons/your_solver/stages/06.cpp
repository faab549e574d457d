// Stage 06, graded: bounds in newton, and sweeps over a matrix given here.
#include "05.cpp"

static void grade_bounds(cairn::Grade& grade) {
  std::vector<Row> rows = {slanted_row(1, 2)};
  rows[0].lower = -0.3;
  rows[0].upper = 0.2;
  const System system = build(rows, two_masses(), 0.05);
  grade.number({"one row: entries of system.lower", 1}, static_cast<double>(system.lower.size()));
  if (system.lower.size() != 1 || system.upper.size() != 1) return;
  grade.number({"bounds from −0.3 to 0.2 N s, Δt = 0.05 s: lower (N)",
                -0.3 / 0.05,
                {{-0.3, "The factor 1/Δt is missing: λ is a force, a row's bounds are impulses."},
                 {0.2 / 0.05, "Lower and upper are swapped."},
                 {0, "Bounds belong to the row: row.lower, not 0."},
                 {-0.3 * 0.05, "Divide by Δt: λ is a force."}}},
               system.lower[0]);
  grade.number({"upper (N)", 0.2 / 0.05, {{0.2, "The factor 1/Δt is missing: λ is a force."}}},
               system.upper[0]);
}

static System made_system(std::vector<std::vector<double>> A, std::vector<double> b, double lower,
                          double upper) {
  System system;
  system.A = A;
  system.b = b;
  system.lower.assign(b.size(), lower);
  system.upper.assign(b.size(), upper);
  return system;
}

static std::vector<double> swept(const System& system, int sweeps) {
  std::vector<double> lambda(system.b.size(), 0.0);
  for (int k = 0; k < sweeps; ++k) sweep_matrix(system, lambda);
  return lambda;
}

static void grade_sweeps(cairn::Grade& grade) {
  const double all = 1e9;
  const System chain = made_system({{2, -1, 0}, {-1, 2.5, -2}, {0, -2, 4}}, {10, 0, 1}, -all, all);
  const std::vector<double> once = swept(chain, 1), twice = swept(chain, 2);
  const char* const order = "The order: a sweep goes from the first row to the last.";
  const char* const before = "The rows before row i count as well: all k ≠ i.";
  const bool is_jacobi = twice[1] > 1, is_backwards = std::abs(once[1] - 0.2) < 1e-9;
  grade.number({"three rows, one sweep: λ of the first (N)",
                10 / 2.0,
                {{10, "Divide by A_ii."},
                 {5.1, order},
                 {0, "The first row was not visited, or lambda is a copy."},
                 {20, "Divide by A_ii, do not multiply."}}},
               once[0]);
  grade.number({"of the second (N)",
                5 / 2.5,
                {{0, is_jacobi ? "That is Jacobi: use the newest λ, that of row 1 included." : before},
                 {0.2, order},
                 {-5 / 2.5, "The sign: b − Σ A_ik λ_k."},
                 {-10 / 2.5 * 0.5, "The sign: b − Σ A_ik λ_k."}}},
               once[1]);
  grade.number({"of the third (N)",
                (1 + 2 * 2) / 4.0,
                {{0.25, is_backwards ? order
                        : is_jacobi  ? "That is Jacobi: use the newest λ."
                                     : before},
                 {0, "An index too few: the last row was not visited."}}},
               once[2]);
  grade.number(
      {"two sweeps: of the first (N)",
       (10 + 2) / 2.0,
       {{(10 + 2 - 2 * 5) / 2.0, "The sum leaves the row's own λ out: k ≠ i."},
        {5,
         once[1] == 0 ? "" : "The second sweep begins with what the first has found, and all k ≠ i count."},
        {5 + 6, "λ_i is replaced, not added to: (28) gives the whole λ."}}},
      twice[0]);
}

/// Three rows of which each meets both others; whether they and the chain are swept as they should be.
static bool grade_star(cairn::Grade& grade) {
  const double all = 1e9;
  const std::vector<double> once =
      swept(made_system({{2, 1, 1}, {1, 2, 1}, {1, 1, 2}}, {8, 0, 0}, -all, all), 1);
  grade.number({"three rows that all meet, one sweep: λ of the third (N)",
                -1,
                {{1, once[1] == -2 ? "All other rows count, not only those beside row i." : ""}}},
               once[2]);
  return once[2] == -1;
}

static void grade_clamp(cairn::Grade& grade, bool sweeps) {
  const double all = 1e9;
  // The lesson's rod on two supports, with other numbers: without bounds row 1 would pull.
  const System supports = made_system({{1, 0.75}, {0.75, 1}}, {10, 22.5}, 0, all);
  const std::vector<double> twice = swept(supports, 2);
  const double motor = swept(made_system({{2}}, {10}, -all, 3), 1)[0];
  const char* const end =
      "What is out of the bounds goes to the bound: not to 0, and not to the λ of before.";
  const char* const undivided = "Clamp λ itself, after the division by A_ii.";
  grade.number({"two supports, two sweeps: λ of the first (N)",
                0,
                {{10 - 0.75 * 15, "A contact cannot pull: clamp λ between its bounds."},
                 {10, !sweeps      ? ""
                      : motor == 0 ? end
                                   : "Clamp λ itself, not what is added to it: it may go down again."}}},
               twice[0]);
  grade.number(
      {"of the second (N)",
       22.5,
       {{22.5 + 0.75 * 1.25, "Clamp immediately, in row 1's turn: row 2 has to see it."},
        {15, sweeps && twice[0] == 0 ? "The second row has to see that the first gives nothing." : ""}}},
      twice[1]);
  grade.number({"a motor with at most 3 N, where 5 N are needed (N)",
                3,
                {{5, "The upper bound is not used."}, {0, end}, {1.5, undivided}}},
               motor);
  grade.number({"a lower bound of −4 N, where −5 N are needed (N)",
                -4,
                {{0, motor == 0 ? end : "Bounds belong to the row: clamp to system.lower, not to 0."},
                 {-2, undivided},
                 {-5, "The lower bound is not used."}}},
               swept(made_system({{2}}, {-10}, -4, all), 1)[0]);
  System both = made_system({{2, 0}, {0, 2}}, {10, 10}, -all, all);
  both.upper[1] = 2;
  grade.number({"a row with a bound behind one without: λ of the second (N)",
                2,
                {{5, motor == 3 ? "Each row has its own bounds: lower[i] and upper[i]." : ""}}},
               swept(both, 1)[1]);
}

static void grade_06(cairn::Grade& grade) {
  grade_bounds(grade);
  grade_sweeps(grade);
  const bool sweeps = grade_star(grade);
  grade_clamp(grade, sweeps);
}

/// With those before it.
static void stage_06(cairn::Grade& grade) {
  stage_05(grade);
  grade.begin(6);
  grade_06(grade);
}
