// Stage 05, graded: A and b of four rows between bodies of 2 kg, 0.5 kg and 1 kg, entry by entry.
#include "04.cpp"

static Row made_row(int body_a, Vec3 j_a, int body_b, Vec3 j_b, double bias) {
  Row row;
  row.body_a = body_a;
  row.body_b = body_b;
  row.j_a = j_a;
  row.j_b = j_b;
  row.bias = bias;
  return row;
}

/// Row 2 has the bodies of row 1 the other way round; row 3 shares nothing but the ground with row 0.
static std::vector<Row> four_rows() {
  return {made_row(0, {0, -1, 0.25}, 1, {0, 1, 0.5}, 0.3),
          made_row(1, {-0.6, 0.8, 0.25}, 2, {0.6, -0.8, 0.5}, 0),
          made_row(2, {1, 0, -0.5}, 1, {-1, 0, 0.75}, -0.3), made_row(0, {0, -1, 0}, 3, {0, 1, 0.5}, 0)};
}

static std::vector<Body> four_bodies() {
  std::vector<Body> bodies = two_masses();
  bodies.push_back(make_box(1, 1, 1, 5, 1));
  bodies[3].velocity = {0, -1, 0};
  return bodies;
}

/// j_i W j_k over the numbers that two rows have for one body.
static double coupled(Vec3 first, Vec3 weight, Vec3 second) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += first[k] * weight[k] * second[k];
  return sum;
}

/// The first entry of A that is not what a push shows: 1 N s along row k changes j·v of row i by A[i][k].
static std::string physics_of(const System& system) {
  const std::vector<Row> rows = four_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows.size() && k < system.A[i].size(); ++k) {
      std::vector<Body> bodies = four_bodies();
      const double before = rate(rows[i], bodies);
      apply_impulse(rows[k], 1, bodies);
      const double change = rate(rows[i], bodies) - before;
      if (std::abs(system.A[i][k] - change) < 1e-9) continue;
      char words[200] = "";
      std::snprintf(
          words, sizeof words,
          "Push row %zu with 1 N s, and j·v of row %zu grows by %.4g m/s. Your A[%zu][%zu] says %.4g.", k, i,
          change, i, k, system.A[i][k]);
      return words;
    }
  }
  return "";
}

static const Vec3 inverse_heavy = {0.5, 0.5, 3}, inverse_light = {2, 2, 12}, inverse_ones = {1, 1, 1},
                  inverse_none = {};  // inverse masses

static void grade_diagonal(cairn::Grade& grade, const System& system, const std::vector<Row>& rows) {
  const double diagonal = slanted_part_a + slanted_part_b;
  const double mixed = diagonal + coupled(rows[1].j_a, inverse_heavy, rows[1].j_b) +
                       coupled(rows[1].j_b, inverse_light, rows[1].j_a);
  const double plain =
      coupled(rows[1].j_a, inverse_heavy, inverse_ones) + coupled(rows[1].j_b, inverse_light, inverse_ones);
  const bool is_doubled =
      std::abs(system.A[0][1] - 2 * coupled(rows[0].j_b, inverse_heavy, rows[1].j_a)) < 1e-9;
  grade.number(
      {"A[1][1], between 2 kg and 0.5 kg (1/kg)",
       diagonal,
       {{2 * diagonal, is_doubled
                           ? "Each body is counted once: a sum over the bodies, not over both lists of them."
                           : "The diagonal is counted twice: a row meets itself once."},
        {mixed, "Every number meets every other: multiply only what two rows have for the same body."},
        {2 + 0.0625 / 3 + 0.5 + 0.25 / 12, "Those are the masses: A has their inverses."},
        {1 + 0.0625 + slanted_part_b, "The inverse masses of body a are missing: A = J M⁻¹ Jᵀ."},
        {slanted_part_a + 1 + 0.25, "The inverse masses of body b are missing: A = J M⁻¹ Jᵀ."},
        {plain, "j is not squared: A_ii has each number of j twice."},
        {1 / diagonal, "That is the effective mass: A_ii is its inverse."},
        {diagonal * 0.05, "A has no Δt: only b has."},
        {diagonal / 0.05, "A has no Δt: only b has."},
        {slanted_part_a, "Body b is missing: sum over both bodies of the row."},
        {slanted_part_b, "Body a is missing: sum over both bodies of the row."},
        {2.5, "An index too few: the turn couples rows, too."},
        {1 + 0.0625 + 1 + 0.25, "The inverse masses are missing: A = J M⁻¹ Jᵀ."}}},
      system.A[1][1]);
}

