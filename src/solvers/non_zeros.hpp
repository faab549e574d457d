// Floor 4. How many entries of A are not zero: eq. (30) as printed, and as it should be.
#pragma once

#include <cstddef>

#include <cairn/constraints/row.hpp>

namespace cairn {

/// Eq. (30) as printed: pairs (i, j) of rows with J_i . J_j != 0. That is not the pattern of A, as M^-1 is
/// missing: rows that share only the ground are counted, and the terms of the product cancel for other pairs
/// than those of A do. The count even depends on where the ground has its origin.
template <Scalar Real>
std::ptrdiff_t non_zeros_as_printed(const VelocityProblem<Real>& problem);

/// Pairs (i, j) of rows with J_i M^-1 J_j^T != 0: the entries of A (15) that are not zero.
template <Scalar Real>
std::ptrdiff_t non_zeros(const VelocityProblem<Real>& problem);

/// Pairs (i, j) of rows that act on the same body of non-zero inverse mass: those that can be non-zero, and
/// that a sparse A has to store, as nobody knows beforehand where terms cancel.
template <Scalar Real>
std::ptrdiff_t coupled_pairs(const VelocityProblem<Real>& problem);

}  // namespace cairn
