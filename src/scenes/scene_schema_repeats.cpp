// Floor 8. Keys of tables that stand for many bodies.
#include <fmt/format.h>

#include "scenes/scene_schema.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

/// Of n rows with n (n + 1) / 2 bodies.
constexpr int most_pyramid_rows() {
  int n = 1;
  while ((n + 1) * (n + 2) / 2 <= most_scene_bodies) ++n;
  return n;
}

/// Of a house of cards with n (n + 1) cards and n boards.
constexpr int most_storeys() {
  int n = 1;
  while ((n + 1) * (n + 3) <= most_scene_bodies) ++n;
  return n;
}

List<SceneKey> scene_block_keys() {
  using enum SceneType;
  const std::string count = fmt::format("from 1 to {}", most_scene_bodies);
  return {
      {"repeat", "name", text, "", "The kind of the table", "", "its bodies are name.1, name.2, ..."},
      {"link", "from", point, "m", "required", "", "where it begins"},
      {"link", "to", point, "m", "required", "", "where it ends"},
      {"link", "radius", number, "m", "0.1", "> 0", "half of its thickness"},
      {"stack", "n", integer, "", "required", count, "how many"},
      {"stack", "position", point, "m", "[0, 0]", "", "of the middle of its foot"},
      {"stack", "offset", number, "m", "0", "", "alternately to the left and to the right"},
      {"pyramid", "n", integer, "", "required", fmt::format("from 1 to {}", most_pyramid_rows()), "rows"},
      {"pyramid", "position", point, "m", "[0, 0]", "", "of the middle of its foot"},
      {"pyramid", "spacing", number, "m", "Width of a box + 0.1", "> 0", "from middle to middle"},
      {"row", "n", integer, "", "required", count, "bodies in a row"},
      {"row", "position", point, "m", "", "", "of the middle of the first row; or give first"},
      {"row", "first", point, "m", "", "", "of the first body; or give position"},
      {"row", "step", point, "m", "required", "", "from a body to the next"},
      {"row", "rows", integer, "", "1", count, "how many"},
      {"row", "row_step", point, "m", "[0, 1]", "", "from a row to the next"},
      {"row", "stagger", point, "m", "[0, 0]", "", "every other row is moved by this"},
      {"row", "every", integer, "", "0", fmt::format("from 0 to {}", most_scene_bodies),
       "the other shape comes once in so many; 0: never"},
      {"row", "other", table, "", "", "shape", "the other shape"},
      {"row", "joint", word, "", "none", "none, pin, weld, rod",
       "joins each body to the next, and to that of the next row: halfway, or by a rod"},
      {"pile", "n", integer, "", "required", count, "how many"},
      {"pile", "columns", integer, "", "required", count, "bodies in a row"},
      {"pile", "first", point, "m", "required", "", "the lowest one on the left"},
      {"pile", "step", point, "m", "required", "", "to the right, and to the next row"},
      {"pile", "jitter", number, "m", "0", ">= 0", "to the left or right at most"},
      {"pile", "spread", number, "m", "0", ">= 0", "radius or sides are larger by up to this"},
      {"pile", "seed", integer, "", "0", "from 0 to 1000000", "another seed makes another pile"},
      {"arch", "n", integer, "", "required", fmt::format("from 2 to {}", most_scene_bodies), "stones"},
      {"arch", "position", point, "m", "[0, 0]", "", "of the middle of its foot"},
      {"arch", "radius", number, "m", "required", "> 0", "of its middle line"},
      {"arch", "thickness", number, "m", "required", "> 0", "less than twice the radius"},
      {"dominoes", "n", integer, "", "required", count, "how many"},
      {"dominoes", "position", point, "m", "[0, 0]", "", "of the middle of its foot"},
      {"dominoes", "box", point, "m", "[0.2, 1.4]", "> 0", "width and height of one"},
      {"dominoes", "step", number, "m", "0.7", "> 0", "from one to the next"},
      {"dominoes", "lean", number, "rad", "0", "from 0 to 1.5", "of the first one, towards the others"},
  };
}

List<SceneKey> scene_hanging_keys() {
  using enum SceneType;
  const std::string count = fmt::format("from 1 to {}", most_scene_bodies);
  return {
      {"cards", "n", integer, "", "required", fmt::format("from 1 to {}", most_storeys()), "storeys"},
      {"cards", "position", point, "m", "[0, 0]", "", "of the middle of its foot"},
      {"cards", "card", point, "m", "[0.04, 1]", "> 0", "thickness and length of a card"},
      {"cards", "lean", number, "rad", "0.3", "from 0.01 to 1.5", "from the vertical"},
      {"cards", "board", number, "m", "0.05", "> 0", "thickness of the boards between the storeys"},
      {"cradle", "n", integer, "", "required", count, "balls"},
      {"cradle", "position", point, "m", "[0, 0]", "", "of the middle of the points they hang from"},
      {"cradle", "radius", number, "m", "0.5", "> 0", "of a ball"},
      {"cradle", "gap", number, "m", "0.004", ">= 0", "between two balls"},
      {"cradle", "rod", number, "m", "3", "> 0", "length"},
      {"cradle", "aside", number, "rad", "0", "from -1.5 to 1.5", "of the first; negative: to the left"},
      {"chain", "n", integer, "", "required", count, "bodies"},
      {"chain", "from", point, "m", "[0, 0]", "", "where it begins"},
      {"chain", "to", point, "m", "", "", "where it ends; or give link and angle"},
      {"chain", "angle", number, "rad", "0", "", "from hanging straight down; positive: to the right"},
      {"chain", "link", number, "m", "", "> 0", "length of a link, or of the way to the next body"},
      {"chain", "thickness", number, "m", "0.12", "> 0", "of a link without a shape of its own"},
      {"chain", "a", text, "", "ground", "", "what its beginning is joined to"},
      {"chain", "b", text, "", "", "", "what its end is joined to; without it the end is free"},
      {"chain", "joint", word, "", "pin", "pin, weld, rod, rope, spring",
       "pin, weld: links that meet. The others: bodies apart, with a shape of their own"},
      {"chain", "length", number, "m", "As far as it is", "> 0", "of a rod, rope or spring"},
      {"chain", "softness", table, "", "", "softness", "of a spring or rope"},
      {"chain", "aside", number, "m", "0", "", "its middle is drawn aside; with rods, ropes and springs"},
      {"chain", "bob", table, "", "", "bob", "a disc at its end"},
      {"bob", "radius", number, "m", "required", "> 0", "of the disc"},
      {"bob", "ratio", number, "", "", "> 0", "its mass over that of a link"},
  };
}

}  // namespace

List<SceneKey> scene_repeat_keys() {
  List<SceneKey> all;
  for (const auto& part : {scene_block_keys, scene_hanging_keys}) {
    for (SceneKey& key : part()) all.push_back(std::move(key));
  }
  return all;
}

}  // namespace cairn
