// Stage 04, filmed: the box stays on its feet, and a tower of three comes down and stands.
#include "03.cpp"

namespace cairn::filmed {

static std::vector<Body> tower_above_ground(int boxes, double x, double height) {
  std::vector<Body> bodies = {make_box(4, 0.5, 0, x, -0.25)};
  for (int i = 0; i < boxes; ++i) bodies.push_back(make_box(1, 1, 1, x, 0.5 + i + height));
  return bodies;
}

static void film_04(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> box = footed_box(), tower = tower_above_ground(3, 5, 0.3);
  motion.view(-3, -0.5, 7, 4.3);
  for (int k = 0; k <= 90; ++k) {
    const std::vector<double> forces = step_feet(box);
    if (k % 4 == 0) {
      motion.frame(k * dt);
      note_feet(motion, box, forces);
      motion.bodies(tower);
      motion.words("on two feet, and a tower by contacts()");
    }
    move_bodies(box, dt);
    add_gravity(tower, 10, dt);
    std::vector<Row> rows = contacts(tower);
    aim(rows, dt);
    for (int sweeps = 0; sweeps < 20; ++sweeps) sweep(rows, tower);
    move_bodies(tower, dt);
  }
}

}  // namespace cairn::filmed
