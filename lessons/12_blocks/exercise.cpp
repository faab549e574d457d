// Exercise 12. Solve both rows of a pin together. Then: bash lessons/run check 12
#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise12 {

struct Body {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m²)]
  double vx = 0, vy = 0;       // [m/s]
  double omega = 0;            // [rad/s]
};

/// Holds a point of body 1 and one of body 2 together. Its arms lead from the centres to these points.
struct Pin {
  double r1x = 0, r1y = 0, r2x = 0, r2y = 0;  // [m]
  double px = 0, py = 0;                      // [N s] that both rows have given so far, in total
};

/// j·v of both rows [m/s]: how fast the point of body 2 moves away from that of body 1.
FixedList<double, 2> row_velocities(const Pin& pin, const Body& one, const Body& two) {
  return {two.vx - two.omega * pin.r2y - one.vx + one.omega * pin.r1y,
          two.vy + two.omega * pin.r2x - one.vy - one.omega * pin.r1x};
}

/// Gives (x, y) [N s] to body 2 at its point, and the opposite to body 1.
void push(const Pin& pin, Body& one, Body& two, double x, double y) {
  one.vx -= one.inverse_mass * x, one.vy -= one.inverse_mass * y;
  one.omega -= one.inverse_inertia * (pin.r1x * y - pin.r1y * x);
  two.vx += two.inverse_mass * x, two.vy += two.inverse_mass * y;
  two.omega += two.inverse_inertia * (pin.r2x * y - pin.r2y * x);
}

// One visit to the pin: makes both row velocities 0 together. Its block of A is
//     k11 = Σ 1/m + r_y²/I     k12 = Σ −r_x r_y/I     k22 = Σ 1/m + r_x²/I     summed over both bodies.
void visit(Pin& pin, Body& one, Body& two) {
  const FixedList<double, 2> jv = row_velocities(pin, one, two);
  // Your code begins here: about nine lines.

  // Your code ends here.
}

}  // namespace cairn::exercise12
