// Floor 8. Of many measurements of one thing the one that is furthest from its formula.
#include <cairn/validation/worst.hpp>

#include <limits>
#include <stdexcept>

namespace cairn::cases {

Worst Worst::by(const std::string& formula) const {
  Worst worst = *this;
  worst.worst_.formula = formula;
  return worst;
}

Worst Worst::since(const std::string& reason) const {
  Worst worst = *this;
  worst.worst_.reason = reason;
  return worst;
}

void Worst::add(const Measured& number) {
  const double error = number.error();
  double tolerances = error == 0 ? 0 : error / number.tolerance;
  if (std::isnan(tolerances)) tolerances = std::numeric_limits<double>::infinity();
  if (tolerances <= tolerances_) return;
  tolerances_ = tolerances;
  worst_ = number;
}

void Worst::add(double expected, double got, double tolerance) {
  Measured number = worst_;
  number.expected = expected;
  number.got = got;
  number.tolerance = tolerance;
  add(number);
}

Measured Worst::number() const {
  if (tolerances_ < 0) throw std::logic_error("Worst: nothing was measured of " + worst_.what);
  return worst_;
}

double farthest(double expected, const List<double>& values) {
  Worst worst("values far from " + std::to_string(expected));
  for (const double value : values) worst.add(expected, value, 1);
  return worst.number().got;
}

}  // namespace cairn::cases
