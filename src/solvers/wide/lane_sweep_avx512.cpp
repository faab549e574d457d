// Floor 4. Sweeps in registers of 64 bytes. Compiled with instructions that not every processor has.
#include "solvers/wide/lane_filling.hpp"
#include "solvers/wide/lane_sets.hpp"
#include "solvers/wide/lane_sweep.hpp"

namespace cairn {

void pass_avx512(LaneProblem<float>& problem, LanePass pass, int first, int last) {
  pass_batches<64>(problem, pass, first, last);
}

void fill_avx512(const LaneFilling<float>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings) {
  fill_lanes(from, rows, couplings);
}

void fill_avx512(const LaneFilling<double>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings) {
  fill_lanes(from, rows, couplings);
}

}  // namespace cairn
