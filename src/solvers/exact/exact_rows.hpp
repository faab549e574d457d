// Floor 4. A problem of rows as the exact methods see it: long double, without units, without equalities.
#pragma once

#include <cairn/constraints/row.hpp>
#include <cairn/solvers/system_matrix.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The interval of one unknown x, as a solution reads it.
struct ExactBounds {
  /// Stands for no row.
  static constexpr int none = -1;

  long double lower = 0;      // of a row without friction
  long double upper = 0;      // of the same
  bool is_friction = false;   // the limit is that below
  int normal = none;          // |x| <= mu x_normal + second_mu x_second
  int second = none;          // a second normal row, or none
  long double mu = 0;         // of the normal row
  long double second_mu = 0;  // of the second one

  /// The largest |x| that friction allows.
  long double limit(const Vector<long double>& x) const;
  /// The nearest value that is allowed beside the others.
  long double clamp(long double value, const Vector<long double>& x) const;
};

/// The rows of a problem as unknowns. They are x with w = S x + s, each inside its bounds and
///   w_i = 0 where l_i < x_i < u_i,   w_i >= 0 at l_i,   w_i <= 0 at u_i.
/// Row i of the original problem is measured in sqrt(J): impulse_i = x_i / sqrt(A_ii), w_i likewise. So
/// numbers are about 1 on the diagonal, whatever the masses.
struct ExactRows {
  Matrix<long double> S;       // A in these units, without the equalities
  Vector<long double> s;       // w where x is 0
  List<ExactBounds> bounds;    // of each x
  Matrix<long double> effect;  // on the velocities, each in sqrt(J): |effect dx| tells how far apart they are
  long double size =
      0;  // the largest |s_i| before the equalities were eliminated: what is small beside it is 0
};

/// The problem without its equalities, solved for beforehand by pivots on the diagonal, largest first; those
/// that say what others say already are left out. x_equality = T x + t for the others. Equalities that
/// contradict each other have their biases replaced by the nearest (in sqrt(J)) that do not.
/// Rows that can do nothing (A_ii = 0) are left out of everything.
struct ExactReduction {
  ExactRows rows;                         // those that are left
  List<int> kept;                         // their places in the problem
  List<int> eliminated;                   // the equalities' places
  PerRow<long double> unit;               // of the problem: impulse = unit * x; 0: does nothing
  Matrix<long double> T;                  // of x_equality
  Vector<long double> t;                  // of x_equality
  bool redundant_equalities = false;      // some say what others say already
  bool contradictory_equalities = false;  // some deny what others say
};

/// The scale of R_E (residual.hpp). Where nothing but friction asks for an impulse, that is next to nothing:
/// so it is a thousandth of the norm of all rows' speeds, in sqrt(J), at least.
template <Scalar Real>
Real exact_scale(const VelocityProblem<Real>& problem);

/// O(m^3).
/// @throws std::invalid_argument for two rows that share a disc, which is no linear complementarity problem,
/// and for friction whose normal row is not a row of impulses >= 0.
ExactReduction reduce_to_exact_rows(const VelocityProblem<long double>& problem);

/// The impulses [N s] of all rows of the problem.
PerRow<long double> impulses_of(const ExactReduction& reduction, const Vector<long double>& x);

/// x_i - clamp(x_i - w_i): R_E is the norm of this over its scale.
Vector<long double> natural_error(const ExactRows& rows, const Vector<long double>& x);

/// M z + q >= 0, z >= 0 of LemkeResult, for such rows: x - l for a row with a lower bound, and a second
/// unknown for its upper bound; for friction x = z - z', and a third unknown, the speed of sliding (D.
/// Stewart, J. Trinkle, An implicit time-stepping scheme, 1996).
struct ComplementarityProblem {
  Matrix<long double> M;      // square
  Vector<long double> q;      // as long as z
  List<int> row;              // of each unknown; -1: of a speed
  List<long double> sign;     // x_row = sum of sign * z + shift_row
  Vector<long double> shift;  // for each row of ExactRows
};
/// The problem that belongs to such rows.
ComplementarityProblem complementarity_problem(const ExactRows& rows);
/// x of ExactRows from its solution z.
Vector<long double> unknowns_of(const ComplementarityProblem& problem, const Vector<long double>& z);

}  // namespace cairn
