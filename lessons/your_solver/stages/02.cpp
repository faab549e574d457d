// Stage 02, graded: the effective mass of a row between 2 kg and 0.5 kg, its correction, and what an impulse
// does.
#include "01.cpp"

/// Unit boxes of 2 kg and 0.5 kg: 1/I is 3 and 12. The ground is body 0.
static std::vector<Body> two_masses() {
  std::vector<Body> bodies = {make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 2, 0, 1),
                              make_box(1, 1, 0.5, 0, 3)};
  bodies[1].velocity = {1, 0, 2};
  bodies[2].velocity = {0, -3, -1};
  return bodies;
}

static Row slanted_row(int body_a, int body_b) {
  Row row;
  row.body_a = body_a;
  row.body_b = body_b;
  row.j_a = {-0.6, 0.8, 0.25};
  row.j_b = {0.6, -0.8, 0.5};
  return row;
}

// j M⁻¹ jᵀ of that row: (0.36 + 0.64)/m + turn²/I for each body.
static const double slanted_part_a = 0.5 + 0.0625 * 3;
static const double slanted_part_b = 2 + 0.25 * 12;
static const double slanted_rate = (-0.6 * 1 + 0.25 * 2) + (-0.8 * -3 + 0.5 * -1);

static void grade_effective_mass(cairn::Grade& grade) {
  const std::vector<Body> bodies = two_masses();
  const double inverse = slanted_part_a + slanted_part_b, mass = effective_mass(slanted_row(1, 2), bodies);
  const double plain_part_a = (-0.6 + 0.8) * 0.5 + 0.25 * 3;  // as if j stood once in each product
  const double plain_part_b = (0.6 - 0.8) * 2 + 0.5 * 12;
  grade.number(
      {"effective mass of a row between 2 kg and 0.5 kg (kg)",
       1 / inverse,
       {{inverse, "That is j M⁻¹ jᵀ: the effective mass is its inverse."},
        {1 / slanted_part_b, "Body a is missing: both bodies give way."},
        {1 / slanted_part_a, "Body b is missing: both bodies give way."},
        {1 / 2.5, "The turn is missing: a push beside the centre turns the body, too."},
        {1 / (1 + 0.0625 + 1 + 0.25), "The inverse masses are missing: j M⁻¹ jᵀ, not j jᵀ."},
        {1 / (2 + 0.0625 / 3 + 0.5 + 0.25 / 12), "Those are the masses: j M⁻¹ jᵀ has their inverses."},
        {1 / (1 + 0.0625 + slanted_part_b), "The inverse masses of body a are missing."},
        {1 / (slanted_part_a + 1 + 0.25), "The inverse masses of body b are missing."},
        {1 / (2 + 0.0625 / 3 + slanted_part_b),
         "Body a comes in with its masses, and not with their inverses."},
        {1 / (slanted_part_a + 0.5 + 0.25 / 12),
         "Body b comes in with its masses, and not with their inverses."},
        {1 / (plain_part_a + plain_part_b), "j is not squared: each product has the number of j twice."},
        {1 / (plain_part_a + slanted_part_b), "j_a is not squared: each product has the number of j twice."},
        {1 / (slanted_part_a + plain_part_b), "j_b is not squared: each product has the number of j twice."},
        {1 / (0.5 + slanted_part_b),
         "The turn of body a is missing: a push beside its centre turns it, too."},
        {1 / (slanted_part_a + 2),
         "The turn of body b is missing: a push beside its centre turns it, too."}}},
      mass);
  char words[160] = "";
  std::snprintf(words, sizeof words,
                "An impulse of your %.4g N s changes j·v by %.4g m/s: it should be 1 m/s.", mass,
                mass * inverse);
  grade.explain(words);
  grade.number({"the same between the ground and 0.5 kg (kg)",
                1 / slanted_part_b,
                {{0, "One body can move: the ground only adds nothing to j M⁻¹ jᵀ."}}},
               effective_mass(slanted_row(0, 2), bodies));
  grade.number({"the same between two bodies that cannot move (kg)",
                0,
                {{1.0 / 0.0, "Neither body can move: 1/0 would spoil every velocity. Return 0."}}},
               effective_mass(slanted_row(0, 0), bodies));
}

static void grade_correction(cairn::Grade& grade) {
  const std::vector<Body> bodies = two_masses();
  const double inverse = slanted_part_a + slanted_part_b;
  grade.number({"correction for that row (N s)",
                -slanted_rate / inverse,
                {{slanted_rate / inverse, "The sign: (22) has ζ − j·v, and ζ is 0 here."},
                 {-slanted_rate * inverse, "Divide by j M⁻¹ jᵀ: the effective mass is its inverse."},
                 {0, "Nothing is clamped here: a row pushes and pulls."},
                 {-slanted_rate, "That is a velocity: multiply by the effective mass."}}},
               correction(slanted_row(1, 2), bodies));
  // The bodies in each other's place: j·v is -2.65 + 1.6, and j M⁻¹ jᵀ is 2.75 + 1.25.
  grade.number({"correction for a row whose points approach each other (N s)",
                1.05 / 4,
                {{-1.05 / 4, "The sign: (22) has ζ − j·v, and ζ is 0 here."},
                 {0, "Nothing is clamped here: a row pushes and pulls."}}},
               correction(slanted_row(2, 1), bodies));
}

