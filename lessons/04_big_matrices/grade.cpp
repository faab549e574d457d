// Exercise 04, graded: a stack of equal boxes, and J M^-1 J^T of one with four different ones.
#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise04 {
namespace {

constexpr double one_rounding = 1e-15;  // of entries up to 3 / kg

/// A_ij by its definition: the rows of J one by one.
double by_definition(int i, int j, const List<double>& masses) {
  const auto row = [](int contact, int box) {
    return box == contact ? 1.0 : (box == contact - 1 ? -1.0 : 0.0);
  };
  double sum = 0;
  for (int box = 0; box < masses.size(); ++box) sum += row(i, box) * row(j, box) / masses[box];
  return sum;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const List<double> equal = {1, 1, 1, 1}, different = {1, 2, 4, 0.5};
  grade.number({.what = "four boxes of 1 kg: A_00 (1/kg)",
                .value = 1,
                .tolerance = one_rounding,
                .misconceptions = {{2, "One of the two bodies is the ground: its inverse mass is 0."}}},
               answer(0, 0, equal));
  grade.number({.what = "the new box: A_33 (1/kg)",
                .value = 2,
                .tolerance = one_rounding,
                .misconceptions = {{1, "Two boxes meet in this contact, and both give way."}}},
               answer(3, 3, equal));
  grade.number({.what = "the new box: A_32 (1/kg)",
                .value = -1,
                .tolerance = one_rounding,
                .misconceptions = {{1, "The sign: contact 3 pushes box 2 down, contact 2 pushes it up."},
                                   {0, "Both contacts touch box 2."}}},
               answer(3, 2, equal));
  grade.number({.what = "boxes of 1, 2, 4 and 0.5 kg: A_21 (1/kg)",
                .value = -0.5,
                .tolerance = one_rounding,
                .misconceptions = {{-1, "That is J Jᵀ: M⁻¹ is missing."},
                                   {-2, "The inverse mass: 1 / m."},
                                   {-0.25, "Contacts 1 and 2 share box 1, not box 2."}}},
               answer(2, 1, different));
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double off = std::abs(answer(i, j, different) - by_definition(i, j, different));
      worst = std::isnan(off) ? off : std::max(worst, off);
    }
  }
  grade.number({.what = "all sixteen: largest difference from J M⁻¹ Jᵀ (1/kg)", .tolerance = one_rounding},
               worst);
}

Exercise exercise() {
  return {
      .lesson = 4,
      .task = "The entries of A = J M⁻¹ Jᵀ for a stack of any height: equation (15).",
      .file = "lessons/04_big_matrices/exercise.cpp",
      .hints = {"Row i of J has -1 at the box below the contact and +1 at the box above it.",
                "A_ij is the sum over the boxes that both contacts touch of (entry of i)(entry of j) / m.",
                "A_ii = 1/m_(i-1) + 1/m_i without the ground; A_ij = -1/m of the box between, if they are "
                "neighbours."},
      .grade = [](Grade& marks) { grade(marks, entry); }};
}

}  // namespace cairn::exercise04
