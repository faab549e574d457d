// Stage 03, graded: ζ from c, ζ in the correction, and a weight that comes back to its rod's length.
#include "02.cpp"

static void grade_bias(cairn::Grade& grade) {
  const double beta = 0.2, dt = 0.05;
  grade.number({"bias of a new row (m/s)", 0}, Row().bias);
  std::vector<Row> rows = {slanted_row(1, 2), slanted_row(1, 2), slanted_row(1, 2)};
  rows[0].c = 0.1;
  rows[1].c = -0.03;
  rows[2].c = 0.2;
  set_bias(rows, beta, dt);
  const bool sets_first = rows[0].bias != 0, sets_second = rows[1].bias != 0, sets_last = rows[2].bias != 0;
  grade.number({"c = 0.1 m, β = 0.2, Δt = 0.05 s: bias (m/s)",
                -beta * 0.1 / dt,
                {{beta * 0.1 / dt, "The sign: j·v has to make c smaller."},
                 {-beta * 0.1, "The factor 1/Δt is missing: the share is to be gone after one step."},
                 {-beta * 0.1 * dt, "Divide by Δt: a short step needs a higher speed."},
                 {-0.1 / dt, "β is missing: a step takes a share of the error."},
                 {-(1 - beta) * 0.1 / dt, "β is the share that goes, not the share that stays."},
                 {0, sets_second ? "An error above 0 has to go, too."
                                 : "The bias of the row has not been set: change the rows of the list."}}},
               rows[0].bias);
  grade.number({"c = −0.03 m: bias (m/s)",
                beta * 0.03 / dt,
                {{0, !sets_first ? ""
                     : sets_last ? "An error below 0 has to go, too."
                                 : "All rows of the list get a bias."},
                 {-beta * 0.1 / dt, "Each row has its own error c."},
                 {-beta * 0.03 / dt, rows[0].bias > 0 ? "" : "The sign of c counts: the bias is −β c/Δt."}}},
               rows[1].bias);
  grade.number({"the last row, c = 0.2 m: bias (m/s)",
                -beta * 0.2 / dt,
                {{0, sets_first && sets_second ? "The last row was left out." : ""}}},
               rows[2].bias);
  rows[0].c = 0.05;
  set_bias(rows, beta, dt);
  grade.number({"set once more, with c = 0.05 m: bias (m/s)",
                -beta * 0.05 / dt,
                {{-beta * 0.15 / dt, "Set the bias: do not add to the one of before."}}},
               rows[0].bias);
  Row row = slanted_row(1, 2);
  row.bias = 0.7;
  const double mass = 1 / (slanted_part1 + slanted_part2);
  grade.number({"correction with a bias of 0.7 m/s (N s)",
                (0.7 - slanted_rate) * mass,
                {{-slanted_rate * mass, "correction does not use the bias yet: (ζ − j·v)."},
                 {(-0.7 - slanted_rate) * mass, "The sign of ζ: (22) has ζ − j·v."},
                 {(0.7 + slanted_rate) * mass, "The sign of j·v: (22) has ζ − j·v."},
                 {0.7 - slanted_rate * mass, "The bias is a velocity: (ζ − j·v), then the mass."}}},
               correction(row, two_masses()));
}

/// A weight of 2 kg on a rod that is 0.1 m too long; what is left of the error after three steps.
static double left_of_the_error(double beta) {
  const double dt = 0.02;
  std::vector<Body> bodies = {make_box(1, 1, 0, 0, 0), make_box(1, 1, 2, 0, -2.1)};
  for (int k = 0; k < 3; ++k) {
    add_gravity(bodies, 10, dt);
    std::vector<Row> rows = {rod(bodies, 0, {0, 0}, 1, {0, 0}, 2)};
    set_bias(rows, beta, dt);
    apply_impulse(rows[0], correction(rows[0], bodies), bodies);
    move_bodies(bodies, dt);
  }
  return rod(bodies, 0, {0, 0}, 1, {0, 0}, 2).c;
}

static void grade_03(cairn::Grade& grade) {
  grade_bias(grade);
  grade.number({"a rod 0.1 m too long, three steps, β = 0.2: c (m)",
                0.1 * 0.8 * 0.8 * 0.8,
                {{0.1, "The error stays: does correction use the bias?"},
                 {0.1 * 0.92 * 0.92 * 0.92, "These steps have 0.02 s: use the dt that is given."},
                 {0.1 * 1.2 * 1.2 * 1.2, "The error grows: the sign of the bias."}}},
               left_of_the_error(0.2));
}

/// With those before it.
static void stage_03(cairn::Grade& grade) {
  stage_02(grade);
  grade.begin(3);
  grade_03(grade);
}
