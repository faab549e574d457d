// The verbs of cairn that list, run, explain, compare and inspect scenes, as processes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <cairn/math/list.hpp>
#include "render/image.hpp"
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE("every verb that takes a scene takes a file of one's own, and refuses an unknown name in one way") {
  const ScratchFolder scratch;
  const std::string scene = scratch.path() + "/own.toml", out = scratch.path() + "/out";
  scratch.write("own.toml",
                "seconds = 0.5\n[ground]\n[[body]]\nname = \"a\"\nbox = [1, 1]\nposition = [0, 0.5]\n");
  using Flags = List<std::string>;
  const List<Flags> verbs = {{"run"},
                             {"explain"},
                             {"compare", "--solvers", "si,accelerated"},
                             {"inspect", "--step", "2"},
                             {"freeze", "--step", "2", "--out", scratch.path() + "/own.json"},
                             {"tune", "--penetration", "10mm", "--starts", "1", "--solvers", "si"},
                             {"tradeoff", "--quick", "--solvers", "si", "--out", out}};
  for (const Flags& verb : verbs) {
    CAPTURE(verb.front());
    const auto with = [&](const std::string& name) {
      Flags words = verb;
      words.insert(words.begin() + 1, name);
      return run_cairn(words);
    };
    const Ran own = with(scene);
    CAPTURE(own.err);
    CHECK(own.code == 0);
    const Ran unknown = with("no-such");
    CHECK(unknown.code == 2);
    CHECK(text_has(unknown.err, "cairn " + verb.front() + ": SCENE"));
    CHECK(with(scratch.path() + "/none.toml").code == 2);
  }
  // Another text is another study: what is known of the old one is not taken for it.
  scratch.write("own.toml",
                "seconds = 0.6\n[ground]\n[[body]]\nname = \"a\"\nbox = [1, 1]\nposition = [0, 0.5]\n");
  const std::string journal = "out/own.journal";
  const std::string before = scratch.text(journal);
  CHECK(run_cairn({"tradeoff", scene, "--quick", "--solvers", "si", "--out", out}).code == 0);
  CHECK(before.substr(0, before.find('\n')) != scratch.text(journal).substr(0, before.find('\n')));
}

TEST_CASE("cairn list names scenes, solvers and stabilizations, and each alone") {
  const nlohmann::json all = cairn_json({"list"});
  CHECK(all["scenes"].size() >= 20);
  CHECK(all["solvers"].size() >= 11);
  CHECK(all["stabilizations"].size() == 5);
  CHECK(cairn_json({"list", "solvers"}) == all["solvers"]);
  const Ran scenes = run_cairn({"list", "scenes"});
  CHECK(scenes.code == 0);
  for (const nlohmann::json& scene : all["scenes"])
    CHECK(text_has(scenes.out, "  " + scene["name"].get<std::string>() + " "));
  CHECK_FALSE(text_has(scenes.out, "jacobi-split"));
  const Ran unknown = run_cairn({"list", "solver"});
  CHECK(unknown.code == 2);
  CHECK(text_has(unknown.err, "did you mean solvers?"));
}

TEST_CASE("cairn run holds a run against what is expected, and says so by its exit code") {
  const Ran good = run_cairn({"run", "stack", "--seconds", "0.5s"});
  CHECK(good.code == 0);
  CHECK(text_has(good.out, "newton x20, 60 Hz x4, relaxed, double"));
  CHECK(text_has(good.out, "0.5 s in 30 steps"));
  // A hundred on one, after four sweeps: the light box is crushed at once.
  const Ran bad = run_cairn({"run", "stack-ratio", "--solver", "si:4", "--seconds", "1s"});
  CHECK(bad.code == 1);
  CHECK(text_has(bad.out, "MISSED"));
  // Jacobi without damping diverges where rows share bodies, and nobody looks after it.
  const Ran wild = run_cairn({"run", "ragdoll", "--solver", "jacobi"});
  CHECK(wild.code == 4);
  CHECK(text_has(wild.out, "diverged after"));
}

TEST_CASE("cairn run takes every part of the setting from its flags") {
  const nlohmann::json run = cairn_json({"run", "stack", "--solver", "wide", "--sweeps", "7", "--substeps",
                                         "3", "--frequency", "120", "--scalar", "float", "--stabilization",
                                         "soft", "--seconds", "0.1s", "--cold", "--tolerance", "1e-3"});
  CHECK(run["setting"] == "wide x7 to 0.001, 120 Hz x3, soft, float, cold");
  CHECK(run["steps"] == 12);
  CHECK(run["dt_s"] == 1.0 / 120);
  CHECK(cairn_json({"run", "stack", "--dt", "1/100", "--seconds", "0.1s"})["steps"] == 10);
  CHECK(cairn_json({"run", "stack", "--dt", "5ms", "--seconds", "0.1s"})["steps"] == 20);
  CHECK(cairn_json({"run", "stack", "--solver", "si:3", "--seconds", "0.1s"})["sweeps"] == 3);
}

