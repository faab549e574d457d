// Chains in scene files: how they arrive, and what is refused.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <cairn/scenes/scene_file.hpp>
#include <cairn/world/world.hpp>

using namespace cairn;

namespace {

const Chain<double>& chain_of(const Scene& scene, int body) {
  return std::get<Chain<double>>(scene.bodies().at({body}).spec.shapes.at(0));
}

struct ChainMistake {
  std::string text = {};
  std::string message = {};
};

}  // namespace

TEST_CASE("a chain in a scene file has its points, its ghosts, or a way round") {
  const Scene scene = read_scene_text(R"(
[[body]]
type = "static"
chain = [[2, 0], [0, 0], ["-1 - 1", 1]]

[[body]]
type = "static"
chain = [[2, 0], [0, 0]]
ghosts = [[3, 1], [-1, 1]]

[[body]]
type = "kinematic"
chain = [[-1, -1], [-1, 1], [1, 1]]
closed = true
angular_velocity = 1
)",
                                      "my.toml")
                          .make();
  CHECK(chain_of(scene, 1) == chain({{2, 0}, {0, 0}, {-2, 1}}));
  CHECK(chain_of(scene, 2) ==
        chain({{2, 0}, {0, 0}}, {.before = Vec2<double>(3, 1), .after = Vec2<double>(-1, 1)}));
  CHECK(chain_of(scene, 3) == chain({{-1, -1}, {-1, 1}, {1, 1}}, {.closed = true}));
  CHECK(make_plan(scene).size.colliders == 2 + 1 + 3);
}

TEST_CASE("a chain that cannot be is refused in the file, with its place") {
  const std::string body = "[[body]]\ntype = \"static\"\n";
  const List<ChainMistake> mistakes = {
      {body + "chain = [[0, 0]]\n",
       "my.toml:1:1: body[1]: chain: number of points must be at least 2, got 1"},
      {body + "chain = [[0, 0], [1, 0]]\nradius = 1\n",
       "my.toml:4:10: body[1].radius must be beside a box, capsule or polygon; a disc is circle = its "
       "radius, got "
       "1"},
      {body + "circle = 1\nclosed = true\n", "my.toml:4:10: body[1].closed must be beside a chain, got true"},
      {body + "chain = [[0, 0], [1, 0]]\nghosts = [[2, 0]]\n",
       "my.toml:4:10: body[1].ghosts must be two points [[x, y], [x, y]], before and after the chain, got a "
       "list of "
       "1"},
      {"[[body]]\nchain = [[0, 0], [1, 0]]\nmass = 1\n",
       "my.toml:1:1: body[1]: shapes[0] must be no chain on a dynamic body: chains are for "
       "static "
       "and kinematic ones, got a chain"}};
  for (const ChainMistake& mistake : mistakes) {
    CHECK_THROWS_WITH_AS(read_scene_text(mistake.text, "my.toml"), mistake.message.c_str(),
                         std::invalid_argument);
  }
}
