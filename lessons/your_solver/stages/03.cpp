// Stage 03, graded: the row of a contact, and sweeps over a tower of 2, 0.5 and 1 kg, held against plain
// loops on a line.
#include "02.cpp"

static void grade_contact(cairn::Grade& grade) {
  const std::vector<Body> bodies = {make_box(10, 1, 0, 3, -0.5), make_box(1, 1, 2, 0.25, 0.5)};
  const Row row = contact(bodies, 0, 1, {0.75, 0}, {0, 1}, -0.01);
  grade.number(
      {"a contact that overlaps by 10 mm: c (m)", -0.01, {{0.01, "The sign: overlap is a gap below 0."}}},
      row.c);
  grade.number({"the contact: j_b[1]",
                1,
                {{-1, "The sign: the normal leads from body a to body b, and c grows that way."}}},
               row.j_b[1]);
  grade.number(
      {"the contact: j_b[2] (m)",
       0.5,
       {{0.75, "The arm begins at the body's centre: subtract it from the point."},
        {-2.25, "The arms are swapped: r_b leads to the point from body b."},
        {-0.5, row.j_a[2] == 2.25 ? "The arm of body b leads from its centre to the point."
                                  : "r × n is r_x n_y − r_y n_x: the order is reversed, or the arm."},
        {0, "A push beside the centre turns the box: r × n."}}},
      row.j_b[2]);
  grade.number({"the contact: j_a[2] (m)",
                2.25,
                {{-2.25, "The sign: all of j_a has a minus."},
                 {-0.75, "The arm begins at the body's centre: subtract it from the point."}}},
               row.j_a[2]);
  const Row beside = contact(bodies, 0, 1, {0.75, 0.75}, {0.6, 0.8}, 0);
  grade.number({"a contact with the normal (0.6, 0.8): j_b[0]",
                0.6,
                {{0, row.j_b[1] == 1 ? "The normal is given: it need not lead upwards." : ""}}},
               beside.j_b[0]);
  const double infinite = 1.0 / 0.0;
  grade.number({"the contact: lower bound (N s)",
                0,
                {{-infinite, "A contact cannot pull: its impulse is at least 0."}}},
               row.lower);
  grade.number(
      {"the contact: upper bound (N s)", infinite, {{0, "A contact may push as hard as it has to."}}},
      row.upper);
  grade.number({"the lower bound of any other row (N s)",
                -infinite,
                {{0, "Bounds belong to the row: a rod may pull, so a new Row has none."}}},
               Row().lower);
}

/// The row of two bodies on a line: j·v is how fast the second rises from the first.
static Row upright_row(int below, int above) {
  Row row;
  row.body_a = below;
  row.body_b = above;
  row.j_a = {0, -1, 0};
  row.j_b = {0, 1, 0};
  row.lower = 0;
  return row;
}

/// The ground and boxes of these masses above each other, which all fall at this speed.
static std::vector<Body> falling_tower(const std::vector<double>& masses, double speed) {
  std::vector<Body> bodies = {make_box(10, 1, 0, 0, -0.5)};
  for (std::size_t i = 0; i < masses.size(); ++i) {
    bodies.push_back(make_box(1, 1, masses[i], 0, 0.5 + static_cast<double>(i)));
    bodies.back().velocity[1] = -speed;
  }
  return bodies;
}

static std::vector<Row> tower_rows(int boxes) {
  std::vector<Row> rows;
  for (int i = 0; i < boxes; ++i) rows.push_back(upright_row(i, i + 1));
  return rows;
}

/// Without bodies and rows: masses on a line, swept by hand. v[0] is the ground.
struct LineTower {
  std::vector<double> weights = {};  // 1/m, the ground's 0 first
  std::vector<double> v = {}, impulse = {};

  LineTower(const std::vector<double>& masses, double speed)
      : weights{0}, v{0}, impulse(masses.size() + 1, 0.0) {
    for (const double mass : masses) {
      weights.push_back(1 / mass);
      v.push_back(-speed);
    }
  }
  void push(std::size_t i, double p) {
    v[i] += weights[i] * p;
    v[i - 1] -= weights[i - 1] * p;
  }
  void sweep_by_hand() {
    for (std::size_t i = 1; i < v.size(); ++i) {
      const double sum = std::max(0.0, impulse[i] + (v[i - 1] - v[i]) / (weights[i] + weights[i - 1]));
      push(i, sum - impulse[i]);
      impulse[i] = sum;
    }
  }
};

