// Solvers that take contacts as they are, and solvers that take rows, in one run: to the bits of rows alone.
#include "leaning_wall.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Boxes side by side, and two on top of two of them.
Scene boxes_side_by_side(const SceneSettings& settings) {
  Scene scene(settings);
  scene.add_ground({.material = {.friction = 0.6}});
  samples::add_line(scene, 10, samples::standing_box(), {2, 0});
  samples::add_line(scene, 2, {.shapes = {box(1, 1)}, .position = {0, 1.5}}, {2, 0});
  return scene;
}

List<SceneSettings> searches_in_substeps() {
  List<SceneSettings> all;
  for (const ContactSearch search : every_search) {
    for (const int substeps : {1, 3}) {
      all.push_back({.substeps = substeps, .contact_search = search});
      all.push_back(all.back());
      all.back().stabilization.policy = StabilizationPolicy::soft;
    }
  }
  return all;
}

}  // namespace

TEST_CASE("a solver with rows takes over from one with contacts, though what touched has gone apart") {
  for (const SceneSettings& settings : searches_in_substeps()) {
    WithRowsAndWithout<double> twins(boxes_side_by_side(settings));
    twins.steps(10);
    for (int i = 1; i <= 12; ++i) {
      twins.change([i](World<double>& world) { world.set_velocity(BodyId{i}, {0, 3, 0}); });
    }
    for (int step = 0; step < 60; ++step) {
      twins.step(true);
      twins.check_alike_ahead();
    }
  }
}

TEST_CASE("a hand takes hold of what rests on contacts without rows, lifts it and lets it go") {
  for (const SceneSettings& settings : searches_in_substeps()) {
    WithRowsAndWithout<double> twins(boxes_side_by_side(settings));
    for (int step = 0; step < 60; ++step) {
      if (step == 10) {
        twins.change([](World<double>& world) {
          world.move_hand(HandInput::grab({.body = BodyId{1}, .anchor = {0, 0.5}, .target = {0, 4}}));
        });
      }
      if (step == 40) twins.change([](World<double>& world) { world.move_hand(HandInput::let_go()); });
      twins.step();
      twins.check_alike_ahead();
    }
  }
}

TEST_CASE("two solvers by turns, with rows and without, lose none of the impulses of each other") {
  for (const SceneSettings& settings : searches_in_substeps()) {
    for (const Scene& scene : {boxes_side_by_side(settings), leaning_wall(settings)}) {
      WithRowsAndWithout<double> twins(scene);
      for (int step = 0; step < 40; ++step) {
        twins.step(step % 7 == 3 || step % 5 == 1);
        if (step % 9 == 0) twins.check_alike_ahead();
      }
      twins.check_alike_ahead();
    }
  }
}

TEST_CASE("after a step that ends in no number, the next one begins from the impulses before it") {
  const double most = std::numeric_limits<double>::max();
  for (const SceneSettings& settings : searches_in_substeps()) {
    Scene scene = boxes_side_by_side(settings);
    const BodyId lost = scene.add(
        {.shapes = {circle(0.1)}, .position = {0, 9}, .gravity_scale = 0, .filter = {.collides_with = 0}});
    WithRowsAndWithout<double> twins(scene);
    twins.steps(20);
    twins.change([&](World<double>& world) { world.set_velocity(lost, {most, 0, 0}); });
    int done = 0;
    const auto push = [&](World<double>& world) { world.set_velocity(BodyId{11}, {0, -0.01 * done, 0}); };
    do {  // other impulses in every step
      twins.change(push);
    } while (twins.step() && ++done < 100);
    REQUIRE(done < 100);
    twins.change([&](World<double>& world) { world.set_velocity(lost, {0, 0, 0}); });
    for (int step = 0; step < 5; ++step) {
      twins.step();
      twins.check_alike_ahead();
    }
  }
}
