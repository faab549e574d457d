// What came out of the closed forms, in one sentence and as a page.
#pragma once

#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/validation/case.hpp>

namespace cairn::sandbox {

/// A case, what came out of it, and how long it took.
struct Outcome {
  const ValidationCase* of = nullptr;
  ValidationResult cairn = {};
  double cairn_seconds = 0;                    // [s]
  std::optional<ValidationResult> box2d = {};  // where it can run the case: the first of Cairn's numbers
  double box2d_seconds = 0;                    // [s]
  std::string box2d_refused = {};              // why there is none

  /// Box2D's number beside Cairn's `number`-th; nullptr where it has none.
  const Measured* beside(int number) const;
};

struct ValidationSummary {
  int cases = 0;
  int passed = 0;
  int numbers = 0;
  int orders = 0;  // of convergence
  int beside = 0;  // numbers that Box2D gives too. Within Cairn's tolerance are, of these:
  int both = 0;
  int cairn_alone = 0;
  int box2d_alone = 0;

  /// "80 of 80 closed forms hold, ..."
  std::string text() const;
};

ValidationSummary summary_of(const List<Outcome>& outcomes);

/// "1.1e-16"; "0".
std::string error_word(double value);
/// Six significant digits.
std::string short_number(double value);

/// The page of the documents: contents, then each case. Numbers only, so that it is the same on every
/// machine.
std::string validation_page(const List<Outcome>& outcomes);

}  // namespace cairn::sandbox
