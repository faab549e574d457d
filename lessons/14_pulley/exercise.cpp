// Exercise 14. Write a joint class: a rope whose end is wound on a drum. Then: bash lessons/run check 14
#include <limits>

#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise14 {

struct Pose {
  double y = 0;      // [m]
  double angle = 0;  // [rad]
};

/// One body's block of j: dc/dt is the sum of vy * v_y + omega * (angular velocity) over all terms.
struct Term {
  int body = 0;
  double vy = 0;     // [1]
  double omega = 0;  // [m]
};

/// What a joint says of itself. A solver needs nothing else.
struct Row {
  double error = 0;                                         // c [m]: how much rope is left over
  List<Term> terms = {};                                    // j, with as many bodies as there are
  double lower = -std::numeric_limits<double>::infinity();  // of λ [N]
  double upper = std::numeric_limits<double>::infinity();
};

/// A rope over fixed wheels, of the given length while the drum's angle is 0. Masses hang on it, each on
/// `parts` parts of it that come down from the height `top`; its end is wound on a drum, which pays out rope
/// as its angle grows. The drum slips on its axle: no pull is harder than its grip.
class RopeOnDrum {
 public:
  struct End {
    int body = 0;
    double parts = 1;
    double top = 0;  // [m]
  };
  struct Drum {
    int body = 0;
    double radius = 0;  // [m]
    double grip = 0;    // [N] the hardest pull
  };

  RopeOnDrum(const List<End>& ends, const Drum& drum, double length)
      : ends_(ends), drum_(drum), length_(length) {}

  // The row of the rope for these poses: c = what is left over of the rope, j with dc/dt = j·v, and the
  // interval of λ, which is positive where the rope pulls.
  Row row(const List<Pose>& poses) const {
    Row row;
    // Your code begins here: about nine lines.

    // Your code ends here.
    return row;
  }

 private:
  List<End> ends_;
  Drum drum_;
  double length_;
};

}  // namespace cairn::exercise14
