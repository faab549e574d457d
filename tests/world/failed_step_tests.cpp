// A step in which the solver or the observer throws is not done.
#include "leaning_wall.hpp"
#include "yard.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Throws in one of the sweeps that it sees.
class ThrowingObserver final : public SolveObserver<double> {
 public:
  explicit ThrowingObserver(int sweeps) : left_(sweeps) {}
  void after_sweep(int, const VelocityProblem<double>&) override {
    if (--left_ == 0) throw std::runtime_error("seen enough");
  }

 private:
  int left_ = 0;
};

/// A wide solver that throws in one of its solves, as one that is given more rows than it takes.
class ThrowingSolver final : public Solver<double> {
 public:
  explicit ThrowingSolver(int solves) : left_(solves) {}

  std::string name() const override { return "throwing"; }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* observer) override {
    const SolveReport report = wide_.solve(problem, observer);
    if (--left_ == 0) throw std::length_error("too many rows");
    return report;
  }
  bool takes_contacts() const override { return wide_.takes_contacts(); }

 private:
  int left_ = 0;
  WideSequentialImpulse<double> wide_{{.iterations = 4}};
};

struct FailingScene {
  Scene scene;
  std::function<void(World<double>&)> begin = [](World<double>&) {};
};

List<FailingScene> failing_scenes(int substeps) {
  List<FailingScene> cases;
  for (const ContactSearch search : every_search) {
    SceneSettings settings = {.substeps = substeps, .contact_search = search};
    cases.push_back({leaning_wall(settings)});
    settings.stabilization.policy = StabilizationPolicy::soft;
    cases.push_back({leaning_wall(settings)});
    settings.sleeping = Sleeping{};
    Scene yard = Yard(settings).scene;
    for (int i = 0; i < 4; ++i) yard.add({.time = 0.5 + 0.1 * i, .action = RemoveBody{BodyId{1 + i}}});
    cases.push_back({yard, [](World<double>& world) {
                       world.move_hand(HandInput::grab({.body = BodyId{9}, .target = {3, 7}}));
                     }});
  }
  return cases;
}

/// As far as they are the same whatever becomes of the impulses.
void check_same_start(const World<double>& one, const World<double>& other) {
  CHECK(go_alike(one, other));
  CHECK(one.hand().inputs().size() == other.hand().inputs().size());
  CHECK((one.hand().joint() == nullptr) == (other.hand().joint() == nullptr));
  CHECK(one.scene().events().size() == other.scene().events().size());
}

void check_same_future(World<double> one, World<double> other) {
  WideSequentialImpulse<double> solver({.iterations = 4}), same({.iterations = 4});
  for (int step = 0; step < 4; ++step) {
    one.step(solver);
    other.step(same);
    check_same_record(with_rows(one), with_rows(other));
    CHECK(go_alike(one, other));
  }
}

/// Calls try_step(world) after every seventh step, which must throw.
template <typename Error, typename Try>
void check_steps_that_throw(int substeps, const Try& try_step) {
  for (const FailingScene& one : failing_scenes(substeps)) {
    World<double> world(one.scene);
    one.begin(world);
    WideSequentialImpulse<double> solver({.iterations = 4});
    for (int step = 1; step <= 56; ++step) {
      world.step(solver);
      if (step % 7 > 0) continue;
      const World<double> before = world;
      CHECK_THROWS_AS(try_step(world), Error);
      check_same_start(world, before);
      if (substeps == 1) check_same_future(world, before);
    }
  }
}

}  // namespace

TEST_CASE("a world whose observer throws goes on as if its step had never been tried") {
  check_steps_that_throw<std::runtime_error>(1, [](World<double>& world) {
    SequentialImpulse<double> solver({.iterations = 4});
    ThrowingObserver observer(3);
    world.step(solver, &observer);
  });
}

TEST_CASE("a world whose solver throws goes on as if its step had never been tried") {
  check_steps_that_throw<std::length_error>(1, [](World<double>& world) {
    ThrowingSolver solver(1);
    world.step(solver);
  });
}

TEST_CASE("where a later substep throws, bodies, time, events and hand are where the step began") {
  for (const int substep : {1, 2, 3}) {
    check_steps_that_throw<std::length_error>(3, [substep](World<double>& world) {
      ThrowingSolver solver(substep);
      world.step(solver);
    });
    check_steps_that_throw<std::runtime_error>(3, [substep](World<double>& world) {
      SequentialImpulse<double> solver({.iterations = 4});
      ThrowingObserver observer(4 * substep - 1);
      world.step(solver, &observer);
    });
  }
}

TEST_CASE("the last step of a world whose step was not done is empty, or still the one before") {
  for (const FailingScene& one : failing_scenes(1)) {
    World<double> world(one.scene);
    WideSequentialImpulse<double> solver({.iterations = 4});
    for (int step = 0; step < 35; ++step) {
      ThrowingSolver throwing(1);
      const int rows = with_rows(world).problem.row_count();
      CHECK_THROWS_AS(world.step(throwing), std::length_error);
      const int left = with_rows(world).problem.row_count();
      CHECK((left == 0 || left == rows));
      CHECK(snapshot(world).bodies.size() == world.bodies().pose.size());
      world.step(solver);
    }
  }
}

TEST_CASE("a solver whose observer has thrown solves on as a new one does") {
  World<double> world(leaning_wall({}));
  take_steps(world, 40);
  for (const Momentum momentum : {Momentum::none, Momentum::nesterov}) {
    WideSequentialImpulse<double> used({.iterations = 4}, momentum), fresh({.iterations = 4}, momentum);
    VelocityProblem<double> tried = world.velocity_problem(), again = tried, expected = tried;
    used.solve(again);
    again = tried;
    ThrowingObserver observer(2);
    CHECK_THROWS_AS(used.solve(tried, &observer), std::runtime_error);
    used.solve(again);
    fresh.solve(expected);
    CHECK(again.impulse == expected.impulse);
    CHECK(again.velocity == expected.velocity);
  }
}
