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

static Row slanted_row(int body1, int body2) {
  Row row;
  row.body1 = body1;
  row.body2 = body2;
  row.j1 = {-0.6, 0.8, 0.25};
  row.j2 = {0.6, -0.8, 0.5};
  return row;
}

// j M⁻¹ jᵀ of that row: (0.36 + 0.64)/m + turn²/I for each body.
static const double slanted_part1 = 0.5 + 0.0625 * 3;
static const double slanted_part2 = 2 + 0.25 * 12;
static const double slanted_rate = (-0.6 * 1 + 0.25 * 2) + (-0.8 * -3 + 0.5 * -1);

static void grade_effective_mass(cairn::Grade& grade) {
  const std::vector<Body> bodies = two_masses();
  const double inverse = slanted_part1 + slanted_part2;
  grade.number(
      {"effective mass of a row between 2 kg and 0.5 kg (kg)",
       1 / inverse,
       {{inverse, "That is j M⁻¹ jᵀ: the effective mass is its inverse."},
        {1 / slanted_part2, "Body 1 is missing: both bodies give way."},
        {1 / slanted_part1, "Body 2 is missing: both bodies give way."},
        {1 / 2.5, "The turn is missing: a push beside the centre turns the body, too."},
        {1 / (1 + 0.0625 + 1 + 0.25), "The inverse masses are missing: j M⁻¹ jᵀ, not j jᵀ."},
        {1 / (2 + 0.0625 / 3 + 0.5 + 0.25 / 12), "Those are the masses: j M⁻¹ jᵀ has their inverses."}}},
      effective_mass(slanted_row(1, 2), bodies));
  grade.number({"the same between the ground and 0.5 kg (kg)",
                1 / slanted_part2,
                {{0, "One body can move: the ground only adds nothing to j M⁻¹ jᵀ."}}},
               effective_mass(slanted_row(0, 2), bodies));
  grade.number({"the same between two bodies that cannot move (kg)",
                0,
                {{1.0 / 0.0, "Neither body can move: 1/0 would spoil every velocity. Return 0."}}},
               effective_mass(slanted_row(0, 0), bodies));
}

static void grade_correction(cairn::Grade& grade) {
  const std::vector<Body> bodies = two_masses();
  const double inverse = slanted_part1 + slanted_part2;
  grade.number({"correction for that row (N s)",
                -slanted_rate / inverse,
                {{slanted_rate / inverse, "The sign: (22) has ζ − j·v, and ζ is 0 here."},
                 {-slanted_rate * inverse, "Divide by j M⁻¹ jᵀ: the effective mass is its inverse."},
                 {0, "Nothing is clamped here: a row pushes and pulls."},
                 {-slanted_rate, "That is a velocity: multiply by the effective mass."}}},
               correction(slanted_row(1, 2), bodies));
  // The bodies in each other's place: j·v is -2.65 + 1.6, and j M⁻¹ jᵀ is 2.75 + 1.25.
  grade.number({"correction for a row whose points close in (N s)",
                1.05 / 4,
                {{-1.05 / 4, "The sign: (22) has ζ − j·v, and ζ is 0 here."},
                 {0, "Nothing is clamped here: a row pushes and pulls."}}},
               correction(slanted_row(2, 1), bodies));
}

static void grade_push(cairn::Grade& grade) {
  std::vector<Body> bodies = two_masses();
  const Row row = slanted_row(1, 2);
  apply_impulse(row, 0.5, bodies);
  const double down = -3 + 2 * -0.8 * 0.5, turn = -1 + 12 * 0.5 * 0.5, other = 1 + 0.5 * -0.6 * 0.5;
  grade.number({"0.5 N s along that row: v_y of body 2 (m/s)",
                down,
                {{-3 - 0.8 * 0.5, "M⁻¹ is missing: an impulse moves a light body more."},
                 {-3 + 0.8 * 0.5 * 2, "The sign: v ← v + M⁻¹ jᵀ λΔt."},
                 {-3 - 0.8 * 0.5 / 2, "That is m: multiply by the inverse mass."},
                 {-0.8, "Add to the velocity: do not replace it."},
                 {-3, "Body 2 is missing: the push has two ends."}}},
               bodies[2].velocity[1]);
  grade.number({"ω of body 2 (rad/s)", turn, {{-1, "The turn is missing: j has three numbers a body."}}},
               bodies[2].velocity[2]);
  grade.number({"ω of body 1 (rad/s)",
                2 + 3 * 0.25 * 0.5,
                {{2, bodies[1].velocity[0] == 1 ? "" : "The turn is missing: j has three numbers a body."},
                 {2 + 3 * 0.5 * 0.5, "Those are the numbers of body 2: body 1 has j1."}}},
               bodies[1].velocity[2]);
  const bool has_j2 = std::abs(bodies[1].velocity[2] - 2.75) < 1e-9;
  grade.number({"v_x of body 1 (m/s)",
                other,
                {{1, "Body 1 is missing: the push has two ends."},
                 {1 + 0.5 * 0.6 * 0.5, has_j2 ? "" : "The sign: j1 has its minus already."},
                 {1 + 2 * -0.6 * 0.5, "Each body has its own inverse mass."}}},
               bodies[1].velocity[0]);
  std::vector<Body> stopped = two_masses();
  apply_impulse(row, correction(row, stopped), stopped);
  grade.number({"j·v after the row's own correction (m/s)", 0}, rate(row, stopped));
}

static void grade_02(cairn::Grade& grade) {
  grade_effective_mass(grade);
  grade_correction(grade);
  grade_push(grade);
}

/// With those before it.
static void stage_02(cairn::Grade& grade) {
  stage_01(grade);
  grade.begin(2);
  grade_02(grade);
}
