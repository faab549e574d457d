// Floor 4. Lemke's method for linear complementarity problems.
#pragma once

#include <cairn/solvers/system_matrix.hpp>

namespace cairn {

/// How the search ended.
enum class LemkeStatus {
  solved,   // z is a solution
  ray,      // the path leads to infinity: for many classes of M it proves that there is no solution
  gave_up,  // more pivots than roundings can explain
};

/// Where the search ended.
struct LemkeResult {
  LemkeStatus status = LemkeStatus::gave_up;  // how it ended
  Vector<long double> z;                      // the solution, where there is one
  int pivots = 0;                             // exchanges of variables
};

/// Seeks z >= 0 with w = M z + q >= 0 and z_i w_i = 0 for every i: adds an artificial variable times `cover`,
/// positive numbers, to q, large enough for z = 0 to be a solution, and follows the path of solutions from
/// there until the artificial variable is 0 (C. E. Lemke, 1965; R. W. Cottle, J.-S. Pang, R. E. Stone, The
/// Linear Complementarity Problem, 1992, algorithm 4.4.5). Ties are broken lexicographically, as if q had
/// been moved by (e, e^2, e^3 ...): no table can come twice, so that in exact numbers it always ends.
///
/// Where M is copositive and a solution is known to exist, as for contacts with friction (D. Stewart,
/// J. Trinkle, 1996), the end is a solution. Where there are several, `cover` decides which: trying other
/// covers is a search for others. Numbers in M and cover should be about 1.
///
/// Cost: n pivots or a few times as many, of n^2 multiply-adds each. Memory n^2.
/// @throws std::invalid_argument unless M is square, q and cover are of its size, and cover is positive.
LemkeResult lemke(const Matrix<long double>& M, const Vector<long double>& q,
                  const Vector<long double>& cover);
/// With a cover of ones.
LemkeResult lemke(const Matrix<long double>& M, const Vector<long double>& q);

}  // namespace cairn
