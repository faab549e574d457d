// What the playground refuses, and that nothing has changed then: scenes too large to look at, steps that
// take too long, texts that are too long or none at all.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include <cairn/math/deadline.hpp>
#include "lessons/playground/interface.h"
#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>

namespace {

const char* const small_stack = R"([ground]
half_width = 8
[[stack]]
name = "crate"
n = 3
box = [1, 1]
)";

/// All bodies in one place: more pairs than are looked at.
const char* const heap = R"([ground]
[[pile]]
n = 5000
columns = 5000
box = [1, 1]
first = [0, 0.5]
step = [0.0001, 0.0001]
)";

std::string refusal_now() { return cairn_refusal(); }

/// All that a student sees of the world.
std::string all_now() {
  std::string all = cairn_fingerprint();
  all += cairn_scene_text();
  all += cairn_settings();
  return all + std::to_string(cairn_numbers()[1]) + std::to_string(cairn_numbers()[4]);
}

void begin_with(const char* text) {
  REQUIRE(cairn_patience(0) == 1);
  REQUIRE(cairn_open(text, "scene") == 1);
  REQUIRE(cairn_set("other", "none") == 1);
}

std::string scene_of_list(const std::string& name) {
  std::stringstream text;
  text << std::ifstream(std::string(CAIRN_SOURCE_DIR) + "/lessons/scenes/" + name + ".toml").rdbuf();
  return text.str();
}

