// A class for each kind of constraint, under SI and under PGS: what an object has to know of the others.
#include "lesson.hpp"

#include <memory>

#include <cairn/solvers/body_rows.hpp>

namespace cairn::pulley {

namespace {

constexpr int object_sweeps = 10;

/// Under SI an object needs the velocities of its own bodies.
class SiObject {
 public:
  virtual ~SiObject() = default;
  virtual void update(VelocityProblem<double>& problem) = 0;
};

/// The rope by its masses and parts alone: no row, no J.
class SiRope final : public SiObject {
 public:
  SiRope(const PulleySettings& settings, int row) : settings_(settings), row_(row) {}
  void update(VelocityProblem<double>& problem) override {
    double jv = 0, inverse = 0;
    for (int i = 0; i < 3; ++i) {
      jv += parts[i] * problem.velocity[{i + 1}].y();
      inverse += parts[i] * parts[i] / settings_.masses[i];
    }
    const double before = problem.impulse[row_];
    problem.impulse[row_] = std::max(0.0, before - jv / inverse);
    for (int i = 0; i < 3; ++i)
      problem.velocity[{i + 1}].y() += parts[i] / settings_.masses[i] * (problem.impulse[row_] - before);
  }

 private:
  PulleySettings settings_;
  int row_;
};

class SiContact final : public SiObject {
 public:
  explicit SiContact(const RowBlock& block) : block_(block) {}
  void update(VelocityProblem<double>& problem) override {
    for (int i = block_.first; i < block_.first + block_.count; ++i) {
      const ConstraintRow<double>& row = problem.rows[i];
      const double before = problem.impulse[i];
      const double sum = before + effective_mass(problem, row) * (row.bias - row_velocity(problem, row));
      problem.impulse[i] = row.bounds.clamp(sum, problem.impulse);
      apply_impulse(problem, row, problem.impulse[i] - before);
    }
  }

 private:
  RowBlock block_;
};

/// Under PGS an object needs the impulses of others: the number of every row that it meets, and their entry
/// of A.
class PgsObject {
 public:
  PgsObject(const VelocityProblem<double>& problem, const BodyRows& meetings, const RowBlock& block)
      : block_(block) {
    for (int i = block.first; i < block.first + block.count; ++i) {
      Row row{.missing = problem.rows[i].bias - row_velocity(problem, problem.rows[i])};
      meetings.append_neighbours(i, row.meets);
      for (const int other : row.meets)
        row.entries.push_back(coupling(problem, problem.rows[i], problem.rows[other], problem.inverse_mass));
      rows_.push_back(row);
    }
  }
  void update(const VelocityProblem<double>& problem, PerRow<double>& impulse) const {
    for (int k = 0; k < rows_.size(); ++k) {
      const int i = block_.first + k;
      double left = rows_[k].missing, diagonal = 0;
      for (int n = 0; n < rows_[k].meets.size(); ++n) {
        left -= rows_[k].entries[n] * impulse[rows_[k].meets[n]];
        if (rows_[k].meets[n] == i) diagonal = rows_[k].entries[n];
      }
      impulse[i] = problem.rows[i].bounds.clamp(impulse[i] + left / diagonal, impulse);
    }
  }
  /// Numbers of rows that are not its own.
  int others() const {
    int count = 0;
    for (const Row& row : rows_)
      for (const int other : row.meets) count += other < block_.first || other >= block_.first + block_.count;
    return count;
  }

 private:
  struct Row {
    double missing = 0;  // [m/s] before any impulse
    List<int> meets = {};
    List<double> entries = {};  // of A
  };
  RowBlock block_;
  List<Row> rows_;
};

double largest_difference(const PerRow<double>& first, const PerRow<double>& second) {
  double largest = 0;
  for (int i = 0; i < first.size(); ++i) largest = std::max(largest, std::abs(first[i] - second[i]));
  return largest;
}

}  // namespace

ObjectSweeps sweep_objects(const PulleySettings& settings) {
  const VelocityProblem<double> start = rope_and_tower(settings);
  VelocityProblem<double> data = start, si = start;
  SequentialImpulse<double>({.iterations = object_sweeps}).solve(data);
  List<std::unique_ptr<SiObject>> objects;
  List<PgsObject> pgs;
  BodyRows meetings;
  meetings.build(start, start.inverse_mass);
  ObjectSweeps swept;
  for (const RowBlock& block : start.blocks) {
    if (block.first == 0)
      objects.push_back(std::make_unique<SiRope>(settings, block.first));
    else
      objects.push_back(std::make_unique<SiContact>(block));
    pgs.emplace_back(start, meetings, block);
    swept.pgs_others += pgs.back().others();
  }
  PerRow<double> impulse = start.impulse;
  for (int sweep = 0; sweep < object_sweeps; ++sweep) {
    for (const auto& object : objects) object->update(si);
    for (const PgsObject& object : pgs) object.update(start, impulse);
  }
  swept.si_gap = largest_difference(si.impulse, data.impulse);
  swept.pgs_gap = largest_difference(impulse, data.impulse);
  for (const double each : data.impulse) swept.largest = std::max(swept.largest, std::abs(each));
  return swept;
}

void print_objects(Lesson& lesson, const ObjectSweeps& swept) {
  lesson.detail(fmt::format(
      "A class for each kind, beside a tower of {} boxes: numbers of others' rows that the objects keep",
      tower_boxes));
  lesson.detail(fmt::format("  under SI none, under PGS {}", swept.pgs_others));
  lesson.detail({});
}

void check_objects(Lesson& lesson, const ObjectSweeps& swept) {
  // Ten sweeps over 81 rows, each a sum of a dozen products.
  const double rounding = 16 * epsilon * object_sweeps * 4 * tower_boxes * swept.largest;
  lesson.check_small("SI by a class for each kind: the impulses of rows as data (N s)", swept.si_gap,
                     rounding);
  lesson.check_small("PGS by objects: the same impulses (N s)", swept.pgs_gap, rounding);
  // Four rows a contact; each contact but the last meets the one above, and that one meets it.
  lesson.check_equal("PGS by objects: numbers of others' rows to keep, 16 for each contact beside a contact",
                     swept.pgs_others, 16.0 * 2 * (tower_boxes - 1), 0);
}

}  // namespace cairn::pulley
