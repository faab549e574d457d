// What no run should show is said, and is exit code 1.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Runs it, and compares si with it, and finds both to fail with these words.
void require_failure(const std::string& text, const std::string& says) {
  const ScratchFolder scratch;
  scratch.write("scene.toml", text);
  const std::string scene = scratch.path() + "/scene.toml";
  const Ran ran = run_cairn({"run", scene});
  CAPTURE(ran.out);
  CHECK(ran.code == 1);
  CHECK(text_has(ran.out, says));
  CHECK(text_has(ran.out, "fails, whatever is expected of it"));
  const nlohmann::json json = cairn_json({"run", scene});
  REQUIRE(json["failures"].size() == 1);
  CHECK(text_has(json["failures"][0].get<std::string>(), says));
  const Ran compared = run_cairn({"compare", scene, "--solvers", "si"});
  CHECK(compared.code == 1);
  CHECK(text_has(compared.out, " fails\n"));
}

int code_of(const std::string& text) {
  const ScratchFolder scratch;
  scratch.write("scene.toml", text);
  const Ran ran = run_cairn({"run", scratch.path() + "/scene.toml"});
  CAPTURE(ran.out);
  return ran.code;
}

const std::string two_rods =
    "seconds = 3\n[[body]]\nname = \"b\"\nbox = [2, 2]\nposition = [0, -3]\n"
    "[[joint]]\ntype = \"rod\"\nb = \"b\"\nanchor_a = [0, 0]\nlength = 3\n"
    "[[joint]]\ntype = \"rod\"\nb = \"b\"\nanchor_a = [0, 0]\nlength = 2.1\n";

}  // namespace

TEST_CASE("a body that begins below the ground is told of") {
  require_failure(
      "[ground]\n[[body]]\nname = \"a\"\nbox = [1, 1]\nposition = [0, 0.5]\ndisplaced = [0, -5]\n",
      "a begins 4 m below the top of the ground, with nothing to land on");
  require_failure("[ground]\n[[body]]\nname = \"a\"\nbox = [1, 1]\nposition = [0, -3]\n",
                  "a begins 2.5 m below the top of the ground");
}

TEST_CASE("two rods that contradict each other end with an error, which is told of") {
  // Lengths of 3 and 2.1 m: the middle is 0.45 m off both.
  require_failure(two_rods, "rod joint of ground and b ends 0.45 m off");
  const ScratchFolder scratch;
  scratch.write("two.toml", two_rods);
  const Ran studied = run_cairn({"tradeoff", scratch.path() + "/two.toml", "--solvers", "si", "--quick",
                                 "--json", "--out", scratch.path()});
  CHECK(studied.code == 1);
  const nlohmann::json rows = nlohmann::json::parse(studied.out, nullptr, false);
  REQUIRE(rows.is_array());
  CHECK(rows.size() > 10);
  for (const nlohmann::json& row : rows) CHECK(row["status"] == "fails");
}

TEST_CASE("a stack without ground falls for ever, and a throw of two seconds does not") {
  require_failure("seconds = 10\n[[stack]]\nn = 3\nbox = [1, 1]\n",
                  "stack.1 falls for ever: from 0.45 s on there was nothing to land on");
  CHECK(code_of("[[body]]\ncircle = 0.1\nvelocity = [10, 10]\n") == 0);
  // Who says where it ends has thought of it.
  CHECK(code_of("seconds = 10\n[[body]]\nname = \"ball\"\ncircle = 0.1\n"
                "[[expect.body]]\nname = \"ball\"\nposition = [0, -500]\nwithin = 2\n") == 0);
}

TEST_CASE("a run that is right exits with 0, whatever its sizes, speeds and directions are") {
  // A ball on a line that rises by 1 mm in 20 m, found 28 mm deep in a line that has no thickness.
  const auto on_line = [](const std::string& rise) {
    return code_of("[[body]]\ntype = \"static\"\nsegment = [[-10, 0], [10, " + rise +
                   "]]\n[[body]]\ncircle = 0.3\nposition = [0, 0.8]\n");
  };
  CHECK(on_line("0") == 0);
  CHECK(on_line("0.001") == 0);
  // 20000 turns a minute, which nothing gave it but the beginning.
  CHECK(code_of("seconds = 1\ngravity = [0, 0]\n[[body]]\nname = \"rotor\"\ncircle = 0.05\nmass = 1\n"
                "angular_velocity = 2094\n[[joint]]\ntype = \"revolute\"\nb = \"rotor\"\n") == 0);
  // A ball that jumps through a chain from behind, and comes to lie on it.
  CHECK(code_of("seconds = 3\n[ground]\n[[body]]\ntype = \"static\"\nchain = [[2, 2], [-2, 2]]\n"
                "[[body]]\ncircle = 0.3\nposition = [0, 0.3]\nvelocity = [0, 9]\n") == 0);
  // Ten boxes of 50 m on each other, where everything falls a hundred times as fast.
  CHECK(code_of("seconds = 5\ngravity = [0, -1000]\n[ground]\n[[stack]]\nn = 10\nbox = [50, 50]\n") == 0);
}

TEST_CASE("tune takes what the scene expects as its wish, and keeps within a budget") {
  const Ran wished = run_cairn({"tune", "stack", "--solvers", "si", "--starts", "1", "--seconds", "0.2s"});
  CHECK(wished.code == 0);
  CHECK(
      text_has(wished.out, "stack: penetration at most 10 mm, energy gain at most 0.1 %, stands 0.2 s, for"));
  const nlohmann::json within = cairn_json({"tune", "stack", "--solvers", "si", "--starts", "1", "--seconds",
                                            "0.2s", "--budget", "100ms", "--time", "2s"});
  CHECK(within["best"]["frame_s"].get<double>() <= 0.1);
  CHECK(within["best"]["share_of_limit"].get<double>() <= 1);
}

TEST_CASE("a run says of each thing that is asked what share of its limit it comes to") {
  const nlohmann::json json = cairn_json({"run", "stack", "--solver", "si:20"});
  REQUIRE(json["asked"].size() == 3);
  CHECK(json["asked"][0]["what"] == "penetration");
  CHECK(json["asked"][0]["share"].get<double>() ==
        doctest::Approx(json["penetration_m"].get<double>() / 0.01).epsilon(1e-12));
  CHECK(json["step_ms_slowest"].get<double>() >= json["step_ms_median"].get<double>());
}

TEST_CASE("of several scenes it is told what more sweeps buy in each") {
  const ScratchFolder scratch;
  const Ran ran = run_cairn({"tradeoff", "stack-ratio", "spring-row", "--out", scratch.path()});
  CHECK(text_has(ran.out, "1 to 64 sweeps of si"));
  for (const char* name : {"stack-ratio", "spring-row"}) CHECK(text_has(ran.out, std::string("\n  ") + name));
  for (const char* ending : {"csv", "json", "png"})
    CHECK_FALSE(scratch.text("sweeps." + std::string(ending)).empty());
}
