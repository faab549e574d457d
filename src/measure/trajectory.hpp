// Floor 6. What went wrong along the way: measures of a run, from its snapshots.
#pragma once

#include <optional>

#include <cairn/measure/energy.hpp>
#include <cairn/measure/energy_account.hpp>

namespace cairn {

/// Errors of a run as a whole. Every "worst" is over all snapshots that were seen, and infinite once a body's
/// position or velocity is no number any more.
struct Trajectory {
  int snapshots = 0;             // seen, the start among them
  double time = 0;               // [s] from the start to the last of them
  bool finite = true;            // all positions, velocities and energies were numbers
  double worst_penetration = 0;  // [m] of shapes (worst_penetration in violation.hpp)
  /// [m] max(0, -separation), averaged over all contact points of all snapshots; the contacts are those that
  /// the solver saw.
  double mean_contact_penetration = 0;
  double worst_drift = 0;  // [m or rad] of a joint
  /// Let E be kinetic and potential energy, that of springs with it, and W the work that the caller knows of.
  /// What is in neither: the work of motors, of kinematic bodies and of a hand that moves.
  double energy_gain = 0;    // [J] max over time of E(t) - E(0) - W(t), and never below 0: E(0) is a time too
  double energy_change = 0;  // [J] the same at the last snapshot: negative where energy was dissipated
  double energy_scale = 0;   // [J] EnergyAccount::scale()
  /// What changed the momentum, but for gravity: 0 for an isolated system without damping; a joint that has
  /// drifted turns its bodies by its drift times its impulse.
  double momentum_error = 0;          // [N s] max over time of |P(t) - P(0) - t sum m s g|
  double angular_momentum_error = 0;  // [N m s] about the origin, of |L(t) - L(0) - sum x x m s g dt|
  /// No contact with a body that is not dynamic had an impulse, and no joint has such a body: only then do
  /// the two above measure an error.
  bool isolated = true;
  double worst_cone_violation = 0;  // [N s] max |lambda_t| - mu lambda_n
  /// [W] max of lambda_t v_t / dt over the contacts, v_t the sliding velocity of b on a after the step:
  /// friction only brakes, so that this is 0 but for rounding.
  double worst_friction_power = 0;

  /// The gains as parts of the scale [1]; 0 where there is none, infinite where the scale is 0.
  double relative_energy_gain() const;
  /// energy_change over energy_scale [1].
  double relative_energy_change() const;
};

/// Sees the start and then every step, and adds up a Trajectory. O(n log n + m) a snapshot, for n bodies with
/// m contacts: most of it for the penetration.
class TrajectoryMeasure {
 public:
  /// The first snapshot is the start. `work` [J] is what motors and drives have done since the last one, as
  /// far as the caller knows. All snapshots are of one scene; of a world with substeps the contacts are those
  /// of the last substep, and the angular momentum is exact only where snapshots are one substep apart.
  /// @throws std::invalid_argument unless it has as many bodies as the start.
  void add(const Snapshot& snapshot, double work = 0);

  /// Of all snapshots so far.
  const Trajectory& result() const { return result_; }

 private:
  void begin(const Snapshot& snapshot);
  void add_contacts(const Snapshot& snapshot);
  void add_energy(const Snapshot& snapshot, double work);
  void add_momentum(const Snapshot& snapshot);
  void blow_up();

  Trajectory result_;
  double start_time_ = 0;                       // [s]
  double last_time_ = 0;                        // [s]
  int bodies_ = 0;                              // of the start
  std::optional<EnergyAccount> energy_;         // from the start on
  double penetration_sum_ = 0;                  // [m]
  double contact_count_ = 0;                    // of all snapshots
  Vec3<double> expected_momentum_ = {0, 0, 0};  // [N s, N s, N m s]
  Vec3<double> gravity_push_ = {0, 0, 0};       // [N, N, N m] of gravity, where the last snapshot stood
};

}  // namespace cairn
