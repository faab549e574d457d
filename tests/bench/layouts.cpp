// The same sweep five times: an array of structs, and four ways to have an object for what is solved.
#include "layouts.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <tuple>

#include <cairn/solvers/row_order.hpp>
#include "sweep_objects.hpp"

namespace cairn::bench {

namespace {

/// Rows in one array, and no virtual call.
class ArrayLayout final : public Layout {
 public:
  ArrayLayout(const VelocityProblem<double>& problem, std::string name)
      : name_(std::move(name)), inverse_mass_(problem.inverse_mass) {
    for (int i = 0; i < problem.row_count(); ++i) rows_.push_back(sweep_row(problem, i));
  }
  std::string name() const override { return name_; }
  void sweep(Velocities& velocity) override {
    update_rows(rows_.data(), rows_.size(), 0, inverse_mass_, velocity);
  }
  PerRow<double> impulses() const override {
    PerRow<double> result;
    for (const SweepRow& row : rows_) result.push_back(row.impulse);
    return result;
  }

 private:
  std::string name_;
  const Masses& inverse_mass_;
  List<SweepRow> rows_;
};

/// Objects that somebody else owns, visited through pointers in the order of the problem's rows.
class ObjectLayout : public Layout {
 public:
  explicit ObjectLayout(const VelocityProblem<double>& problem) : inverse_mass_(problem.inverse_mass) {}
  void sweep(Velocities& velocity) override {
    for (Solvable* object : order_) object->solve(inverse_mass_, velocity);
  }
  PerRow<double> impulses() const override {
    PerRow<double> result;
    for (const Solvable* object : order_) object->append_impulses(result);
    return result;
  }

 protected:
  List<Solvable*> order_ = {};

 private:
  const Masses& inverse_mass_;
};

/// A friction row reads the impulse of another object.
void link_friction(const VelocityProblem<double>& problem, const List<Solvable*>& order) {
  for (int i = 0; i < order.size(); ++i) {
    const Bounds<double>& bounds = problem.rows[i].bounds;
    if (!bounds.is_friction()) continue;
    const Solvable* normal = order[bounds.normal_row];
    static_cast<FrictionRow*>(order[i])->set_normal(static_cast<const RowObject*>(normal));
  }
}

bool is_joint(const VelocityProblem<double>& problem, const RowBlock& block) {
  return problem.rows[block.first].bounds.is_equality();
}

/// Constraints in an array for each class.
class ConstraintArrays final : public ObjectLayout {
 public:
  explicit ConstraintArrays(const VelocityProblem<double>& problem) : ObjectLayout(problem) {
    joints_.reserve(problem.blocks.size());  // so that pointers stay
    manifolds_.reserve(problem.blocks.size());
    for (const RowBlock& block : problem.blocks) {
      order_.push_back(is_joint(problem, block)
                           ? static_cast<Solvable*>(&joints_.emplace_back(problem, block))
                           : &manifolds_.emplace_back(problem, block));
    }
  }
  std::string name() const override { return "virtual call a constraint, objects in arrays"; }

 private:
  List<JointObject> joints_;
  List<ManifoldObject> manifolds_;
};

/// Calls make.operator()<Row>(row) with the class of row i.
template <typename Make>
void make_row(const VelocityProblem<double>& problem, int i, const Make& make) {
  const SweepRow row = sweep_row(problem, i);
  if (row.row.bounds.is_friction()) return make.template operator()<FrictionRow>(row);
  if (row.row.bounds.is_unilateral()) return make.template operator()<NormalRow>(row);
  make.template operator()<EqualityRow>(row);
}

/// Rows in an array for each class.
class RowArrays final : public ObjectLayout {
 public:
  explicit RowArrays(const VelocityProblem<double>& problem) : ObjectLayout(problem) {
    std::apply([&](auto&... lists) { (lists.reserve(problem.rows.size()), ...); }, rows_);
    for (int i = 0; i < problem.row_count(); ++i) {
      make_row(problem, i, [&]<typename Row>(const SweepRow& row) {
        order_.push_back(&std::get<List<Row>>(rows_).emplace_back(row));
      });
    }
    link_friction(problem, order_);
  }
  std::string name() const override { return "virtual call a row, objects in arrays"; }

