// What it takes to add a body to many.
#include <fmt/format.h>

#include "../table.hpp"
#include "peer_tables.hpp"

namespace cairn::bench {

namespace {

const int many = 20'000;
const int edits = 21;

/// Boxes 2 m apart, above each other in a hundred rows: they fall together, and touch nothing for a second.
Scene crowd() {
  Scene scene;
  scene.add_ground({.height = -50, .half_width = 300});
  for (int i = 0; i < many; ++i)
    scene.add({.shapes = {box(1, 1)}, .position = {2.0 * (i % 200), 2.0 * (i / 200)}});
  return scene;
}

void add_edits(const std::string& engine, const List<Phase>& edits_of, TextTable& table) {
  for (const Phase& edit : edits_of) {
    const Times time = times_of(edit.seconds);
    table.add({engine + ": " + edit.name, three_digits(1e6 * time.median),
               fmt::format("{} - {}", three_digits(1e6 * time.lower_quartile),
                           three_digits(1e6 * time.upper_quartile))});
  }
}

}  // namespace

void print_edits() {
  print_heading("5. One body more");
  fmt::print(
      "Medians of {} additions of a box to {} that fall, each alone. An edit of a running world of Cairn "
      "may\n"
      "change anything, and is undone as a whole where it fails; the step after it finds all pairs anew.\n\n",
      edits, grouped(many));
  TextTable table({{fmt::format("{} boxes", grouped(many)), ""}, {"time", "us"}, {"quartiles", "us"}});
  const Scene scene = crowd();
  const BodySpec added = {.shapes = {box(1, 1)}, .position = {-10, 0}};
  add_edits("Cairn", edits_of_cairn(scene, added, edits), table);
#ifdef CAIRN_PEER_BOX2D_3
  add_edits("Box2D 3", edits_of_box2d_3(scene, added, edits), table);
#endif
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
