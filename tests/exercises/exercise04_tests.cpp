// Exercise 04: every misconception is told from the answer.
#include "lessons/04_big_matrices/exercise.hpp"

#include <algorithm>
#include <cstdlib>

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise04 {
namespace {

using Masses = List<double>;

double mass(const Masses& masses, int box) { return masses[box]; }

double without_masses(int i, int j, const Masses&) {
  return i == j ? (i == 0 ? 1 : 2) : (std::abs(i - j) == 1 ? -1 : 0);
}

double with_masses(int i, int j, const Masses& masses) {
  return std::abs(i - j) == 1 ? -mass(masses, std::min(i, j)) : 0;
}

}  // namespace

TEST_CASE("exercise 04 tells J Jᵀ, masses for their inverses, signs, the ground and the wrong neighbour") {
  CHECK(testing::tells<grade>(without_masses, "M⁻¹ is missing"));
  CHECK(testing::tells<grade>(with_masses, "The inverse mass"));
  CHECK(testing::tells<grade>([](int, int, const Masses&) { return 2.0; }, "the ground"));
  CHECK(testing::tells<grade>([](int, int, const Masses&) { return 1.0; }, "both give way"));
  CHECK(testing::tells<grade>([](int, int, const Masses&) { return 1.0; }, "The sign"));
  CHECK(testing::tells<grade>([](int, int, const Masses&) { return 0.0; }, "touch box 2"));
  CHECK(testing::tells<grade>([](int i, int j, const Masses& m) { return -1 / mass(m, std::max(i, j)); },
                              "not box 2"));
}

}  // namespace cairn::exercise04
