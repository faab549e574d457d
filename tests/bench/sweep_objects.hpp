// What a sweep of sequential impulses is made of: rows, or objects that are solved by a virtual call.
#pragma once

#include <algorithm>
#include <stdexcept>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn::bench {

using Velocities = PerBody<Vec3<double>>;
using Masses = PerBody<Vec3<double>>;  // inverse, for each body

/// What one row update reads, and the impulse that it changes.
struct SweepRow {
  ConstraintRow<double> row = {};
  double effective_mass = 0;  // [kg]
  double impulse = 0;         // [N s]
};

inline SweepRow sweep_row(const VelocityProblem<double>& problem, int i) {
  SweepRow result;
  result.row = problem.rows[i];
  const double inverse = inverse_effective_mass(problem, result.row);
  result.effective_mass = inverse > 0 ? 1 / inverse : 0;
  return result;
}

/// (22), Algorithm 1 and (21) for an interval [lower, upper] of the impulse.
inline void update(SweepRow& r, double lower, double upper, const Masses& inverse_mass,
                   Velocities& velocity) {
  const BodyId a = r.row.a;
  const BodyId b = r.row.b;
  const double jv = r.row.jacobian_a.dot(velocity[a]) + r.row.jacobian_b.dot(velocity[b]);
  const double old = r.impulse;
  const double corrective = (r.row.bias - jv - r.row.softness * old) * r.effective_mass;
  r.impulse = std::max(std::min(old + corrective, upper), lower);
  velocity[a] += inverse_mass[a].cwiseProduct(r.row.jacobian_a) * (r.impulse - old);
  velocity[b] += inverse_mass[b].cwiseProduct(r.row.jacobian_b) * (r.impulse - old);
}

/// The same where the interval is that of friction at a normal impulse.
inline void update_friction(SweepRow& r, double normal_impulse, const Masses& inverse_mass,
                            Velocities& velocity) {
  const double limit = r.row.bounds.friction * std::max(normal_impulse, 0.0);
  update(r, -limit, limit, inverse_mass, velocity);
}

/// The rows [0, count) one after the other, whatever they are; normal rows are counted from `first`.
inline void update_rows(SweepRow* rows, int count, int first, const Masses& inverse_mass,
                        Velocities& velocity) {
  for (int i = 0; i < count; ++i) {
    const Bounds<double>& bounds = rows[i].row.bounds;
    if (bounds.is_friction()) {
      update_friction(rows[i], rows[bounds.normal_row - first].impulse, inverse_mass, velocity);
    } else {
      update(rows[i], bounds.lower, bounds.upper, inverse_mass, velocity);
    }
  }
}

/// An object that is solved by a virtual call: a row, or a constraint with all its rows.
class Solvable {
 public:
  virtual ~Solvable() = default;
  virtual void solve(const Masses& inverse_mass, Velocities& velocity) = 0;
  virtual void append_impulses(PerRow<double>& impulses) const = 0;
};

/// A joint or a manifold: two classes with the same data.
class ConstraintObject : public Solvable {
 public:
  static constexpr int most_rows = 4;

  ConstraintObject(const VelocityProblem<double>& problem, const RowBlock& block)
      : first_(block.first), count_(block.count) {
    if (count_ > most_rows) throw std::out_of_range("cairn_bench: a constraint must have at most 4 rows");
    for (int i = 0; i < count_; ++i) rows_[i] = sweep_row(problem, first_ + i);
  }
  void append_impulses(PerRow<double>& impulses) const override {
    for (int i = 0; i < count_; ++i) impulses.push_back(rows_[i].impulse);
  }

 protected:
  int first_;  // row of the problem
  int count_;  // of rows
  FixedList<SweepRow, most_rows> rows_ = {};
};

class ManifoldObject final : public ConstraintObject {
 public:
  using ConstraintObject::ConstraintObject;
  void solve(const Masses& inverse_mass, Velocities& velocity) override {
    update_rows(rows_.data(), count_, first_, inverse_mass, velocity);
  }
};

/// Its rows have no bounds.
class JointObject final : public ConstraintObject {
 public:
  using ConstraintObject::ConstraintObject;
  void solve(const Masses& inverse_mass, Velocities& velocity) override {
    for (int i = 0; i < count_; ++i) {
      update(rows_[i], rows_[i].row.bounds.lower, rows_[i].row.bounds.upper, inverse_mass, velocity);
    }
  }
};

/// One row: three classes, which know their bounds.
class RowObject : public Solvable {
 public:
  explicit RowObject(const SweepRow& row) : row_(row) {}
  void append_impulses(PerRow<double>& impulses) const override { impulses.push_back(row_.impulse); }
  double impulse() const { return row_.impulse; }

 protected:
  SweepRow row_;
};

class EqualityRow final : public RowObject {
 public:
  using RowObject::RowObject;
  void solve(const Masses& inverse_mass, Velocities& velocity) override {
    update(row_, row_.row.bounds.lower, row_.row.bounds.upper, inverse_mass, velocity);
  }
};

class NormalRow final : public RowObject {
 public:
  using RowObject::RowObject;
  void solve(const Masses& inverse_mass, Velocities& velocity) override {
    update(row_, 0, row_.row.bounds.upper, inverse_mass, velocity);
  }
};

class FrictionRow final : public RowObject {
 public:
  using RowObject::RowObject;
  void set_normal(const RowObject* normal) { normal_ = normal; }
  void solve(const Masses& inverse_mass, Velocities& velocity) override {
    update_friction(row_, normal_->impulse(), inverse_mass, velocity);
  }

 private:
  const RowObject* normal_ = nullptr;
};

}  // namespace cairn::bench
