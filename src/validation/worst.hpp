// Floor 8. Of many measurements of one thing the one that is furthest from its formula.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include <cairn/validation/case.hpp>

namespace cairn::cases {

/// Keeps of all that it is given the measurement whose error is the most tolerances long; a NaN is worse than
/// any number.
class Worst {
 public:
  /// Of measurements that say themselves what they are.
  Worst() = default;
  /// Of numbers that are all of one kind.
  explicit Worst(const std::string& what, const std::string& unit = "") { worst_ = measured(what, 0, unit); }
  /// By this formula, and where its tolerance comes from.
  Worst by(const std::string& formula) const;
  Worst since(const std::string& reason) const;

  void add(const Measured& number);
  void add(double expected, double got, double tolerance);
  /// @throws std::logic_error where nothing was added: a case that measures nothing would always pass.
  Measured number() const;

 private:
  Measured worst_ = {};
  double tolerances_ = -1;  // error over tolerance of the worst; negative before the first
};

/// The value that is farthest from the expected one; a NaN is farther than any number.
/// @throws std::logic_error where there are no values.
double farthest(double expected, const List<double>& values);

}  // namespace cairn::cases
