// Exercise 09: every misconception is told from the answer.
#include "lessons/09_warm_start/exercise.hpp"

#include <algorithm>

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise09 {
namespace {

using Keys = List<int>;
using Numbers = List<double>;
using Store = List<Kept>;

Numbers by_place(const Keys& keys, const Store& kept, double, double) {
  Numbers guess;
  for (int i = 0; i < keys.size(); ++i) guess.push_back(i < kept.size() ? kept[i].impulse : 0);
  return guess;
}

Numbers all_of_yesterday(const Keys&, const Store& kept, double, double) {
  Numbers guess;
  for (const Kept& each : kept) guess.push_back(each.impulse);
  return guess;
}

Numbers nothing(const Keys& keys, const Store&, double, double) { return Numbers(keys.size(), 0.0); }

/// By key, with another factor for steps of another length; new rows are left out where that is asked for.
Numbers by_key(const Keys& keys, const Store& kept, double factor, bool with_new) {
  Numbers guess;
  for (const int key : keys) {
    const auto own = std::find_if(kept.begin(), kept.end(), [key](const Kept& k) { return k.key == key; });
    if (own != kept.end()) guess.push_back(factor * own->impulse);
    if (own == kept.end() && with_new) guess.push_back(0);
  }
  return guess;
}

Numbers unscaled(const Keys& keys, const Store& kept, double, double) { return by_key(keys, kept, 1, true); }

Numbers scaled_up(const Keys& keys, const Store& kept, double now, double before) {
  return by_key(keys, kept, before / now, true);
}

Numbers without_new(const Keys& keys, const Store& kept, double now, double before) {
  return by_key(keys, kept, now / before, false);
}

}  // namespace

TEST_CASE(
    "exercise 09 tells rows known by their place, what has vanished, what is new and what should be scaled") {
  CHECK(testing::tells<grade>(by_place, "not by their place"));
  CHECK(testing::tells<grade>(by_place, "a new row begins with 0"));
  CHECK(testing::tells<grade>(all_of_yesterday, "has vanished"));
  CHECK(testing::tells<grade>(nothing, "begins with what it had"));
  CHECK(testing::tells<grade>(unscaled, "force times dt"));
  CHECK(testing::tells<grade>(scaled_up, "needs less"));
  CHECK(testing::tells<grade>(without_new, "A new row needs"));
}

}  // namespace cairn::exercise09