/// Three boxes after one sweep; `line` is swept beside them.
static void grade_first_sweep(cairn::Grade& grade, std::vector<Body>& bodies, std::vector<Row>& rows,
                              LineTower& line) {
  sweep(rows, bodies);
  line.sweep_by_hand();
  grade.number({"tower of 2, 0.5 and 1 kg, one sweep: impulse on the ground (N s)",
                line.impulse[1],
                {{0, "row.impulse has not changed: add the push to the rows of the list."},
                 {-line.impulse[1], "The sign: boxes that approach are pushed apart."}}},
               rows[0].impulse);
  // What an impulse of 0 comes from shows in the velocities, and in a second sweep.
  std::vector<Body> later_bodies = bodies;
  std::vector<Row> later = rows;
  sweep(later, later_bodies);
  LineTower later_line = line;
  later_line.sweep_by_hand();
  const bool is_kept = rows[0].impulse != 0, has_moved = bodies[1].velocity[1] != -0.5;
  const char* why_nothing = "No row has changed a velocity: apply each push immediately.";
  if (has_moved) why_nothing = "Apply each push immediately, not after the sweep.";
  if (has_moved && later[1].impulse == 0)
    why_nothing = "The second row was not visited: a sweep visits all rows.";
  if (std::abs(later[0].impulse - later_line.impulse[1]) < 1e-9)
    why_nothing = "The order: a sweep goes from the first row to the last.";
  if (bodies[1].velocity[1] < -0.5) why_nothing = "The sign: apply the push as it is.";
  if (!is_kept) why_nothing = "";
  grade.number({"of the second row (N s)",
                line.impulse[2],
                {{0, why_nothing}, {2 * line.impulse[2], "Each push has been applied twice."}}},
               rows[1].impulse);
  grade.number(
      {"of the third row (N s)",
       line.impulse[3],
       {{0,
         !is_kept               ? ""
         : rows[1].impulse != 0 ? "The last row was not visited."
         : later[1].impulse == 0 || !has_moved || later_line.impulse[1] == later[0].impulse
             ? why_nothing
             : "No row has changed a velocity in time: apply each push immediately, not after the sweep."}}},
      rows[2].impulse);
  grade.number(
      {"velocity of the lowest box (m/s)",
       line.v[1],
       {{0, rows[1].impulse == 0 ? "" : "The second row pushes the lowest box down again: both ends."},
        {-0.5, "No push has reached the bodies: apply it, to the bodies of the list."}}},
      bodies[1].velocity[1]);
}

static void grade_tower(cairn::Grade& grade) {
  const std::vector<double> masses = {2, 0.5, 1};
  std::vector<Body> bodies = falling_tower(masses, 0.5);
  std::vector<Row> rows = tower_rows(3);
  LineTower line(masses, 0.5);
  grade_first_sweep(grade, bodies, rows, line);
  const double first = line.impulse[1];
  sweep(rows, bodies);
  line.sweep_by_hand();
  grade.number({"two sweeps: impulse on the ground (N s)",
                line.impulse[1],
                {{line.impulse[1] - first, "The second push has replaced the first: row.impulse is the sum."},
                 {first, rows[1].impulse == 0 ? "" : "The second sweep has not pushed."}}},
               rows[0].impulse);
}

static void grade_two_sweeps(cairn::Grade& grade) {
  std::vector<Body> bodies = falling_tower({2}, 1);
  std::vector<Row> rows = {upright_row(0, 1)};
  rows[0].bias = 0.25;
  sweep(rows, bodies);
  grade.number({"2 kg that falls at 1 m/s and is to rise at 0.25 m/s: impulse (N s)",
                2 * 1.25,
                {{2, "Use the row's correction: it has the bias in it."}}},
               rows[0].impulse);
  const bool stops = std::abs(bodies[1].velocity[1] - 0.25) < 1e-9;
  bodies[1].velocity[1] -= 0.5;
  sweep(rows, bodies);
  grade.number({"pushed down by 0.5 m/s, and swept again: velocity (m/s)",
                0.25,
                {{1.5, stops ? "Apply the push: the rest of the sum was applied before." : ""}}},
               bodies[1].velocity[1]);
}

static void grade_one_row(cairn::Grade& grade) {
  std::vector<Body> bodies = falling_tower({2}, -1);
  std::vector<Row> rows = {upright_row(0, 1)};
  sweep(rows, bodies);
  grade.number({"2 kg that rises at 1 m/s from its contact: impulse (N s)",
                0,
                {{-2, "A contact cannot pull: clamp the push between the bounds."}}},
               rows[0].impulse);
  grade.number({"its velocity (m/s)", 1, {{0, "Apply what the clamp has left, not the correction."}}},
               bodies[1].velocity[1]);
  bodies = falling_tower({2}, 1);
  rows[0] = upright_row(0, 1);
  rows[0].upper = 0.5;
  sweep(rows, bodies);
  grade.number({"2 kg that falls at 1 m/s, at most 0.5 N s: velocity (m/s)",
                -1 + 0.5 / 2,
                {{0, "The upper bound is not used: a row is only as strong as its bounds."}}},
               bodies[1].velocity[1]);
  bodies = falling_tower({0.5}, -1);
  rows[0] = upright_row(0, 1);
  rows[0].lower = -rows[0].upper;
  sweep(rows, bodies);
  grade.number({"0.5 kg that rises on a rod, which may pull: impulse (N s)",
                -0.5,
                {{0, "Bounds belong to the row: clamp to row.lower, not to 0."}}},
               rows[0].impulse);
}

static void grade_03(cairn::Grade& grade) {
  grade_contact(grade);
  grade_tower(grade);
  grade_two_sweeps(grade);
  grade_one_row(grade);
}

/// With those before it.
static void stage_03(cairn::Grade& grade) {
  stage_02(grade);
  grade.begin(3);
  grade_03(grade);
}
