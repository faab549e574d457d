// Sweeps in lanes that several threads share: the bits of one thread.
#include <doctest/doctest.h>

#include <concepts>
#include <stdexcept>
#include <thread>

#include "constraints/converted.hpp"
#include "solvers/wide/lane_grid.hpp"
#include "math/list.hpp"
#include "world/world.hpp"

#if defined(__SANITIZE_THREAD__)
#define CAIRN_UNDER_TSAN 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CAIRN_UNDER_TSAN 1
#endif
#endif

using namespace cairn;
using namespace cairn::testing;

namespace {

#ifdef CAIRN_UNDER_TSAN  // every access is looked at: what is shared is the same in a small problem
const bool small_problems_only = true;
const List<int> thread_counts = {3};
#else
const bool small_problems_only = false;
const List<int> thread_counts = {2, 3, 7};
#endif

/// Towers of boxes and discs side by side, in contact from the first step on.
Scene many_towers(int towers) {
  Scene scene;
  scene.add_ground({.half_width = 10000});
  for (int tower = 0; tower < towers; ++tower) {
    for (int i = 0; i < 4; ++i) {
      const Vec2<double> place(2.0 * tower, 0.5 + i);
      if (i == 3) {
        scene.add({.shapes = {circle(0.5)}, .position = place});
      } else {
        scene.add({.shapes = {box(1, 1)}, .position = place, .angle = 0.001 * (tower % 3)});
      }
    }
  }
  return scene;
}

/// The rows of its second step, which has impulses to begin with.
VelocityProblem<double> problem_of(const Scene& scene) {
  World<double> world(scene);
  WideSequentialImpulse<double> solver;
  world.step(solver);
  world.step(solver);
  return with_rows(world).problem;
}

int colours_to_share(const VelocityProblem<double>& problem) {
  LaneBatches batches;
  batches.arrange(problem);
  int count = 0;
  for (int k = 0; k + 1 < batches.colours().size(); ++k) {
    const int size = batches.colours()[k + 1] - batches.colours()[k];
    if (size >= LaneSystem<double>::fewest_to_share) ++count;
  }
  return count;
}

template <typename Real>
void check_same_bits(const VelocityProblem<Real>& start, const SolverSettings& settings, Momentum momentum) {
  VelocityProblem<Real> expected = start;
  WideSequentialImpulse<Real> alone(settings, momentum);
  const SolveReport report = alone.solve(expected);
  for (const int threads : thread_counts) {
    CAPTURE(threads);
    SolverSettings shared_settings = settings;
    shared_settings.threads = threads;
    WideSequentialImpulse<Real> shared(shared_settings, momentum);
    for (int again = 0; again < 2; ++again) {
      VelocityProblem<Real> problem = start;
      const SolveReport other = shared.solve(problem);
      CHECK(same_bits(problem, expected));
      CHECK(other.iterations == report.iterations);
      CHECK(other.largest_change == report.largest_change);
      CHECK(other.stop == report.stop);
      CHECK(shared.restarts() == alone.restarts());
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("any number of threads gives the bits of one, with momentum and without", Real, float,
                   double) {
  List<VelocityProblem<double>> starts = {lane_chains(900)};
  if (!small_problems_only) starts.push_back(problem_of(many_towers(900)));
  for (const VelocityProblem<double>& start : starts) {
    REQUIRE(colours_to_share(start) >= 3);
    for (const Momentum momentum : {Momentum::none, Momentum::nesterov}) {
      check_same_bits(converted<Real>(start), {.iterations = 20}, momentum);
      check_same_bits(converted<Real>(start), {.iterations = 40, .tolerance = 1e-3}, momentum);
    }
  }
}

TEST_CASE("an observer of rows sees with several threads what it sees with one") {
  const VelocityProblem<double> start = lane_chains(900);
  OrderWatcher<double> by_one, by_three;
  VelocityProblem<double> one = start, three = start, unwatched = start;
  WideSequentialImpulse<double>({.iterations = 3}).solve(one, &by_one);
  WideSequentialImpulse<double>({.iterations = 3, .threads = 3}).solve(three, &by_three);
  WideSequentialImpulse<double>({.iterations = 3, .threads = 3}).solve(unwatched);
  CHECK(by_one.rows == by_three.rows);
  CHECK(same_bits(one, three));
  CHECK(same_bits(one, unwatched));
}

TEST_CASE("solvers with threads can be copied, moved, and be at work several at a time") {
  const VelocityProblem<double> start = lane_chains(900);
  VelocityProblem<double> expected = start;
  WideSequentialImpulse<double>({.iterations = 20}).solve(expected);
  WideSequentialImpulse<double> first({.iterations = 20, .threads = 2});
  List<VelocityProblem<double>> answers(4, start);
  first.solve(answers[0]);
  WideSequentialImpulse<double> copy = first;
  WideSequentialImpulse<double> moved = std::move(first);
  {
    const std::jthread beside([&] { copy.solve(answers[1]); });
    moved.solve(answers[2]);
  }
  moved = copy;
  moved.solve(answers[3]);
  for (const VelocityProblem<double>& answer : answers) CHECK(same_bits(answer, expected));
}

TEST_CASE("a number of threads that cannot be is refused") {
  CHECK_THROWS_WITH_AS(WideSequentialImpulse<double>({.threads = 0}),
                       "WideSequentialImpulse: threads must be from 1 to 64, got 0", std::invalid_argument);
  CHECK_THROWS_WITH_AS(WideSequentialImpulse<double>({.threads = 65}),
                       "WideSequentialImpulse: threads must be from 1 to 64, got 65", std::invalid_argument);
}
