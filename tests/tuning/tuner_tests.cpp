// The tuner against runs whose outcome is a formula, and against all settings tried one by one.
#include <cairn/study/tuning/tuner.hpp>

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <thread>

#include <cairn/scenes/scene_list.hpp>

using namespace cairn;

namespace {

/// An engine by formula: overlap goes down with sweeps and with the square of steps, SI needs 3 times as many
/// sweeps as others, and Box2D never gets below 5 mm.
TrialResult formula_run(const Setting& setting, std::uint64_t = 0, double = 0) {
  TrialResult result;
  result.seconds = 2;
  result.stands_until = 2;
  const double steps = setting.substeps / (60 * setting.dt);
  const double sweeps = setting.solver == "si" ? setting.sweeps.iterations / 3.0 : setting.sweeps.iterations;
  result.worst_penetration = 0.1 / (sweeps * steps * steps);
  if (setting.solver == "box2d") result.worst_penetration += 0.005;
  result.step_seconds = 1e-6 * expected_work(setting) * (1 + 0.3 * std::sin(expected_work(setting)));
  result.row_updates = static_cast<std::int64_t>(expected_work(setting));
  return result;
}

/// The least cost of all settings that meet the wish by the formula.
double least_formula_cost(const Wish& wish, const List<std::string>& solvers) {
  double least = std::numeric_limits<double>::infinity();
  for (const Setting& setting : tuner_settings(solvers, false)) {
    const TrialResult result = formula_run(setting, 0);
    if (judge(result, wish).meets()) least = std::min(least, result.cost());
  }
  return least;
}

}  // namespace

TEST_CASE("the tuner finds what trying every setting finds") {
  const TunerOptions options = {.solvers = {"si", "block"}, .starts = 2, .runners_up = 4, .time_limit = 1e9};
  for (const double limit : {1e-2, 1e-3, 1e-4}) {
    const Wish wish = {.penetration = limit};
    const TunerAnswer answer = tune(formula_run, wish, options);
    REQUIRE(answer.best);
    CHECK(answer.complete);
    CHECK(answer.best->cost == least_formula_cost(wish, options.solvers));
    CHECK(answer.best->worst_penetration <= limit);
    CHECK(answer.best->starts == 2);
    double before = answer.best->cost;
    for (const Candidate& next : answer.runners_up) {
      CHECK(next.meets());
      CHECK(next.cost >= before);
      before = next.cost;
    }
    REQUIRE(answer.plain_si);
    REQUIRE(answer.plain_si->meets() == (0.3 / 1024 <= limit));
    if (answer.plain_si->meets()) CHECK(answer.plain_si->cost >= answer.best->cost);
    REQUIRE(answer.box2d.has_value() == has_box2d());
    if (answer.box2d) CHECK(answer.box2d->meets() == (limit > 0.005));
  }
}

TEST_CASE("the best settings are tried with manifolds that last, and in single precision") {
  const TunerOptions options = {.solvers = {"si"}, .starts = 2, .time_limit = 1e9};
  const Wish wish = {.penetration = 1e-3};
  const auto cheaper = [](ContactSearch search, Precision scalar) {
    return [search, scalar](const Setting& setting, std::uint64_t start, double) {
      TrialResult result = formula_run(setting, start);
      if (setting.contact_search == search && setting.scalar == scalar) result.step_seconds /= 8;
      return result;
    };
  };
  for (const ContactSearch search : {ContactSearch::every_substep, ContactSearch::when_moved}) {
    for (const Precision scalar : {Precision::double_precision, Precision::single_precision}) {
      const TunerAnswer answer = tune(cheaper(search, scalar), wish, options);
      REQUIRE(answer.best);
      CHECK(answer.best->setting.contact_search == search);
      CHECK(answer.best->setting.scalar == scalar);
    }
  }
}

TEST_CASE("where nothing meets a wish the tuner says so, and what came of the most work") {
  const TunerAnswer answer =
      tune(formula_run, {.penetration = 1e-12}, {.solvers = {"si"}, .starts = 1, .time_limit = 1e9});
  CHECK_FALSE(answer.best);
  CHECK(answer.runners_up.empty());
  REQUIRE(answer.plain_si);
  CHECK_FALSE(answer.plain_si->meets());
  CHECK(answer.plain_si->list_exhausted);
  CHECK(answer.plain_si->setting.sweeps.iterations == 1024);
  CHECK(answer.complete);
  CHECK(answer.tried == static_cast<int>(tuner_settings({"si"}, false).size()));
  REQUIRE(answer.nearest);
  CHECK(answer.nearest->setting.sweeps.iterations == 256);
  CHECK(answer.nearest->missed.rfind("penetration", 0) == 0);
}