 private:
  std::tuple<List<EqualityRow>, List<NormalRow>, List<FrictionRow>> rows_;
};

/// 0, 1, ..., count - 1 in an order that is the same on every run.
List<int> shuffled_indices(int count) {
  List<int> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  std::shuffle(indices.begin(), indices.end(), std::mt19937(1));
  return indices;
}

/// Every constraint allocated alone, in a shuffled order: neighbours in the sweep are strangers in memory, as
/// in a program that has made and freed constraints for a while.
class ScatteredConstraints final : public ObjectLayout {
 public:
  explicit ScatteredConstraints(const VelocityProblem<double>& problem) : ObjectLayout(problem) {
    objects_.resize(problem.blocks.size());
    for (const int i : shuffled_indices(problem.blocks.size())) {
      const RowBlock& block = problem.blocks[i];
      if (is_joint(problem, block)) {
        objects_[i] = std::make_unique<JointObject>(problem, block);
      } else {
        objects_[i] = std::make_unique<ManifoldObject>(problem, block);
      }
    }
    for (const auto& object : objects_) order_.push_back(object.get());
  }
  std::string name() const override { return "virtual call a constraint, objects scattered"; }

 private:
  List<std::unique_ptr<Solvable>> objects_;
};

/// The same for rows.
class ScatteredRows final : public ObjectLayout {
 public:
  explicit ScatteredRows(const VelocityProblem<double>& problem) : ObjectLayout(problem) {
    objects_.resize(problem.rows.size());
    for (const int i : shuffled_indices(problem.rows.size())) {
      make_row(problem, i,
               [&]<typename Row>(const SweepRow& row) { objects_[i] = std::make_unique<Row>(row); });
    }
    for (const auto& object : objects_) order_.push_back(object.get());
    link_friction(problem, order_);
  }
  std::string name() const override { return "virtual call a row, objects scattered"; }

 private:
  List<std::unique_ptr<Solvable>> objects_;
};

}  // namespace

List<std::unique_ptr<Layout>> make_layouts(const VelocityProblem<double>& problem) {
  List<std::unique_ptr<Layout>> layouts;
  layouts.push_back(std::make_unique<ArrayLayout>(problem, "array of rows, no virtual call"));
  layouts.push_back(std::make_unique<ConstraintArrays>(problem));
  layouts.push_back(std::make_unique<RowArrays>(problem));
  layouts.push_back(std::make_unique<ScatteredConstraints>(problem));
  layouts.push_back(std::make_unique<ScatteredRows>(problem));
  return layouts;
}

VelocityProblem<double> in_coloured_order(const VelocityProblem<double>& problem) {
  RowSequence sequence;
  order_rows(problem, RowOrder::coloured, 1, 1, sequence);
  PerRow<int> place(problem.row_count());  // where a row goes
  for (int turn = 0; turn < place.size(); ++turn) place[sequence.rows[turn]] = turn;
  VelocityProblem<double> result = problem;
  for (int turn = 0; turn < place.size(); ++turn) {
    const int i = sequence.rows[turn];
    ConstraintRow<double>& row = result.rows[turn];
    row = problem.rows[i];
    if (row.bounds.is_friction()) row.bounds.normal_row = place[row.bounds.normal_row];
    result.impulse[turn] = problem.impulse[i];
  }
  return result;
}

std::unique_ptr<Layout> make_coloured_layout(const VelocityProblem<double>& coloured) {
  return std::make_unique<ArrayLayout>(coloured, "the first, rows stored in coloured order");
}

}  // namespace cairn::bench
