// Floor 9. A scene under a setting, whoever steps it: Cairn in one of its scalars, or Box2D.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <cairn/scenes/setting.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

class Contestant {
 public:
  virtual ~Contestant() = default;
  /// Does the events of the scene that are due before the next step, which would do them otherwise. Whether
  /// there were any.
  virtual bool do_events() = 0;
  /// One step of the setting's dt: all that is to be timed.
  virtual void step() = 0;
  virtual Snapshot snapshot() const = 0;
  /// From the next step on, a snapshot has the impulses of a whole step (StepImpulses) and not those of its
  /// last substep.
  virtual void sum_impulses() = 0;
  /// The body for whose sake the last step was not done: it would have got what is no finite number.
  virtual std::optional<BodyId> not_finite() const { return std::nullopt; }
  /// The largest R_E of the last step, where one of its solves is known to have ended far from its answer
  /// (StepReport::unfinished).
  virtual std::optional<double> unfinished() const { return std::nullopt; }
  /// Row updates of the last step: rows times sweeps, summed over substeps and over the second solves of the
  /// policies that have them. Of Box2D: two rows a contact point and those of the joints, as the snapshot
  /// `after` the step has them, times velocity iterations and substeps. What came and went within the step
  /// is not in it, nor are position iterations.
  virtual std::int64_t row_updates(const Snapshot& after) const = 0;
  /// Rows of the last step, summed over substeps: of Box2D as for row_updates.
  virtual std::int64_t rows(const Snapshot& after) const = 0;
  /// R_E that the solver will reach in the next step, in the velocities of its first substep: solved a second
  /// time beside the world. Nothing for Box2D, whose rows cannot be seen.
  virtual std::optional<double> residual_ahead() = 0;
  /// FNV-1a (G. Fowler, L. Noll, K. Vo) of all bits of poses and velocities.
  virtual std::uint64_t state_hash() const = 0;
};

/// The scene steps by the setting in place of its own settings.
/// @throws std::invalid_argument for a setting that check() refuses, and for Box2D a scene that it cannot
/// run; std::length_error for one that has more pairs of shapes at its start than a step of Cairn takes.
std::unique_ptr<Contestant> make_contestant(const Scene& scene, const Setting& setting);

/// What the solver of a setting does in another way than the scene says, a line each: Box2D with some joints.
List<std::string> known_differences(const Scene& scene, const Setting& setting);

}  // namespace cairn