static void grade_shared_body(cairn::Grade& grade, const System& system, const std::vector<Row>& rows) {
  const bool is_diagonal = system.A[1][2] == 0 && system.A[2][1] == 0 && system.A[0][2] == 0;
  const double shared = coupled(rows[0].j_b, inverse_heavy, rows[1].j_a);
  grade.number(
      {"A[0][1]: body b of one row is body a of the other",
       shared,
       {{0, is_diagonal
                ? "Rows that share a body are coupled: A is more than its diagonal."
                : "The rows share a body: look for the same body, not for the same place in the row."},
        {2 * shared, "Each body is counted once: a sum over the bodies, not over both lists of them."},
        {-shared, "The sign: J_i M⁻¹ J_kᵀ, the minus is in j_a already."},
        {coupled(rows[0].j_b, inverse_ones, rows[1].j_a), "The inverse masses are missing: A = J M⁻¹ Jᵀ."},
        {coupled(rows[0].j_b, inverse_light, rows[1].j_a),
         "The inverse mass is that of the body that they share."},
        {coupled(rows[0].j_b, inverse_heavy, rows[1].j_b) + coupled(rows[0].j_a, inverse_none, rows[1].j_a),
         "The rows share a body: look for the same body, not for the same place in the row."}}},
      system.A[0][1]);
}

static void grade_A(cairn::Grade& grade, const System& system) {
  const std::vector<Row> rows = four_rows();
  grade.number({"four rows: rows of A", 4}, static_cast<double>(system.A.size()));
  if (system.A.size() != 4 || system.A[1].size() != 4) return;
  grade_diagonal(grade, system, rows);
  grade_shared_body(grade, system, rows);
  const bool is_right = std::abs(system.A[1][1] - slanted_part_a - slanted_part_b) < 1e-9;
  const bool is_diagonal = system.A[1][2] == 0 && system.A[2][1] == 0 && system.A[0][2] == 0;
  const double crossed =
      coupled(rows[1].j_a, inverse_heavy, rows[2].j_b) + coupled(rows[1].j_b, inverse_light, rows[2].j_a);
  grade.number(
      {"A[1][2]: both bodies shared, the other way round (1/kg)",
       crossed,
       {{coupled(rows[1].j_a, inverse_heavy, rows[2].j_a) + coupled(rows[1].j_b, inverse_light, rows[2].j_b),
         "Look for the same body, not for the same place in the row."},
        {coupled(rows[1].j_a, inverse_heavy, rows[2].j_b), "Both bodies are shared: add both parts."},
        {coupled(rows[1].j_b, inverse_light, rows[2].j_a), "Both bodies are shared: add both parts."}}},
      system.A[1][2]);
  grade.number({"A[2][1]: A is symmetric (1/kg)",
                crossed,
                {{0, system.A[1][2] == 0 ? "" : "Only one half of A is filled."}}},
               system.A[2][1]);
  grade.number(
      {"A[0][2]: both rows have the same body b (1/kg)",
       coupled(rows[0].j_b, inverse_heavy, rows[2].j_b),
       {{0, is_diagonal || !is_right ? "" : "All pairs of rows count, not only those beside each other."}}},
      system.A[0][2]);
  grade.number({"A[0][3]: both stand on the ground (1/kg)",
                0,
                {{1, "The ground couples nothing: its inverse mass is 0."}}},
               system.A[0][3]);
  const std::string physics = physics_of(system);
  grade.number({"pushes along single rows: they show the same A (1: yes)", 1}, physics.empty());
  grade.explain(physics);
}

static void grade_b(cairn::Grade& grade, const System& system) {
  const double dt = 0.05, ground_rate = 0.5 * 2;  // row 0: v_y is 0, and the box turns with 2 rad/s
  grade.number({"entries of b", 4}, static_cast<double>(system.b.size()));
  if (system.b.size() != 4) return;
  const double last_rate = 0.5 + 0.5;  // of row 2: (1, 0, -0.5) · (0, -3, -1) and (-1, 0, 0.75) · (1, 0, 2)
  const char* const gravity = "Gravity is in v already, and has no part in b: b = (ζ − J v)/Δt.";
  grade.number({"b[0], with a bias of 0.3 m/s (m/s²)",
                (0.3 - ground_rate) / dt,
                {{(0.3 - ground_rate) / dt + 10, gravity},
                 {(0.3 - ground_rate) / dt - 10, gravity},
                 {(0.3 - ground_rate) / dt + 9.81, gravity},
                 {(0.3 - ground_rate) / dt - 9.81, gravity},
                 {0.3 - ground_rate, "The factor 1/Δt is missing: λ is a force."},
                 {(0.3 - ground_rate) * dt, "Divide by Δt: λ is a force."},
                 {(ground_rate - 0.3) / dt, "The sign: b = (ζ − J v)/Δt."},
                 {-ground_rate / dt, "ζ is missing: b = (ζ − J v)/Δt."},
                 {(-0.3 - ground_rate) / dt, "The sign of ζ: b = (ζ − J v)/Δt."},
                 {(0.3 + ground_rate) / dt, "The sign of j·v: b = (ζ − J v)/Δt."},
                 {0.3 - ground_rate / dt, "Both parts are divided by Δt."}}},
               system.b[0]);
  grade.number({"b[2], with a bias of −0.3 m/s (m/s²)",
                (-0.3 - last_rate) / dt,
                {{(0.3 - last_rate) / dt, "Each row has its own ζ."}, {0, "Each row has an entry of b."}}},
               system.b[2]);
}

static void grade_05(cairn::Grade& grade) {
  const System system = build(four_rows(), four_bodies(), 0.05);
  grade_A(grade, system);
  grade_b(grade, system);
}

/// With those before it.
static void stage_05(cairn::Grade& grade) {
  stage_04(grade);
  grade.begin(5);
  grade_05(grade);
}
