// Stage 08, filmed: ten boxes stand, with ten sweeps in each step of the reader's world.
#include "07.cpp"

namespace cairn::filmed {

static void film_08(Motion& motion) {
  World world;
  world.bodies = tower_above_ground(10, 0, 0);
  const double top = world.bodies.back().position[1];
  motion.view(-5, -0.5, 5, 10.5);
  for (int k = 0; k <= 120; ++k) {
    if (k % 5 == 0) {
      motion.frame(k * world.dt);
      motion.bodies(world.bodies);
      motion.words("ten sweeps a step; the top has sunk by " + in_mm(top - world.bodies.back().position[1]));
    }
    step(world);
  }
}

}  // namespace cairn::filmed
