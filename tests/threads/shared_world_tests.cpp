// What worlds share, and what may be read, on several threads at a time: to the bits of one thread. Under
// `bash tests/run tsan` nothing may be read while it is written, either.
#include <atomic>
#include <thread>

#include <cairn/measure/fingerprint.hpp>
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

const int thread_count = 4;

/// Calls job(i) for i from 0 on, each on a thread of its own, once all threads are there.
template <typename Job>
void on_threads(const Job& job) {
  std::atomic<int> waiting = thread_count;
  List<std::jthread> threads;
  for (int i = 0; i < thread_count; ++i) {
    threads.push_back(std::jthread([&job, &waiting, i] {
      for (--waiting; waiting > 0;) std::this_thread::yield();
      job(i);
    }));
  }
}

/// Boxes that lean on each other, and where asked for a chain, which goes in mid-run.
Scene scene_to_share(bool with_chain, ContactSearch search) {
  SceneSettings settings = {.substeps = 2, .contact_search = search};
  settings.stabilization.policy = StabilizationPolicy::soft;
  Scene scene(settings);
  scene.add_ground();
  for (int i = 0; i < 12; ++i) {
    scene.add({.shapes = {box(1, 0.8)}, .position = {1.1 * (i % 4) + 0.2 * (i / 4), 0.4 + 0.8 * (i / 4)}});
  }
  if (with_chain) samples::add_chain(scene, 4, {.shapes = {box(1, 0.2)}, .position = {8.5, 4}}, {1, 0});
  scene.add({.time = 0.1, .action = RemoveBody{BodyId{5}}});
  return scene;
}

/// What comes of a world after some steps, a push, an edit and a hand; another for each number.
std::uint64_t run_to_an_end(World<double> world, int number) {
  WideSequentialImpulse<double> wide({.iterations = 4});
  SequentialImpulse<double> plain({.iterations = 4});
  for (int step = 0; step < 15; ++step) {
    if (step == 4) world.set_velocity(BodyId{1 + number}, {0, 1, 0});
    if (step == 8) world.edit([number](Scene& scene) { scene.remove(BodyId{7 + number}); });
    if (step == 12) world.move_hand(HandInput::grab({.body = BodyId{2}, .target = {0, 4.0 + number}}));
    world.step(number % 2 == 0 ? static_cast<Solver<double>&>(wide) : plain);
  }
  return fingerprint_of(snapshot(world));
}

List<Scene> scenes_to_share() {
  List<Scene> scenes;
  for (const ContactSearch search : {ContactSearch::every_substep, ContactSearch::when_moved}) {
    for (const bool with_chain : {false, true}) scenes.push_back(scene_to_share(with_chain, search));
  }
  return scenes;
}

}  // namespace

TEST_CASE("copies of a world are stepped, edited and read on several threads as on one") {
  for (const Scene& scene : scenes_to_share()) {
    World<double> world(scene);
    WideSequentialImpulse<double> solver({.iterations = 4});
    for (int step = 0; step < 3; ++step) world.step(solver);
    List<std::uint64_t> found(thread_count, 0), expected(thread_count, 0);
    for (int i = 0; i < thread_count; ++i) expected[i] = run_to_an_end(world, i);
    on_threads([&](int i) { found[i] = run_to_an_end(world, i); });
    CHECK(found == expected);
  }
}

TEST_CASE("worlds of one scene are made and stepped on several threads as on one") {
  for (const Scene& scene : scenes_to_share()) {
    List<std::uint64_t> found(thread_count, 0), expected(thread_count, 0);
    for (int i = 0; i < thread_count; ++i) expected[i] = run_to_an_end(World<double>(scene), i);
    on_threads([&](int i) { found[i] = run_to_an_end(World<double>(scene), i); });
    CHECK(found == expected);
  }
}

TEST_CASE("a world that nobody changes is read and copied by several threads, its last step too") {
  for (const Scene& scene : scenes_to_share()) {
    World<double> world(scene);
    WideSequentialImpulse<double> solver({.iterations = 4});
    for (int step = 0; step < 5; ++step) {
      world.step(solver);
      const World<double> alone = world;
      const std::uint64_t expected = fingerprint_of(snapshot(alone));
      const PerRow<double> impulses = alone.velocity_problem().impulse;
      std::atomic<int> alike = 0;
      on_threads([&](int i) {
        const World<double> copy = world;
        if (i % 2 == 0) alike += copy.velocity_problem().impulse == impulses ? 1 : 0;
        const bool same = with_rows(world).problem.impulse == with_rows(copy).problem.impulse;
        alike += same && fingerprint_of(snapshot(world)) == expected ? 1 : 0;
        if (i % 2 != 0) alike += world.velocity_problem().impulse == impulses ? 1 : 0;
      });
      CHECK(alike == 2 * thread_count);
    }
  }
}

TEST_CASE("copies of a scene are changed on several threads, and no other sees it") {
  const Scene scene = scene_to_share(true, ContactSearch::every_substep);
  List<Scene> copies(thread_count, scene);
  on_threads([&](int i) {
    Scene own = scene;
    for (int k = 0; k < 20; ++k) {
      displace(copies[i], BodyId{1 + i}, {0, 1});
      displace(own, BodyId{1}, {1, 0});
      own = copies[i];  // lets go of what others have
    }
  });
  for (int i = 0; i < thread_count; ++i) {
    for (int k = 0; k < thread_count; ++k) {
      const double moved = copies[i].bodies()[BodyId{1 + k}].pose.position.y() -
                           scene.bodies()[BodyId{1 + k}].pose.position.y();
      CHECK(moved == doctest::Approx(i == k ? 20 : 0));
    }
  }
}