static void grade_aim(cairn::Grade& grade) {
  grade.number({"bias of a new row (m/s)", 0}, Row().bias);
  Row row = slanted_row(1, 2);
  row.bias = 0.7;
  const double mass = 1 / (slanted_part_a + slanted_part_b);
  grade.number({"correction with a bias of 0.7 m/s (N s)",
                (0.7 - slanted_rate) * mass,
                {{-slanted_rate * mass, "correction does not use the bias: (ζ − j·v)."},
                 {(-0.7 - slanted_rate) * mass, "The sign of ζ: (22) has ζ − j·v."},
                 {(0.7 + slanted_rate) * mass, "The sign of j·v: (22) has ζ − j·v."},
                 {0.7 - slanted_rate * mass, "The bias is a velocity: (ζ − j·v), then the mass."}}},
               correction(row, two_masses()));
}

/// What a push along the reader's rod does to momentum and to angular momentum, which it has to keep.
static std::string physics_of_push() {
  const std::vector<Body> before = turned_boxes();
  std::vector<Body> after = before;
  const Row row = rod(before, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3);
  apply_impulse(row, 0.5, after);
  double momentum[2] = {}, angular = 0, turn[3] = {};
  for (std::size_t i = 1; i < 3; ++i) {
    double p[2] = {};
    for (std::size_t k = 0; k < 2; ++k) {
      p[k] = (after[i].velocity[k] - before[i].velocity[k]) / before[i].inverse_mass[k];
      momentum[k] += p[k];
    }
    turn[i] = (after[i].velocity[2] - before[i].velocity[2]) / before[i].inverse_mass[2];
    angular += turn[i] + before[i].position[0] * p[1] - before[i].position[1] * p[0];
  }
  const bool keeps = std::abs(momentum[0]) + std::abs(momentum[1]) < 1e-9;
  if (!keeps) return "Momentum is not kept: what one body gets, the other has to lose.";
  if (std::abs(angular) < 1e-9) return "";
  const bool is_body_a = !(std::abs(turn[1] - 0.5 * row.j_a[2]) < 1e-9);
  return std::string("Momentum is kept, angular momentum is not: look at the turn of body ") +
         (is_body_a ? "a." : "b.");
}

static void grade_push(cairn::Grade& grade) {
  std::vector<Body> bodies = two_masses();
  const Row row = slanted_row(1, 2);
  apply_impulse(row, 0.5, bodies);
  const double down = -3 + 2 * -0.8 * 0.5, turn = -1 + 12 * 0.5 * 0.5, other = 1 + 0.5 * -0.6 * 0.5;
  grade.number({"0.5 N s along that row: v_y of body b (m/s)",
                down,
                {{-3 - 0.8 * 0.5, "M⁻¹ is missing: an impulse moves a light body more."},
                 {-3 + 0.8 * 0.5 * 2, "The sign: v ← v + M⁻¹ jᵀ λΔt."},
                 {-3 - 0.8 * 0.5 / 2, "That is m, or body a's inverse mass: take that of body b."},
                 {-0.8, "Add to the velocity: do not replace it."},
                 {-3, "Body b is missing: the push has two ends."}}},
               bodies[2].velocity[1]);
  grade.number({"ω of body b (rad/s)",
                turn,
                {{-1, "The turn is missing: j has three numbers a body."},
                 {-1 + 0.5 * 0.5, "M⁻¹ is missing at the turn of body b."},
                 {-1 + 0.5 * 0.5 / 12, "That is I: multiply by the inverse of I."}}},
               bodies[2].velocity[2]);
  grade.number({"ω of body a (rad/s)",
                2 + 3 * 0.25 * 0.5,
                {{2, bodies[1].velocity[0] == 1 ? "" : "The turn is missing: j has three numbers a body."},
                 {2 + 0.25 * 0.5, "M⁻¹ is missing for body a."},
                 {2 + 0.25 * 0.5 / 3, "That is I of body a: multiply by the inverse."},
                 {2 + 12 * 0.25 * 0.5, "Each body has its own inverse mass: here body a."},
                 {2 - 3 * 0.25 * 0.5, "The sign: j_a has its minus already."},
                 {2 + 3 * 0.5 * 0.5, "Those are the numbers of body b: body a has j_a."}}},
               bodies[1].velocity[2]);
  const bool has_j_b = std::abs(bodies[1].velocity[2] - 2.75) < 1e-9;
  grade.number({"v_x of body a (m/s)",
                other,
                {{1, "Body a is missing: the push has two ends."},
                 {1 + 0.5 * 0.6 * 0.5, has_j_b ? "" : "The sign: j_a has its minus already."},
                 {1 + 2 * -0.6 * 0.5, "Each body has its own inverse mass."}}},
               bodies[1].velocity[0]);
  std::vector<Body> stopped = two_masses();
  apply_impulse(row, correction(row, stopped), stopped);
  grade.number({"j·v after the row's own correction (m/s)", 0}, rate(row, stopped));
  grade.explain(physics_of_push());
}

static void grade_02(cairn::Grade& grade) {
  grade_effective_mass(grade);
  grade_correction(grade);
  grade_aim(grade);
  grade_push(grade);
}

/// With those before it.
static void stage_02(cairn::Grade& grade) {
  stage_01(grade);
  grade.begin(2);
  grade_02(grade);
}
