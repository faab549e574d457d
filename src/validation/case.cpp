// Floor 8. Orders of convergence, and Cairn as an engine.
#include <cairn/validation/case.hpp>

#include <algorithm>
#include <utility>

#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/world/world.hpp>

namespace cairn {

namespace {

class CairnEngine final : public Engine {
 public:
  CairnEngine(const Scene& scene, std::unique_ptr<Solver<double>> solver)
      : world_(scene), solver_(std::move(solver)) {}
  void step() override { world_.step(*solver_); }
  Snapshot snapshot() const override { return cairn::snapshot(world_); }

 private:
  World<double> world_;
  std::unique_ptr<Solver<double>> solver_;
};

}  // namespace

Measured measured(const std::string& what, double got, const std::string& unit) {
  return {.what = what, .unit = unit, .got = got};
}

Measured Measured::by(const std::string& its_formula, double value) const {
  Measured number = *this;
  number.formula = its_formula;
  number.expected = value;
  return number;
}

Measured Measured::within(double its_tolerance, const std::string& why) const {
  Measured number = *this;
  number.tolerance = its_tolerance;
  number.reason = why;
  return number;
}

Measured Measured::within_share(double share, const std::string& why) const {
  return within(share * std::abs(expected), why);
}

Measured Measured::zero_within(double its_tolerance, const std::string& why) const {
  return by("0", 0).within(its_tolerance, why);
}

double Convergence::order() const {
  const auto n = static_cast<double>(dt.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (int i = 0; i < dt.size(); ++i) {
    const double log_dt = std::log(dt[i]), log_error = std::log(error[i]);
    x += log_dt;
    y += log_error;
    xx += log_dt * log_dt;
    xy += log_dt * log_error;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

bool ValidationResult::passes() const {
  return std::all_of(numbers.begin(), numbers.end(), [](const Measured& m) { return m.passes(); }) &&
         (!convergence || convergence->passes());
}

EngineMaker cairn_engine() {
  return cairn_engine([](int iterations) {
    return std::make_unique<SequentialImpulse<double>>(SolverSettings{.iterations = iterations});
  });
}

EngineMaker cairn_engine(const std::function<std::unique_ptr<Solver<double>>(int iterations)>& solver) {
  return [solver](const Scene& scene, int iterations) {
    return std::make_unique<CairnEngine>(scene, solver(iterations));
  };
}

}  // namespace cairn
