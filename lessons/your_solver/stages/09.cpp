// Stage 09, graded: ζ from c, a weight that comes back to its rod's length, and a box that comes out of the
// ground.
#include "08.cpp"

static void grade_bias(cairn::Grade& grade) {
  const double beta = 0.2, dt = 0.05;
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

static void grade_step_with_bias(cairn::Grade& grade) {
  World world;
  world.bodies = {make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 0.5, 0, 0.45)};
  world.gravity = 8;
  world.dt = 0.04;
  world.sweeps = 4;
  world.bodies[1].inverse_mass[2] = 0;
  world.beta = 0.2;
  step(world);
  grade.number({"50 mm deep in the ground, β = 0.2: height after one step (m)",
                0.5 - 0.05 * 0.8,
                {{0.45, "The bias is missing: set it before the sweeps."},
                 {0.45 + 0.01 * 0.04 / 0.05, "Use world.dt, for the bias as well."},
                 {0.45 + 0.01 * 0.04 / 0.02, "Use world.dt, for the bias as well."},
                 {0.5 - 0.05 * 1.2, "The sign of the bias."}}},
               world.bodies[1].position[1]);
}

static void grade_09(cairn::Grade& grade) {
  grade_bias(grade);
  grade.number({"a rod 0.1 m too long, three steps, β = 0.2: c (m)",
                0.1 * 0.8 * 0.8 * 0.8,
                {{0.1, "The error stays: does set_bias change the rows?"},
                 {0.1 * 0.92 * 0.92 * 0.92, "These steps have 0.02 s: use the dt that is given."},
                 {0.1 * 1.2 * 1.2 * 1.2, "The error grows: the sign of the bias."}}},
               left_of_the_error(0.2));
  grade_step_with_bias(grade);
}

/// With those before it.
static void stage_09(cairn::Grade& grade) {
  stage_08(grade);
  grade.begin(9);
  grade_09(grade);
}
