// Exercise NN, graded: two balls of other masses and speeds.
#include "exercise.cpp"

namespace cairn::exerciseNN {
namespace {

void grade(Grade& grade) {
  // m v = 2 * 3 and 0.5 * 8, exact in binary: two roundings at most.
  grade.number({.what = "2 kg at 3 m/s (N s)",
                .value = 6,
                .tolerance = 1e-15,
                .misconceptions = {{0, "Nothing was computed."},
                                   {3, "That is the speed: the mass is missing."},
                                   {2, "That is the mass: the speed is missing."},
                                   {1.5, "A heavy ball needs more impulse, not less: divide by 1/m."},
                                   {-6, "The sign: the ground pushes the ball up."},
                                   {9, "That is an energy, m v²/2: an impulse changes a velocity."},
                                   {300, "That is the force over 0.02 s: an impulse is the force times Δt."},
                                   {12, "The ball stops; it does not fly up again."}}},
               impulse_of(2, 3));
  grade.number({.what = "0.5 kg at 8 m/s (N s)", .value = 4, .tolerance = 1e-15}, impulse_of(0.5, 8));
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = NN_DECIMAL,
      .task = "Equation (22), times Δt, for one ball and the ground.",
      .file = "lessons/FOLDER/exercise.cpp",
      .hints = {"What is j·v, and what should it be?", "j M⁻¹ jᵀ is 1/m here.", "Divide the speed by 1/m."},
      .grade = grade};
}

}  // namespace cairn::exerciseNN
