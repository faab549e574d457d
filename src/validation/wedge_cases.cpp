// Floor 8. A block that slides down a wedge that is free to go.
#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double wedge_angle = in_radians(30);
const double wedge_mass = 3;  // [kg] M; the block has m = 1 kg

/// A wedge on the ground whose face goes down to the right, and a block on it: nothing has friction.
Scene free_wedge() {
  const double s = std::sin(wedge_angle), c = std::cos(wedge_angle), width = 6;
  Scene scene;
  scene.add_ground({.material = {.friction = 0}});
  scene.add({.shapes = {polygon({{0, 0}, {width, 0}, {0, width * s / c}})},
             .mass = wedge_mass,
             .material = {.friction = 0}});
  const Vec2<double> middle_of_face(width / 2, width / 2 * s / c);
  scene.add({.shapes = {box(1, 0.5)},
             .position = middle_of_face + 0.25 * Vec2<double>(s, c),
             .angle = -wedge_angle,
             .mass = 1,
             .material = {.friction = 0}});
  return scene;
}

// Lagrange: (M + m) a = m b cos, b - a cos = g sin, with b along the face as seen from the wedge. Momentum
// along x is kept: the block gets M/m a, and comes down by tan of its way over the wedge.
ValidationResult block_on_wedge(const EngineMaker& make) {
  const double s = std::sin(wedge_angle), c = std::cos(wedge_angle), t = 0.5;
  const double a = standard_gravity * s * c / (wedge_mass + s * s);  // 1.332347 m/s^2
  const Snapshot end = run_scene(make, free_wedge(), 300, t);
  ValidationResult result;
  const auto add = [&](const char* what, const char* formula, double expected, double got) {
    result.add(measured(what, got, "m/s")
                   .by(formula, expected)
                   .within(1e-9 * std::abs(expected),
                           "constant forces: velocities are exact; 300 sweeps leave rounding"));
  };
  add("speed of the wedge after 0.5 s", "-m g sin cos/(M + m sin^2) t = -a t", -a * t,
      end.bodies[{1}].velocity.x());
  add("speed of the block along x", "M/m a t", wedge_mass * a * t, end.bodies[{2}].velocity.x());
  add("speed of the block along y", "-(1 + M/m) tan a t", -(1 + wedge_mass) * a * t * s / c,
      end.bodies[{2}].velocity.y());
  return result;
}

}  // namespace

void add_wedge_cases(ValidationCases& cases) {
  cases.push_back({.id = "B14",
                   .title = "A block on a free wedge drives it by m g sin cos / (M + m sin^2)",
                   .asks = Asks::any_engine,
                   .run = block_on_wedge});
}

}  // namespace cairn
