// Lesson 01. To a solver a constraint is a number c that has to be 0, and its derivative j: (3) and (5). A
// box hangs on a rod. We write down c and j by hand, hold j against differences of c, and use it in both ways
// that solvers do: j·v says how fast a velocity v breaks the rod, and jᵀ λ is the force with which the rod
// resists (10). The library says the same of its own rod.
#include "lesson.hpp"

namespace cairn::one_row {

// [c_and_j]
/// (3) By how much the rod would have to be longer, with the box at this pose [m].
double error_at(const Rod& rod, const Pose<double>& box) {
  const Vec2<double> p = box.world(rod.local_anchor);
  return p.norm() - rod.length;
}

/// (5) How fast c grows while the box moves to the right, moves up, or turns [1, 1, m].
Vec3<double> jacobian_at(const Rod& rod, const Pose<double>& box) {
  const Vec2<double> r = Rotation<double>(box.angle) * rod.local_anchor;  // from the centre to the anchor
  const Vec2<double> p = box.position + r;
  const Vec2<double> u = p / p.norm();  // along the rod
  return {u.x(), u.y(), cross(r, u)};
}
// [/c_and_j]

Quotient quotient(const Rod& rod, double h) {
  Quotient result{.h = h};
  for (int k = 0; k < 3; ++k) {  // x, y, angle
    result.forward[k] = error_at(rod, carried(rod.pose, Vec3<double>::Unit(k), h));
    result.backward[k] = error_at(rod, carried(rod.pose, Vec3<double>::Unit(k), -h));
    result.slope[k] = (result.forward[k] - result.backward[k]) / (2 * h);
    result.error = std::max(result.error, std::abs(result.slope[k] - rod.jacobian(k)));
  }
  return result;
}

}  // namespace cairn::one_row

namespace {

using namespace cairn;
using namespace cairn::one_row;

constexpr double half_box = 0.5;  // [m] from the middle of the box to the anchor on its side

/// The scene, and of the library's rod its row.
Rod hung_box(const RodSettings& settings) {
  Rod rod{.settings = settings, .local_anchor = {-half_box, 0}, .length = settings.anchor.norm()};
  rod.arm = Rotation<double>(settings.turn) * rod.local_anchor;
  Scene scene({.gravity = {0, 0}});
  const BodyId body = scene.add({.shapes = {box(2 * half_box, 2 * half_box)},
                                 .position = settings.anchor - rod.arm,
                                 .angle = settings.turn,
                                 .velocity = settings.velocity.head<2>(),
                                 .angular_velocity = settings.velocity.z(),
                                 .mass = 1});
  scene.join<DistanceJoint>({.a = ground, .b = body, .anchor_a = {0, 0}, .anchor_b = settings.anchor});
  rod.snapshot = snapshot(scene);
  const BodyState<double> state = state_of<double>(scene);
  rod.pose = state.pose[body];
  RowSpecs<double> rows;
  scene.joints()[0]->append_rows(state.pose, rows);
  rod.row = rows.at(0);
  return rod;
}

void look_at(Rod& rod) {
  rod.error = error_at(rod, rod.pose);
  rod.jacobian = jacobian_at(rod, rod.pose);
  for (int half = 2; half <= 22; ++half) rod.quotients.push_back(quotient(rod, std::pow(10, -0.5 * half)));
  rod.motion = motion_of(rod.jacobian, "as asked", rod.settings.velocity);
  rod.allowed = allowed_motions(rod.jacobian, rod.arm);
  rod.force = rod.jacobian * rod.settings.lambda;  // (10) f = jᵀ λ
}

void run(Lesson& lesson) {
  Rod rod = hung_box({.anchor = {lesson.real("x"), lesson.real("y")},
                      .turn = lesson.real("turn") * pi / 180,
                      .velocity = {lesson.real("vx"), lesson.real("vy"), lesson.real("omega")},
                      .lambda = lesson.real("lambda")});
  look_at(rod);
  print_scene(lesson, rod);
  lesson.predict();
  lesson.print();
  print_derivative(lesson, rod);
  print_motions(lesson, rod);
  lesson.answer({rod.motion.rate}, 0.01,
                "It is j·v. Where that is 0 the rod allows the motion: one row takes one of three freedoms, "
                "and two are left, swinging and turning about the anchor.");
  check_derivative(lesson, rod);
  check_force(lesson, rod);
  lesson.film(rod_shots(rod));
  lesson.data(quotients_table(rod));
  lesson.fingerprint({rod.error, rod.jacobian.x(), rod.jacobian.y(), rod.jacobian.z(), rod.force.z()});
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(card(), run, argc, argv); }
