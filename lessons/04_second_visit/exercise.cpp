// Exercise 04. Move the clamp. Then: bash lessons/run check 4
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise04 {

/// A box that lands: how fast its centre rises, and how fast it turns.
struct Box {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m²)]
  double velocity = 0;         // [m/s] upwards
  double spin = 0;             // [rad/s]
};

struct Foot {
  double place = 0;      // [m] right of the centre
  double strongest = 0;  // [N s] the most that it can give in one step, before it breaks
  double impulse = 0;    // [N s] that it has given so far, in total; it cannot pull
};

// One visit to a foot: stops it, as far as it is able to. This one clamps each push. Move the clamp to the
// sum, which has two ends here.
void visit(Foot& foot, Box& box) {
  const double jv = box.velocity + foot.place * box.spin;  // [m/s] of the foot, upwards
  const double inverse_effective_mass = box.inverse_mass + foot.place * foot.place * box.inverse_inertia;
  const double correction = -jv / inverse_effective_mass;  // [N s] (22) times Δt
  // Your code begins here: change what has to be changed.
  const double push = std::max(correction, 0.0);
  foot.impulse += push;
  box.velocity += box.inverse_mass * push;
  box.spin += box.inverse_inertia * foot.place * push;
  // Your code ends here.
}

}  // namespace cairn::exercise04
