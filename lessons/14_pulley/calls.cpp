// The rope beside a tower: sweeps with a virtual call for each constraint, and with a loop for contacts.
#include "lesson.hpp"

namespace cairn::pulley {

namespace {

constexpr int tower_boxes = 20, counted_sweeps = 10;

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

VelocityProblem<double> rope_and_tower(const PulleySettings& settings) {
  Scene scene = pulley_scene(settings);
  scene.add_ground();
  for (int i = 0; i < tower_boxes; ++i)
    scene.add({.shapes = {box(1, 1)}, .position = {20, i + 0.5}, .mass = 2, .friction = 0.5});
  return World<double>(scene).velocity_problem();
}

}  // namespace

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

void print_calls(Lesson& lesson, const CountedCalls& counted) {
  lesson.print(fmt::format("The rope beside a tower of {} boxes: virtual calls in a sweep", tower_boxes));
  lesson.print(fmt::format("  one loop over all constraints {}, contacts in a loop of their own {}",
                           counted.in_one_loop, counted.in_two_loops));
  lesson.print();
}

void check_calls(Lesson& lesson, const CountedCalls& counted) {
  lesson.check_small("virtual calls, or none: change of the impulses (N s)", counted.change, 0);
  lesson.check_equal("contacts in a loop of their own: virtual calls in a sweep", counted.in_two_loops,
                     counted.constraints - tower_boxes, 0);
}

}  // namespace cairn::pulley
