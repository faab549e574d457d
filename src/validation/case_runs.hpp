// Floor 8. What many cases do: run a scene for a while, bisect for a threshold, refine dt, ask every
// solver.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <cairn/validation/case.hpp>
#include <cairn/validation/case_constants.hpp>
#include <cairn/validation/case_solvers.hpp>
#include <cairn/math/list.hpp>

namespace cairn::cases {

/// A scene in an engine, and what it looks like now.
class Motion {
 public:
  Motion(const EngineMaker& make, const Scene& scene, int iterations);

  void step();
  /// Steps for about this long [s]: a whole number of steps.
  void run(double seconds);

  const Snapshot& now() const { return now_; }
  const SnapshotBody& body(BodyId id) const { return now_.bodies[id]; }
  const Vec2<double>& position(BodyId id) const { return body(id).pose.position; }  // [m]
  double angle(BodyId id) const { return body(id).pose.angle; }                     // [rad]
  const Vec3<double>& velocity(BodyId id) const { return body(id).velocity; }       // [m/s, m/s, rad/s]
  double dt() const { return dt_; }                                                 // [s]
  double time() const { return steps_ * dt_; }                                      // [s]

 private:
  std::unique_ptr<Engine> engine_;
  Snapshot now_;
  double dt_;
  int steps_ = 0;
};

/// What the scene looks like after about this long [s].
Snapshot run_scene(const EngineMaker& make, const Scene& scene, int iterations, double seconds);

/// Cairn in double with a solver that `make` makes; the number of iterations is that of the EngineMaker.
EngineMaker engine_of(const SolverMaker<double>& make);

/// Cairn with each solver that has the impulses of Gauss-Seidel after every sweep.
List<EngineMaker> gauss_seidel_engines();

/// Where something begins to happen: not yet at `before`, already at `after`, which may be the lower one.
struct Bracket {
  double before = 0;
  double after = 0;
  double middle() const { return (before + after) / 2; }
};

/// Bisects until the ends are no farther apart than `width`. Where both ends of the start agree there is
/// nothing to bisect: then both ends of the result are the end of the start that disagrees with the case.
Bracket bisected(const Bracket& start, double width, const std::function<bool(double)>& happens);

/// The two ends of a bracket, which must both lie within the tolerance of `number.expected`: `number.what`
/// and `before`, and the same with `after`.
void add_bracket(List<Measured>& numbers, const Measured& number, const Bracket& bracket,
                 const std::string& before, const std::string& after);

/// The errors of a number at 60, 120, 240 and 480 steps a second, whose order must be `lowest` to `highest`:
/// without them, the first. `error` may be negative.
Convergence converges(const std::string& what, const std::function<double(double frequency)>& error,
                      double lowest = 0.8, double highest = 1.2);

}  // namespace cairn::cases
