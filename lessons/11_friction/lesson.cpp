// Lesson 11. Friction: a row whose bounds depend on the row beside it.
//
// A block lies on a slope with two corners, and each corner writes two rows: one along the normal, which only
// pushes, and one along the surface, which stops the sliding if mu times what the normal row gives is enough.
// How much that is, is not known before the solve. So the bound is looked up whenever the row is visited, and
// whether the block sticks or slides is decided by a clamp.
#include "lesson.hpp"

namespace cairn::friction {

Scene slope_scene(const Slope& slope, const Block& block) {
  Scene scene({.gravity = {0, -slope.gravity},
               .dt = slope.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const Vec2<double> foot(slope.length * std::cos(slope.angle), 0);
  const Vec2<double> top(0, slope.length * std::sin(slope.angle));
  scene.add({.type = BodyType::static_body,
             .shapes = {polygon({Vec2<double>(0, 0), foot, top})},
             .material = {.friction = 1}});
  const Vec2<double> centre = top + block.from_top * slope.downhill() + 0.5 * slope.normal();
  // A pair's mu is sqrt(mu_a mu_b), and the slope's is 1.
  scene.add({.shapes = {box(1, 1)},
             .position = centre,
             .angle = -slope.angle,
             .mass = block.mass,
             .material = {.friction = block.friction * block.friction}});
  return scene;
}

Coulomb coulomb(const Slope& slope, const Block& block) {
  Coulomb result;
  result.load = block.mass * slope.gravity * std::cos(slope.angle);
  result.needed = block.mass * slope.gravity * std::sin(slope.angle);
  result.limit = block.friction * result.load;
  result.acceleration = std::max(0.0, result.needed - result.limit) / block.mass;
  return result;
}

List<PerRow<double>> sweeps_by_hand(const Slope& slope, const Block& block) {
  VelocityProblem<double> problem = World<double>(slope_scene(slope, block)).velocity_problem();
  List<PerRow<double>> impulses = {problem.impulse};  // zeros: a cold start
  for (int sweep = 1; sweep <= slope.sweeps; ++sweep) {
    // [sweep]
    for (int i = 0; i < problem.row_count(); ++i) {
      const ConstraintRow<double>& row = problem.rows[i];
      double lower = 0;  // a normal row pushes, and never pulls
      double upper = std::numeric_limits<double>::infinity();
      if (row.bounds.is_friction()) {  // a tangent row: +- mu times what its neighbour gives by now
        upper = block.friction * problem.impulse[row.bounds.normal_row];
        lower = -upper;
      }
      const double jv = row_velocity(problem, row);  // the rows before have just changed v
      const double corrective = (row.bias - jv) * effective_mass(problem, row);  // (22) times dt
      const double old = problem.impulse[i];
      problem.impulse[i] = std::clamp(old + corrective, lower, upper);
      apply_impulse(problem, row, problem.impulse[i] - old);  // (19), (21)
    }
    // [/sweep]
    impulses.push_back(problem.impulse);
  }
  return impulses;
}

Slide slide(const Slope& slope, const Block& block) {
  Slide result{.slope = slope, .block = block};
  World<double> world(slope_scene(slope, block));
  SequentialImpulse<double> solver({.iterations = slope.sweeps});
  SweepRecorder<double> first;
  look(world, result);
  for (int step = 1; step <= slope.steps; ++step) {
    world.step(solver, step == 1 ? &first : nullptr);
    judge_rows(world, result);
    look(world, result);
  }
  result.first_step = first.sweeps();
  ask_box2d(result);
  return result;
}

namespace {

void run(Lesson& lesson) {
  const Study study = make_study(settings_of(lesson));
  tell_scene(lesson, study);
  lesson.predict();
  tell_sweeps(lesson, study);
  tell_run(lesson, study);
  tell_law(lesson, study.heavy);
  const Coulomb law = coulomb(study.slippery.slope, study.slippery.block);
  lesson.answer({std::abs(first_force(study, lower_tangent))}, 0.1,
                fmt::format("Friction turns the block onto its lower corner. Its λ_n is half of load plus "
                            "friction, ({} + {})/2 N, and μ times that is its bound.",
                            fixed(law.load, 2), fixed(law.given(), 2)));
  check_study(lesson, study);
  lesson.data(table_of(study));
  lesson.fingerprint(study.slippery.frames.back());
  lesson.film(pictures(study));
}

}  // namespace
}  // namespace cairn::friction

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::friction::run, argc, argv); }
