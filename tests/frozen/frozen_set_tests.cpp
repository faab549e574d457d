// The frozen set: what its files hold is what its scenes give.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <cairn/study/frozen/frozen_set.hpp>
#include <cairn/math/list.hpp>
#include "scratch_folder.hpp"
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/solvers/residual.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

const std::filesystem::path frozen_folder = std::filesystem::path(CAIRN_SOURCE_DIR) / "tests/frozen/problems";

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("every problem of the frozen set can be read, and there are eleven") {
  // Renewed by CAIRN_RENEW_FROZEN=1, when scenes or the step have changed on purpose.
  if (std::getenv("CAIRN_RENEW_FROZEN") != nullptr) write_frozen_set(frozen_folder);
  const List<FrozenProblem> all = read_frozen_set(frozen_folder);
  REQUIRE(all.size() >= 11);
  for (int i = 0; i < all.size(); ++i) {
    CHECK(all[i].name == frozen_names()[i]);
    CHECK(std::filesystem::file_size(frozen_folder / (all[i].name + ".json")) < 300000);
    CHECK(all[i].tags.size() == 3);
    CHECK(residual_scale(all[i].problem) > 0);  // there is something to solve
  }
}

TEST_CASE("made anew, every problem of the frozen set has the bits of its file") {
  const ScratchFolder folder;
  write_frozen_set(folder / "set");  // a folder that is not there
  for (const std::string& name : frozen_names()) {
    CAPTURE(name);
    CHECK((folder.text("set/" + name + ".json") == text_of_file(frozen_folder / (name + ".json"))));
  }
  CHECK_THROWS_AS(make_frozen("stack11"), std::invalid_argument);
}

TEST_CASE("the problems have four rows for each pair of boxes, three for a weld and two for a pin") {
  const std::map<std::string, int> rows = {{"ratio100", 2 * 4},
                                           {"stack10", 10 * 4},
                                           {"stack10_offset", 40},
                                           {"stack5_100", 5 * 4},
                                           {"weld10", 10 * 3},
                                           {"chain20x100", 20 * 2},
                                           {"arch21", 22 * 4},
                                           {"painleve_rod", 2},
                                           {"pyramid10", (10 + 2 * 45) * 4}};  // all but ten stand on two
  for (const FrozenProblem& frozen : read_frozen_set(frozen_folder)) {
    const auto expected = rows.find(frozen.name);
    if (expected == rows.end()) continue;
    CAPTURE(frozen.name);
    CHECK(frozen.problem.row_count() == expected->second);
    CHECK(frozen.tags[1] == std::to_string(expected->second) + " rows");
  }
}

TEST_CASE("a world is frozen as its next step will see it, and goes on as if it had not been") {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  World world(scene);
  CHECK(freeze(world, "box", "").tags == List<std::string>{"cold", "4 rows", "start"});
  SequentialImpulse<double> solver({.iterations = 50});
  for (int step = 0; step < 10; ++step) world.step(solver);
  const FrozenProblem frozen = freeze(world, "box", "");
  CHECK(frozen.tags == List<std::string>{"warm", "4 rows", "settled"});
  VelocityProblem<double> problem = frozen.problem;
  solver.solve(problem);
  world.step(solver);
  CHECK(problem.impulse == world.last_step().problem.impulse);
  CHECK(problem.velocity == world.bodies().velocity);
}
