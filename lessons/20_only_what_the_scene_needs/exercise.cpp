// Exercise 20. What does a step cost? Then: bash lessons/run check 20
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise20 {

/// Two bodies that touch or hold each other.
struct Pair {
  int a = 0, b = 0;  // numbers of the bodies; 0 is the ground
  int rows = 0;
  int sweeps = 0;  // after which its errors are small enough
};

// The row updates of a step that does only what it has to. Bodies that touch or hold each other, also by way
// of others, are an island; the ground joins nobody. An island is asleep if all its bodies are, and has no
// rows then. Otherwise all its rows are swept until each of its pairs has small enough errors.
// asleep[i] is for body i; asleep[0], the ground, is always 1.
int row_updates(const List<Pair>& pairs, const List<int>& asleep) {
  int updates = 0;
  // Your code begins here: about twenty lines, the first half of them for the islands.

  // Your code ends here.
  return updates;
}

}  // namespace cairn::exercise20
