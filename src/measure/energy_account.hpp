// Floor 6. What the energy of a run is held against: what the scene began with, and what may drive it.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// A size for the energies of a scene [J]: its kinetic energy, what its springs hold, and what its dynamic
/// bodies would gain by falling through the diagonal of the box around them all and the anchors of their
/// joints. Unlike the potential energy itself it does not depend on where the origin is.
double energy_scale(const Snapshot& snapshot);

/// Energy as a run goes on, against what was given.
class EnergyAccount {
 public:
  /// Of a run that begins so.
  explicit EnergyAccount(const Snapshot& start);
  /// What has come from outside [J] since the last look.
  void give(double work) { given_ += work; }
  /// Events have made this of what was seen last: what they gave and took was given.
  void scene_changed(const Snapshot& now);
  /// Looks at the bodies as they are now.
  void see(const Snapshot& now);
  /// [J] Of kinetic and potential energy above what was given, when it was last looked at.
  double change() const { return energy_ - given_; }
  /// [J] What gains and losses are shares of: all energy that was given, counted from the lowest potential
  /// energy that there has been; energy_scale() where that is more. So no more than all of it is ever lost.
  double scale() const;

 private:
  double energy_ = 0;  // [J] kinetic and potential
  double given_ = 0;   // [J] in the beginning, and since
  double lowest_ = 0;  // [J] potential energy
  double size_ = 0;    // [J] energy_scale()
};

/// What in a scene gives energy to the rest, as far as that is known beforehand. A motor of speed s and force
/// F gives F s a second at most, as it pushes no row that is faster than itself. A body that moves by itself
/// is as good as infinitely heavy: nothing leaves it faster than it came by more than twice its speed.
class Drive {
 public:
  /// Of its motors, those that events will switch on, its kinematic bodies, surfaces that run, forces, wind
  /// and flow.
  explicit Drive(const Scene& scene);
  /// [J] The most that the bodies can have after `time` [s] in `steps` steps, if they had `energy` [J]
  /// without what drives them; infinite with a motor whose force nothing bounds.
  double most_energy(double energy, double time, double steps) const;

 private:
  struct Force {
    double growth = 0;  // [sqrt(J) / s]
    double begins = 0;  // [s]
    double ends = 0;    // [s]
  };

  double power_ = 0;  // [W] of all motors
  double speed_ = 0;  // [m/s] of any point of a body that moves by itself, and of any surface that runs
  double mass_ = 0;   // [kg] of all bodies that can be moved
  List<Force> forces_;
};

}  // namespace cairn
