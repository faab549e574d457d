// What a virtual call for each constraint costs: counted beside a tower, timed on a pyramid.
#include "lesson.hpp"

#include <chrono>
#include <memory>

#include "lessons/kit/random.hpp"
#include <cairn/samples/samples.hpp>

namespace cairn::pulley {

namespace {

constexpr int counted_sweeps = 10, timed_sweeps = 200;

void update_rows(VelocityProblem<double>& problem, const RowBlock& block) {
  for (int i = block.first; i < block.first + block.count; ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    const double before = problem.impulse[i];
    const double sum = before + effective_mass(problem, row) * (row.bias - row_velocity(problem, row));
    problem.impulse[i] = row.bounds.clamp(sum, problem.impulse);
    apply_impulse(problem, row, problem.impulse[i] - before);
  }
}

/// A constraint as an object: a solver calls update(), and knows no more of it.
class Updatable {
 public:
  virtual ~Updatable() = default;
  virtual void update(VelocityProblem<double>& problem, int& calls) const = 0;
};

class UpdatableRows final : public Updatable {
 public:
  explicit UpdatableRows(const RowBlock& block) : block_(block) {}
  void update(VelocityProblem<double>& problem, int& calls) const override {
    ++calls;
    update_rows(problem, block_);
  }

 private:
  RowBlock block_;
};

struct CountedSweeps {
  PerRow<double> impulse = {};
  int calls = 0;  // virtual ones
};

/// The constraints before `first_plain` by virtual calls, the others in a plain loop.
CountedSweeps sweep_counting(VelocityProblem<double> problem, int first_plain) {
  CountedSweeps counted;
  List<std::unique_ptr<const Updatable>> objects;
  for (int i = 0; i < first_plain; ++i)
    objects.push_back(std::make_unique<const UpdatableRows>(problem.blocks[i]));
  for (int sweep = 0; sweep < counted_sweeps; ++sweep) {
    for (const auto& object : objects) object->update(problem, counted.calls);
    for (int i = first_plain; i < problem.blocks.size(); ++i) update_rows(problem, problem.blocks[i]);
  }
  counted.impulse = problem.impulse;
  return counted;
}

}  // namespace

VelocityProblem<double> rope_and_tower(const PulleySettings& settings) {
  Scene scene = pulley_scene(settings);
  scene.add_ground();
  for (int i = 0; i < tower_boxes; ++i)
    scene.add({.shapes = {box(1, 1)}, .position = {20, i + 0.5}, .mass = 2, .material = {.friction = 0.5}});
  return World<double>(scene).velocity_problem();
}

CountedCalls count_calls(const PulleySettings& settings) {
  const VelocityProblem<double> problem = rope_and_tower(settings);
  const int constraints = problem.blocks.size(), joints = 1;
  const CountedSweeps none = sweep_counting(problem, 0), split = sweep_counting(problem, joints),
                      all = sweep_counting(problem, constraints);
  CountedCalls counted{.constraints = constraints,
                       .in_one_loop = all.calls / counted_sweeps,
                       .in_two_loops = split.calls / counted_sweeps};
  for (int i = 0; i < problem.row_count(); ++i)
    counted.change = std::max(counted.change, std::abs(all.impulse[i] - none.impulse[i]));
  return counted;
}

namespace {

constexpr int pyramid_base = 30;

/// Four classes that do the same with one row, in code that differs: a processor has to guess which comes
/// next.
template <int Kind>
class RowOfKind final : public Updatable {
 public:
  explicit RowOfKind(int row) : row_(row) {}
  void update(VelocityProblem<double>& problem, int& calls) const override {
    ++calls;
    const ConstraintRow<double>& row = problem.rows[row_];
    const double before = problem.impulse[row_];
    const double sum = before + mass_ * (row.bias - row_velocity(problem, row));
    problem.impulse[row_] = clamped(row, sum, problem.impulse);
    apply_impulse(problem, row, problem.impulse[row_] - before);
  }
  void prepare(const VelocityProblem<double>& problem) {
    mass_ = effective_mass(problem, problem.rows[row_]);
  }

