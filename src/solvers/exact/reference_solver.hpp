// Floor 4. The exact answer, where there is one, and whether there is another.
#pragma once

#include <cstddef>
#include <string>

#include <cairn/solvers/exact/exact_rows.hpp>
#include <cairn/solvers/solver.hpp>

namespace cairn {

/// How large a problem each of the methods may have, and what counts as an answer.
struct ReferenceSettings {
  int max_modes = 4096;   // with more, modes are not enumerated: six contacts with friction have 4096
  int max_rows = 400;     // with more, Lemke's method is not tried: its work grows like their number cubed
  int newton_rows = 150;  // with more, Newton's method comes before Lemke's: it takes a hundredth of the time
  int other_covers = 2;   // further covering vectors, or starts of Newton's method, to find other answers
  double tolerance = 1e-12;  // on R_E in long double: what is farther off is no answer
};

/// Which method found the answer.
enum class ReferenceMethod {
  none,         // no answer was found: what is returned is the best of Newton's method and accelerated PGS
  enumeration,  // of all modes (contact_modes.hpp)
  lemke,        // lemke.hpp
  newton,       // newton.hpp
};

/// Whether there is another answer.
enum class Uniqueness { unique, not_unique, unknown };

/// What a claim about uniqueness rests on.
enum class Evidence {
  none,         // of what is unknown
  convexity,    // no friction: the velocity is the nearest to the one before that the rows allow
  enumeration,  // all modes were tried
  two_answers,  // another covering vector, or start, led to another velocity; both have R_E up to 1e-15
  rank,         // given the velocities: of the rows that are not held at their bounds
};

/// A claim with what it rests on.
struct UniquenessClaim {
  Uniqueness verdict = Uniqueness::unknown;  // what is claimed
  Evidence evidence = Evidence::none;        // why
};

/// What is known about the answer of the last solve.
struct ReferenceReport {
  ReferenceMethod method = ReferenceMethod::none;  // by which it was found
  double residual =
      0;  // R_E in long double, before the answer is rounded to Real, with the scale of exact_rows.hpp
  UniquenessClaim velocity = {};      // whether other velocities solve the problem
  UniquenessClaim impulse = {};       // whether other impulses cause these velocities
  int solutions = 0;                  // distinct velocities that were found
  bool redundant_equalities = false;  // some equalities say what others say already
  /// Some equalities contradict each other: the answer is that for the nearest biases (exact_rows.hpp) that
  /// do not, and the residual, against those that were given, is not small.
  bool contradictory_equalities = false;
};

/// Sees the rows, and solves them to the last digits whatever the masses: a yardstick for other solvers, not
/// a solver for games. Small problems by trying all modes of the contacts, larger ones by Lemke's method, and
/// those of more than `newton_rows` rows, or with circular friction, by Newton's; then, up to `max_rows`, by
/// Lemke's, where Newton's has failed. Everything is in long double but Newton's factors. A warm start is
/// ignored: where several velocities solve the problem, it is always the same one that is answered, of modes
/// the first, with the most open contacts.
///
/// Guarantees: `converged` only if R_E of the answer, in long double, is at most the tolerance. For rows with
/// fixed bounds that do not contradict each other there is an answer, and it is found. For contacts with
/// friction, up to `max_rows` rows, it is if one exists for sure (D. Stewart, J. Trinkle, 1996); for more
/// rows nothing is guaranteed, but piles of 1600 are solved. What is claimed of uniqueness is shown: of a
/// velocity with friction by enumeration alone; that of impulses is not looked into beyond `max_rows`. In
/// `solve`'s report the iterations are those of Newton's method, else 1. Cost: by Lemke's method m^3 and
/// more, 10 s for 400 rows of contacts; by Newton's less than a second for them, some seconds for 1600, and
/// as much again for every further start. Memory of Lemke's method: (2 m)^2 numbers.
template <Scalar Real = double>
class ReferenceSolver final : public Solver<Real> {
 public:
  /// Above this many rows one solve could take many minutes.
  static constexpr int most_rows = 5000;

  /// @throws std::invalid_argument unless numbers are >= 0, and the tolerance is above 0 and finite.
  explicit ReferenceSolver(const ReferenceSettings& settings = {});

  std::string name() const override { return "reference"; }
  /// @throws std::invalid_argument for friction bound to a row whose impulses may be negative,
  /// std::length_error for more than most_rows rows: before anything is changed.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// Of the last solve.
  const ReferenceReport& report() const { return report_; }
  std::size_t memory() const override { return memory_; }

 private:
  ReferenceSettings settings_;
  ReferenceReport report_;
  std::size_t memory_ = 0;
};

}  // namespace cairn
