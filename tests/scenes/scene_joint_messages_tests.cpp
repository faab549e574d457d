// What a scene file with a mistake is answered: about joints and settings.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "math/list.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/solver_list.hpp"

using namespace cairn;

namespace {

struct JointMistakes {
  std::string mistake = {};
  std::string text = {};
  std::string message = {};
};

const List<JointMistakes> joint_mistakes = {
    {"a joint without a type", "[[joint]]\nb = \"ball\"\n",
     "my.toml:1:1: joint[1].type must be given: one of rod, rope, spring, revolute, prismatic, weld, pulley, "
     "gear, differential, drag, friction (what joins the bodies)"},
    {"a joint of an unknown type", "[[joint]]\ntype = \"hinge\"\nb = \"ball\"\n",
     "my.toml:2:8: joint[1].type must be one of rod, rope, spring, revolute, prismatic, weld, pulley, gear, "
     "differential, drag, friction, got \"hinge\""},
    {"a key of another type of joint",
     "[[body]]\nname = \"ball\"\ncircle = 1\n[[joint]]\ntype = \"rod\"\nb = \"ball\"\nmotor = { speed = 1, "
     "max_torque = 1 }\n",
     "my.toml:7:1: joint[1].motor must be a known key, but type = \"rod\" has none of that name; it may have "
     "type, name, collide, a, b, anchor_a, anchor_b, length, frequency, damping_ratio"},
    {"a joint without a body", "[[joint]]\ntype = \"weld\"\n",
     "my.toml:1:1: joint[1].b must be given: a text in quotes (name of a body; \"row.*\": a joint for each "
     "of a row)"},
    {"a joint to an unknown body",
     "[[body]]\nname = \"ball\"\ncircle = 1\n[[joint]]\ntype = \"weld\"\nb = \"bal\"\n",
     "my.toml:6:5: joint[1].b must be the name of a body (ball?), got \"bal\""},
    {"a joint to a body that a stack has not",
     "[[stack]]\nn = 3\nbox = [1, 1]\n[[joint]]\ntype = \"weld\"\nb = \"stack.14\"\n",
     "my.toml:6:5: joint[1].b must be the name of a body (stack.1?), got \"stack.14\""},
    {"a joint of two things that cannot move",
     "[[body]]\nname = \"wall\"\ntype = \"static\"\nbox = [1, 1]\n[[joint]]\ntype = \"weld\"\nb = \"wall\"\n",
     "my.toml:5:1: joint[1] must be on at least one body that can move, got ground, wall"},
    {"a joint of a body to itself",
     "[[body]]\nname = \"ball\"\ncircle = 1\n[[joint]]\ntype = \"weld\"\na = \"ball\"\nb = \"ball\"\n",
     "my.toml:4:1: joint[1] must be between different bodies, got ball, ball"},
    {"a gear whose wheel carries it",
     "[[row]]\nn = 2\nfirst = [0, 0]\nstep = [2, 0]\ncircle = 1\n[[joint]]\ntype = \"gear\"\na = "
     "\"row.1\"\nb = \"row.2\"\ncarrier = \"row.2\"\n",
     "my.toml:6:1: joint[1] must be between different bodies, got row.1, row.2, row.2"},
    {"a chain that hangs from itself", "[[chain]]\nn = 2\nlink = 1\na = \"chain.1\"\n",
     "my.toml:1:1: chain[1] must be between different bodies, got chain.1, chain.1"},
    {"the ground dragged", "[[joint]]\ntype = \"drag\"\nb = \"ground\"\ntarget = [0, 1]\n",
     "my.toml:3:5: joint[1].b must be a body other than the ground, got \"ground\""},
    {"a rope end that carries its own roller",
     "[[body]]\nname = \"weight\"\ncircle = 0.3\n[[joint]]\ntype = \"pulley\"\nends = [{ body = \"weight\", "
     "anchor = [0, 0], roller = [0, 2], carrier = \"weight\" }]\n",
     "my.toml:6:72: joint[1].ends[1].carrier must be another body than the end's, got weight"},
    {"a rope on five bodies",
     "[[row]]\nn = 5\nfirst = [0, 0]\nstep = [1, 0]\ncircle = 0.1\n[[joint]]\ntype = \"pulley\"\nends = [{ "
     "body "
     "= \"row.1\", anchor = [0, 0], roller = [0, 2] }, { body = \"row.2\", anchor = [1, 0], roller = [1, 2] "
     "}, { "
     "body = \"row.3\", anchor = [2, 0], roller = [2, 2] }, { body = \"row.4\", anchor = [3, 0], roller = "
     "[3, 2], "
     "carrier = \"row.5\" }]\n",
     "my.toml:8:8: joint[1].ends must be on at most 4 bodies besides the ground, carriers "
     "among "
     "them, got 5"},
    {"limits that leave no room",
     "[[body]]\nname = \"door\"\nbox = [1, 1]\n[[joint]]\ntype = \"revolute\"\nb = \"door\"\nlower = "
     "1\nupper = 0\n",
     "my.toml:8:9: joint[1].upper must be >= lower, 1 rad, got 0"},
    {"a spring without its softness",
     "[[body]]\nname = \"ball\"\ncircle = 1\n[[joint]]\ntype = \"spring\"\nb = \"ball\"\nanchor_a = [0, 2]\n",
     "my.toml:4:1: joint[1].softness must be given for a spring: softness = { stiffness = 50, damping = 1 }, "
     "got nothing"},
    {"half of two kinds of softness",
     "[[body]]\nname = \"ball\"\ncircle = 1\n[[joint]]\ntype = \"spring\"\nb = \"ball\"\nanchor_a = [0, "
     "2]\nsoftness = { frequency = 2, stiffness = 5 }\n",
     "my.toml:8:12: joint[1].softness must be frequency and damping_ratio, or else stiffness and damping, "
     "got neither, or some of both"},
    {"a motor without a torque",
     "[[body]]\nname = \"wheel\"\ncircle = 1\n[[joint]]\ntype = \"revolute\"\nb = \"wheel\"\nmotor = { speed "
     "= 2 }\n",
     "my.toml:7:9: joint[1].motor.max_torque must be given: a number > 0 N m (the most that it may apply)"},
    {"gravity from above", "view = \"top\"\ngravity = [0, -10]\n",
     "my.toml:2:11: gravity must be left out where view = \"top\", got a list of 2"},
    {"an unknown solver", "[recommended]\nsolver = \"pgz\"\n",
     "my.toml:2:10: recommended.solver must be the name of a solver (pgs?), got \"pgz\""},
    {"a chain without a length", "[[chain]]\nn = 3\n",
     "my.toml:1:1: chain[1].link must be given, or else to, so that the chain has a length, got neither"},
    {"a negative step", "[step]\ndt = -0.01\n",
     "my.toml:2:6: step.dt must be a number from 1e-12 to 1e6 s, got -0.01"},
    {"a drum that is the ground",
     "[[body]]\nname = \"weight\"\ncircle = 0.3\n[[joint]]\ntype = \"pulley\"\nends = [{ body = \"weight\", "
     "anchor = [0, 0], roller = [0, 2], kind = \"drum\" }]\n",
     "my.toml:6:9: joint[1].ends[1].carrier must be a body that can turn for a drum, got ground"},
    {"a pulley without ends", "[[joint]]\ntype = \"pulley\"\n",
     "my.toml:1:1: joint[1].ends must be given: a list of tables: [{...}, {...}] (one or more, on at most 4 "
     "bodies; carriers count, the ground does not)"},
    {"a row of nothing",
     "[[body]]\nname = \"ball\"\ncircle = 1\n[[joint]]\ntype = \"weld\"\nb = \"balls.*\"\n",
     "my.toml:6:5: joint[1].b must be the name of a row, and .* behind it, got \"balls.*\""},
    {"a bob on a chain that is fastened",
     "[[chain]]\nn = 3\nto = [3, 0]\nb = \"ground\"\n[chain.bob]\nradius = 0.4\n",
     "my.toml:5:1: chain[1].bob must be at the free end of links, got an end that is none"},
};

}  // namespace

TEST_CASE("a mistake in a joint or a setting is told with its place, its field and its rule") {
  for (const JointMistakes& each : joint_mistakes) {
    CAPTURE(each.mistake);
    CHECK_THROWS_WITH_AS(read_scene_text(each.text, "my.toml"), each.message.c_str(), std::invalid_argument);
  }
}

TEST_CASE("an unknown solver that is like none is answered with all of them") {
  std::string message;
  try {
    read_scene_text("[recommended]\nsolver = \"magic\"\n", "my.toml");
  } catch (const std::invalid_argument& error) {
    message = error.what();
  }
  CHECK(message.find("my.toml:2:10: recommended.solver must be the name of a solver: box2d, ") == 0);
  for (const SolverEntry& solver : solver_entries()) {
    CHECK(message.find(", " + solver.name + ", ") != std::string::npos);
  }
  CHECK(message.find(", got \"magic\"") != std::string::npos);
}
