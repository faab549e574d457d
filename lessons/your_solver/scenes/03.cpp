// Stage 03, filmed: the same box on a rod that is 0.4 m too long at the beginning.
#include "02.cpp"

namespace cairn::filmed {

static void film_03(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> bodies = hanging_box(0.4);
  motion.view(-3.7, -3.7, 3.7, 0.9);
  for (int k = 0; k <= 160; ++k) {
    if (k % 5 == 0) note_swing(motion, k * dt, bodies, rod(bodies, 0, {0, 0}, 1, {-0.5, 0.5}, 2));
    add_gravity(bodies, 10, dt);
    std::vector<Row> rows = {rod(bodies, 0, {0, 0}, 1, {-0.5, 0.5}, 2)};
    set_bias(rows, 0.2, dt);
    apply_impulse(rows[0], correction(rows[0], bodies), bodies);
    move_bodies(bodies, dt);
  }
}

}  // namespace cairn::filmed