TEST_CASE("a setting that meets the wish from one start only is not taken") {
  // Few sweeps are lucky from the first start.
  const TunerRun lucky = [](const Setting& setting, std::uint64_t start, double) {
    TrialResult result = formula_run(setting, start);
    result.worst_penetration = start == 0 || setting.sweeps.iterations >= 64 ? 0.0 : 1.0;
    return result;
  };
  const TunerAnswer answer =
      tune(lucky, {.penetration = 1e-3}, {.solvers = {"si"}, .starts = 16, .time_limit = 1e9});
  REQUIRE(answer.best);
  CHECK(answer.best->setting.sweeps.iterations >= 64);
  CHECK(answer.best->starts == 16);
}

TEST_CASE("the search ends when its time is over, or when it is told to") {
  const TunerOptions hasty = {.solvers = {"si"}, .starts = 1, .time_limit = 1e-9};
  const TunerAnswer late = tune(formula_run, {.penetration = 1e-12}, hasty);
  CHECK_FALSE(late.complete);
  TunerOptions stopped = {.solvers = {"si"}, .starts = 1, .time_limit = 1e9};
  stopped.progress = [](int tried, int) { return tried < 5; };
  const TunerAnswer told = tune(formula_run, {.penetration = 1e-12}, stopped);
  CHECK(told.tried == 5);
  CHECK_FALSE(told.complete);
}

TEST_CASE("progress counts up to the number of settings that were tried, and never past what it was told") {
  for (const double wish :
       {1e-2, 1e-12}) {  // the first leaves settings out that are too much work, and has variants
    CAPTURE(wish);
    TunerOptions options = {.starts = 1, .time_limit = 1e9};
    int last_tried = 0, last_total = 0;
    options.progress = [&](int tried, int total) {
      CHECK(tried >= last_tried);
      CHECK(tried <= total);
      last_tried = tried;
      last_total = total;
      return true;
    };
    const TunerAnswer answer = tune(formula_run, {.penetration = wish}, options);
    CHECK(answer.best.has_value() == (wish == 1e-2));
    CHECK(last_tried == answer.tried);
    CHECK(last_total == answer.tried);
  }
}

TEST_CASE(
    "the time holds for the search and its rivals together, and a run cut off by its end says nothing") {
  double longest = 0;
  const TunerRun endless = [&](const Setting&, std::uint64_t, double seconds_left) {
    longest = std::max(longest, seconds_left);
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds_left));
    return TrialResult();  // meets any wish
  };
  const auto begin = std::chrono::steady_clock::now();
  const TunerAnswer answer = tune(endless, {.penetration = 1}, {.solvers = {"si"}, .time_limit = 0.9});
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  CHECK(longest <= 0.6);
  CHECK(passed.count() < 1.8);  // a limit of its own for each of the three would be 2.7 s
  CHECK(answer.tried == 0);
  CHECK_FALSE(answer.complete);
  CHECK_FALSE((answer.best || answer.nearest || answer.plain_si || answer.box2d));
}

TEST_CASE("wishes that mean nothing are refused") {
  CHECK_THROWS_WITH_AS(tune(formula_run, {}), doctest::Contains("at least one"), std::invalid_argument);
  CHECK_THROWS_WITH_AS(tune(formula_run, {.drift = 0}), doctest::Contains("drift"), std::invalid_argument);
  CHECK_THROWS_AS(tune(formula_run, {.stands = std::numeric_limits<double>::infinity()}),
                  std::invalid_argument);
  CHECK_THROWS_AS(tune(formula_run, {.stands = 1}, {.starts = 0}), std::invalid_argument);
}

TEST_CASE("no setting runs twice, and once it is told to stop none runs at all") {
  std::map<std::string, int> runs;
  const TunerRun counted = [&](const Setting& setting, std::uint64_t start, double) {
    runs[setting_text(setting)] += 1;
    return formula_run(setting, start);
  };
  TunerOptions options = {.solvers = {"si"}, .starts = 1, .time_limit = 1e9};
  const TunerAnswer answer = tune(counted, {.penetration = 1e-3}, options);
  for (const auto& run : runs) CHECK_MESSAGE(run.second == 1, run.first);
  // What plain SI costs is what it cost in the search: the same setting is never dearer than itself.
  REQUIRE(answer.best);
  REQUIRE(answer.plain_si);
  if (setting_text(answer.best->setting) == setting_text(answer.plain_si->setting)) {
    CHECK(answer.best->cost == answer.plain_si->cost);
  }
  runs.clear();
  options.progress = [](int, int) { return false; };
  const TunerAnswer stopped = tune(counted, {.penetration = 1e-12}, options);
  CHECK(runs.size() == 1);
  CHECK(stopped.tried == 1);
  CHECK_FALSE(stopped.complete);
  CHECK_FALSE(stopped.plain_si);
}

