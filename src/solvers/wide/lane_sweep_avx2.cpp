// Floor 4. Sweeps in registers of 32 bytes. Compiled with instructions that not every processor has.
#include "solvers/wide/lane_filling.hpp"
#include "solvers/wide/lane_sets.hpp"
#include "solvers/wide/lane_sweep.hpp"

namespace cairn {

void pass_avx2(LaneProblem<float>& problem, LanePass pass, int first, int last) {
  pass_batches<32>(problem, pass, first, last);
}

void fill_avx2(const LaneFilling<float>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings) {
  fill_lanes(from, rows, couplings);
}

void fill_avx2(const LaneFilling<double>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings) {
  fill_lanes(from, rows, couplings);
}

}  // namespace cairn
