// Exercise 06, graded: boxes of 2 and 0.5 kg, every kind of row at both ends of its interval, and a rod.
#include "exercise.cpp"

namespace cairn::exercise06 {
namespace {

constexpr double sweep_rounding = 1e-13;  // a few dozen operations on numbers below 100

List<double> swept(const System& system, int sweeps) {
  List<double> lambda(system.b.size(), 0);
  for (int k = 0; k < sweeps; ++k) sweep(system, lambda);
  return lambda;
}

bool is_near(double got, double value) { return std::abs(got - value) <= sweep_rounding; }

/// Boxes of 2, 0.5 and 2 kg on each other, held by rows that push and pull: one sweep, then two.
void grade_stack(Grade& grade, const List<double>& one, const List<double>& two) {
  // Row 2 has seen nothing of row 1.
  const char* blind = "Row 2 needs the λ_1 of this sweep: the newest λ, not the old ones.";
  if (is_near(two[1], 0)) blind = "The rows before row i count as well: all j but i.";
  if (is_near(two[0], 24)) blind = "The order: a sweep goes from the first row to the last.";
  const bool is_blind = is_near(one[1], 0) && !is_near(one[0], 0);
  grade.number({.what = "1 sweep of 3 joints: λ_1 (N)",
                .value = 20,
                .misconceptions = {{0, "Row 1 got nothing: the first row has the index 0."},
                                   {10, "Divide by A_ii: (28)."},
                                   {5, "Divide by A_ii instead of multiplying: (28)."},
                                   {24, "One sweep a call: each row has one turn."},
                                   {45, "That solves all rows together: here each row is solved for itself."},
                                   {-20, "The sign: A λ = b."}},
                .tolerance = sweep_rounding},
               one[0]);
  grade.number({.what = "1 sweep of 3 joints: λ_2 (N)",
                .value = 4,
                .misconceptions = {{0, is_blind ? blind : ""}, {-4, "The sign: take A_ij λ_j off b_i."}},
                .tolerance = sweep_rounding},
               one[1]);
  grade.number({.what = "1 sweep of 3 joints: λ_3 (N)",
                .value = 3.2,
                .misconceptions = {{0, is_blind             ? blind
                                       : is_near(one[1], 0) ? ""
                                                            : "The last row had no turn."}},
                .tolerance = sweep_rounding},
               one[2]);
  grade.number(
      {.what = "2 sweeps of 3 joints: λ_1 (N)",
       .value = 24,
       .misconceptions = {{4, "A_ii λ_i belongs on the left: leave j = i out of the sum."},
                          {20, is_blind ? blind : "The rows after row i count as well: all j but i."},
                          {44, "(28) gives the new λ_i itself: replace the old one."}},
       .tolerance = sweep_rounding},
      two[0]);
}

/// Joints whose sweeps need every row. Whether they are right.
bool grade_joints(Grade& grade) {
  const System stack{
      .A = {{0.5, -0.5, 0}, {-0.5, 2.5, -2}, {0, -2, 2.5}}, .b = {10, 0, 0}, .rows = List<Row>(3, Row{})};
  const List<double> one = swept(stack, 1), two = swept(stack, 2);
  grade_stack(grade, one, two);
  const System star{.A = {{2, 1, 1}, {1, 2, 1}, {1, 1, 2}}, .b = {8, 0, 0}, .rows = List<Row>(3, Row{})};
  const double last = swept(star, 1)[2];
  const char* const neighbours = "Every other row counts, not only the one before and the one after.";
  grade.number({.what = "1 sweep of 3 joints on one body: λ_3 (N)",
                .value = -1,
                .misconceptions = {{1, is_near(one[2], 3.2) ? neighbours : ""}},
                .tolerance = sweep_rounding},
               last);
  return is_near(one[2], 3.2) && is_near(two[0], 24) && is_near(last, -1);
}

/// A row alone, that needs `needed` N: what it gets.
double alone(RowKind kind, double needed, double strength = 2) {
  return swept({.A = {{2}}, .b = {2 * needed}, .rows = {{.kind = kind, .strength = strength}}}, 1)[0];
}

/// An answer that does not solve a joint alone has words for that, and none for its intervals.
void grade_kinds(Grade& grade) {
  const bool solves = is_near(alone(RowKind::joint, 1), 1);
  const auto row = [&](const char* what, double got, double value, const std::vector<Misconception>& wrong) {
    grade.number({.what = what,
                  .value = value,
                  .misconceptions = solves ? wrong : std::vector<Misconception>{},
                  .tolerance = sweep_rounding},
                 got);
  };
  row("a joint that needs -3 N (N)", alone(RowKind::joint, -3), -3,
      {{0, "A joint pulls, too."}, {-2, "Only a motor has a strength: a joint takes no notice of it."}});
  row("a contact that needs 3 N (N)", alone(RowKind::contact, 3), 3,
      {{0, "A contact pushes: λ ≥ 0."},
       {2, "Only a motor has a strength: a contact takes no notice of it."}});
  row("a contact that needs -3 N (N)", alone(RowKind::contact, -3), 0, {{-3, "A contact does not pull."}});
  row("a rope that needs 3 N (N)", alone(RowKind::rope, 3), 3,
      {{0, "A rope pulls, and a pull is λ ≥ 0: j·v is how fast it goes slack."}});
  row("a rope that needs -3 N (N)", alone(RowKind::rope, -3), 0, {{-3, "A rope does not push."}});
  row("a motor of 2 N that needs 3 N (N)", alone(RowKind::motor, 3), 2,
      {{3, "A motor has only its strength."},
       {1, "Clamp λ itself, after the division by A_ii."},
       {0, "What is out of the interval goes to its end, not to 0."}});
  row("a motor of 1 N that needs -3 N (N)", alone(RowKind::motor, -3, 1), -1,
      {{-3, "A motor has only its strength, in both directions."},
       {-2, "Each motor has its own strength."},
       {-0.5, "Clamp λ itself, after the division by A_ii."},
       {1, "What is below -strength goes to -strength."},
       {0, "A motor brakes as well: its interval begins at -strength."}});
}

/// The rod of this lesson with 2 kg: twice the A, half the forces.
void grade_rod(Grade& grade, bool solves) {
  const System rod{
      .A = {{2, 1}, {1, 2.0 / 3}}, .b = {10, 10}, .rows = List<Row>(2, {.kind = RowKind::contact})};
  const List<double> two = swept(rod, 2), three = swept(rod, 3);
  grade.number(
      {.what = "the rod, 2 sweeps: λ_1 (N)",
       .value = 1.25,
       .misconceptions = {{5, solves ? "A contact may give less than before: clamp λ itself, not its change."
                                     : ""}},
       .tolerance = sweep_rounding},
      two[0]);
  grade.number(
      {.what = "the rod, 3 sweeps: λ_2 (N)",
       .value = 15,
       .misconceptions = {{13.125, "What is out of the interval goes to its end: do not keep the old λ."},
                          {17.34375, "Clamp immediately: row 2 must see that row 1 cannot pull."}},
       .tolerance = sweep_rounding},
      three[1]);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 6,
      .task = "One sweep of projected Gauss-Seidel: (28) for every row, and the interval of its kind (2.2).",
      .file = "lessons/06_sweep_and_bounds/exercise.cpp",
      .hints = {"Solve row i for λ_i with all other λ as they are, and clamp it before you go on.",
                "rest = b_i less A_ij λ_j for all j but i; then rest / A_ii.",
                "A contact and a rope: 0 to infinite, by the signs of j·v; a motor: -strength to strength. "
                "std::clamp(value, lower, upper)."},
      .grade = [](Grade& grade) {
        const bool solves = grade_joints(grade);
        grade_kinds(grade);
        grade_rod(grade, solves);
      }};
}

}  // namespace cairn::exercise06
