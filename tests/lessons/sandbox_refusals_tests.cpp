// What cairn does not do, it says on standard error and by its exit code.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

bool lists_box2d() { return text_has(run_cairn({"list", "solvers"}).out, "  box2d "); }

}  // namespace

TEST_CASE("a flag that means nothing to any of the solvers is refused") {
  using Flags = List<std::string>;
  List<Flags> idle = {{"inspect", "stack", "--solver", "reference", "--sweeps", "10"},
                      {"run", "stack", "--solver", "reference", "--cold"},
                      {"run", "stack", "--solver", "reference", "--tolerance", "1e-6"}};
  const bool has_box2d = lists_box2d();
  for (const Flags& flag : List<Flags>{{"--stabilization", "soft"},
                                       {"--contact-search", "when-moved"},
                                       {"--scalar", "double"},
                                       {"--tolerance", "1e-6"}}) {
    if (!has_box2d) break;
    idle.push_back({"run", "stack", "--solver", "box2d", flag[0], flag[1]});
    idle.push_back({"compare", "stack", "--solvers", "box2d:4,box2d:8", flag[0], flag[1]});
  }
  for (const Flags& words : idle) {
    const Ran ran = run_cairn(words);
    CAPTURE(ran.err);
    CHECK(ran.code == 2);
    CHECK(ran.out.empty());
    CHECK(text_has(ran.err, " means nothing to "));
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  }
  const Ran sweeps = run_cairn({"run", "stack", "--solver", "reference:10"});
  CHECK(sweeps.code == 2);
  CHECK(text_has(sweeps.err, "--solver must be reference without sweeps"));
  // One that takes it is enough.
  CHECK(run_cairn({"compare", "stack", "--solvers", "si,reference", "--cold", "--seconds", "0.1s"}).code ==
        0);
}

TEST_CASE("a solver that cannot run the scene is told of on standard error") {
  // Box2D has no differentials; or Cairn was built without it.
  const Ran beside = run_cairn({"compare", "differential", "--solvers", "si,box2d", "--seconds", "0.2s"});
  CHECK(beside.code == 0);
  CHECK(text_has(beside.err, "cairn compare: box2d cannot run differential: "));
  CHECK(text_has(beside.out, "left out"));
  const Ran none = run_cairn({"compare", "differential", "--solvers", "box2d", "--seconds", "0.2s"});
  CHECK(none.code == 2);
  CHECK(none.out.empty());
  CHECK(text_has(none.err, "cairn compare: box2d cannot run differential: "));
  if (lists_box2d()) {
    const Ran studied = run_cairn({"tradeoff", "differential", "--solvers", "box2d", "--quick"});
    CHECK(studied.code == 2);
    CHECK(studied.out.empty());
    CHECK(text_has(studied.err, "cairn tradeoff: box2d cannot run differential: "));
  }
  const Ran alone = run_cairn({"run", "differential", "--solver", "box2d"});
  CHECK(alone.code == 2);
  CHECK(alone.out.empty());
  CHECK(std::count(alone.err.begin(), alone.err.end(), '\n') == 1);
}

TEST_CASE("flags take words with blanks, hyphens or underscores") {
  for (const std::string blank : {" ", "-", "_"}) {
    const nlohmann::json run = cairn_json({"run", "stack", "--solver", "wide" + blank + "accelerated:5",
                                           "--stabilization", "split" + blank + "impulse", "--contact-search",
                                           "when" + blank + "moved", "--seconds", "0.1s"});
    CHECK(run["setting"] == "wide-accelerated x5, 60 Hz x4, contacts when moved, split impulse, double");
  }
}

TEST_CASE("a run in any number type but float and double is refused in one line, with both") {
  for (const char* verb : {"run", "compare"}) {
    const Ran refused = run_cairn({verb, "stack", "--scalar", "long-double"});
    CHECK(refused.code == 2);
    CHECK(refused.out.empty());
    CHECK(refused.err ==
          std::string("cairn ") + verb + ": --scalar must be float or double, got long-double\n");
  }
}

TEST_CASE("a joint has the name that its scene file gives it") {
  const ScratchFolder scratch;
  scratch.write("rod.toml",
                "[[body]]\nbox = [1, 1]\nposition = [0, -2]\n[[joint]]\ntype = \"rod\"\nb = \"body.1\"\n");
  const std::string scene = scratch.path() + "/rod.toml";
  CHECK(text_has(run_cairn({"inspect", scene}).out, " rod "));
  CHECK(cairn_json({"inspect", scene})["rows"][0]["kind"] == "rod");
  scratch.write("rod.toml", "[[body]]\nbox = [1, 1]\n[[joint]]\ntype = \"rod\"\nb = \"body.1\"\n");
  const Ran short_rod = run_cairn({"run", scene});
  CHECK(short_rod.code == 2);
  CHECK(text_has(short_rod.err, "rod.toml:3:1: joint[1].length must be > 0 m, got 0"));
}