TEST_CASE(
    "the tuner tries Newton's method, with a few systems, among the solvers that are not said otherwise") {
  for (const bool has_joints : {false, true}) {
    int with_newton = 0, with_baumgarte = 0, most = 0;
    for (const Setting& setting : tuner_settings(TunerOptions().solvers, has_joints)) {
      if (setting.solver != "newton") continue;
      with_newton += 1;
      with_baumgarte += setting.stabilization.policy == StabilizationPolicy::baumgarte;
      most = std::max(most, setting.sweeps.iterations);
    }
    CHECK(with_newton ==
          3 * 5 * 5 * (has_joints ? 4 : 3));  // steps a second, substeps, 1 to 16 systems, policies
    CHECK(with_baumgarte == (has_joints ? 3 * 5 * 5 : 0));
    CHECK(most == 16);
  }
}

TEST_CASE(
    "within a budget the best is the most accurate that keeps to it, and what is too slow is not taken") {
  // A step of the scene takes a millionth of a second for each unit of work.
  const TunerRun timed = [](const Setting& setting, std::uint64_t start, double) {
    TrialResult result = formula_run(setting, start);
    result.steps = static_cast<int>(std::lround(result.seconds / setting.dt));
    result.median_step = result.step_seconds / result.steps;
    return result;
  };
  const Wish wish = {.penetration = 1e-3};
  TunerOptions options = {.solvers = {"si", "block"}, .starts = 2, .time_limit = 1e9};
  for (const double budget : {2e-5, 2e-4, 2e-3}) {
    options.budget = budget;
    const TunerAnswer answer = tune(timed, wish, options);
    REQUIRE(answer.best);
    double least = std::numeric_limits<double>::infinity();
    for (const Setting& setting : tuner_settings(options.solvers, false)) {
      const TrialResult result = timed(setting, 0, 0);
      if (result.frame() <= budget) least = std::min(least, judge(result, wish).share());
    }
    CHECK(answer.best->share == least);
    CHECK(answer.best->frame <= budget);
    for (const Candidate& next : answer.runners_up) CHECK(next.share >= answer.best->share);
  }
  options.budget = 1e-12;
  const TunerAnswer none = tune(timed, wish, options);
  CHECK_FALSE(none.best);
  REQUIRE(none.nearest);
  CHECK(none.nearest->frame > 1e-12);
}

TEST_CASE("settings that come first are tried first, and the coarse ones before the rest") {
  List<Setting> order;
  const TunerRun noted = [&order](const Setting& setting, std::uint64_t start, double) {
    order.push_back(setting);
    return formula_run(setting, start);
  };
  Setting own{.solver = "si", .substeps = 3};
  own.sweeps.iterations = 20;
  (void)tune(noted, {.penetration = 1e-12},
             {.solvers = {"si"}, .first = {own}, .starts = 1, .time_limit = 1e9});
  CHECK(setting_text(order.front()) == setting_text(own));
  const List<Setting> rest = tuner_settings({"si"}, false);
  for (int i = 0; i < 15; ++i) {  // 1, 4, 16 substeps; 1, 4, 16, 64, 256 sweeps
    CHECK(rest[i].dt == 1.0 / 60);
    CHECK((rest[i].substeps == 1 || rest[i].substeps == 4 || rest[i].substeps == 16));
    CHECK((i == 0 || expected_work(rest[i]) >= expected_work(rest[i - 1])));
  }
}

TEST_CASE("where there is time for a few runs only, the answer is from those starts that there were") {
  // As long as those of a scene of some hundred bodies, whose own setting does what is wished.
  const TunerRun slow = [](const Setting& setting, std::uint64_t start, double seconds_left) {
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(0.1, seconds_left)));
    return formula_run(setting, start);
  };
  Setting own{.solver = "si", .substeps = 16};
  own.sweeps.iterations = 256;
  const TunerAnswer answer =
      tune(slow, {.penetration = 1e-5}, {.solvers = {"si"}, .first = {own}, .starts = 16, .time_limit = 1});
  REQUIRE(answer.best);
  CHECK(setting_text(answer.best->setting) == setting_text(own));
  CHECK(answer.best->starts >= 1);
  CHECK(answer.best->starts < 16);
  CHECK_FALSE(answer.complete);
}
