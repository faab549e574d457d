// Floor 7. Jacobi's method on a device: a graphics card, or the processor itself, through OpenCL.
#pragma once

#include <memory>

#include <cairn/solvers/iterative/jacobi.hpp>

namespace cairn {

/// Jacobi with split masses (Jacobi, Splitting::mass), every sweep in two steps on a device: all rows at once
/// compute their impulses, then all bodies at once gather what acts on them, in the order of the rows. Two
/// rows never wait for each other, which is the paper's reason to think of Jacobi on parallel hardware (4.4,
/// last paragraph). Rows go to the device once a solve; without tolerance, patience, time budget and observer
/// all sweeps run there with nothing read back in between. With one of them impulses and velocities are read
/// after every sweep.
///
/// Guarantees: the same bits as Jacobi where impulses are finite and the device rounds as IEEE 754 asks for.
/// double always does. float may flush numbers below 1.2e-38 to 0, and where it does not round roots
/// correctly a disc of friction (Bounds::rest_of_disc) may differ in its last bit. Bodies that nothing can
/// move are left as they are.
///
/// Cost: 12 multiply-adds a row and sweep, and two starts of a kernel a sweep, which take as long as some
/// thousand rows. The first solver of a process also compiles its kernels.
template <Scalar Real = double>
class OpenClJacobi final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range, std::runtime_error where there is no device, or
  /// none that knows double; it names what is missing.
  explicit OpenClJacobi(const SolverSettings& settings = {});
  ~OpenClJacobi() override;

  std::string name() const override { return "mass-splitting Jacobi, OpenCL"; }
  /// An observer that watches rows is shown those of Jacobi.
  /// @throws std::runtime_error when the device fails, with what it said.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// On this side and on the device.
  std::size_t memory() const override;
  /// Its name, as the driver gives it.
  std::string device() const;

 private:
  struct Device;
  std::unique_ptr<Device> device_;
  SolverSettings settings_;
  Jacobi<Real> host_;  // for observers of rows
  PerBody<int> rows_on_body_;
  PerRow<Real> step_;  // omega / D_ii [kg] for each row
  Stopping<Real> stopping_;
};

/// Whether a solver of this precision would find a device.
template <Scalar Real>
bool has_opencl_device();

}  // namespace cairn
