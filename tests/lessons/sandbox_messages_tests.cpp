// What cairn says of scenes to people: names instead of numbers, and nothing that commands a terminal.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/math/printable.hpp>
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

bool is_printable(const Ran& ran) { return printable(ran.out + ran.err) == ran.out + ran.err; }

/// A post that is pinned to the ground, and stands 0.5 m deep in it.
const std::string sunk_post =
    "seconds = 0.5\n[ground]\n[[body]]\nname = \"post\"\nbox = [0.5, 2]\nposition = [0, 0.5]\n"
    "[[joint]]\ntype = \"revolute\"\nb = \"post\"\n";

}  // namespace

TEST_CASE("nothing that commands a terminal gets there from flags, names of files or scene files") {
  const ScratchFolder scratch;
  scratch.write("key.toml", "\"k\\u001b[31m\" = 3\n");
  scratch.write("\x1b[31mred\xe9.toml", sunk_post);
  const std::string red = scratch.path() + "/\x1b[31mred\xe9.toml";
  using Flags = List<std::string>;
  for (const Flags& words : List<Flags>{{"\x1b[2J"},
                                        {"run", "\x1b[2J"},
                                        {"run", "stack", "--\x1b[2J"},
                                        {"run", "stack", "--solver", "\x1b[2J"},
                                        {"run", "\x1b[2J\u202e.toml"},
                                        {"explain", scratch.path() + "/key.toml"}}) {
    const Ran ran = run_cairn(words);
    CAPTURE(words.front());
    CHECK(ran.code == 2);
    CHECK(is_printable(ran));
    CHECK((text_has(ran.err, "\\x1b[2J") || text_has(ran.err, "k\\x1b[31m must be a known key")));
  }
  for (const char* verb : {"run", "explain", "inspect"}) {
    const Ran ran = run_cairn({verb, red});
    CHECK(is_printable(ran));
    CHECK(text_has(ran.out, "\\x1b[31mred\\xe9"));
    CHECK(cairn_json({verb, red})["scene"] == "\\x1b[31mred\\xe9");
  }
}

TEST_CASE("a word of 100 kB is not said again in full") {
  const std::string huge(100000, 'k');
  using Flags = List<std::string>;
  for (const Flags& words : List<Flags>{
           {huge}, {"run", huge}, {"run", "stack", "--" + huge}, {"run", "stack", "--solver", huge}}) {
    const Ran ran = run_cairn(words);
    CHECK(ran.code == 2);
    CHECK(ran.err.size() <= longest_message + 4);  // "..." and the end of the line
    CHECK(text_has(ran.err, "kkk...kkk"));
  }
}

TEST_CASE("cairn run names the bodies and the time of the worst overlap, and the joint of the worst drift") {
  const Ran ran = run_cairn({"run", "tower-and-ball"});
  CHECK(text_has(ran.out, "tower.5 and ball, at "));
  CHECK(text_has(ran.out, "rod joint of ground and ball, at "));
  const nlohmann::json json = cairn_json({"run", "tower-and-ball"});
  CHECK(json["drift_worst"]["joint"] == "rod");
  CHECK(json["drift_worst"]["b"] == "ball");
  const double time = json["penetration_worst"]["time_s"];
  // A run that ends just there is as bad, one that ends a step before is not.
  const auto worst_until = [](double seconds) {
    return cairn_json({"run", "tower-and-ball", "--seconds", std::to_string(seconds)})["penetration_m"]
        .get<double>();
  };
  CHECK(worst_until(time) == json["penetration_m"]);
  CHECK(worst_until(time - 1.0 / 60) < json["penetration_m"]);
}

TEST_CASE("a body that is joined to the ground and goes through it is told of") {
  const ScratchFolder scratch;
  scratch.write("post.toml", sunk_post);
  const std::string post = scratch.path() + "/post.toml";
  CHECK(text_has(run_cairn({"run", post}).out, "mm: post is joined to it, and joined bodies do not collide"));
  CHECK(text_has(run_cairn({"explain", post}).out, "joined bodies do not collide: ground and post"));
  CHECK(cairn_json({"explain", post})["pairs_apart"] == 1);
  scratch.write("post.toml", sunk_post + "collide = \"on\"\n");
  CHECK_FALSE(text_has(run_cairn({"run", post}).out, "joined bodies do not collide"));
  CHECK_FALSE(text_has(run_cairn({"explain", post}).out, "joined bodies do not collide"));
}