 private:
  static double clamped(const ConstraintRow<double>& row, double sum, const PerRow<double>& impulse) {
    if constexpr (Kind == 0) return std::max(0.0, sum);
    if constexpr (Kind == 1) return row.bounds.clamp(sum, impulse);
    if constexpr (Kind == 2) return std::min(std::max(0.0, sum), 1e300);
    return 0.5 * (sum + std::abs(sum));
  }
  int row_;
  double mass_ = 0;
};

template <int Kind>
std::unique_ptr<const Updatable> row_of_kind(const VelocityProblem<double>& problem, int row) {
  auto object = std::make_unique<RowOfKind<Kind>>(row);
  object->prepare(problem);
  return object;
}

/// The normals of a pyramid, in the order of the scene or colour by colour.
VelocityProblem<double> rows_of_pyramid(RowOrder order) {
  Scene scene({.gravity = {0, -10}, .dt = 0.02});
  scene.add_ground({.material = {.friction = 0}});
  for (int level = 0; level < pyramid_base; ++level) {
    for (int i = 0; i < pyramid_base - level; ++i)
      scene.add({.shapes = {box(1, 1)},
                 .position = {1.1 * (i + 0.5 * level), level + 0.5},
                 .mass = 1,
                 .material = {.friction = 0}});
  }
  VelocityProblem<double> problem = World<double>(scene).velocity_problem();
  PerRow<ConstraintRow<double>> normals;
  for (const ConstraintRow<double>& row : problem.rows) {
    if (row.bounds.is_unilateral()) normals.push_back(row);
  }
  problem.rows = normals;
  problem.blocks.clear();
  problem.impulse.assign(problem.row_count(), 0);
  for (int i = 0; i < problem.row_count(); ++i) problem.blocks.push_back({i, 1});
  RowSequence sequence;
  order_rows(problem, order, 1, 1, sequence);
  const PerRow<ConstraintRow<double>> rows = problem.rows;
  for (int i = 0; i < rows.size(); ++i) problem.rows[i] = rows[sequence.rows[i]];
  return problem;
}

/// [ns] a row update, the least of several sweeps; `objects` of one class, or of four in random order.
double time_of_update(VelocityProblem<double>& problem, int classes) {
  Random random(1);
  List<std::unique_ptr<const Updatable>> objects;
  for (int i = 0; i < problem.row_count(); ++i) {
    const int kind = random.below(classes);
    objects.push_back(kind == 0   ? row_of_kind<0>(problem, i)
                      : kind == 1 ? row_of_kind<1>(problem, i)
                      : kind == 2 ? row_of_kind<2>(problem, i)
                                  : row_of_kind<3>(problem, i));
  }
  double least = std::numeric_limits<double>::infinity();
  for (int sweep = 0, calls = 0; sweep < timed_sweeps; ++sweep) {
    const auto begin = std::chrono::steady_clock::now();
    for (const auto& object : objects) object->update(problem, calls);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    least = std::min(least, 1e9 * taken.count() / problem.row_count());
  }
  return least;
}

}  // namespace

void time_calls(CountedCalls& counted) {
  for (const RowOrder order : {RowOrder::as_written, RowOrder::coloured}) {
    const VelocityProblem<double> start = rows_of_pyramid(order);
    VelocityProblem<double> plain = start, four = start;
    CallTimes times{.rows = start.row_count()};
    times.one = time_of_update(plain, 1);
    times.four = time_of_update(four, 4);
    for (int i = 0; i < start.row_count(); ++i)
      counted.change = std::max(counted.change, std::abs(plain.impulse[i] - four.impulse[i]));
    counted.times.push_back(times);
  }
}

void print_calls(Lesson& lesson, const CountedCalls& counted) {
  lesson.detail(fmt::format("The rope beside a tower of {} boxes: virtual calls in a sweep", tower_boxes));
  lesson.detail(fmt::format("  one loop over all constraints {}, contacts in a loop of their own {}",
                            counted.in_one_loop, counted.in_two_loops));
  for (const CallTimes& times : counted.times)
    lesson.detail(
        fmt::format("  a pyramid of {} rows, {}: ns a row update with one class {:.1f}, four {:.1f} ({:.2f})",
                    times.rows, &times == &counted.times[0] ? "order of the scene" : "by colours", times.one,
                    times.four, times.four / times.one));
  lesson.detail({});
}

void check_calls(Lesson& lesson, const CountedCalls& counted) {
  lesson.check_small("virtual calls, or none: change of the impulses (N s)", counted.change, 0);
  lesson.check_equal("contacts in a loop of their own: virtual calls in a sweep", counted.in_two_loops,
                     counted.constraints - tower_boxes, 0);
}

}  // namespace cairn::pulley