TEST_CASE("two runs by one command end in the same state") {
  const nlohmann::json first = cairn_json({"run", "dominoes", "--seconds", "0.5s"});
  CHECK(first["state"] == cairn_json({"run", "dominoes", "--seconds", "0.5s"})["state"]);
  CHECK(first["state"] != cairn_json({"run", "dominoes", "--seconds", "0.5s", "--scalar", "float"})["state"]);
}

TEST_CASE("what the verbs cannot understand they refuse with a hint, before any work") {
  struct Refusal {
    List<std::string> words;
    std::string says;
  };
  const List<Refusal> refusals = {
      {{"run", "stac"}, "stack"},
      {{"run"}, "a word is missing"},
      {{"run", "stack", "--solver", "jakobi"}, "did you mean jacobi?"},
      {{"run", "stack", "--solver", "si:many"}, "such as si:10"},
      {{"run", "stack", "--solver", "si:1000001"}, "0 to 1000000 sweeps"},
      {{"run", "stack", "--sweeps", "1000001"}, "from 0 to 1000000, got 1000001"},
      {{"freeze", "stack", "--sweeps", "1000001"}, "from 0 to 1000000, got 1000001"},
      {{"run", "stack", "--substeps", "1000001"}, "from 1 to 1000000, got 1000001"},
      {{"run", "stack", "--tolerance", "-1"}, "--tolerance must be a number from 0 to 1, got -1"},
      {{"run", "stack", "--dt", "0"}, "--dt must be a time above 0"},
      {{"run", "stack", "--dt", "1/60", "--frequency", "60"}, "give one of them"},
      {{"run", "stack", "--scalar", "doubel"}, "did you mean double?"},
      {{"run", "stack", "--frames", "never", "--show", "lods"}, "did you mean loads?"},
      {{"run", "stack", "--frames", "never", "--size", "10x10"}, "from 320x180"},
      {{"run", "stack", "--csv", "-", "--json"}, "both want stdout"},
      {{"compare", "stack", "--solvers", "si,pgs,block,accelerated,jacobi", "--frames", "never"},
       "at most 4"},
      {{"inspect", "stack", "--step", "0"}, "--step must be"},
      {{"inspect", "stack", "--scalar", "float"}, "--scalar must be double"},
      {{"inspect", "stack", "--solver", "box2d"}, "--solver must be"},
      {{"completion", "fish"}, "bash or zsh"}};
  for (const Refusal& refusal : refusals) {
    const Ran ran = run_cairn(refusal.words);
    CAPTURE(ran.err);
    CHECK(ran.code == 2);
    CHECK(ran.out.empty());
    CHECK(text_has(ran.err, refusal.says));
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  }
  CHECK_FALSE(std::filesystem::exists("never"));
}

TEST_CASE("a scene with more contacts or rows than there is room for is refused with two") {
  const ScratchFolder folder;
  const std::string heap = folder.path() + "/heap.toml", point = folder.path() + "/point.toml";
  const std::string boxes = "box = [1, 1]\nfirst = [0, 0.5]\njitter = 0.01\n";
  folder.write("heap.toml", "[ground]\n[[pile]]\nn = 900\ncolumns = 30\nstep = [0.99, 0.99]\n" + boxes);
  folder.write("point.toml", "[ground]\n[[pile]]\nn = 2000\ncolumns = 2000\nstep = [0, 0]\n" + boxes);
  const Ran exact = run_cairn({"run", heap, "--solver", "reference", "--seconds", "0.1s"});
  CHECK(exact.code == 2);
  CHECK(text_has(exact.err, "above the limit of 5000"));
  const Ran run = run_cairn({"run", point, "--seconds", "0.1s"});
  CHECK(run.code == 2);
  CHECK(text_has(run.err, "more than 1000000 pairs of shapes"));
  const Ran frozen = run_cairn({"freeze", point, "--out", folder.path() + "/point.json"});
  CHECK(frozen.code == 2);
  CHECK(text_has(frozen.err, "more than 1000000 pairs of shapes"));
  CHECK(folder.names() == List<std::string>{"heap.toml", "point.toml"});
}

TEST_CASE("cairn explain counts bodies, joints and rows, and says what is left out") {
  // 21 stones touch in 20 joints, and the ground twice: 22 manifolds of two points, each with a friction row.
  const nlohmann::json arch = cairn_json({"explain", "arch"});
  CHECK(arch["bodies"] == nlohmann::json{{"dynamic", 21}, {"static", 1}});
  CHECK(arch["contacts"] == 44);
  CHECK(arch["rows_one_sided"] == 44);
  CHECK(arch["rows_of_friction"] == 44);
  CHECK(arch["rows_of_joints"] == 0);
  // A dense matrix of 88 rows is 88^2 doubles, at least.
  CHECK(arch["solver_bytes"]["pgs"].get<std::size_t>() >= 88 * 88 * sizeof(double));
  // A chain of 20 links: a pin has two rows.
  const nlohmann::json chain = cairn_json({"explain", "chain"});
  CHECK(chain["joints"] == nlohmann::json{{"revolute", 20}});
  CHECK(chain["rows_of_joints"] == 40);
  CHECK(text_has(run_cairn({"explain", "chain"}).out, "left out"));
}

