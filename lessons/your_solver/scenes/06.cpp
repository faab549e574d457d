// Stage 06, filmed: a box comes down on two legs, whose feet sweeps over A hold.
#include "05.cpp"

namespace cairn::filmed {

static void film_06(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> bodies = footed_box();
  motion.view(-2.2, -0.5, 2.2, 2.8);
  for (int k = 0; k <= 90; ++k) {
    add_gravity(bodies, 10, dt);
    const std::vector<Row> rows = foot_rows(bodies);
    const System system = build(rows, bodies, dt);
    std::vector<double> lambda(rows.size(), 0.0);
    for (int sweeps = 0; sweeps < 20; ++sweeps) sweep_matrix(system, lambda);
    if (k % 4 == 0) {
      motion.frame(k * dt);
      note_feet(motion, bodies, lambda);
      motion.words("arrows: pushes, 60 N a metre, 1 m at most");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) apply_impulse(rows[i], lambda[i] * dt, bodies);
    move_bodies(bodies, dt);
  }
}

}  // namespace cairn::filmed
