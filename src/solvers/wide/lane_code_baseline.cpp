// Floor 4. Lanes in registers of 16 bytes, with instructions that every processor of its kind has.
#include <cairn/solvers/wide/lane_code.hpp>

namespace cairn {

template <typename Real>
LaneCode<Real> baseline_code() {
  return code_in_registers_of<16, Real>();
}

template LaneCode<float> baseline_code();
template LaneCode<double> baseline_code();

}  // namespace cairn
