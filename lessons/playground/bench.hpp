// One world at work, in whichever number it computes, and a look into its next solve.
#pragma once

#include <functional>
#include <memory>

#include <cairn/math/list.hpp>
#include <cairn/scenes/setting.hpp>
#include <cairn/world/world.hpp>

namespace cairn::playground {

/// The first solve of the next step, stopped after some of its row updates. n bodies, m rows.
struct SolveLook {
  VelocityProblem<double> given = {};          // with the warm start, which is not applied yet
  PerBody<Vec3<double>> velocity = {};         // n [m/s, m/s, rad/s] after those updates
  PerRow<double> impulse = {};                 // m [N s] after them
  int updates = 0;                             // done
  int all_updates = 0;                         // of the whole solve; 0 for solvers that have none
  std::optional<RowUpdate<double>> last = {};  // of those that are done
  List<double> residuals = {};  // R_E before the first sweep and after each: of the whole solve
};

/// Where sweeps would end if they went on from a problem's warm start: m impulses [N s]. Sought for about so
/// many row updates at most.
PerRow<double> where_sweeps_end(VelocityProblem<double> problem, int row_updates);

/// A scene under a setting, as it runs.
class Bench {
 public:
  virtual ~Bench() = default;
  /// The same once more, to go on by itself.
  virtual std::unique_ptr<Bench> copy() const = 0;
  /// One step; then what the scene's events have due before the next.
  virtual StepReport step() = 0;
  /// Goes on under another setting, whose scalar is the same.
  virtual void set(const Setting& setting) = 0;
  /// As World::edit().
  virtual void edit(const std::function<void(Scene&)>& change) = 0;
  /// What a hand does, as World::repeat().
  virtual void repeat(const HandInput& input) = 0;
  /// All that it did.
  virtual const List<HandInput>& hand_inputs() const = 0;
  /// What the hand holds and where it pulls to; none: nothing.
  virtual const DragJoint* hand() const = 0;
  /// The world now.
  virtual Snapshot snapshot() const = 0;
  /// What it was made from.
  virtual const Scene& scene() const = 0;
  /// Steps that were taken.
  virtual int steps() const = 0;
  /// The next solve up to so many row updates; a negative number: all of it.
  virtual SolveLook look(int updates) const = 0;
};

/// @throws std::invalid_argument for what the world refuses.
std::unique_ptr<Bench> make_bench(const Scene& scene, const Setting& setting);

}  // namespace cairn::playground
