// All closed forms: each of them passes, with every solver and without a crash in Box2D, and says what it is.
#include <doctest/doctest.h>

#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <cairn/validation/box2d_engine.hpp>
#include <cairn/validation/case.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn::validation_tests {

using namespace cairn::cases;

namespace {

/// A case has passed if it has measured something and all of it is within its tolerance.
void check_result(const ValidationCase& one, const ValidationResult& result) {
  CAPTURE(one.id);
  CHECK((!result.numbers.empty() || result.convergence));
  for (const Measured& number : result.numbers) {
    CAPTURE(number.what);
    CAPTURE(number.expected);
    CAPTURE(number.got);
    CAPTURE(number.tolerance);
    CHECK(number.passes());
  }
  if (result.convergence) {
    CAPTURE(result.convergence->what);
    CAPTURE(result.convergence->order());
    CHECK(result.convergence->passes());
  }
  CHECK(result.passes());
}

/// Errors c dt^power at four steps.
Convergence power_law(double power) {
  Convergence convergence;
  for (const double dt : {1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480}) {
    convergence.dt.push_back(dt);
    convergence.error.push_back(3 * std::pow(dt, power));
  }
  return convergence;
}

/// Large scenes are for the quicker ones of the other solvers, the largest for the quickest: all would take
/// minutes. That their impulses are the same after every sweep is a test of its own.
bool is_worth_its_time(const std::string& id, const std::string& solver) {
  const std::set<std::string> large = {"A1b", "B16", "B22", "B26", "B32"}, largest = {"B35", "B36", "B37"};
  if (solver == FactoredProjectedGaussSeidel<double>().name()) return true;
  if (solver == ProjectedGaussSeidel<double>().name()) return largest.count(id) == 0;
  return large.count(id) + largest.count(id) == 0;
}

const double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("every closed form holds in Cairn, and says of every number where its tolerance comes from") {
  for (const ValidationCase& one : validation_cases()) {
    const ValidationResult result = one.run(cairn_engine());
    check_result(one, result);
    for (const Measured& number : result.numbers) {
      CAPTURE(one.id);
      CHECK_FALSE(number.what.empty());
      CHECK_FALSE(number.formula.empty());
      CHECK_FALSE(number.reason.empty());
      CHECK(number.tolerance >= 0);
    }
  }
}

TEST_CASE("closed forms that see snapshots hold with every solver that has the impulses of Gauss-Seidel") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    const std::string solver = make({})->name();
    CAPTURE(solver);
    if (solver == SequentialImpulse<double>().name()) continue;  // that of the test above
    for (const ValidationCase& one : validation_cases()) {
      if (one.asks == Asks::any_engine && is_worth_its_time(one.id, solver)) {
        check_result(one, one.run(engine_of(make)));
      }
    }
  }
}

TEST_CASE("Box2D computes every closed form that sees snapshots, or says that it has no such scene") {
  if (!box2d_engine()) return;  // built without it
  int computed = 0;
  for (const ValidationCase& one : validation_cases()) {
    if (one.asks != Asks::any_engine) continue;
    CAPTURE(one.id);
    try {
      const ValidationResult result = one.run(box2d_engine());
      CHECK((!result.numbers.empty() || result.convergence));
      ++computed;
    } catch (const std::invalid_argument& error) {
      CHECK_FALSE(std::string(error.what()).empty());
    }
  }
  CHECK(computed > 0);
}

TEST_CASE("there are fifty closed forms or more, each with an id of its own, a title and a source") {
  std::set<std::string> ids;
  for (const ValidationCase& one : validation_cases()) {
    CAPTURE(one.id);
    CHECK(ids.insert(one.id).second);
    REQUIRE_FALSE(one.title.empty());
    CHECK(std::isupper(static_cast<unsigned char>(one.title.front())) != 0);
    CHECK(one.title.back() != '.');
    CHECK_FALSE(one.source.empty());
  }
  CHECK(ids.size() >= 50);
}

