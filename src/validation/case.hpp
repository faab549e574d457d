// Floor 8. A closed form as data: what a formula foretells beside what an engine gave.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <cairn/solvers/solver.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// One number that a formula foretells.
struct Measured {
  std::string what = {};     // "apex of the third bounce"
  std::string formula = {};  // "e^6 h"
  std::string unit = {};     // "m"; empty for a pure number
  double expected = 0;
  double got = 0;
  double tolerance = 0;     // of |got - expected|
  std::string reason = {};  // where the tolerance comes from

  /// What a formula makes of it.
  Measured by(const std::string& its_formula, double value) const;
  /// How far it may be off, and why; `share`: of what is expected.
  Measured within(double its_tolerance, const std::string& why) const;
  Measured within_share(double share, const std::string& why) const;
  /// By the formula 0.
  Measured zero_within(double its_tolerance, const std::string& why) const;
  double error() const { return std::abs(got - expected); }
  bool passes() const { return error() <= tolerance; }  // a NaN does not
};

/// "impulse under box 1 of 5", and what came out.
Measured measured(const std::string& what, double got, const std::string& unit = "");

/// Errors of one number at finer and finer steps.
struct Convergence {
  std::string what = {};
  List<double> dt = {};     // [s]
  List<double> error = {};  // of each, > 0
  double lowest = 0.8;      // orders that pass
  double highest = 1.2;
  /// The slope of log error over log dt, by least squares.
  double order() const;
  bool passes() const { return order() >= lowest && order() <= highest; }
};

struct ValidationResult {
  List<Measured> numbers = {};
  std::optional<Convergence> convergence = {};
  void add(const Measured& number) { numbers.push_back(number); }
  bool passes() const;
};

/// A scene that moves, in one engine or another.
class Engine {
 public:
  virtual ~Engine() = default;
  /// One step of the scene's dt.
  virtual void step() = 0;
  virtual Snapshot snapshot() const = 0;
};

/// Makes engines of one kind. `iterations`: sweeps a step; Box2D's velocity iterations.
/// @throws std::invalid_argument for scenes that the engine does not have.
using EngineMaker = std::function<std::unique_ptr<Engine>(const Scene& scene, int iterations)>;

/// Cairn in double, with sequential impulses.
EngineMaker cairn_engine();
/// Cairn in double, with the solver that `solver` makes for so many sweeps.
EngineMaker cairn_engine(const std::function<std::unique_ptr<Solver<double>>(int iterations)>& solver);

/// Whom a case can ask.
enum class Asks {
  cairn,       // it looks into problems and solvers
  any_engine,  // it sees snapshots only
};

struct ValidationCase {
  std::string id = {};             // of the list of cases: "B4"
  std::string title = {};          // a sentence that holds
  std::string source = "derived";  // by the comment of the case; or "M. W. Walker, 1904"
  Asks asks = Asks::cairn;
  /// `make` is cairn_engine() unless asks is any_engine.
  std::function<ValidationResult(const EngineMaker& make)> run = {};
};

/// All cases, in the order of their ids.
const List<ValidationCase>& validation_cases();

}  // namespace cairn
