// Floor 5. The solves of a substep.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/world/contact_cache.hpp>
#include <cairn/world/impact_sequence.hpp>
#include <cairn/world/joint_writer.hpp>
#include <cairn/world/step_report.hpp>
#include <cairn/world/substep.hpp>

namespace cairn {

/// Solves once to go, and once to stay: positions move with velocities that take errors back, and bodies keep
/// velocities that do not have that speed. Owns scratch memory only.
template <Scalar Real>
class TwoSolves {
 public:
  /// What a substep is solved for, and what rows gave before.
  struct Parts {
    const Substep<Real>& step;     // where it begins
    JointWriter<Real>& joints;     // whose rows are written
    ContactCache<Real>& contacts;  // likewise
    StepRecord<Real>& record;      // whose problem is solved: it has the contacts
  };

  /// Writes the record's problem as it is solved first, with all rows: the velocities v_1 that bodies would
  /// have without constraints, the masses that they take part with, rows, and what these begin from.
  void write(const Parts& parts) { write(parts, ForcesOf::last_substep, true); }
  /// Writes and solves the problem, and leaves the velocities that stay. Those to go with. Contacts have no
  /// rows where the solver takes them so and nobody looks.
  const PerBody<Vec3<Real>>& solve(const Parts& parts, Solver<Real>& solver, SolveObserver<Real>* observer,
                                   StepReport& report);

 private:
  const PerBody<Vec3<Real>>& find_stiffness(const Parts& parts, ForcesOf when);
  void begin(const Parts& parts, ForcesOf when);
  int write(const Parts& parts, ForcesOf when, bool with_rows);
  int write_rows(const Parts& parts, StabilizationPass pass, bool with_rows, VelocityProblem<Real>& problem);
  void solve_again(const Parts& parts, Solver<Real>& solver, StepReport& report);
  void correct_positions(const Parts& parts, Solver<Real>& solver, StepReport& report);

  PerBody<Vec3<Real>> stiffness_;         // geometric: [N/m, N/m, N m/rad]
  ImpactSequence<Real> impacts_;          // where a scene asks for it
  RowForces<Real> forces_;                // of a joint or a contact
  List<SecondRow<Real>> second_rows_;     // of those that are written, where they are solved twice
  VelocityProblem<Real> second_problem_;  // of positions
  PerBody<Vec3<Real>> first_velocity_;    // v_1, and
  PerRow<Real> first_impulse_;            // the warm start of a solve that is done twice
  PerBody<Vec3<Real>> going_;             // the velocities to go with
};

}  // namespace cairn
