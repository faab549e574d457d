// Floor 3. What a constraint is: errors C, their Jacobians and their bounds. Nothing about dt or solvers.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "constraints/row.hpp"
#include "constraints/softness.hpp"
#include "math/list.hpp"

namespace cairn {

/// One scalar condition as a constraint states it, before anybody decided how fast errors go.
template <Scalar Real>
struct RowSpec {
  /// With a body: without one, every new row would be cleared as a whole before its members are set.
  RowSpec() {}

  BodyId a = {};                               // the first body
  BodyId b = {};                               // the second body
  Real error = 0;                              // C (3) [m or rad]; for an inequality: the room left
  Vec3<Real> jacobian_a = Vec3<Real>::Zero();  // dC/dt = j v (5)
  Vec3<Real> jacobian_b = Vec3<Real>::Zero();  // the same for b
  Bounds<Real> bounds = {};                    // a friction row names its normal row by place in this list
  std::uint64_t part = 0;                      // names the row within its constraint, from step to step
  Real speed = 0;  // [m/s or rad/s] that j v should have where C is 0: of a motor, or along an arc
  /// [N or N m]; replaces the bounds by |impulse| <= max_force dt, or by what the row that they name has left
  /// of a disc of that radius
  std::optional<Real> max_force = {};
  std::optional<Softness> softness = {};  // none: rigid
  bool keeps_slop = true;                 // an inequality: may stay violated by the slop, as contacts do
  FixedList<RowTerm<Real>, 2> extra = {};  // a third and a fourth body
  int extra_count = 0;                     // how many of `extra` there are
};

/// How far the condition is from holding [m or rad], signed: all of the error of an equality, the missing
/// room of an inequality, and nothing for a row that is meant to give way.
template <Scalar Real>
Real violation(const RowSpec<Real>& spec) {
  if (spec.softness || spec.max_force) return 0;
  return spec.bounds.is_equality() ? spec.error : std::min(spec.error, Real(0));
}

/// The rows of a constraint, or of all of them.
template <Scalar Real>
using RowSpecs = List<RowSpec<Real>>;

/// The force of one row [N or N m].
template <Scalar Real>
struct RowForce {
  std::uint64_t part = 0;  // RowSpec::part
  Real force = 0;          // the paper's lambda
};

/// What the rows of a constraint gave in the last substep.
template <Scalar Real>
struct RowForces {
  List<RowForce<Real>> rows = {};  // those that there were

  /// Of the row of this part; 0 where there was none.
  Real of(std::uint64_t part) const {
    for (const RowForce<Real>& row : rows) {
      if (row.part == part) return row.force;
    }
    return 0;
  }
};

/// A place where a joint is fastened.
struct Attachment {
  BodyId body = {};              // that it is fastened to
  Vec2<double> anchor = {0, 0};  // [m] in the frame of the body
  bool turns = true;             // with the body; false: it keeps its place beside the centre of mass
};

/// What drives the coordinate of a joint: of b, seen from a.
struct JointMotor {
  double speed = 0;      // [rad/s] of an angle, [m/s] of a slide
  double max_force = 0;  // [N m] or [N], at most
};

/// A joint: immutable, shared by all worlds of a scene. Derive from ConstraintOf<Derived>, not from this.
class Constraint {
 public:
  virtual ~Constraint() = default;

  /// What it is called, as in scene files: "rod", "rope", "spring", "revolute", "prismatic", "weld",
  /// "pulley", "gear", "differential", "drag", "friction".
  virtual std::string name() const = 0;

  /// Where it is fastened, in the order of the line that it would be drawn as.
  virtual List<Attachment> attachments() const = 0;

  /// Whether its bodies may touch each other, where the scene does not say.
  virtual bool bodies_collide() const { return false; }

  /// Its motor, if it has one.
  virtual std::optional<JointMotor> motor() const { return std::nullopt; }
  /// The same joint with another motor, or with none; null for a kind that can have no motor.
  /// @throws std::invalid_argument as the constructor.
  virtual std::shared_ptr<const Constraint> with_motor(const std::optional<JointMotor>&) const {
    return nullptr;
  }

  /// Appends the rows that hold at these poses. A degenerate one writes none.
  virtual void append_rows(const PerBody<Pose<float>>& poses, RowSpecs<float>& rows) const = 0;
  /// The same in double.
  virtual void append_rows(const PerBody<Pose<double>>& poses, RowSpecs<double>& rows) const = 0;
  /// The same in long double.
  virtual void append_rows(const PerBody<Pose<long double>>& poses, RowSpecs<long double>& rows) const = 0;

