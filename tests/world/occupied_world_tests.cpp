// Whoever is called by a world may not change it meanwhile: every change is refused by name, and nothing is
// lost.
#include "yard.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

struct NamedChange {
  std::string name = {};  // that a refusal begins with
  std::function<void(World<double>&)> make = {};
};

/// All there are.
List<NamedChange> every_change() {
  static SequentialImpulse<double> solver({.iterations = 2});
  return {
      {"World::step", [](World<double>& world) { world.step(solver); }},
      {"World::set_dt", [](World<double>& world) { world.set_dt(0.01); }},
      {"World::set_velocity",
       [](World<double>& world) {
         world.set_velocity(BodyId{1}, {1, 2, 3});
       }},
      {"World::edit", [](World<double>& world) { world.edit([](Scene&) {}); }},
      {"World::move_hand",
       [](World<double>& world) { world.move_hand(HandInput::grab({.body = BodyId{1}})); }},
      {"World::move_hand", [](World<double>& world) { world.move_hand(HandInput::let_go()); }},
      {"World::operator=", [](World<double>& world) { world = World<double>(Yard().scene); }},
      {"World::operator=",
       [](World<double>& world) {
         const World<double> other(Yard().scene);
         world = other;
       }},
  };
}

/// What the change of a world is refused with; empty where it is made.
std::string occupied_refusal(const NamedChange& change, World<double>& world) {
  try {
    change.make(world);
  } catch (const std::invalid_argument&) {
    return "refused for another reason";
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

/// Tries one change of its world in every sweep.
struct Meddler final : SolveObserver<double> {
  World<double>& world;
  const NamedChange& change;
  std::string refusal = {};

  Meddler(World<double>& of, const NamedChange& what) : world(of), change(what) {}
  void after_sweep(int, const VelocityProblem<double>&) override {
    refusal = occupied_refusal(change, world);
  }
};

World<double> held_yard() {
  Scene scene = Yard().scene;
  scene.add({.time = 10.5 / 60, .action = RemoveBody{BodyId{3}}});
  World<double> world(scene);
  take_steps(world, 10);
  world.move_hand(HandInput::grab({.body = BodyId{2}, .target = {1, 5}}));
  return world;
}

}  // namespace

TEST_CASE("within an edit, every change of the same world is refused by name, and the edit is made") {
  for (const NamedChange& change : every_change()) {
    CAPTURE(change.name);
    World<double> world = held_yard(), expected = world;
    const auto remove = [](Scene& scene) { scene.remove(BodyId{5}); };
    world.edit([&](Scene& scene) {
      remove(scene);
      CHECK(occupied_refusal(change, world) ==
            change.name + ": not from within World::edit of the same world, which would lose it");
    });
    expected.edit(remove);
    CHECK(go_alike(world, expected));
    CHECK(world.hand().inputs().size() == expected.hand().inputs().size());
    CHECK(go_on_alike(world, expected, 5));
  }
}

TEST_CASE("a nested edit that nobody catches leaves the world as it was, and free") {
  World<double> world = held_yard(), untouched = world;
  const auto nested = [&](Scene& scene) {
    scene.remove(BodyId{4});
    world.edit([](Scene& inner) { inner.remove(BodyId{2}); });
  };
  CHECK_THROWS_AS(world.edit(nested), std::logic_error);
  CHECK(!world.scene().bodies()[BodyId{4}].removed);
  CHECK(go_alike(world, untouched));
  world.edit([](Scene& scene) { scene.remove(BodyId{4}); });
  CHECK(world.scene().bodies()[BodyId{4}].removed);
}

TEST_CASE("within a step, an observer's changes of its world are refused by name, and the step is taken") {
  for (const int steps_before : {0, 1}) {  // with the event that the step begins with, and behind it
    for (const NamedChange& change : every_change()) {
      CAPTURE(change.name);
      World<double> world = held_yard();
      take_steps(world, steps_before);
      World<double> expected = world;
      Meddler meddler(world, change);
      SequentialImpulse<double> solver({.iterations = 10});
      world.step(solver, &meddler);
      take_steps(expected, 1);
      CHECK(meddler.refusal ==
            change.name + ": not from within World::step of the same world, which would lose it");
      CHECK(go_alike(world, expected));
    }
  }
}

TEST_CASE("a copy of a world that is being edited is free, and so are other worlds") {
  for (const NamedChange& change : every_change()) {
    CAPTURE(change.name);
    World<double> world = held_yard(), other = world;
    world.edit([&](Scene&) {
      World<double> copy = world;
      CHECK(occupied_refusal(change, copy).empty());
      CHECK(occupied_refusal(change, other).empty());
      CHECK(copy.last_step().problem.row_count() >= 0);
      CHECK(world.velocity_problem().row_count() > 0);
    });
  }
}

TEST_CASE("a world that its own edit moves away is not edited") {
  World<double> world = held_yard();
  const World<double> before = world;
  World<double> away(Yard().scene);
  CHECK_THROWS_AS(world.edit([&](Scene&) { away = std::move(world); }), std::logic_error);
  CHECK(go_alike(away, before));
  world = before;  // it can be had again
  CHECK(go_on_alike(world, away, 1));
}
