// Floor 4. Lanes in registers of 32 bytes. Compiled with instructions that not every processor has.
#include <cairn/solvers/wide/lane_code.hpp>

namespace cairn {

template <typename Real>
LaneCode<Real> avx2_code() {
  return code_in_registers_of<32, Real>();
}

template LaneCode<float> avx2_code();
template LaneCode<double> avx2_code();

}  // namespace cairn
