// Floor 8. What many cases do: running, bisecting, refining, and asking every solver.
#include <cairn/validation/case_runs.hpp>
#include <cairn/math/list.hpp>

#include <cmath>

namespace cairn::cases {

Motion::Motion(const EngineMaker& make, const Scene& scene, int iterations)
    : engine_(make(scene, iterations)), now_(engine_->snapshot()), dt_(scene.settings().dt) {}

void Motion::step() {
  engine_->step();
  now_ = engine_->snapshot();
  ++steps_;
}

void Motion::run(double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / dt_));
  for (int i = 0; i < steps; ++i) engine_->step();
  now_ = engine_->snapshot();
  steps_ += steps;
}

Snapshot run_scene(const EngineMaker& make, const Scene& scene, int iterations, double seconds) {
  Motion motion(make, scene, iterations);
  motion.run(seconds);
  return motion.now();
}

EngineMaker engine_of(const SolverMaker<double>& make) {
  return cairn_engine([make](int iterations) { return make({.iterations = iterations}); });
}

List<EngineMaker> gauss_seidel_engines() {
  List<EngineMaker> engines;
  for (const SolverMaker<double>& make : all_solvers<double>()) engines.push_back(engine_of(make));
  return engines;
}

Bracket bisected(const Bracket& start, double width, const std::function<bool(double)>& happens) {
  if (happens(start.before)) return {start.before, start.before};
  if (!happens(start.after)) return {start.after, start.after};
  Bracket now = start;
  while (std::abs(now.after - now.before) > width) {
    const double middle = now.middle();
    (happens(middle) ? now.after : now.before) = middle;
  }
  return now;
}

void add_bracket(List<Measured>& numbers, const Measured& number, const Bracket& bracket,
                 const std::string& before, const std::string& after) {
  Measured end = number;
  end.what = number.what + before;
  end.got = bracket.before;
  numbers.push_back(end);
  end.what = number.what + after;
  end.got = bracket.after;
  numbers.push_back(end);
}

Convergence converges(const std::string& what, const std::function<double(double frequency)>& error,
                      double lowest, double highest) {
  Convergence result{.what = what, .lowest = lowest, .highest = highest};
  for (const double frequency : {60.0, 120.0, 240.0, 480.0}) {
    result.dt.push_back(1 / frequency);
    result.error.push_back(std::abs(error(frequency)));
  }
  return result;
}

}  // namespace cairn::cases
