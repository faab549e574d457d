// Exercise 05, graded: a stack of four different boxes, entry by entry and against J M^-1 J^T, and one of
// six.
#include "exercise.cpp"

namespace cairn::exercise05 {
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
  for (int i = 0; i < masses.size(); ++i) {
    for (int j = 0; j < masses.size(); ++j) {
      const double off = std::abs(entry(i, j, masses) - by_definition(i, j, masses));
      worst = std::isnan(off) ? off : std::max(worst, off);
    }
  }
  return worst;
}

void grade_diagonal(Grade& grade, const List<double>& masses) {
  const char* const ground =
      "One of the two bodies is the ground, no box of the list: its inverse mass is 0.";
  const char* const two_boxes = "Two boxes meet in this contact, and both can move.";
  const double infinity = std::numeric_limits<double>::infinity();
  grade.number({.what = "boxes of 5, 0.5, 1.25 and 2 kg: A_00 (1/kg)",
                .value = 0.2,
                .misconceptions = {{0.4, ground},
                                   {infinity, ground},
                                   {-0.2, "Entries of the diagonal are positive: (−1)² and 1² times 1/m."},
                                   {1, no_masses},
                                   {5, not_inverse}},
                .tolerance = few_roundings},
               entry(0, 0, masses));
  grade.number({.what = "the uppermost box: A_33 (1/kg)",
                .value = 1.3,
                .misconceptions = {{0.5, two_boxes},
                                   {0.8, two_boxes},
                                   {1, "Each box has its own 1/m: they differ."},
                                   {-0.3, "Contact 3 moves both its boxes: add their 1/m."},
                                   {2, no_masses},
                                   {3.25, not_inverse},
                                   {1 / 3.25, "Add the inverses, not the masses."}},
                .tolerance = few_roundings},
               entry(3, 3, masses));
}

void grade_neighbours(Grade& grade, const List<double>& masses) {
  const char* const both_touch = "Both contacts touch box 2.";
  const char* const symmetric = "A is symmetric: A_23 is A_32.";
  const double lower = entry(3, 2, masses), upper = entry(2, 3, masses);
  grade.number({.what = "the uppermost box: A_32 (1/kg)",
                .value = -0.8,
                .misconceptions = {{0.8, "The sign: contact 3 pushes box 2 down, contact 2 pushes it up."},
                                   {0, upper == 0 ? both_touch : symmetric},
                                   {-1, no_masses},
                                   {-1.25, not_inverse},
                                   {-2, "Contacts 2 and 3 share box 2, not box 1."},
                                   {-1.3, "Contacts 2 and 3 share box 2 alone: one entry of M⁻¹."},
                                   {-0.5, "Contacts 2 and 3 share box 2, not box 3."}},
                .tolerance = few_roundings},
               lower);
  grade.number({.what = "above the diagonal: A_23 (1/kg)",
                .value = -0.8,
                .misconceptions = {{0, lower == 0 ? both_touch : symmetric},
                                   {-0.5, "Contacts 2 and 3 share box 2, not box 3."}},
                .tolerance = few_roundings},
               upper);
  grade.number({.what = "two contacts further: A_31 (1/kg)",
                .value = 0,
                .misconceptions = {{-2, "Contacts 1 and 3 have no box in common."}},
                .tolerance = few_roundings},
               entry(3, 1, masses));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 5,
          .task = "The entries of A = J M⁻¹ Jᵀ for a stack of any height: equation (15).",
          .file = "lessons/05_big_matrices/exercise.cpp",
          .hints =
              {"Row i of J has −1 at the box below the contact and +1 at the box above it.",
               "A_ij is the sum over the boxes that both contacts touch of (entry of i)(entry of j) / m.",
               "A_ii = 1/m_(i−1) + 1/m_i without the ground. For neighbours A_ij = −1/m of the box between."},
          .grade = [](Grade& grade) {
            const List<double> masses = {5, 0.5, 1.25, 2};
            grade_diagonal(grade, masses);
            grade_neighbours(grade, masses);
            grade.number(
                {.what = "all sixteen: largest difference from J M⁻¹ Jᵀ (1/kg)", .tolerance = few_roundings},
                worst_entry(masses));
            grade.number({.what = "all of six other boxes: largest difference from J M⁻¹ Jᵀ (1/kg)",
                          .tolerance = few_roundings},
                         worst_entry({0.8, 3, 1.5, 0.5, 4, 2.5}));
          }};
}

}  // namespace cairn::exercise05