TEST_CASE("cairn inspect names bodies, and gives A in full up to 400 rows") {
  const Ran ran = run_cairn({"inspect", "stack", "--rows", "40"});
  CHECK(text_has(ran.out, " stack.9 stack.10 "));
  const nlohmann::json stack = cairn_json({"inspect", "stack"});
  CHECK(stack["rows"][0]["a"] == "ground");
  CHECK(stack["rows"][0]["b"] == "stack.1");
  REQUIRE(stack["rows"].size() == 40);
  CHECK(stack["A"].size() == 40);
  CHECK(stack["A"][39].size() == 40);
  const ScratchFolder scratch;
  scratch.write("many.toml",
                "[ground]\n[[row]]\nn = 101\nposition = [0, 0.5]\nstep = [0.9, 0]\nbox = [0.5, 1]\n");
  const nlohmann::json many = cairn_json({"inspect", scratch.path() + "/many.toml", "--step", "1"});
  CHECK(many["rows"].size() == 404);
  CHECK(many["A"].is_null());
}

TEST_CASE("cairn freeze takes a scene file whatever its name is") {
  const ScratchFolder scratch;
  scratch.write("my first post.toml", sunk_post);
  CHECK(cairn_json({"freeze", scratch.path() + "/my first post.toml", "--step", "2"})["name"] ==
        "my-first-post-2");
}

TEST_CASE("a TMPDIR that is not there is named by whom it stops") {
  const ScratchFolder scratch;  // a stand-in for the encoder, which is asked for before the frames are drawn
  scratch.write("ffmpeg", "#!/bin/sh\n");
  std::filesystem::permissions(scratch.path() + "/ffmpeg", std::filesystem::perms::owner_all);
  const Ran ran = run_program("/usr/bin/env", {"TMPDIR=/no/such/folder", "PATH=" + scratch.path(),
                                               CAIRN_BIN_DIR "/cairn", "run", "puck", "--seconds", "0.1s",
                                               "--size", "small", "--gif", scratch.path() + "/puck.gif"});
  CHECK(ran.code == 3);
  CHECK(text_has(ran.err, "TMPDIR must name a folder for temporary files, got /no/such/folder"));
}

TEST_CASE("a solver on a device gives the bits of the one here, or is refused with what to install") {
  const ScratchFolder scratch;
  scratch.write("device.toml",
                "[ground]\n[[body]]\nbox = [1, 1]\n[recommended]\nsolver = \"opencl-jacobi\"\n");
  const std::string scene = scratch.path() + "/device.toml";
  const auto is_refused = [](const Ran& ran, const std::string& rule) {
    return ran.code == 2 && text_has(ran.err, " must be another where " + rule) &&
           text_has(ran.err, "pocl-opencl-icd") && text_has(ran.err, ", got opencl-jacobi");
  };
  const Ran here = run_cairn({"run", scene, "--json"});
  const std::string rule =
      text_has(here.err, "without OpenCL") ? "Cairn was built without OpenCL" : "there is no OpenCL device";
  if (here.code == 2) {
    CHECK(is_refused(here, rule));
    MESSAGE(here.err);
  } else {
    const nlohmann::json there =
        cairn_json({"run", "stack", "--solver", "opencl-jacobi:50", "--seconds", "0.2"});
    const nlohmann::json split =
        cairn_json({"run", "stack", "--solver", "jacobi-split:50", "--seconds", "0.2"});
    CHECK(there["state"] == split["state"]);
    CHECK(there["row_updates"] == split["row_updates"]);
  }
  // The loader looks for drivers here, and finds none.
  const char* const key = "OCL_ICD_VENDORS";
  const std::string before = std::getenv(key) == nullptr ? "" : std::getenv(key);
  setenv(key, (scratch.path() + "/nowhere").c_str(), 1);
  CHECK(is_refused(run_cairn({"run", scene}), rule));
  CHECK(is_refused(run_cairn({"compare", "stack", "--solvers", "si,opencl-jacobi:20"}), rule));
  before.empty() ? unsetenv(key) : setenv(key, before.c_str(), 1);
  CHECK(run_cairn({"tune", scene, "--solvers", "opencl-jacobi"}).code == 2);
}