TEST_CASE("the order of errors that are a power of dt is that power") {
  for (const double power : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    // The logarithms, of numbers below 20, are rounded; their slope over ln 8 as well.
    CHECK(std::abs(power_law(power).order() - power) <= 64 * double_epsilon * 20);
  }
  CHECK(power_law(1).passes());
  CHECK_FALSE(power_law(0.7).passes());
  CHECK_FALSE(power_law(2).passes());
  Convergence broken = power_law(1);
  broken.error[2] = no_number;
  CHECK_FALSE(broken.passes());
}

TEST_CASE("a result passes if all numbers and the order do, and never with a number that is none") {
  const Measured good{.expected = 1, .got = 1.1, .tolerance = 0.2};
  CHECK(ValidationResult{.numbers = {good, good}}.passes());
  Measured bad = good;
  bad.tolerance = 0.05;
  CHECK_FALSE(ValidationResult{.numbers = {good, bad}}.passes());
  for (double Measured::*const part : {&Measured::expected, &Measured::got, &Measured::tolerance}) {
    Measured none = good;
    none.*part = no_number;
    CHECK_FALSE(ValidationResult{.numbers = {good, none}}.passes());
  }
  CHECK(ValidationResult{.numbers = {good}, .convergence = power_law(1)}.passes());
  CHECK_FALSE(ValidationResult{.numbers = {good}, .convergence = power_law(2)}.passes());
}

TEST_CASE("the worst of many numbers is the one whose error is the most tolerances long") {
  Worst worst = Worst("speed", "m/s").by("v").since("rounding");
  CHECK_THROWS_AS(worst.number(), std::logic_error);  // it would always pass
  worst.add(1, 1, 0);                                 // no error needs no tolerance
  CHECK(worst.number().passes());
  worst.add(1, 1.1, 1);
  worst.add(1, 1.05, 0.1);
  CHECK(worst.number().got == 1.05);
  worst.add(1, 0.9, 1);  // farther off, but nearer in tolerances
  CHECK(worst.number().got == 1.05);
  CHECK(worst.number().passes());
  CHECK(worst.number().what == "speed");
  CHECK(worst.number().unit == "m/s");
  worst.add(1, no_number, 1);
  worst.add(1, 5, 1);
  CHECK_FALSE(worst.number().passes());
  CHECK(std::isnan(worst.number().got));
}

TEST_CASE("the worst of whole measurements keeps what that one says of itself") {
  Worst worst;
  worst.add({.what = "near", .expected = 1, .got = 1.1, .tolerance = 1});
  worst.add({.what = "far", .expected = 1, .got = 1.1, .tolerance = 0.5});
  worst.add({.what = "nearest", .expected = 1, .got = 1.1, .tolerance = 2});
  CHECK(worst.number().what == "far");
  Worst exact;
  exact.add(1, 2, 0);
  CHECK_FALSE(exact.number().passes());
  CHECK(farthest(1, {1.5, 0.25, 1.6}) == 0.25);
  CHECK(std::isnan(farthest(1, {1.5, no_number, 9})));
  CHECK_THROWS_AS(farthest(1, {}), std::logic_error);
}

TEST_CASE("a bracket closes in on what begins between its ends, and tells when nothing does") {
  const auto beyond = [](double x) { return x > 0.3; };
  const Bracket up = bisected({0, 1}, 1e-6, beyond);
  CHECK(up.before <= 0.3);
  CHECK(up.after > 0.3);
  CHECK(up.after - up.before <= 1e-6);
  const Bracket down = bisected({1, 0}, 1e-6, [](double x) { return x < 0.3; });
  CHECK(down.before >= 0.3);
  CHECK(down.after < 0.3);
  CHECK(bisected({0.5, 1}, 1e-6, beyond).middle() == 0.5);  // it had begun already
  CHECK(bisected({0, 0.2}, 1e-6, beyond).middle() == 0.2);  // it never did
}

}  // namespace cairn::validation_tests
