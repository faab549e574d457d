// Exercise 09, answered.
#include <algorithm>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise09 {

List<double> first_guess(const List<int>& keys, const List<Kept>& kept, double dt_now, double dt_before) {
  List<double> guess;
  for (const int key : keys) {
    const auto own =
        std::find_if(kept.begin(), kept.end(), [key](const Kept& each) { return each.key == key; });
    guess.push_back(own == kept.end() ? 0 : own->impulse * dt_now / dt_before);  // the same force
  }
  return guess;
}

}  // namespace cairn::exercise09
