// Exercise 04, graded: a stack of four different boxes, entry by entry and against J M^-1 J^T.
#include <algorithm>
#include <cmath>

#include "exercise.cpp"

namespace cairn::exercise04 {
namespace {

constexpr double few_roundings = 4e-15;  // of entries up to 3 / kg
const char* const no_masses = "That is J Jᵀ: M⁻¹ is missing.";
const char* const not_inverse = "The inverse mass: 1/m.";

/// A_ij by its definition: the rows of J one by one.
double by_definition(int i, int j, const List<double>& masses) {
  const auto row = [](int contact, int box) {
    return box == contact ? 1.0 : (box == contact - 1 ? -1.0 : 0.0);
  };
  double sum = 0;
  for (int box = 0; box < masses.size(); ++box) sum += row(i, box) * row(j, box) / masses[box];
  return sum;
}

double worst_entry(const List<double>& masses) {
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double off = std::abs(entry(i, j, masses) - by_definition(i, j, masses));
      worst = std::isnan(off) ? off : std::max(worst, off);
    }
  }
  return worst;
}

void grade_diagonal(Grade& grade, const List<double>& masses) {
  grade.number({.what = "boxes of 4, 0.5, 2 and 0.8 kg: A_00 (1/kg)",
                .value = 0.25,
                .tolerance = few_roundings,
                .misconceptions = {{0.5, "One of the two bodies is the ground: its inverse mass is 0."},
                                   {1, no_masses},
                                   {4, not_inverse}}},
               entry(0, 0, masses));
  grade.number({.what = "the uppermost box: A_33 (1/kg)",
                .value = 1.75,
                .tolerance = few_roundings,
                .misconceptions = {{1.25, "Two boxes meet in this contact, and both can move."},
                                   {2, no_masses},
                                   {2.8, not_inverse},
                                   {1 / 2.8, "Add the inverses, not the masses."}}},
               entry(3, 3, masses));
}

void grade_neighbours(Grade& grade, const List<double>& masses) {
  grade.number({.what = "the uppermost box: A_32 (1/kg)",
                .value = -0.5,
                .tolerance = few_roundings,
                .misconceptions = {{0.5, "The sign: contact 3 pushes box 2 down, contact 2 pushes it up."},
                                   {0, "Both contacts touch box 2."},
                                   {-1, no_masses},
                                   {-2, not_inverse},
                                   {-1.25, "Contacts 2 and 3 share box 2, not box 3."}}},
               entry(3, 2, masses));
  grade.number({.what = "above the diagonal: A_23 (1/kg)",
                .value = -0.5,
                .tolerance = few_roundings,
                .misconceptions = {{0, "A is symmetric: A_23 is A_32."}}},
               entry(2, 3, masses));
  grade.number({.what = "two contacts further: A_31 (1/kg)",
                .value = 0,
                .tolerance = few_roundings,
                .misconceptions = {{-2, "Contacts 1 and 3 have no box in common."}}},
               entry(3, 1, masses));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 4,
          .task = "The entries of A = J M⁻¹ Jᵀ for a stack of any height: equation (15).",
          .file = "lessons/04_big_matrices/exercise.cpp",
          .hints =
              {"Row i of J has −1 at the box below the contact and +1 at the box above it.",
               "A_ij is the sum over the boxes that both contacts touch of (entry of i)(entry of j) / m.",
               "A_ii = 1/m_(i−1) + 1/m_i without the ground. For neighbours A_ij = −1/m of the box between."},
          .grade = [](Grade& grade) {
            const List<double> masses = {4, 0.5, 2, 0.8};
            grade_diagonal(grade, masses);
            grade_neighbours(grade, masses);
            grade.number(
                {.what = "all sixteen: largest difference from J M⁻¹ Jᵀ (1/kg)", .tolerance = few_roundings},
                worst_entry(masses));
          }};
}

}  // namespace cairn::exercise04