double seconds_since(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace

TEST_CASE("a scene that cannot be looked at is refused when it is opened") {
  begin_with(small_stack);
  REQUIRE(cairn_step(3) == 1);
  const std::string before = all_now();
  CHECK(cairn_open(heap, "heap") == 0);
  CHECK(refusal_now().find("pairs") != std::string::npos);
  CHECK(all_now() == before);
  CHECK(cairn_row_count() > 0);
  CHECK(cairn_step(1) == 1);
}

TEST_CASE("a step that takes too long is refused, and the world goes on with the same bits") {
  begin_with(small_stack);
  REQUIRE(cairn_step(20) == 1);
  const std::string end = cairn_fingerprint();
  REQUIRE(cairn_restart() == 1);
  REQUIRE(cairn_step(10) == 1);
  REQUIRE(cairn_row(3) == 1);
  const std::string before = all_now();
  REQUIRE(cairn_patience(1e-9) == 1);
  CHECK(cairn_step(1) == 0);
  CHECK(refusal_now().find("longer than 1e-09 s") != std::string::npos);
  CHECK(cairn_set("solver", "pgs") == 0);
  CHECK(cairn_set("friction", "0.1") == 0);
  CHECK(cairn_grab(0, 0.5) == 0);
  CHECK(cairn_add_box(3, 0.5, 1, 1) == 0);
  CHECK(cairn_restart() == 0);
  CHECK(cairn_open(small_stack, "scene") == 0);
  CHECK(all_now() == before);
  REQUIRE(cairn_patience(0) == 1);
  CHECK(cairn_step(10) == 1);
  CHECK(std::string(cairn_fingerprint()) == end);
}

TEST_CASE("the exact solver is refused where it would hold the page up") {
  begin_with(scene_of_list("pyramid").c_str());
  REQUIRE(cairn_step(60) == 1);  // now its rows are many
  const std::string before = all_now();
  REQUIRE(cairn_patience(0.02) == 1);
  const auto begun = std::chrono::steady_clock::now();
  CHECK(cairn_set("solver", "reference") == 0);
  CHECK(seconds_since(begun) < 2);
  CHECK(refusal_now() ==
        "One step takes longer than 0.02 s here, and the playground waits no longer: take another solver, or "
        "fewer "
        "sweeps or substeps.");
  REQUIRE(cairn_patience(0) == 1);
  CHECK(all_now() == before);
}

TEST_CASE("many steps come in slices of time, and a slice has one step at least") {
  begin_with(small_stack);
  REQUIRE(cairn_step_for(100000, 0) == 1);
  CHECK(cairn_numbers()[1] == 1);
  REQUIRE(cairn_step_for(9, 1e9) == 1);
  CHECK(cairn_numbers()[1] == 10);
  REQUIRE(cairn_step_for(100000, 20) == 1);
  CHECK(cairn_numbers()[1] < 100000);
  CHECK(cairn_step_for(100001, 20) == 0);
  CHECK(refusal_now().find("from 1 to 100000") != std::string::npos);
  CHECK(cairn_step_for(1, std::nan("")) == 0);
  CHECK(cairn_step_for(1, -1) == 0);
}

TEST_CASE("slow steps leave more moments to come back to") {
  begin_with(scene_of_list("pyramid").c_str());
  REQUIRE(cairn_set("substeps", "16") == 1);
  REQUIRE(cairn_set("sweeps", "100") == 1);
  REQUIRE(cairn_step(4) == 1);
  const std::string there = cairn_fingerprint();
  REQUIRE(cairn_step(1) == 1);
  REQUIRE(cairn_back() == 1);
  CHECK(std::string(cairn_fingerprint()) == there);
}

TEST_CASE("a world that diverges on the way keeps its last step, and then has no next one") {
  begin_with("gravity = [0, 0]\n[[body]]\ncircle = 0.5\nvelocity = [1.7e308, 0]\n");
  CHECK(cairn_step(200) == 1);
  CHECK(cairn_numbers()[10] == 1);
  CHECK(cairn_numbers()[1] < 200);
  CHECK(cairn_step(1) == 0);
  CHECK(refusal_now().find("no finite place") != std::string::npos);
}

TEST_CASE("a text that is too long or none is refused") {
  begin_with(small_stack);
  const std::string before = all_now();
  const std::string longer(static_cast<std::size_t>(cairn_most_text()) + 1, '#');
  CHECK(cairn_open(longer.c_str(), "scene") == 0);
  CHECK(refusal_now().find("at most 1000000 bytes, got 1000001") != std::string::npos);
  CHECK(cairn_open(nullptr, "scene") == 0);
  CHECK(refusal_now() == "open: text must be a text, got null");
  CHECK(cairn_set(nullptr, "si") == 0);
  CHECK(cairn_set("solver", nullptr) == 0);
  CHECK(cairn_theme(nullptr) == 0);
  CHECK(all_now() == before);
  const std::string longest(static_cast<std::size_t>(cairn_most_text()), '#');
  CHECK(cairn_open(longest.c_str(), "scene") == 1);
}

TEST_CASE("a place that is no number has nothing there") {
  begin_with(small_stack);
  REQUIRE(cairn_draw() == 1);
  for (const double wild : {std::nan(""), 1e300, -1e300, std::numeric_limits<double>::infinity()}) {
    CAPTURE(wild);
    CHECK(cairn_at(wild, 100)[0] == 0);
    CHECK(cairn_at(100, wild)[0] == 0);
    CHECK(cairn_grab(wild, 0.5) == 0);
    CHECK(cairn_grab(0, wild) == 0);
  }
  CHECK(cairn_resize(2147483647, 400, 1) == 0);
  CHECK(cairn_resize(400, 400, std::nan("")) == 0);
}

TEST_CASE("every solver gives up when its time is up, and has another go with the same bits") {
  using namespace cairn;
  const World world(read_scene_text(small_stack, "scene").make());
  const VelocityProblem<double> problem = world.velocity_problem();
  REQUIRE(problem.row_count() > 0);
  for (const SolverEntry& entry : solver_entries()) {
    CAPTURE(entry.name);
    VelocityProblem<double> late = problem, after = problem, alone = problem;
    const auto solver = make_solver<double>(entry.name);
    {
      const Deadline deadline(1e-9);
      CHECK_THROWS_AS(solver->solve(late), TimeUp);
    }
    solver->solve(after);
    make_solver<double>(entry.name)->solve(alone);
    CHECK(after.impulse == alone.impulse);
  }
}

TEST_CASE("contacts by the hundred thousand are given up while they are sought") {
  begin_with(small_stack);
  const std::string before = all_now();
  REQUIRE(cairn_patience(0.05) == 1);
  std::string crowd = heap;
  crowd.replace(crowd.find("5000"), 4, "700").replace(crowd.find("5000"), 4, "700");
  const auto begun = std::chrono::steady_clock::now();
  CHECK(cairn_open(crowd.c_str(), "crowd") == 0);
  CHECK(seconds_since(begun) < 2);
  CHECK(refusal_now().find("longer than 0.05 s") != std::string::npos);
  REQUIRE(cairn_patience(0) == 1);
  CHECK(all_now() == before);
}
