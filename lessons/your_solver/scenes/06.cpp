// Stage 06, filmed: the same box, held by pushes that are clamped one by one. It hops; stage 07 mends that.
#include "05.cpp"

namespace cairn::filmed {

/// One step of the box on its feet, by sweeps without a matrix; the forces [N] of the feet that touch.
static std::vector<double> step_feet(std::vector<Body>& bodies) {
  const double dt = 0.02;
  add_gravity(bodies, 10, dt);
  std::vector<Row> rows = foot_rows(bodies);
  for (int sweeps = 0; sweeps < 20; ++sweeps) sweep(rows, bodies);
  std::vector<double> forces;
  for (const Row& row : rows) forces.push_back(row.impulse / dt);
  return forces;
}

static void film_06(Motion& motion) {
  std::vector<Body> bodies = footed_box();
  motion.view(-2.2, -0.5, 2.2, 2.8);
  for (int k = 0; k <= 90; ++k) {
    const std::vector<double> forces = step_feet(bodies);
    if (k % 4 == 0) {
      motion.frame(k * 0.02);
      note_feet(motion, bodies, forces);
      motion.words("each push is clamped: it hops until stage 07");
    }
    move_bodies(bodies, 0.02);
  }
}

}  // namespace cairn::filmed
