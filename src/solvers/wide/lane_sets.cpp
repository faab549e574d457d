// Floor 4. Which sweep this processor can do.
#include <cairn/solvers/wide/lane_sets.hpp>

namespace cairn {

bool has(LaneSet set) {
#ifdef __x86_64__
  if (set == LaneSet::avx512) return __builtin_cpu_supports("avx512f") != 0;
  if (set == LaneSet::avx2) return __builtin_cpu_supports("avx2") != 0;
#endif
  return set == LaneSet::baseline;
}

LaneSet widest_lane_set() {
  if (has(LaneSet::avx512)) return LaneSet::avx512;
  return has(LaneSet::avx2) ? LaneSet::avx2 : LaneSet::baseline;
}

template <typename Real>
LaneCode<Real> lane_code([[maybe_unused]] LaneSet set) {
#ifdef __x86_64__
  if (set == LaneSet::avx512) return avx512_code<Real>();
  if (set == LaneSet::avx2) return avx2_code<Real>();
#endif
  return baseline_code<Real>();
}

template LaneCode<float> lane_code(LaneSet);
template LaneCode<double> lane_code(LaneSet);

}  // namespace cairn
