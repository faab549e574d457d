// Stage 09, filmed: step() lets ten boxes stand. Then one of 6 kg is thrown at them, friction rows are added,
// and they fall.
#include "08.cpp"
#include "touching.cpp"

namespace cairn::filmed {

/// A row for each touch of boxes, and a friction row behind it.
static std::vector<Row> rough_rows(const std::vector<Body>& bodies) {
  std::vector<Row> rows;
  const int count = static_cast<int>(bodies.size());
  for (int i = 0; i < count; ++i) {
    for (int k = i + 1; k < count; ++k) {
      if (bodies[i].inverse_mass[1] + bodies[k].inverse_mass[1] == 0) continue;
      for (const Touch& touch : touches(bodies[i], bodies[k])) {
        const double nx = touch.normal_x, ny = touch.normal_y;
        rows.push_back(contact(bodies, i, k, {touch.x, touch.y}, {nx, ny}, touch.gap));
        rows.back().key = {i, k, touch.feature};
        rows.push_back(contact(bodies, i, k, {touch.x, touch.y}, {ny, -nx}, 0));
        rows.back().key = {i, k, 1000 + touch.feature};
      }
    }
  }
  return rows;
}

/// Friction is at most half of what its contact pushes.
static void bound_friction(std::vector<Row>& rows) {
  for (std::size_t i = 1; i < rows.size(); i += 2) {
    rows[i].upper = 0.5 * rows[i - 1].impulse;
    rows[i].lower = -rows[i].upper;
  }
}

static void step_with_friction(World& world) {
  add_gravity(world.bodies, world.gravity, world.dt);
  std::vector<Row> rows = rough_rows(world.bodies);
  set_bias(rows, world.beta, world.dt);
  warm_start(rows, world.rows, world.bodies);
  for (int k = 0; k < 20; ++k) {
    bound_friction(rows);
    sweep(rows, world.bodies);
  }
  move_bodies(world.bodies, world.dt);
  world.rows = rows;
}

static void film_09(Motion& motion) {
  const int standing = 50, falling = 120;
  World world;
  world.bodies = tower_above_ground(10, 0, 0);
  world.bodies[0] = make_box(40, 0.5, 0, 0, -0.25);
  world.bodies.push_back(make_box(1, 1, 0, -6, 6));
  world.beta = 0.2;
  motion.view(-6.8, -0.5, 11.2, 11);
  for (int k = 0; k <= standing + falling; ++k) {
    if (k % 8 == 0) {
      motion.frame(k * world.dt);
      motion.bodies(world.bodies);
      motion.words(k < standing ? "step() of stage 09, without friction"
                                : "your rows and sweeps, with friction 0.5");
    }
    if (k == standing) {
      world.bodies[11] = make_box(1, 1, 6, -6, 6);
      world.bodies[11].velocity = {8, 3.5, 0};
      world.rows.clear();
    }
    if (k < standing)
      step(world);
    else
      step_with_friction(world);
  }
}

}  // namespace cairn::filmed
