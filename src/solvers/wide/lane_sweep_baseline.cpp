// Floor 4. Sweeps in registers of 16 bytes, with instructions that every processor of its kind has.
#include "solvers/wide/lane_filling.hpp"
#include "solvers/wide/lane_sets.hpp"
#include "solvers/wide/lane_sweep.hpp"

namespace cairn {

void pass_baseline(LaneProblem<float>& problem, LanePass pass, int first, int last) {
  pass_batches<16>(problem, pass, first, last);
}

void pass_baseline(LaneProblem<double>& problem, LanePass pass, int first, int last) {
  pass_batches<16>(problem, pass, first, last);
}

void fill_baseline(const LaneFilling<float>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings) {
  fill_lanes(from, rows, couplings);
}

void fill_baseline(const LaneFilling<double>& from, LaneRow<float>* rows, LaneCoupling<float>* couplings) {
  fill_lanes(from, rows, couplings);
}

void fill_baseline(const LaneFilling<long double>& from, LaneRow<double>* rows,
                   LaneCoupling<double>* couplings) {
  fill_lanes(from, rows, couplings);
}

}  // namespace cairn
