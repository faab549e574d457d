// Stage 05, filmed: a box comes down on two legs, whose feet sweeps over A hold.
#include "04.cpp"

namespace cairn::filmed {

/// The ends of a box's legs [m], in its own frame.
static const std::array<std::array<double, 2>, 2> feet = {{{-0.25, -0.75}, {0.25, -0.75}}};

/// The ground, and a box above it that is a little turned.
static std::vector<Body> footed_box() {
  std::vector<Body> bodies = {make_box(6, 0.5, 0, 0, -0.25), make_box(1, 1, 6, 0, 1.6)};
  bodies[1].position[2] = 0.1;
  return bodies;
}

/// A row for each foot that touches the ground.
static std::vector<Row> foot_rows(const std::vector<Body>& bodies) {
  std::vector<Row> rows;
  for (const auto& foot : feet) {
    const auto at = in_the_world(bodies[1], foot[0], foot[1]);
    if (at[1] < 0.001) rows.push_back(contact(bodies, 0, 1, {at[0], at[1]}, {0, 1}, at[1]));
  }
  set_bias(rows, 0.2, 0.02);
  return rows;
}

/// `forces` [N] are those of the rows.
static void note_feet(Motion& motion, const std::vector<Body>& bodies, const std::vector<double>& forces) {
  motion.bodies(bodies);
  std::size_t next = 0;
  for (const auto& foot : feet) {
    const auto at = in_the_world(bodies[1], foot[0], foot[1]);
    const auto leg = in_the_world(bodies[1], foot[0], -0.5);
    motion.rod(leg[0], leg[1], at[0], at[1]);
    if (at[1] >= 0.001 || next == forces.size()) continue;
    const double length = std::clamp(forces[next++] / 60, -1.0, 1.0);
    motion.arrow(at[0], at[1] - length, 0, length);
  }
}

static void film_05(Motion& motion) {
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
