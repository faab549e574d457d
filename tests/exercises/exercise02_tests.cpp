// Exercise 02: every misconception is told from the answer.
#include "lessons/02_effective_mass/exercise.hpp"

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise02 {
namespace {

double change_of(const Meeting& m) { return m.wanted - m.speed; }

double compliance_of(const Meeting& m) { return m.inverse_mass + m.arm * m.arm * m.inverse_inertia; }

}  // namespace

TEST_CASE("exercise 02 tells a force, a wrong sign, a product for a quotient and a forgotten arm") {
  CHECK(testing::tells<grade>([](const Meeting& m) { return change_of(m) / compliance_of(m) / 0.02; },
                              "the force"));
  CHECK(testing::tells<grade>([](const Meeting& m) { return change_of(m) / compliance_of(m) * 0.02; },
                              "One dt too many"));
  CHECK(testing::tells<grade>([](const Meeting& m) { return -change_of(m) / compliance_of(m); }, "The sign"));
  CHECK(testing::tells<grade>([](const Meeting& m) { return change_of(m) * compliance_of(m); }, "Divide by"));
  CHECK(testing::tells<grade>([](const Meeting& m) { return change_of(m); }, "How heavy is the body"));
  CHECK(testing::tells<grade>([](const Meeting& m) { return change_of(m) / m.inverse_mass; },
                              "where is the arm"));
  CHECK(testing::tells<grade>(
      [](const Meeting& m) { return change_of(m) / (m.inverse_mass + m.arm * m.inverse_inertia); }, "twice"));
  CHECK(testing::tells<grade>([](const Meeting& m) { return -m.speed / compliance_of(m); }, "not always 0"));
}

}  // namespace cairn::exercise02
