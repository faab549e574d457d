// Floor 6. Records a solver at work, row by row and sweep by sweep.
#pragma once

#include <cairn/solvers/residual.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The state after one sweep; sweep 0 is the warm start, before any row was visited.
struct SweepRecord {
  int sweep = 0;                 // from 0
  double residual_energy = 0;    // R_E
  double residual_velocity = 0;  // r_inf [m/s]
  PerRow<double> impulse = {};   // [N s], for each row
};

/// One row update and what it led to.
struct RowRecord {
  RowUpdate<double> update = {};        // what the solver did
  PerBody<Vec3<double>> velocity = {};  // of all bodies, after the update
};

/// Keeps every sweep of a solve, and every row update too if asked. The last solve only.
template <Scalar Real = double>
class SweepRecorder final : public SolveObserver<Real> {
 public:
  /// Whether single row updates are kept beside the sweeps.
  enum class Detail { sweeps, rows };
  /// Keeps sweeps, and rows where they are asked for.
  explicit SweepRecorder(Detail detail = Detail::sweeps) : detail_(detail) {}

  bool watches_rows() const override { return detail_ == Detail::rows; }
  void before_solve(const VelocityProblem<Real>& problem) override;
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override;
  void after_sweep(int sweep, const VelocityProblem<Real>& problem) override;

  /// From sweep 0 on.
  const List<SweepRecord>& sweeps() const { return sweeps_; }
  /// In the order in which they were visited; empty unless asked for.
  const List<RowRecord>& rows() const { return rows_; }

 private:
  Detail detail_;
  Real scale_ = 0;
  List<SweepRecord> sweeps_;
  List<RowRecord> rows_;
};

}  // namespace cairn
