// Floor 4. Where lanes were before a sweep, for momentum.
#pragma once

#include <algorithm>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>
#include <cairn/solvers/wide/lane_data.hpp>

namespace cairn {

/// Where impulses and velocities were when momentum was gathered last, and how much is.
template <Scalar Real>
struct LaneMomentum {
  Real momentum = 0;                // how many times the way that impulses went they go on
  List<LaneImpulse> rows;           // in lanes
  List<Real> singles;               // [N s] of the rows that go one by one
  PerBody<LaneBody<float>> bodies;  // velocities

  /// Here impulses are now; rows `single_rows` of the problem go one by one.
  void remember(const List<LaneRow>& lanes, Span<const int> single_rows, const PerRow<Real>& impulse) {
    rows.assign(lanes.size(), LaneImpulse{});
    for (int i = 0; i < lanes.size(); ++i) std::copy_n(lanes[i].impulse, lane_count, rows[i].impulse);
    singles.clear();
    for (const int row : single_rows) singles.push_back(impulse[row]);
  }
  /// Changes in lanes begin at 0 from where they are now.
  void take_off(const List<LaneRow>& lanes) {
    for (int i = 0; i < rows.size(); ++i) {
      for (int lane = 0; lane < lane_count; ++lane) rows[i].impulse[lane] -= lanes[i].impulse[lane];
    }
  }
  /// Puts impulses back.
  void give_back(List<LaneRow>& lanes, Span<const int> single_rows, PerRow<Real>& impulse) const {
    for (int i = 0; i < lanes.size(); ++i) std::copy_n(rows[i].impulse, lane_count, lanes[i].impulse);
    for (int k = 0; k < singles.size(); ++k) impulse[single_rows[k]] = singles[k];
  }
  /// What it takes up [bytes].
  std::size_t bytes() const { return rows.bytes() + singles.bytes() + bodies.bytes(); }
};

}  // namespace cairn
