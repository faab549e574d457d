// In which order blocks and their rows take their turns, what is refused, and what is kept in memory.
#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A chain of `links` bodies: link i hangs on link i - 1 by a pin, whose block begins with a row of a limit.
/// Three rows a block: 3 i is x, 3 i + 1 the limit, 3 i + 2 is y.
VelocityProblem<double> limited_chain(int links) {
  VelocityProblem<double> problem;
  problem.velocity.assign(links + 1, {0, -0.1, 0.2});
  problem.inverse_mass.assign(links + 1, {1, 1, 3});
  problem.velocity[ground].setZero();
  problem.inverse_mass[ground].setZero();
  for (int i = 0; i < links; ++i) {
    const Vec3<double> of_a[] = {{-1, 0, 0.4}, {0, 0, -1}, {0, -1, -0.3}};
    const Vec3<double> of_b[] = {{1, 0, 0.4}, {0, 0, 1}, {0, 1, -0.3}};
    for (int k = 0; k < 3; ++k) {
      problem.rows.push_back({.a = {i}, .b = {i + 1}, .jacobian_a = of_a[k], .jacobian_b = of_b[k]});
    }
    problem.rows[3 * i + 1].bounds = Bounds<double>::unilateral();
    problem.blocks.push_back({3 * i, 3});
  }
  problem.impulse.assign(problem.rows.size(), 0);
  return problem;
}

/// The blocks of limited_chain in the order of their turns, over all sweeps.
List<int> turns_of_blocks(VelocityProblem<double> problem, const SolverSettings& settings) {
  RowWatcher<double> visits;
  BlockSequentialImpulse<double>(settings).solve(problem, &visits);
  List<int> blocks;
  for (int k = 0; k < visits.rows.size(); k += 3) {
    const int block = visits.rows[k] / 3;
    // The bounded row alone, then the equality rows together.
    CHECK(visits.rows[k] == 3 * block + 1);
    CHECK(visits.rows[k + 1] == 3 * block);
    CHECK(visits.rows[k + 2] == 3 * block + 2);
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace

TEST_CASE("blocks can be visited as written, backwards, or up and down in turn; inside, bounded rows first") {
  const VelocityProblem<double> chain = limited_chain(4);
  CHECK(turns_of_blocks(chain, {.iterations = 2}) == List<int>{0, 1, 2, 3, 0, 1, 2, 3});
  CHECK(turns_of_blocks(chain, {.iterations = 1, .order = RowOrder::reverse}) == List<int>{3, 2, 1, 0});
  CHECK(turns_of_blocks(chain, {.iterations = 2, .order = RowOrder::alternating}) ==
        List<int>{0, 1, 2, 3, 3, 2, 1, 0});
}

TEST_CASE("shuffled blocks each have one turn a sweep, and the same seed gives the same order") {
  const VelocityProblem<double> chain = limited_chain(20);
  const SolverSettings settings{.iterations = 1, .order = RowOrder::shuffled, .seed = 7};
  List<int> blocks = turns_of_blocks(chain, settings);
  CHECK(blocks == turns_of_blocks(chain, settings));
  CHECK_FALSE(std::is_sorted(blocks.begin(), blocks.end()));  // once in 20! seeds
  std::sort(blocks.begin(), blocks.end());
  for (int i = 0; i < 20; ++i) CHECK(blocks[i] == i);
}

TEST_CASE("coloured blocks take their turns colour by colour: in a chain, every second one") {
  CHECK(turns_of_blocks(limited_chain(6), {.iterations = 1, .order = RowOrder::coloured}) ==
        List<int>{0, 2, 4, 1, 3, 5});
}

TEST_CASE("blocks that leave rows out or overlap are refused") {
  VelocityProblem<double> problem = limited_chain(2);
  problem.blocks.pop_back();
  CHECK_THROWS_WITH_AS(BlockSequentialImpulse<double>().solve(problem),
                       "BlockSequentialImpulse: rows in blocks must be all of the problem's rows, got 3",
                       std::invalid_argument);
  problem.blocks.push_back({2, 4});
  CHECK_THROWS_WITH_AS(BlockSequentialImpulse<double>().solve(problem),
                       "BlockSequentialImpulse: block must be the rows after those of the block before it, "
                       "got 2",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(BlockSequentialImpulse<double>({.relaxation = 2}),
                       "BlockSequentialImpulse: relaxation must be > 0 and < 2, got 2",
                       std::invalid_argument);
}

TEST_CASE("a block without rows is passed over") {
  VelocityProblem<double> problem = limited_chain(2);
  VelocityProblem<double> expected = problem;
  problem.blocks.insert(problem.blocks.begin() + 1, {3, 0});
  BlockSequentialImpulse<double>().solve(problem);
  BlockSequentialImpulse<double>().solve(expected);
  CHECK(problem.impulse == expected.impulse);
}

TEST_CASE("memory is linear in the rows, and none before the first solve") {
  BlockSequentialImpulse<double> solver;
  CHECK(solver.memory() == 0);
  VelocityProblem<double> small = limited_chain(10);
  solver.solve(small);
  const std::size_t of_ten = solver.memory();
  CHECK(of_ten > 0);
  VelocityProblem<double> large = limited_chain(40);
  solver.solve(large);
  CHECK(solver.memory() == 4 * of_ten);
}
