// Stage 02, filmed: a box swings on a rod. Nothing mends its drift.
#include "01.cpp"

namespace cairn::filmed {

/// The pivot, and a box whose rod of 2 m is too long by `error` [m] at the beginning.
static std::vector<Body> hanging_box(double error) {
  return {make_box(0.3, 0.3, 0, 0, 0), make_box(1, 1, 2, 2.5 + error, -0.5)};
}

/// One frame of that box; `row` has the error that is shown.
static void note_swing(Motion& motion, double time, const std::vector<Body>& bodies, const Row& row) {
  motion.frame(time);
  motion.bodies(bodies);
  note_rod(motion, bodies[0], {0, 0}, bodies[1], {-0.5, 0.5});
  motion.words("error of the rod: " + in_mm(row.c));
}

static void film_02(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> bodies = hanging_box(0);
  motion.view(-3.7, -3.7, 3.7, 0.9);
  for (int k = 0; k <= 160; ++k) {
    if (k % 5 == 0) note_swing(motion, k * dt, bodies, rod(bodies, 0, {0, 0}, 1, {-0.5, 0.5}, 2));
    add_gravity(bodies, 10, dt);
    const Row row = rod(bodies, 0, {0, 0}, 1, {-0.5, 0.5}, 2);
    apply_impulse(row, correction(row, bodies), bodies);
    move_bodies(bodies, dt);
  }
}

}  // namespace cairn::filmed
