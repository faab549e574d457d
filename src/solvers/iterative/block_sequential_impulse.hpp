// Floor 4. Sequential impulses for whole blocks of rows: section 4.3 of the paper.
#pragma once

#include <cairn/solvers/iterative/block_solve.hpp>
#include <cairn/solvers/iterative/equality_pair.hpp>
#include <cairn/solvers/row_order.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Which rows of a contact manifold are solved together.
enum class ContactBlock {
  none,                 // each row alone, as in SequentialImpulse
  normal_and_friction,  // the two rows of each contact point, by Coulomb's law
  two_normals,          // the normals of both points, then each friction row alone
};

/// Algorithm 1 with blocks in the place of rows: "we can solve the whole constraint at once" (paper 4.3). It
/// visits the problem's blocks, the rows that one joint or manifold wrote, one after the other. In a block
/// - the bounded rows of a joint (limits, motors) come first, each alone, as written;
/// - then up to four equality rows together: the two of a pin, the three of a weld. A_BB = J M^-1 J^T and
///   softness is factorized once per solve, and A_BB times the correction is the velocity error;
/// - contact rows as ContactBlock says, by trying the few cases that there are (block_solve.hpp).
/// Rows that cannot be told apart (A_BB singular but for rounding, redundant rows) are visited alone, each as
/// in SequentialImpulse, and so is what has no partner: without any blocks it is SequentialImpulse, to the
/// last bit. A relaxation omega multiplies the correction of a whole block, before clamping. A block takes
/// its turn where RowOrder puts the first of its rows; inside, the order stays as above.
///
/// Guarantees: every impulse is inside its bounds after its block's update; a block is satisfied, all its
/// jointly solved rows at once, where omega is 1. With equality rows only, it is block Gauss-Seidel on
/// A lambda = b, which converges: every block takes out of the energy 1/2 lambda^T A lambda - b^T lambda all
/// that it can. It need not take fewer sweeps: rows of one block that hardly couple gain nothing. Two rows
/// of a pin on a long arm couple strongly; so do normal and friction when mu |A_nt| > A_nn, where row after
/// row turns in a circle (P. Painleve's rod, 1895).
///
/// Cost: 12 multiply-adds a row and sweep, as SI, and n^2 for the n rows of a block. Memory linear in m.
/// Observers: after_row comes once for every row of a block, when all of them have acted; the correction is
/// the row's part of the block's. Sources: E. Catto, Fast and Simple Physics using Sequential Impulses (2006)
/// and Box2D (2007), for blocks in SI; D. Stewart and J. Trinkle (1996), for the modes of friction.
template <Scalar Real = double>
class BlockSequentialImpulse final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit BlockSequentialImpulse(const SolverSettings& settings = {},
                                  ContactBlock contact = ContactBlock::normal_and_friction);

  std::string name() const override { return "block SI"; }
  /// @throws std::invalid_argument unless the problem's blocks follow each other and cover all rows.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// The parts of all blocks and their matrices; without the order of the rows, an index for each.
  std::size_t memory() const override;

 private:
  enum class Kind { row, equality_pair, equalities, contact, two_normals };
  /// Rows that are solved together: a part of a block, or all of it.
  struct Part {
    Kind kind = Kind::row;
    int count = 0;
    int matrix = 0;                            // its place in the array that goes with its kind
    FixedList<int, max_block_rows> rows = {};  // a normal row before its friction row
  };
  /// Parts from first to last - 1.
  struct Turn {
    int first = 0;
    int last = 0;
  };

  bool is_prepared(const VelocityProblem<Real>& problem) const;
  void prepare(const VelocityProblem<Real>& problem);
  void find_partners(const VelocityProblem<Real>& problem, const RowBlock& block);
  void add_parts(const VelocityProblem<Real>& problem, const RowBlock& block);
  void add_row(const VelocityProblem<Real>& problem, int row);
  bool add_pair(const VelocityProblem<Real>& problem, Kind kind, int first, int second);
  bool add_equalities(const VelocityProblem<Real>& problem, const List<int>& rows);
  Real update(int number, const Part& part, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);
  void correct(const Part& part, const VelocityProblem<Real>& problem, BlockVector<Real>& error) const;

  SolverSettings settings_;
  ContactBlock contact_;
  List<Part> parts_;              // in the order of their turns
  List<Turn> turns_;              // for each row: the parts of the block that begins with it
  PerRow<Real> effective_mass_;   // [kg] of rows that are alone
  List<PairMatrix<Real>> pairs_;  // of contacts
  List<EqualityPair<Real>> equality_pairs_;
  List<BlockFactor<Real>> factors_;  // of other equality rows
  std::uint64_t prepared_ = 0;       // the number of the problem that they are of
  PerRow<Real> softness_;            // [1/kg] that the matrices hold
  PerRow<int> partner_;              // scratch, for each row: whom it is solved with, or -1
  List<int> equalities_;             // scratch: equality rows of one block
  RowSequence sequence_;
  Stopping<Real> stopping_;
};

}  // namespace cairn
