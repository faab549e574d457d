// Exercise 22. Choose the default for a scene. Then: bash lessons/run check 22
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise22 {

struct BodyKind {
  bool moves = false;  // static bodies do not
  bool turns = false;  // some only slide
};

struct RowKind {
  bool is_equality = false;        // of a joint; limits are none
  bool is_soft = false;            // a spring
  bool has_largest_force = false;  // a motor: beyond that force it gives way
};

struct Choice {
  int freedoms = 0;
  bool at_once = false;
  int substeps = 0;
};

// A body that moves and turns has three freedoms, one that only slides two. A row takes one away if it is an
// equality that never gives way. Up to 300 freedoms all rows are solved at once. There are four substeps, or
// as many as the scene asks for if these are more.
Choice choose(const List<BodyKind>& bodies, const List<RowKind>& rows, int asked_substeps) {
  Choice choice;
  // Your code begins here: about eight lines.

  // Your code ends here.
  return choice;
}

}  // namespace cairn::exercise22
