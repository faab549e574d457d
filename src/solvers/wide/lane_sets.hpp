// Floor 4. The instruction sets that lanes are compiled for.
#pragma once

#include <cairn/solvers/wide/lane_contact_data.hpp>
#include <cairn/solvers/wide/lane_data.hpp>

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

/// The code of one set.
template <typename Real>
struct LaneCode {
  /// A pass over batches `first` to `last` - 1.
  void (*pass)(LaneProblem& problem, LanePass pass, int first, int last) = nullptr;
  /// Fills the rows of one batch, and the couplings between them.
  void (*fill)(const LaneFilling<Real>& from, LaneRow* rows, LaneCoupling* couplings) = nullptr;
  /// Arms, bias and softness of a batch of contacts, from what was gathered.
  void (*measure_contacts)(const LaneContactInput<Real>& from, const RowRule<Real>& rule,
                           LaneContactBatch<Real>& to) = nullptr;
  /// Leaves the springs of a batch of contacts out.
  void (*begin_second_solve)(LaneContactBatch<Real>& batch) = nullptr;
  /// The warm start of a batch of contacts: gives their impulses to their bodies, which are so fast.
  void (*push_contacts)(LaneContactBatch<Real>& batch, const LaneBatch& at, LaneBody<Real>* bodies) = nullptr;
  /// One sweep over a batch of contacts in the problem's own precision. Raises the largest step of an
  /// impulse [N s] in each lane.
  void (*sweep_contacts)(LaneContactBatch<Real>& batch, const LaneBatch& at, Real relaxation,
                         LaneBody<Real>* bodies, Real* largest) = nullptr;
  /// Fills the rows of a batch of contacts, and the couplings between them.
  void (*fill_contacts)(LaneContactBatch<Real>& batch, const LaneBatch& at, const LaneBody<Real>* bodies,
                        const LaneRoots& roots, Real relaxation, LaneRow* rows,
                        LaneCoupling* couplings) = nullptr;
  /// Takes over what sweeps have changed, and gives it to the bodies.
  void (*empty_contacts)(const LaneRow* rows, LaneContactBatch<Real>& batch, const LaneBatch& at,
                         LaneBody<Real>* bodies) = nullptr;
  /// Adds one of the two sums of R_E [J] to those of each lane.
  void (*weigh_contacts)(const LaneContactBatch<Real>& batch, const LaneBatch& at,
                         const LaneBody<Real>* bodies, LaneEnergy kind, Real* squares) = nullptr;
};

/// That of a set that has() knows.
template <typename Real>
LaneCode<Real> lane_code(LaneSet set);

/// @cond
// Each set in a file of its own, compiled for it.
template <typename Real>
LaneCode<Real> baseline_code();
template <typename Real>
LaneCode<Real> avx2_code();
template <typename Real>
LaneCode<Real> avx512_code();
/// @endcond

}  // namespace cairn
