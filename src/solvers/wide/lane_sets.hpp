// Floor 4. The instruction sets that lanes are compiled for.
#pragma once

#include <concepts>
#include <type_traits>

#include "solvers/wide/lane_data.hpp"

namespace cairn {

/// What a processor must have. All sets give the same bits.
enum class LaneSet {
  baseline,  // what every processor of its kind has: SSE2 on x86-64
  avx2,      // registers of 32 bytes
  avx512,    // registers of 64 bytes
};

/// Whether this program has code for a set, and the processor the instructions.
bool has(LaneSet set);
/// The widest set that there is.
LaneSet widest_lane_set();

/// What the lanes of a problem compute in.
template <typename Real>
using LaneNumber = std::conditional_t<std::same_as<Real, long double>, double, float>;

/// The code of one set.
template <typename Real>
struct LaneCode {
  /// Of the lanes.
  using Number = LaneNumber<Real>;
  /// A pass over batches `first` to `last` - 1.
  void (*pass)(LaneProblem<Number>& problem, LanePass pass, int first, int last) = nullptr;
  /// Fills the rows of one batch, and the couplings between them.
  void (*fill)(const LaneFilling<Real>& from, LaneRow<Number>* rows,
               LaneCoupling<Number>* couplings) = nullptr;
};

/// That of a set that has() knows; for long double there is the baseline only.
template <typename Real>
LaneCode<Real> lane_code(LaneSet set);

/// @cond
// Each set in a file of its own, compiled for it.
void pass_baseline(LaneProblem<float>& problem, LanePass pass, int first, int last);
void pass_baseline(LaneProblem<double>& problem, LanePass pass, int first, int last);
void pass_avx2(LaneProblem<float>& problem, LanePass pass, int first, int last);
void pass_avx512(LaneProblem<float>& problem, LanePass pass, int first, int last);
void fill_baseline(const LaneFilling<float>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings);
void fill_baseline(const LaneFilling<double>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings);
void fill_baseline(const LaneFilling<long double>& from, LaneRow<double>* rows,
                   LaneCoupling<double>* couplings);
void fill_avx2(const LaneFilling<float>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings);
void fill_avx2(const LaneFilling<double>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings);
void fill_avx512(const LaneFilling<float>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings);
void fill_avx512(const LaneFilling<double>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings);
/// @endcond

}  // namespace cairn
