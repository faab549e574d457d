// Stage 07, graded: λ of both ways after each sweep, held against plain loops on a line and against the
// feet's formula.
#include "06.cpp"

static void grade_sizes(cairn::Grade& grade, const Record& record, std::size_t sweeps, std::size_t rows) {
  const double fewer = static_cast<double>(sweeps) - 1;
  grade.number({"four sweeps: entries of record.matrix",
                static_cast<double>(sweeps),
                {{1, "One entry for each sweep, not only for the last."}, {fewer, "An index too few."}}},
               static_cast<double>(record.matrix.size()));
  grade.number({"entries of record.impulses",
                static_cast<double>(sweeps),
                {{1, "One entry for each sweep, not only for the last."}, {fewer, "An index too few."}}},
               static_cast<double>(record.impulses.size()));
  for (const auto& lambda : record.matrix)
    grade.number({"rows in an entry of record.matrix", static_cast<double>(rows)},
                 static_cast<double>(lambda.size()));
  for (const auto& lambda : record.impulses)
    grade.number({"rows in an entry of record.impulses", static_cast<double>(rows)},
                 static_cast<double>(lambda.size()));
}

static void grade_both_ways(cairn::Grade& grade) {
  const double dt = 0.05;
  const std::vector<double> masses = {2, 0.5, 1};
  std::vector<Row> rows = tower_rows(3);
  for (Row& row : rows) row.impulse = 7;  // of another step
  const Record record = compare(rows, falling_tower(masses, 0.5), dt, 4);
  grade_sizes(grade, record, 4, 3);
  if (!grade.passed()) return;
  LineTower line(masses, 0.5), shifted(masses, 0.5);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::vector<double> before = line.impulse;
    line.sweep_by_hand();
    LineTower next = line;
    next.sweep_by_hand();
    const std::string sweep_of = "sweep " + std::to_string(k + 1) + ": λ on the ground, with ";
    const double force = line.impulse[1] / dt;
    grade.number(
        {sweep_of + "the matrix (N)",
         force,
         {{LineTower(masses, 0.5).v[1] * -2 / dt, "Each sweep begins where the last one ended: keep λ."},
          {next.impulse[1] / dt, "One sweep before each entry, not two."},
          {before[1] / dt, "Record λ after the sweep, not before it."}}},
        record.matrix[k][0]);
    grade.number({sweep_of + "impulses (N)",
                  force,
                  {{line.impulse[1], "That is an impulse in N s: divide by Δt."},
                   {line.impulse[1] * dt, "Divide by Δt, do not multiply."},
                   {2 * 0.5 / dt, "Each sweep begins where the last one ended: keep rows and bodies."},
                   {before[1] / dt, "Record λ after the sweep, not before it."},
                   {(line.impulse[1] - before[1]) / dt,
                    "That is the push of one sweep: row.impulse is the sum of all."},
                   {(7 + line.impulse[1]) / dt, "Both begin from 0."}}},
                 record.impulses[k][0]);
  }
}

/// The last of three rows, so that each has its own λ.
static void grade_last_row(cairn::Grade& grade) {
  const double dt = 0.05;
  const std::vector<double> masses = {2, 0.5, 1};
  const Record record = compare(tower_rows(3), falling_tower(masses, 0.5), dt, 2);
  if (record.matrix.size() != 2 || record.impulses.size() != 2) return;
  LineTower line(masses, 0.5);
  for (int k = 0; k < 2; ++k) line.sweep_by_hand();
  const char* const own = "Each row has its own λ.";
  const double first = line.impulse[1] / dt, last = line.impulse[3] / dt;
  grade.number({"sweep 2: λ of the third row, with the matrix (N)", last, {{first, own}}},
               record.matrix[1][2]);
  grade.number({"with impulses (N)", last, {{first, own}}}, record.impulses[1][2]);
}

static void grade_feet(cairn::Grade& grade) {
  const double dt = 0.05, half = 3, q = 5.0 / 11;  // as in stage 04
  const Landing landing;
  const Record record = compare(landing.rows, landing.bodies, dt, 3);
  grade.number({"three sweeps: entries of record.impulses",
                3,
                {{4, "`sweeps` says how many there are."}, {10, "`sweeps` says how many there are."}}},
               static_cast<double>(record.impulses.size()));
  if (record.matrix.size() != 3 || record.impulses.size() != 3) return;
  const double taken_back = half * (1 + std::pow(q, 5)) / dt;
  grade.number({"landing on two feet, sweep 3: with the matrix (N)", taken_back}, record.matrix[2][0]);
  grade.number({"with impulses (N)", taken_back}, record.impulses[2][0]);
}

static void grade_bias_both_ways(cairn::Grade& grade) {
  std::vector<Row> rows = tower_rows(1);
  rows[0].bias = 0.25;
  const Record record = compare(rows, falling_tower({0.5}, 1), 0.04, 2);
  if (record.matrix.empty() || record.impulses.empty()) return;
  const double force = 0.5 * 1.25 / 0.04;
  grade.number({"0.5 kg that is to rise at 0.25 m/s: with the matrix (N)",
                force,
                {{0, "A and b are built once, from the velocities before the first sweep."}}},
               record.matrix.back()[0]);
  grade.number({"with impulses (N)",
                force,
                {{force * 0.04 / 0.05, "This step has 0.04 s: divide by the dt that is given."}}},
               record.impulses.back()[0]);
}

static void grade_07(cairn::Grade& grade) {
  grade_both_ways(grade);
  grade_last_row(grade);
  grade_feet(grade);
  grade_bias_both_ways(grade);
}

/// With those before it.
static void stage_07(cairn::Grade& grade) {
  stage_06(grade);
  grade.begin(7);
  grade_07(grade);
}
