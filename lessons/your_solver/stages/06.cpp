// Stage 06, graded: sweeps over a tower of 2, 0.5 and 1 kg, held against plain loops on a line.
#include "05.cpp"

/// The row of two bodies on a line: j·v is how fast the second rises from the first.
static Row upright_row(int below, int above) {
  Row row;
  row.body1 = below;
  row.body2 = above;
  row.j1 = {0, -1, 0};
  row.j2 = {0, 1, 0};
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

/// A tower of 2, 0.5 and 1 kg that falls: as bodies and rows, and as masses on a line.
struct SweptTower {
  const std::vector<double> masses = {2, 0.5, 1};
  std::vector<Body> bodies = falling_tower(masses, 0.5);
  std::vector<Row> rows = tower_rows(3);
  LineTower line = LineTower(masses, 0.5);

  void sweep_both() {
    sweep(rows, bodies);
    line.sweep_by_hand();
  }
};

/// What an impulse of 0 in the second row comes from: the velocities show it, and a second sweep.
static const char* tower_why_nothing(const SweptTower& once, const SweptTower& twice) {
  if (once.rows[0].impulse == 0) return "";
  if (once.bodies[1].velocity[1] < -0.5) return "The sign: apply the push as it is.";
  if (std::abs(twice.rows[0].impulse - twice.line.impulse[1]) < 1e-9)
    return "The order: a sweep goes from the first row to the last.";
  if (once.bodies[1].velocity[1] == -0.5) return "No row has changed a velocity: apply each push at once.";
  return twice.rows[1].impulse == 0 ? "The second row was not visited: a sweep visits all rows."
                                    : "Apply each push at once, not after the sweep.";
}

/// The same of the third.
static const char* tower_why_no_third(const SweptTower& once, const SweptTower& twice) {
  if (once.rows[0].impulse == 0) return "";
  if (once.rows[1].impulse != 0) return "The last row was not visited.";
  const bool is_other = twice.rows[1].impulse == 0 || once.bodies[1].velocity[1] == -0.5 ||
                        twice.line.impulse[1] == twice.rows[0].impulse;
  return is_other ? tower_why_nothing(once, twice)
                  : "No row has changed a velocity in time: apply each push at once, not after the sweep.";
}

static void grade_tower(cairn::Grade& grade) {
  SweptTower once;
  once.sweep_both();
  SweptTower twice = once;
  twice.sweep_both();
  const LineTower& line = once.line;
  const std::vector<Row>& rows = once.rows;
  grade.number({"tower of 2, 0.5 and 1 kg, one sweep: impulse on the ground (N s)",
                line.impulse[1],
                {{0, "row.impulse has not changed: add the push to the rows of the list."},
                 {-line.impulse[1], "The sign: boxes that close in are pushed apart."}}},
               rows[0].impulse);
  grade.number(
      {"of the second row (N s)",
       line.impulse[2],
       {{0, tower_why_nothing(once, twice)}, {2 * line.impulse[2], "Each push has been applied twice."}}},
      rows[1].impulse);
  grade.number({"of the third row (N s)", line.impulse[3], {{0, tower_why_no_third(once, twice)}}},
               rows[2].impulse);
  grade.number(
      {"velocity of the lowest box (m/s)",
       line.v[1],
       {{0, rows[1].impulse == 0 ? "" : "The second row pushes the lowest box down again: both ends."},
        {-0.5, "No push has reached the bodies: apply it, to the bodies of the list."}}},
      once.bodies[1].velocity[1]);
  const double first = line.impulse[1], second = twice.line.impulse[1];
  grade.number({"two sweeps: impulse on the ground (N s)",
                second,
                {{second - first, "The second push has replaced the first: row.impulse is the sum."},
                 {first, rows[1].impulse == 0 ? "" : "The second sweep has not pushed."}}},
               twice.rows[0].impulse);
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

static void grade_06(cairn::Grade& grade) {
  grade_tower(grade);
  grade_two_sweeps(grade);
  grade_one_row(grade);
}

/// With those before it.
static void stage_06(cairn::Grade& grade) {
  stage_05(grade);
  grade.begin(6);
  grade_06(grade);
}
