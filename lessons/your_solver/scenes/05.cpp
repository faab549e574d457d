// Stage 05, filmed: a chain of three boxes swings. A and b are the reader's; elimination solves them here.
#include "04.cpp"

namespace cairn::filmed {

/// λ [N] of A λ = b, by elimination with the largest pivot of each column.
static std::vector<double> eliminated(System system) {
  const std::size_t count = system.b.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i; k < count; ++k)
      if (std::abs(system.A[k][i]) > std::abs(system.A[pivot][i])) pivot = k;
    std::swap(system.A[i], system.A[pivot]);
    std::swap(system.b[i], system.b[pivot]);
    for (std::size_t k = i + 1; k < count; ++k) {
      const double share = system.A[k][i] / system.A[i][i];
      for (std::size_t n = i; n < count; ++n) system.A[k][n] -= share * system.A[i][n];
      system.b[k] -= share * system.b[i];
    }
  }
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t k = i + 1; k < count; ++k) system.b[i] -= system.A[i][k] * system.b[k];
    system.b[i] /= system.A[i][i];
  }
  return system.b;
}

static const double half_link = 0.3, link = 0.6;  // [m]

static std::vector<Row> chain_rows(const std::vector<Body>& bodies) {
  std::vector<Row> rows = {rod(bodies, 0, {0, 0}, 1, {-half_link, 0}, link)};
  for (int i = 1; i < 3; ++i) rows.push_back(rod(bodies, i, {half_link, 0}, i + 1, {-half_link, 0}, link));
  return rows;
}

static void note_chain(Motion& motion, double time, const std::vector<Body>& bodies) {
  motion.frame(time);
  motion.bodies(bodies);
  double largest = 0;
  for (const Row& row : chain_rows(bodies)) largest = std::max(largest, std::abs(row.c));
  note_rod(motion, bodies[0], {0, 0}, bodies[1], {-half_link, 0});
  for (std::size_t i = 1; i < 3; ++i)
    note_rod(motion, bodies[i], {half_link, 0}, bodies[i + 1], {-half_link, 0});
  motion.words("largest error of a rod: " + in_mm(largest));
}

static void film_05(Motion& motion) {
  const double dt = 0.02;
  std::vector<Body> bodies = {make_box(0.3, 0.3, 0, 0, 0)};
  for (int i = 0; i < 3; ++i) bodies.push_back(make_box(0.6, 0.6, 1, 0.9 + 1.2 * i, 0));
  motion.view(-4, -4, 4, 0.9);
  for (int k = 0; k <= 160; ++k) {
    if (k % 5 == 0) note_chain(motion, k * dt, bodies);
    add_gravity(bodies, 10, dt);
    std::vector<Row> rows = chain_rows(bodies);
    aim(rows, dt);
    const System system = build(rows, bodies, dt);
    if (system.b.size() != rows.size() || system.A.size() != rows.size() ||
        system.A.back().size() != rows.size())
      throw std::runtime_error("A and b of three rows must have three rows each");
    const std::vector<double> lambda = eliminated(system);
    for (std::size_t i = 0; i < rows.size(); ++i) apply_impulse(rows[i], lambda[i] * dt, bodies);
    move_bodies(bodies, dt);
  }
}

}  // namespace cairn::filmed
