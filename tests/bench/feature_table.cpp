// What a feature costs those who do not use it, and those who do.
#include <fmt/format.h>

#include <stdexcept>

#include "lean_sweeps.hpp"
#include <cairn/math/list.hpp>
#include "measure.hpp"
#include <cairn/samples/samples.hpp>
#include "scenes.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

/// Does something once, and says how long it took [s].
using TimedRun = std::function<double()>;

/// A feature: a run without it, one that has it and does not use it, and one that uses it. The last two may
/// be missing.
struct Feature {
  std::string name = {};
  TimedRun without = {};
  TimedRun unused = {};
  TimedRun used = {};
};

/// What came out: times of the run without the feature, and the other runs' over it. They are run in turns,
/// so that what disturbs the machine disturbs both, and each repetition gives a ratio.
struct FeatureCost {
  Times without = {};  // [ns]
  Times unused = {};   // ratio
  Times used = {};     // ratio
};

/// The sum of so many runs of each, in turns [s]; 0 of a run that is missing.
FixedList<double, 3> run_in_turns(const Feature& feature, std::int64_t turns) {
  FixedList<double, 3> sums = {};
  for (std::int64_t turn = 0; turn < turns; ++turn) {
    sums[0] += feature.without();
    if (feature.unused) sums[1] += feature.unused();
    if (feature.used) sums[2] += feature.used();
  }
  return sums;
}

List<FeatureCost> measure_features(const List<Feature>& features) {
  const int repetitions = 31;
  List<std::int64_t> turns;
  for (const Feature& feature : features) {
    run_in_turns(feature, 1);  // all memory is touched now
    const Stopwatch pilot;
    run_in_turns(feature, 1);
    turns.push_back(iterations_for(pilot.seconds()));
  }
  List<FixedList<List<double>, 3>> all(features.size());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (int i = 0; i < features.size(); ++i) {
      const FixedList<double, 3> sums = run_in_turns(features[i], turns[i]);
      all[i][0].push_back(sums[0] / static_cast<double>(turns[i]) * 1e9);
      for (const int k : {1, 2}) all[i][k].push_back(sums[k] / sums[0]);
    }
  }
  List<FeatureCost> costs;
  for (const auto& values : all) {
    costs.push_back({times_of(values[0]), times_of(values[1]), times_of(values[2])});
  }
  return costs;
}

/// "1.02", "-" for a run that is missing, or "noisy".
std::string cost_cell(const Times& ratio) {
  if (ratio.median == 0) return "-";
  return ratio.noise() > largest_noise ? "noisy" : three_digits(ratio.median);
}

std::string cost_noise_cell(const Times& ratio) { return ratio.median == 0 ? "-" : noise_cell(ratio); }

/// A solve of ten sweeps from a cold start, with its set-up.
TimedRun timed_solve(std::shared_ptr<Solver<double>> solver, const VelocityProblem<double>& start,
                     std::shared_ptr<SolveObserver<double>> observer = nullptr) {
  const auto problem = std::make_shared<VelocityProblem<double>>(start);
  const auto begin = std::make_shared<const VelocityProblem<double>>(start);
  return [=] { return solve_seconds(*solver, *begin, *problem, observer.get()); };
}

/// One of ten steps of a scene, which always begin where its first twenty ended.
TimedRun timed_steps(const Scene& scene, int steps = 10) {
  const auto solver = std::make_shared<SequentialImpulse<double>>();
  const auto start = std::make_shared<World<double>>(scene);
  for (int step = 0; step < 20; ++step) start->step(*solver);
  const auto world = std::make_shared<World<double>>(*start);
  return [=] {
    *world = *start;
    const Stopwatch stopwatch;
    for (int step = 0; step < steps; ++step) world->step(*solver);
    return stopwatch.seconds() / steps;
  };
}

template <unsigned without>
std::shared_ptr<Solver<double>> lean() {
  return std::make_shared<LeanSweeps<without>>(SolverSettings{.iterations = 10});
}

std::shared_ptr<Solver<double>> impulses(SolverSettings settings = {}) {
  settings.iterations = 10;
  return std::make_shared<SequentialImpulse<double>>(settings);
}

