// Scenes that change on the way, as the verbs of the program see them.
#include "sandbox_program.hpp"

namespace cairn::testing {

namespace {

/// A disc that hangs on a rod for half a second, and then falls; it should end at the height `place`.
std::string falling_disc(const std::string& place) {
  return "seconds = 1\n"
         "step = { dt = \"1 / 64\", substeps = 1 }\n"
         "[[body]]\nname = \"disc\"\ncircle = 0.5\n"
         "[[joint]]\nname = \"rod\"\ntype = \"rod\"\nb = \"disc\"\nanchor_a = [0, 2]\n"
         "[[event]]\ntime = 0.5\nremove = \"rod\"\n"
         "[[expect.body]]\nname = \"disc\"\nposition = [0, " +
         place + "]\nwithin = 0.005\n";
}

// Semi-implicit Euler: g dt^2 n (n + 1) / 2 in the 32 steps of the fall.
const std::string end_of_fall = "\"-10 / 64 / 64 * 32 * 33 / 2\"";

}  // namespace

TEST_CASE("run says how far a body is from where it should end, and whether that is near enough") {
  const ScratchFolder scratch;
  const std::string scene = scratch.path() + "/falling.toml";
  scratch.write("falling.toml", falling_disc(end_of_fall));
  const Ran met = run_cairn({"run", scene});
  CHECK(met.code == 0);
  CHECK(text_has(met.out, "place of disc       off by 0 mm           expected at most 5 mm  ok"));
  CHECK(text_has(met.out, "meets what is expected"));
  scratch.write("falling.toml", falling_disc("0"));
  const Ran missed = run_cairn({"run", scene});
  CHECK(missed.code == 1);
  CHECK(text_has(missed.out, "place of disc       off by 1.29e+03 mm    expected at most 5 mm  MISSED"));
  const nlohmann::json early = cairn_json({"run", scene, "--seconds", "0.5s"});
  CHECK(early["places"].empty());
  CHECK(early["missed"].empty());
}

TEST_CASE("compare, freeze, inspect, explain and tune see the events of a scene") {
  const ScratchFolder scratch;
  scratch.write("falling.toml", falling_disc(end_of_fall));
  const std::string scene = scratch.path() + "/falling.toml";
  const nlohmann::json compared = cairn_json({"compare", scene, "--solvers", "si,box2d"});
  for (const nlohmann::json& run : compared) {
    if (run["status"] == "refused") continue;  // built without Box2D
    CHECK(run["places"][0]["body"] == "disc");
    CHECK(run["places"][0]["distance_m"].get<double>() <= 1e-4);  // single precision, in steps
  }
  CHECK(cairn_json({"inspect", scene, "--step", "32"})["rows"].size() == 1);  // that of the rod
  CHECK(cairn_json({"inspect", scene, "--step", "33"})["rows"].empty());
  CHECK(cairn_json({"explain", scene})["events"] == 1);
  const Ran frozen = run_cairn({"freeze", scene, "--step", "32", "--out", scratch.path() + "/frozen.json"});
  CHECK(text_has(frozen.out, "0 rows"));
  // At 60 Hz the fall ends 2.6 mm deeper.
  const nlohmann::json tuned =
      cairn_json({"tune", scene, "--stands", "1s", "--solvers", "si", "--starts", "1"});
  CHECK(tuned["best"]["missed"] == "");
}

}  // namespace cairn::testing
