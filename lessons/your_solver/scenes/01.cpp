// Stage 01, filmed: two boxes fly, and nothing holds them. The arrows are j, the numbers c and j·v.

namespace cairn::filmed {

static std::array<double, 2> in_the_world(const Body& body, double x, double y) {
  const double cosine = std::cos(body.position[2]), sine = std::sin(body.position[2]);
  return {body.position[0] + cosine * x - sine * y, body.position[1] + sine * x + cosine * y};
}

/// Draws the rod where it is, whatever c is.
static void note_rod(Motion& motion, const Body& one, const std::array<double, 2>& point_a, const Body& two,
                     const std::array<double, 2>& point_b) {
  const auto from = in_the_world(one, point_a[0], point_a[1]), to = in_the_world(two, point_b[0], point_b[1]);
  motion.rod(from[0], from[1], to[0], to[1]);
}

static void film_01(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> bodies = {make_box(11, 0.5, 0, 0, -0.75), make_box(1, 1, 2, -2, 0.5),
                              make_box(1, 1, 0.5, 1, 1)};
  bodies[1].velocity = {0.5, 5, 1};
  bodies[2].velocity = {1, 6, -2.5};
  const std::array<double, 2> point_a = {0.5, 0.25}, point_b = {-0.5, -0.25};
  motion.view(-4, -0.8, 4, 4);
  for (int k = 0; k <= 60; ++k) {
    const Row row = rod(bodies, 1, {point_a[0], point_a[1]}, 2, {point_b[0], point_b[1]}, 2);
    if (k % 3 == 0) {
      motion.frame(k * dt);
      motion.bodies(bodies);
      note_rod(motion, bodies[1], point_a, bodies[2], point_b);
      const auto from = in_the_world(bodies[1], point_a[0], point_a[1]);
      const auto to = in_the_world(bodies[2], point_b[0], point_b[1]);
      motion.arrow(from[0], from[1], row.j_a[0], row.j_a[1]);
      motion.arrow(to[0], to[1], row.j_b[0], row.j_b[1]);
      char text[96] = "";
      std::snprintf(text, sizeof text, "c = %.2f m, j·v = %.2f m/s", row.c, rate(row, bodies));
      motion.words(text);
    }
    add_gravity(bodies, 10, dt);
    move_bodies(bodies, dt);
  }
}

}  // namespace cairn::filmed