TEST_CASE("cairn compare puts solvers in one table, and leaves out what cannot run the scene") {
  const nlohmann::json rows =
      cairn_json({"compare", "stack", "--solvers", "si:5,si:50,pgs:5", "--seconds", "0.5s"});
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["sweeps"] == 5);
  CHECK(rows[1]["row_updates"].get<double>() == 10 * rows[0]["row_updates"].get<double>());
  // SI and PGS are the same iteration: they differ by rounding, which a standing stack does not amplify.
  CHECK(rows[2]["penetration_m"].get<double>() ==
        doctest::Approx(rows[0]["penetration_m"].get<double>()).epsilon(1e-6));
  // Box2D has no differentials; or Cairn was built without it.
  const nlohmann::json figure =
      cairn_json({"compare", "differential", "--solvers", "si,box2d", "--seconds", "0.2s"});
  CHECK(figure[0]["status"] == "ok");
  CHECK(figure[1]["status"] == "refused");
  CHECK_FALSE(figure[1]["reason"].get<std::string>().empty());
}

TEST_CASE("cairn inspect shows the rows of a step, their sweeps and the exact answer") {
  const nlohmann::json step = cairn_json({"inspect", "stack", "--step", "1", "--sweeps", "10"});
  CHECK(step["rows"].size() == 40);  // ten manifolds of two points, each with its friction
  CHECK(step["sweeps"].size() == 11);
  CHECK(step["sweeps"][0]["R_E"] == 1.0);  // nothing was done
  // Ten boxes of 1 kg at rest: the ground gives them 10 kg times g dt in all, at two points, one half each.
  const double weight = 10 * 10 * step["time_s"].get<double>();
  CHECK(step["rows"][0]["exact_Ns"].get<double>() + step["rows"][2]["exact_Ns"].get<double>() ==
        doctest::Approx(weight).epsilon(1e-12));
  CHECK(step["rows"][0]["impulse_Ns"] == step["sweeps"][10]["impulse_Ns"][0]);
  CHECK(step["reference"]["residual"].get<double>() <= 1e-12);
  CHECK(step["reference"]["impulses"] == "more than one");
  // The reference beside itself.
  const nlohmann::json exact = cairn_json({"inspect", "stack", "--step", "1", "--solver", "reference"});
  CHECK(exact["reference"]["velocity_gap"] == 0.0);
}

TEST_CASE("cairn inspect prints a small A as text, and draws a large one") {
  // Two weights on a rope over two pulleys: one row, and A = 1/m_1 + 1/m_2 of it.
  const Ran pulley = run_cairn({"inspect", "pulley", "--step", "2"});
  CHECK(pulley.code == 0);
  CHECK(text_has(pulley.out, "1 rows"));
  CHECK(text_has(pulley.out, "A = J M⁻¹ Jᵀ"));
  const ScratchFolder folder;
  const std::string picture = folder.path() + "/A.png";
  const Ran arch =
      run_cairn({"inspect", "arch", "--step", "1", "--sweeps", "5", "--picture", picture, "--size", "small"});
  CHECK(arch.code == 0);
  CHECK(text_has(arch.out, "88 x 88"));
  CHECK(render::read_png(picture).width == 960);
  CHECK(run_cairn({"inspect", "pulley", "--picture", "/dev/null/A.png"}).code == 3);
}

TEST_CASE("the completion script knows every verb, flag, scene and solver, and bash can read it") {
  const Ran bash = run_cairn({"completion", "bash"});
  CHECK(bash.code == 0);
  for (const char* word : {"inspect", "--stabilization", "wrecking-ball", "accelerated", "split-impulse"})
    CHECK(text_has(bash.out, word));
  CHECK(text_has(run_cairn({"completion", "zsh"}).out, "bashcompinit"));
  const ScratchFolder folder;
  folder.write("completion.sh",
               bash.out +
                   "COMP_WORDS=(cairn run wreck) COMP_CWORD=2; _cairn; echo \"${COMPREPLY[@]}\"\n"
                   "COMP_WORDS=(cairn run stack --solver acc) COMP_CWORD=4; _cairn; "
                   "echo \"${COMPREPLY[@]}\"\n");
  const std::string answer = folder.path() + "/answer";
  REQUIRE(std::system(("cd " + folder.path() + " && bash completion.sh > " + answer).c_str()) == 0);
  CHECK(folder.text("answer") == "wrecking-ball\naccelerated\n");
}

TEST_CASE("the bar of tune ends where the search does") {
  const Ran ran = run_cairn({"tune", "stack", "--penetration", "20mm", "--starts", "1", "--seconds", "0.1s",
                             "--progress", "always"});
  CHECK(ran.code == 0);
  const std::size_t bar = ran.err.rfind("] ");
  REQUIRE(bar != std::string::npos);
  int tried = 0, total = 0;
  CHECK(std::sscanf(ran.err.c_str() + bar, "] %d/%d settings", &tried, &total) == 2);
  CHECK(tried == total);
  CHECK(text_has(ran.out, std::to_string(tried) + " settings tried"));
}
