// Stage 03, filmed: a box comes down on two legs, held by pushes that are clamped one by one. It hops; stage
// 04 mends that.
#include "02.cpp"

namespace cairn::filmed {

/// Gives each row its ζ (7), before stage 09 does: a fifth of its error is to be gone after one step.
static void aim(std::vector<Row>& rows, double dt) {
  for (Row& row : rows) row.bias = -0.2 * row.c / dt;
}

/// The ends of a box's legs [m], in its own frame.
static const std::array<std::array<double, 2>, 2> feet = {{{-0.25, -0.75}, {0.25, -0.75}}};

/// The ground, and a box above it: turned so little that soon both feet are down together.
static std::vector<Body> footed_box() {
  std::vector<Body> bodies = {make_box(6, 0.5, 0, 0, -0.25), make_box(1, 1, 6, 0, 1.6)};
  bodies[1].position[2] = 0.02;
  return bodies;
}

/// A row for each foot that touches the ground, and behind them for each corner, should the box fall.
static std::vector<Row> foot_rows(const std::vector<Body>& bodies) {
  std::vector<Row> rows;
  const auto touch = [&](double x, double y) {
    const auto at = in_the_world(bodies[1], x, y);
    if (at[1] < 0.001) rows.push_back(contact(bodies, 0, 1, {at[0], at[1]}, {0, 1}, at[1]));
  };
  for (const auto& foot : feet) touch(foot[0], foot[1]);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) touch(x, y);
  aim(rows, 0.02);
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

static void film_03(Motion& motion) {
  std::vector<Body> bodies = footed_box();
  motion.view(-2.2, -0.5, 2.2, 2.8);
  for (int k = 0; k <= 90; ++k) {
    const std::vector<double> forces = step_feet(bodies);
    if (k % 4 == 0) {
      motion.frame(k * 0.02);
      note_feet(motion, bodies, forces);
      motion.words("it should stand; stage 04 says why it does not");
    }
    move_bodies(bodies, 0.02);
  }
}

}  // namespace cairn::filmed
