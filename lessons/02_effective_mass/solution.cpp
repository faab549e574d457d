// Exercise 02, answered.
#include "exercise.hpp"

namespace cairn::exercise02 {

double impulse_of(const Meeting& meeting) {
  // j M^-1 j^T: how far the point gives way to a push of 1 N s.
  const double gives = meeting.inverse_mass + meeting.arm * meeting.arm * meeting.inverse_inertia;
  return (meeting.wanted - meeting.speed) / gives;
}

}  // namespace cairn::exercise02
