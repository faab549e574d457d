// Exercise 06. Write one sweep of projected Gauss-Seidel. Then: bash lessons/run check 6
#include <algorithm>
#include <limits>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise06 {

/// What a row may do.
enum class RowKind {
  joint,    // pushes and pulls
  contact,  // j·v is the speed at which the bodies part: it only pushes them apart
  rope,     // j·v is the speed at which it goes slack: it only pulls the bodies together
  motor     // pushes and pulls, with at most `strength`
};

struct Row {
  RowKind kind = RowKind::joint;
  double strength = 0;  // [N] of a motor; other kinds take no notice of it
};

/// A λ = b, with the kind of every row.
struct System {
  List<List<double>> A = {};  // [1/kg] row by row
  List<double> b = {};        // [m/s²]
  List<Row> rows = {};
};

constexpr double infinite = std::numeric_limits<double>::infinity();

// One sweep, from the first row to the last. Each row gets the λ [N] that solves its own equation (28), as
// far as the interval of its kind allows.
void sweep(const System& system, List<double>& lambda) {
  const int count = lambda.size();
  // Your code begins here: about ten lines.

  // Your code ends here.
}

}  // namespace cairn::exercise06
