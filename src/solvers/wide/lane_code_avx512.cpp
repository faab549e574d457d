// Floor 4. Lanes in registers of 64 bytes. Compiled with instructions that not every processor has.
#include <cairn/solvers/wide/lane_code.hpp>

namespace cairn {

template <typename Real>
LaneCode<Real> avx512_code() {
  return code_in_registers_of<64, Real>();
}

template LaneCode<float> avx512_code();
template LaneCode<double> avx512_code();

}  // namespace cairn
