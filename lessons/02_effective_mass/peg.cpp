// What (22) divides by, by hand.
#include "lesson.hpp"

namespace cairn::one_push {

double inertia_of(double mass) { return mass / 6; }

double mass_at(double mass, const Vec2<double>& arm, const Vec2<double>& direction) {
  const double lever = cross(arm, direction);
  return 1 / (1 / mass + lever * lever / inertia_of(mass));
}

}  // namespace cairn::one_push
