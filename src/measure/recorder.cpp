// Floor 6. The recorder.
#include <cairn/measure/recorder.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

template <Scalar Real>
SweepRecord record(int sweep, const VelocityProblem<Real>& problem, Real scale) {
  const Residual<Real> left = residual(problem, scale);
  return {.sweep = sweep,
          .residual_energy = static_cast<double>(left.energy),
          .residual_velocity = static_cast<double>(left.velocity),
          .impulse = PerRow<double>(problem.impulse.begin(), problem.impulse.end())};
}

}  // namespace

template <Scalar Real>
void SweepRecorder<Real>::before_solve(const VelocityProblem<Real>& problem) {
  sweeps_.clear();
  rows_.clear();
  scale_ = residual_scale(problem);
  VelocityProblem<Real> warm = problem;
  for (int i = 0; i < warm.rows.size(); ++i) {
    apply_impulse(warm, warm.rows[i], warm.impulse[i]);
  }
  sweeps_.push_back(record(0, warm, scale_));
}

template <Scalar Real>
void SweepRecorder<Real>::after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) {
  RowRecord row;
  row.update = {update.sweep,
                update.row,
                static_cast<double>(update.row_velocity),
                static_cast<double>(update.inverse_mass),
                static_cast<double>(update.corrective),
                static_cast<double>(update.impulse_before),
                static_cast<double>(update.impulse_after)};
  for (const Vec3<Real>& v : problem.velocity) row.velocity.push_back(v.template cast<double>());
  rows_.push_back(row);
}

template <Scalar Real>
void SweepRecorder<Real>::after_sweep(int sweep, const VelocityProblem<Real>& problem) {
  sweeps_.push_back(record(sweep, problem, scale_));
}

template class SweepRecorder<float>;
template class SweepRecorder<double>;

}  // namespace cairn
