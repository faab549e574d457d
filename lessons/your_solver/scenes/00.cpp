// Stage 00, filmed: boxes of 1 kg and 4 kg fly above the ground.

namespace cairn::filmed {

static void film_00(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> bodies = {make_box(11, 0.5, 0, 0, -0.75), make_box(1, 1, 1, -4, 1),
                              make_box(1.6, 0.8, 4, -1.5, 1)};
  bodies[1].velocity = {4, 6, -1};
  bodies[2].velocity = {3, 6, 4};
  motion.view(-5.5, -1, 5.5, 4);
  for (int k = 0; k <= 60; ++k) {
    if (k % 3 == 0) {
      motion.frame(k * dt);
      motion.bodies(bodies);
    }
    add_gravity(bodies, 10, dt);
    move_bodies(bodies, dt);
  }
}

}  // namespace cairn::filmed