/// @throws std::logic_error unless a solver gives the impulses of SequentialImpulse, bit by bit.
void require_impulses_of_si(Solver<double>& solver, VelocityProblem<double> problem) {
  VelocityProblem<double> expected = problem;
  impulses()->solve(expected);
  solver.solve(problem);
  if (problem.impulse != expected.impulse) {
    throw std::logic_error("cairn_bench: " + solver.name() + ": impulses must be those of SequentialImpulse");
  }
}

VelocityProblem<double> soft_everywhere(VelocityProblem<double> problem) {
  for (ConstraintRow<double>& row : problem.rows) row.softness = 1e-3;
  return problem;
}

/// Every row acts on a third body.
VelocityProblem<double> third_body_everywhere(VelocityProblem<double> problem) {
  for (int i = 0; i < problem.row_count(); ++i) {
    ConstraintRow<double>& row = problem.rows[i];
    const int third = (row.b.index + 7) % problem.body_count();
    row.first_extra = i;
    row.extra_count = 1;
    problem.extra_terms.push_back({.body = {third}, .jacobian = {1e-3, 0, 0}});
  }
  return problem;
}

/// Looks at every sweep, and at rows if it is asked to.
class IdleObserver final : public SolveObserver<double> {
 public:
  explicit IdleObserver(bool rows) : rows_(rows) {}
  bool watches_rows() const override { return rows_; }

 private:
  bool rows_;
};

/// Sweeps: the twin of a feature is a copy of the code that goes without.
List<Feature> sweep_features() {
  const VelocityProblem<double> start = cold(pyramid_problem(10));
  using namespace left_out;
  for (const auto& solver : {lean<nothing>(), lean<extra_bodies>(), lean<softness>(), lean<relaxation>(),
                             lean<order>(), lean<second_normal>(), lean<everything>()}) {
    require_impulses_of_si(*solver, start);
  }
  const TimedRun copy = timed_solve(lean<nothing>(), start);
  const TimedRun library = timed_solve(impulses(), start);
  const TimedRun shuffled = timed_solve(impulses({.order = RowOrder::shuffled}), start);
  const TimedRun relaxed = timed_solve(impulses({.relaxation = 1.3}), start);
  const TimedRun patient = timed_solve(impulses({.tolerance = 1e-300, .patience = 1000}), start);
  return {
      {"(nothing: the same twice)", library, timed_solve(impulses(), start), {}},
      {"bodies beyond two in a row", timed_solve(lean<extra_bodies>(), start), copy,
       timed_solve(impulses(), third_body_everywhere(start))},
      {"softness", timed_solve(lean<softness>(), start), copy,
       timed_solve(impulses(), soft_everywhere(start))},
      {"relaxation", timed_solve(lean<relaxation>(), start), copy, relaxed},
      {"order of rows (shuffled)", timed_solve(lean<order>(), start), copy, shuffled},
      {"friction on two normal rows", timed_solve(lean<second_normal>(), start), copy, {}},
      {"observers, stopping, variants", copy, library, patient},
      {"an observer (of rows)", library,
       timed_solve(impulses(), start, std::make_shared<IdleObserver>(false)),
       timed_solve(impulses(), start, std::make_shared<IdleObserver>(true))},
      {"all of the above", timed_solve(lean<everything>(), start), library, {}},
  };
}

/// Twenty boxes `one` on each other, and beside them, touching nothing, `far`.
Scene tower_scene(const SceneSettings& settings, BodySpec one, BodySpec far) {
  Scene scene(settings);
  scene.add_ground({.material = {.friction = one.friction}});
  one.shapes = {box(1, 1)};
  one.position = {0, 0.5};
  samples::add_stack(scene, 20, one);
  far.type = BodyType::static_body;
  far.shapes = {box(2, 30)};
  if (far.position.isZero(0)) far.position = {30, 20};
  scene.add(far);
  return scene;
}

TimedRun tower(const BodySpec& one, const BodySpec& far = {}) {
  return timed_steps(tower_scene({}, one, far));
}

TimedRun tower_with(const SceneSettings& settings, const BodySpec& one = {}) {
  return timed_steps(tower_scene(settings, one, {}));
}

SceneSettings with_policy(StabilizationPolicy policy) { return {.stabilization = {.policy = policy}}; }

