// Floor 8. Keys of tables that stand for many bodies.
#include <fmt/format.h>

#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_field.hpp>

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

}  // namespace

List<SceneKey> scene_block_keys() {
  using enum SceneType;
  const std::string count = fmt::format("from 1 to {}", most_scene_bodies);
  return {
      {"repeat", "name", text, "", "", "its bodies are name.1, name.2, ...", "The kind of the table"},
      {"link", "from", point, "m", "", "where it begins", "required"},
      {"link", "to", point, "m", "", "where it ends", "required"},
      {"link", "radius", number, "m", "> 0", "half of its thickness", "0.1"},
      {"stack", "n", integer, "", count, "how many", "required"},
      {"stack", "position", point, "m", "", "of the middle of its foot", "[0, 0]"},
      {"stack", "offset", number, "m", "", "alternately to the left and to the right", "0"},
      {"pyramid", "n", integer, "", fmt::format("from 1 to {}", most_pyramid_rows()), "rows", "required"},
      {"pyramid", "position", point, "m", "", "of the middle of its foot", "[0, 0]"},
      {"pyramid", "spacing", number, "m", "> 0", "from middle to middle", "Width of a box + 0.1"},
      {"row", "n", integer, "", count, "bodies in a row", "required"},
      {"row", "position", point, "m", "", "of the middle of the first row; or give first"},
      {"row", "first", point, "m", "", "of the first body; or give position"},
      {"row", "step", point, "m", "", "from a body to the next", "required"},
      {"row", "rows", integer, "", count, "how many", "1"},
      {"row", "row_step", point, "m", "", "from a row to the next", "[0, 1]"},
      {"row", "stagger", point, "m", "", "every other row is moved by this", "[0, 0]"},
      {"row", "every", integer, "", fmt::format("from 0 to {}", most_scene_bodies),
       "the other shape comes once in so many; 0: never", "0"},
      {"row", "other", table, "", "shape", "the other shape"},
      {"row", "joint", one_of({"none", "pin", "weld", "rod"}), "", "",
       "joins each body to the next, and to that of the next row: halfway, or by a rod", "none"},
      {"pile", "n", integer, "", count, "how many", "required"},
      {"pile", "columns", integer, "", count, "bodies in a row", "required"},
      {"pile", "first", point, "m", "", "the lowest one on the left", "required"},
      {"pile", "step", point, "m", "", "to the right, and to the next row", "required"},
      {"pile", "jitter", number, "m", ">= 0", "to the left or right at most", "0"},
      {"pile", "spread", number, "m", ">= 0", "radius or sides are larger by up to this", "0"},
      {"pile", "seed", integer, "", "from 0 to 1000000", "another seed makes another pile", "0"},
      {"arch", "n", integer, "", fmt::format("from 2 to {}", most_scene_bodies), "stones", "required"},
      {"arch", "position", point, "m", "", "of the middle of its foot", "[0, 0]"},
      {"arch", "radius", number, "m", "> 0", "of its middle line", "required"},
      {"arch", "thickness", number, "m", "> 0", "less than twice the radius", "required"},
      {"dominoes", "n", integer, "", count, "how many", "required"},
      {"dominoes", "position", point, "m", "", "of the middle of its foot", "[0, 0]"},
      {"dominoes", "box", point, "m", "> 0", "width and height of one", "[0.2, 1.4]"},
      {"dominoes", "step", number, "m", "> 0", "from one to the next", "0.7"},
      {"dominoes", "lean", number, "rad", "from 0 to 1.5", "of the first one, towards the others", "0"},
  };
}

List<SceneKey> scene_hanging_keys() {
  using enum SceneType;
  const std::string count = fmt::format("from 1 to {}", most_scene_bodies);
  return {
      {"cards", "n", integer, "", fmt::format("from 1 to {}", most_storeys()), "storeys", "required"},
      {"cards", "position", point, "m", "", "of the middle of its foot", "[0, 0]"},
      {"cards", "card", point, "m", "> 0", "thickness and length of a card", "[0.04, 1]"},
      {"cards", "lean", number, "rad", "from 0.01 to 1.5", "from the vertical", "0.3"},
      {"cards", "board", number, "m", "> 0", "thickness of the boards between the storeys", "0.05"},
      {"cradle", "n", integer, "", count, "balls", "required"},
      {"cradle", "position", point, "m", "", "of the middle of the points they hang from", "[0, 0]"},
      {"cradle", "radius", number, "m", "> 0", "of a ball", "0.5"},
      {"cradle", "gap", number, "m", ">= 0", "between two balls", "0.004"},
      {"cradle", "rod", number, "m", "> 0", "length", "3"},
      {"cradle", "aside", number, "rad", "from -1.5 to 1.5", "of the first; negative: to the left", "0"},
      {"chain", "n", integer, "", count, "bodies", "required"},
      {"chain", "from", point, "m", "", "where it begins", "[0, 0]"},
      {"chain", "to", point, "m", "", "where it ends; or give link and angle"},
      {"chain", "angle", number, "rad", "", "from hanging straight down; positive: to the right", "0"},
      {"chain", "link", number, "m", "> 0", "length of a link, or of the way to the next body"},
      {"chain", "thickness", number, "m", "> 0", "of a link without a shape of its own", "0.12"},
      {"chain", "a", text, "", "", "what its beginning is joined to", "ground"},
      {"chain", "b", text, "", "", "what its end is joined to; without it the end is free"},
      {"chain", "joint", one_of({"pin", "weld", "rod", "rope", "spring"}), "", "",
       "pin, weld: links that meet. The others: bodies apart, with a shape of their own", "pin"},
      {"chain", "length", number, "m", "> 0", "of a rod, rope or spring", "As far as it is"},
      {"chain", "softness", table, "", "softness", "of a spring or rope"},
      {"chain", "aside", number, "m", "", "its middle is drawn aside; with rods, ropes and springs", "0"},
      {"chain", "bob", table, "", "bob", "a disc at its end"},
      {"bob", "radius", number, "m", "> 0", "of the disc", "required"},
      {"bob", "ratio", number, "", "> 0", "its mass over that of a link"},
  };
}

}  // namespace cairn