  /// The same for a constraint whose rows depend on the motion too, as friction along the way that a body
  /// goes. The velocities are those that the step would have without constraints.
  virtual void append_rows(const PerBody<Pose<float>>& poses, const PerBody<Vec3<float>>& velocities,
                           RowSpecs<float>& rows) const = 0;
  /// The same in double.
  virtual void append_rows(const PerBody<Pose<double>>& poses, const PerBody<Vec3<double>>& velocities,
                           RowSpecs<double>& rows) const = 0;
  /// The same in long double.
  virtual void append_rows(const PerBody<Pose<long double>>& poses,
                           const PerBody<Vec3<long double>>& velocities,
                           RowSpecs<long double>& rows) const = 0;

  /// Adds its geometric stiffness under these forces: how they change as its bodies move, because they keep
  /// to rods and arms that move along. It is the matrix K = -sum of lambda d^2C/dx^2. What is added is a
  /// diagonal that bounds K and -K from above, with a number for each freedom of each body [N/m, N/m,
  /// N m/rad]: the forces are mostly those of the last substep, and may have the other sign by now. A kind
  /// whose C is linear has none. Sources: M. Tournier, M. Nesme, B. Gilles, F. Faure, Stable Constrained
  /// Dynamics (2015); S. Andrews, M. Teichmann, P. Kry, Geometric Stiffness for Real-time Constrained
  /// Multibody Dynamics (2017).
  virtual void add_stiffness(const PerBody<Pose<float>>& poses, const RowForces<float>& forces,
                             PerBody<Vec3<float>>& stiffness) const = 0;
  /// The same in double.
  virtual void add_stiffness(const PerBody<Pose<double>>& poses, const RowForces<double>& forces,
                             PerBody<Vec3<double>>& stiffness) const = 0;
  /// The same in long double.
  virtual void add_stiffness(const PerBody<Pose<long double>>& poses, const RowForces<long double>& forces,
                             PerBody<Vec3<long double>>& stiffness) const = 0;
};

/// Turns one member template of Derived,
///   template <Scalar Real> void rows(const PerBody<Pose<Real>>&, RowSpecs<Real>&) const;
/// into the virtual functions; and, where Derived has it, a second one that sees the velocities:
///   template <Scalar Real>
///   void rows(const PerBody<Pose<Real>>&, const PerBody<Vec3<Real>>&, RowSpecs<Real>&) const;
/// and, where it has geometric stiffness,
///   template <Scalar Real>
///   void stiffen(const PerBody<Pose<Real>>&, const RowForces<Real>&, PerBody<Vec3<Real>>&) const;
template <typename Derived>
class ConstraintOf : public Constraint {
 public:
  /// @cond
  // Documented in Constraint.
  void append_rows(const PerBody<Pose<float>>& poses, RowSpecs<float>& rows) const override {
    derived().rows(poses, rows);
  }
  void append_rows(const PerBody<Pose<double>>& poses, RowSpecs<double>& rows) const override {
    derived().rows(poses, rows);
  }
  void append_rows(const PerBody<Pose<long double>>& poses, RowSpecs<long double>& rows) const override {
    derived().rows(poses, rows);
  }
  void append_rows(const PerBody<Pose<float>>& poses, const PerBody<Vec3<float>>& velocities,
                   RowSpecs<float>& rows) const override {
    rows_in_motion(poses, velocities, rows);
  }
  void append_rows(const PerBody<Pose<double>>& poses, const PerBody<Vec3<double>>& velocities,
                   RowSpecs<double>& rows) const override {
    rows_in_motion(poses, velocities, rows);
  }
  void append_rows(const PerBody<Pose<long double>>& poses, const PerBody<Vec3<long double>>& velocities,
                   RowSpecs<long double>& rows) const override {
    rows_in_motion(poses, velocities, rows);
  }
  void add_stiffness(const PerBody<Pose<float>>& poses, const RowForces<float>& forces,
                     PerBody<Vec3<float>>& stiffness) const override {
    stiffen_if_stiff(poses, forces, stiffness);
  }
  void add_stiffness(const PerBody<Pose<double>>& poses, const RowForces<double>& forces,
                     PerBody<Vec3<double>>& stiffness) const override {
    stiffen_if_stiff(poses, forces, stiffness);
  }
  void add_stiffness(const PerBody<Pose<long double>>& poses, const RowForces<long double>& forces,
                     PerBody<Vec3<long double>>& stiffness) const override {
    stiffen_if_stiff(poses, forces, stiffness);
  }
  /// @endcond

 private:
  template <Scalar Real>
  void rows_in_motion(const PerBody<Pose<Real>>& poses, const PerBody<Vec3<Real>>& velocities,
                      RowSpecs<Real>& rows) const {
    if constexpr (requires { derived().rows(poses, velocities, rows); }) {
      derived().rows(poses, velocities, rows);
    } else {
      derived().rows(poses, rows);
    }
  }
  template <Scalar Real>
  void stiffen_if_stiff(const PerBody<Pose<Real>>& poses, const RowForces<Real>& forces,
                        PerBody<Vec3<Real>>& stiffness) const {
    if constexpr (requires { derived().stiffen(poses, forces, stiffness); }) {
      derived().stiffen(poses, forces, stiffness);
    }
  }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace cairn