/// Steps: the twin of a feature is a scene that goes without.
List<Feature> step_features() {
  const TimedRun plain = tower({});
  const TimedRun no_policy = tower_with(with_policy(StabilizationPolicy::none));
  const TimedRun baumgarte = tower_with(with_policy(StabilizationPolicy::baumgarte));
  const TimedRun split = tower_with(with_policy(StabilizationPolicy::split_impulse));
  const TimedRun soft = tower_with(with_policy(StabilizationPolicy::soft));
  return {
      {"(nothing: the same twice)", plain, tower({}), {}},
      {"friction", tower({.material = {.friction = 0}}, {.material = {.friction = 0}}),
       tower({.material = {.friction = 0}}, {.material = {.friction = 0.6}}), plain},
      {"restitution", plain, tower({.material = {.restitution = 0.5}}),
       tower_with({.restitution_threshold = 0}, {.material = {.restitution = 0.5}})},
      {"gravity", tower_with({.gravity = {0, 0}}), tower({.gravity_scale = 0}), plain},
      {"damping", plain, tower({}, {.damping = {.linear = 1}}), tower({.damping = {.linear = 1e-3}})},
      {"sensors", plain, tower({}, {.sensor = true}), tower({}, {.position = {1e-9, 10}, .sensor = true})},
      {"filters", plain, tower({.filter = {.category = 2, .collides_with = 3}}), {}},
      {"warm start", tower_with({.warm_start = false}), {}, plain},
      {"policy baumgarte", no_policy, {}, baumgarte},
      {"policy relaxed", no_policy, {}, plain},
      {"policy split_impulse", no_policy, {}, split},
      {"policy soft", no_policy, {}, soft},
      {"substeps (2)", plain, {}, tower_with({.substeps = 2})},
  };
}

void print_features(const List<Feature>& features, const std::string& unit_of_work) {
  const List<FeatureCost> costs = measure_features(features);
  TextTable table({{"feature", ""},
                   {"without it", "us a " + unit_of_work},
                   {"noise", ""},
                   {"not used", "to without"},
                   {"noise", "of the ratio"},
                   {"used", "to without"},
                   {"noise", "of the ratio"}});
  for (int i = 0; i < features.size(); ++i) {
    const FeatureCost& cost = costs[i];
    table.add({features[i].name, three_digits(cost.without.median / 1000), noise_cell(cost.without),
               cost_cell(cost.unused), cost_noise_cell(cost.unused), cost_cell(cost.used),
               cost_noise_cell(cost.used)});
  }
  fmt::print("{}\n", table.text());
}

}  // namespace

void print_feature_table() {
  print_heading("6. Features: what they cost where they are not used");
  fmt::print(
      "The runs of a line are made in turns, and each of 31 repetitions gives a ratio: its median and its\n"
      "interquartile range are shown. The first line compares a thing with itself, somewhere else in "
      "memory:\n"
      "what it differs by is what a ratio can be wrong by.\n\n"
      "A solve of ten sweeps, pyramid of base 10. \"Without\" is a copy of the sweep from which this "
      "feature\n"
      "was taken out of the source, \"not used\" the copy that has it still; both give the impulses of\n"
      "SequentialImpulse to the last bit. \"Used\" is SequentialImpulse with the feature in every row. In\n"
      "the line of observers, stopping and variants \"without\" is the copy, \"not used\" the library's own\n"
      "code, and \"used\" its rules for stopping, asked for and never met; in the line after it, the\n"
      "library's own without an observer, with one that does not watch rows, and with one that does. The\n"
      "last line compares the copy that lacks everything with the library.\n\n");
  print_features(sweep_features(), "solve");
  fmt::print(
      "A step of a tower of twenty boxes. The library cannot be compiled anew while it runs: \"without\" is "
      "a\n"
      "scene that lacks the feature, and \"not used\" one that asks for it where it does nothing (mu > 0 of\n"
      "a body that rubs on nothing, e > 0 below the threshold, gravity on bodies with gravity_scale 0,\n"
      "damping, sensing or speed of a static body that nothing comes near, categories that accept each\n"
      "other). \"-\": there is no such scene: a policy or a warm start that is chosen acts, and one substep\n"
      "is the step itself. The policies are compared with the policy none.\n\n");
  print_features(step_features(), "step");
}

}  // namespace cairn::bench
