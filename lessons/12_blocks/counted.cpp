// What a block saves in each sweep, counted: velocity updates and inverses.
#include "lesson.hpp"

#include <Eigen/LU>

#include <chrono>

namespace cairn::blocks {

namespace {

constexpr int counted_sweeps = 10;
constexpr double rounding = 2.3e-16;

struct CountedSweeps {
  PerRow<double> impulse = {};
  int updates = 0;   // of the velocities of two bodies
  int inverses = 0;  // of 3 x 3 matrices
};

CountedSweeps by_rows(VelocityProblem<double> problem) {
  CountedSweeps counted;
  for (int update = 0; update < counted_sweeps * problem.row_count(); ++update) {
    const int i = update % problem.row_count();
    const ConstraintRow<double>& row = problem.rows[i];
    const double p = effective_mass(problem, row) * (row.bias - row_velocity(problem, row));
    problem.impulse[i] += p;
    apply_impulse(problem, row, p);
    ++counted.updates;
  }
  counted.impulse = problem.impulse;
  return counted;
}

enum class Inverses { once, in_each_sweep };

/// All rows of a weld together: their impulses are summed before the two bodies are touched.
void update_block(VelocityProblem<double>& problem, const RowBlock& block, const Eigen::Matrix3d& inverse) {
  Eigen::Vector3d missing;
  for (int k = 0; k < 3; ++k) {
    const ConstraintRow<double>& row = problem.rows[block.first + k];
    missing(k) = row.bias - row_velocity(problem, row);
  }
  const Eigen::Vector3d p = inverse * missing;
  ConstraintRow<double> together = problem.rows[block.first];
  together.jacobian_a = together.jacobian_b = Vec3<double>::Zero();
  for (int k = 0; k < 3; ++k) {
    problem.impulse[block.first + k] += p(k);
    together.jacobian_a += problem.rows[block.first + k].jacobian_a * p(k);
    together.jacobian_b += problem.rows[block.first + k].jacobian_b * p(k);
  }
  apply_impulse(problem, together, 1.0);
}

CountedSweeps by_blocks(VelocityProblem<double> problem, const Matrix<double>& A, Inverses when) {
  CountedSweeps counted;
  List<Eigen::Matrix3d> inverses(problem.blocks.size());
  for (int sweep = 0; sweep < counted_sweeps; ++sweep) {
    for (int i = 0; i < problem.blocks.size(); ++i) {
      const RowBlock& block = problem.blocks[i];
      if (sweep == 0 || when == Inverses::in_each_sweep) {
        inverses[i] = Eigen::Matrix3d(A.block<3, 3>(block.first, block.first)).inverse();
        ++counted.inverses;
      }
      update_block(problem, block, inverses[i]);
      ++counted.updates;
    }
  }
  counted.impulse = problem.impulse;
  return counted;
}

double largest_gap(const PerRow<double>& a, const PerRow<double>& b) {
  double gap = 0;
  for (int i = 0; i < a.size(); ++i) gap = std::max(gap, std::abs(a[i] - b[i]));
  return gap;
}

/// [s] The least time of several solves.
double seconds_of(Solver<double>& solver, const VelocityProblem<double>& start) {
  double least = std::numeric_limits<double>::infinity();
  for (int reading = 0; reading < 9; ++reading) {
    VelocityProblem<double> problem = start;
    const auto begin = std::chrono::steady_clock::now();
    solver.solve(problem);
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return least;
}

/// Of 200 sweeps as blocks, set-up included, to 200 row by row.
double time_ratio(const VelocityProblem<double>& problem) {
  SequentialImpulse<double> rows({.iterations = 200});
  BlockSequentialImpulse<double> blocks({.iterations = 200});
  return seconds_of(blocks, problem) / seconds_of(rows, problem);
}

}  // namespace

Savings count_savings(const BlocksRuns& all) {
  const ChainRun& chain = all.chains[welded_three];
  const CountedSweeps rows = by_rows(chain.problem);
  const CountedSweeps blocks = by_blocks(chain.problem, chain.A, Inverses::once);
  const CountedSweeps again = by_blocks(chain.problem, chain.A, Inverses::in_each_sweep);
  VelocityProblem<double> library = chain.problem;
  BlockSequentialImpulse<double>({.iterations = counted_sweeps}).solve(library);
  return {.row_updates = rows.updates,
          .block_updates = blocks.updates,
          .inverses_once = blocks.inverses,
          .inverses_again = again.inverses,
          .change = largest_gap(blocks.impulse, again.impulse),
          .library_gap = largest_gap(blocks.impulse, library.impulse),
          .time_ratio = time_ratio(all.chains[welded_ten].problem),
          .shared = count_shared()};
}

void print_savings(Lesson& lesson, const BlocksRuns& all, const Savings& savings) {
  lesson.print(fmt::format("What blocks save: {} welds, {} sweeps, counted.",
                           all.chains[welded_three].problem.blocks.size(), counted_sweeps));
  lesson.print(
      fmt::format("  velocity updates: rows {}, blocks {}; 3 × 3 inverses: {} once a step, {} in each sweep",
                  savings.row_updates, savings.block_updates, savings.inverses_once, savings.inverses_again));
  print_shared(lesson, savings.shared);
  lesson.print(fmt::format(
      "  and yet a sweep over ten welds as blocks takes {:.2f} times as long as row by row, on this machine",
      savings.time_ratio));
  lesson.print();
}

void check_savings(Lesson& lesson, const BlocksRuns& all, const Savings& savings) {
  const ChainRun& chain = all.chains[welded_three];
  // Sums of a few products in another order, in each sweep; an inverse of a matrix of condition below 100.
  // The largest is the moment at the wall, of 30 N on an arm of 1.5 m.
  const double largest = 3 * gravity * 1.5 * beam_length * all.settings.dt;
  lesson.check_small("these blocks and the library's: the same impulses (N s)", savings.library_gap,
                     64 * rounding * 100 * counted_sweeps * largest);
  lesson.check_equal(
      "a weld as a block saves so many velocity updates a sweep",
      1.0 * (savings.row_updates - savings.block_updates) / (chain.problem.blocks.size() * counted_sweeps), 2,
      0);
  lesson.check_small("inverted once a step, not in each sweep: change of the impulses (N s)", savings.change,
                     0);
  check_shared(lesson, savings.shared);
}

}  // namespace cairn::blocks
