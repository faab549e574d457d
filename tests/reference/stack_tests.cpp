// Stacks that stand for ten seconds in both engines, awake.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

constexpr int ten_seconds = 600;  // steps

/// How far a contact may let a box sink or float [m]: in Cairn it keeps up to its slop of overlap, in Box2D
/// the boxes may part as long as their skins touch.
struct Allowance {
  double sink = 0;
  double float_up = 0;
};
const Allowance cairn_allowance = {.sink = usual_slop};
const Allowance box2d_allowance = {.float_up = 2 * box2d_skin};

/// Whether a unit box kept its height in a pile, in a row counted from 1: so many contacts are below it.
bool kept_height(const Snapshot& snapshot, BodyId id, int row, const Allowance& allowance) {
  const double rise = body(snapshot, id).pose.position.y() - (row - 0.5);
  return rise >= -row * allowance.sink && rise <= row * allowance.float_up;
}

TEST_CASE("a stack of 10 boxes stands for 10 s in both engines, and straighter in Box2D") {
  const int boxes = 10;
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < boxes; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}});
  Engines engines(scene);
  double cairn_lean = 0;  // [m]
  double box2d_lean = 0;
  for (int step = 0; step < ten_seconds; ++step) {
    engines.step();
    cairn_lean = std::max(cairn_lean, std::abs(body(snapshot(engines.cairn), {boxes}).pose.position.x()));
    box2d_lean = std::max(box2d_lean, std::abs(body(engines.box2d.snapshot(), {boxes}).pose.position.x()));
  }
  // No box can tip while the top one is above the middle half of the lowest.
  CHECK(cairn_lean < 0.25);
  CHECK(box2d_lean < 0.25);
  // Ten sweeps over single rows leave the stack swaying; Box2D solves both points of an interface at once.
  CHECK(box2d_lean < cairn_lean);
  for (int row = 1; row <= boxes; ++row) {
    CAPTURE(row);
    CHECK(kept_height(snapshot(engines.cairn), {row}, row, cairn_allowance));
    CHECK(kept_height(engines.box2d.snapshot(), {row}, row, box2d_allowance));
  }
  CHECK(engines.box2d.is_awake({boxes}));
}

TEST_CASE("a pyramid of 10 rows stands for 10 s in both engines") {
  const int rows = 10;
  const double spacing = 1.1;  // [m], so that the skins of neighbours do not touch
  Scene scene;
  scene.add_ground();
  List<std::pair<int, double>> places;  // row and x of each box
  for (int row = 1; row <= rows; ++row) {
    for (int i = 0; i <= rows - row; ++i) {
      places.emplace_back(row, spacing * (i - (rows - row) / 2.0));
      scene.add({.shapes = {box(1, 1)}, .position = {places.back().second, row - 0.5}});
    }
  }
  Engines engines(scene);
  engines.step(ten_seconds);
  const Snapshot cairn = snapshot(engines.cairn);
  const Snapshot box2d = engines.box2d.snapshot();
  for (int i = 0; i < places.size(); ++i) {
    const auto& [row, x] = places[i];
    const BodyId id = {i + 1};
    CAPTURE(id.index);
    CHECK(kept_height(cairn, id, row, cairn_allowance));
    CHECK(kept_height(box2d, id, row, box2d_allowance));
    // Less than half the gap to the next box: no row has spread.
    CHECK(std::abs(body(cairn, id).pose.position.x() - x) < (spacing - 1) / 2);
    CHECK(std::abs(body(box2d, id).pose.position.x() - x) < (spacing - 1) / 2);
  }
}

}  // namespace

}  // namespace cairn::reference_tests
