// Floor 3. What a constraint is: errors C, their Jacobians and their bounds. Nothing about dt or solvers.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include <cairn/constraints/joint_traits.hpp>
#include <cairn/constraints/row_writer.hpp>
#include <cairn/dynamics/placements.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The force of one row [N or N m].
template <Scalar Real>
struct RowForce {
  std::uint64_t part = 0;  // RigidRow::part
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

/// A joint: immutable, shared by all worlds of a scene. Derive from ConstraintOf<Derived>, not from this.
class Constraint {
 public:
  virtual ~Constraint() = default;

  /// What it is called, as in scene files: "revolute".
  virtual std::string name() const = 0;

  /// That of its kind.
  virtual JointTraits traits() const { return {}; }

  /// Where it is fastened, in the order of the line that it would be drawn as.
  virtual List<Attachment> attachments() const = 0;

  /// The ends of the line that it slides along, for pictures; empty: none.
  virtual List<Attachment> groove() const { return {}; }

  /// Whether its bodies may touch each other, where the scene does not say.
  virtual bool bodies_collide() const { return false; }

  /// Its motor, if it has one.
  virtual std::optional<JointMotor> motor() const { return std::nullopt; }
  /// The same joint with another motor, or with none; null for a kind that can have no motor.
  /// @throws std::invalid_argument as the constructor.
  virtual std::shared_ptr<const Constraint> with_motor(const std::optional<JointMotor>&) const {
    return nullptr;
  }

  /// Writes the rows that hold where bodies are. A degenerate one writes none.
  virtual void write_rows(const Placements<float>& at, RowWriter<float>& rows) const = 0;
  /// The same in double.
  virtual void write_rows(const Placements<double>& at, RowWriter<double>& rows) const = 0;
  /// Appends them as they are stated, of bodies at rest.
  template <Scalar Real>
  void append_rows(const std::type_identity_t<Placements<Real>>& at, RowSpecs<Real>& rows) const {
    StatedRows<Real> stated(rows);
    write_rows(at, stated);
  }

  /// Adds its geometric stiffness under these forces: how they change as its bodies move, because they keep
  /// to rods and arms that move along. It is the matrix K = -sum of lambda d^2C/dx^2. What is added is a
  /// diagonal that bounds K and -K from above, with a number for each freedom of each body [N/m, N/m,
  /// N m/rad]: the forces are mostly those of the last substep, and may have the other sign by now. A kind
  /// whose C is linear has none. Sources: M. Tournier, M. Nesme, B. Gilles, F. Faure, Stable Constrained
  /// Dynamics (2015); S. Andrews, M. Teichmann, P. Kry, Geometric Stiffness for Real-time Constrained
  /// Multibody Dynamics (2017).
  virtual void add_stiffness(const Placements<float>& at, const RowForces<float>& forces,
                             PerBody<Vec3<float>>& stiffness) const = 0;
  /// The same in double.
  virtual void add_stiffness(const Placements<double>& at, const RowForces<double>& forces,
                             PerBody<Vec3<double>>& stiffness) const = 0;
};

/// Turns one member template of Derived,
///   template <Scalar Real> void rows(const Placements<Real>&, RowWriter<Real>&) const;
/// into the virtual functions; and, where it has geometric stiffness,
///   template <Scalar Real>
///   void stiffen(const Placements<Real>&, const RowForces<Real>&, PerBody<Vec3<Real>>&) const;
template <typename Derived>
class ConstraintOf : public Constraint {
 public:
  /// @cond
  // Documented in Constraint.
  void write_rows(const Placements<float>& at, RowWriter<float>& rows) const override {
    derived().rows(at, rows);
  }
  void write_rows(const Placements<double>& at, RowWriter<double>& rows) const override {
    derived().rows(at, rows);
  }
  void add_stiffness(const Placements<float>& at, const RowForces<float>& forces,
                     PerBody<Vec3<float>>& stiffness) const override {
    stiffen_if_stiff(at, forces, stiffness);
  }
  void add_stiffness(const Placements<double>& at, const RowForces<double>& forces,
                     PerBody<Vec3<double>>& stiffness) const override {
    stiffen_if_stiff(at, forces, stiffness);
  }
  /// @endcond

 private:
  template <Scalar Real>
  void stiffen_if_stiff(const Placements<Real>& at, const RowForces<Real>& forces,
                        PerBody<Vec3<Real>>& stiffness) const {
    if constexpr (requires { derived().stiffen(at, forces, stiffness); }) {
      derived().stiffen(at, forces, stiffness);
    }
  }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace cairn
