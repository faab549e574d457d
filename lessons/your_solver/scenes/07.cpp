// Stage 07, filmed: the left tower is moved by λ of the matrix, the right one by λ of the impulses.
#include "06.cpp"

namespace cairn::filmed {

static void step_by_record(std::vector<Body>& bodies, bool by_matrix) {
  const double dt = 0.02;
  add_gravity(bodies, 10, dt);
  std::vector<Row> rows = contacts(bodies);
  aim(rows, dt);
  const Record record = compare(rows, bodies, dt, 20);
  const auto& ledger = by_matrix ? record.matrix : record.impulses;
  if (ledger.empty() || ledger.back().size() != rows.size())
    throw std::runtime_error("the record has no last sweep with a λ for each row");
  for (std::size_t i = 0; i < rows.size(); ++i) apply_impulse(rows[i], ledger.back()[i] * dt, bodies);
  move_bodies(bodies, dt);
}

static void film_07(Motion& motion) {
  std::vector<Body> left = tower_above_ground(3, 0, 0.3), right = tower_above_ground(3, 5, 0.3);
  motion.view(-2, -0.5, 7, 4.3);
  for (int k = 0; k <= 90; ++k) {
    if (k % 4 == 0) {
      motion.frame(k * 0.02);
      motion.bodies(left);
      motion.bodies(right);
      motion.words("left: λ of the matrix; right: λ of the impulses");
    }
    step_by_record(left, true);
    step_by_record(right, false);
  }
}

}  // namespace cairn::filmed
