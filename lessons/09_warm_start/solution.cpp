// Exercise 09, answered.
#include <algorithm>

#include "exercise.hpp"

namespace cairn::exercise09 {

std::vector<double> first_guess(const std::vector<int>& keys, const std::vector<Kept>& kept, double dt_now,
                                double dt_before) {
  std::vector<double> guess;
  for (const int key : keys) {
    const auto own =
        std::find_if(kept.begin(), kept.end(), [key](const Kept& each) { return each.key == key; });
    guess.push_back(own == kept.end() ? 0 : own->impulse * dt_now / dt_before);  // the same force
  }
  return guess;
}

}  // namespace cairn::exercise09
