// A steady step takes no memory from the heap: counted here, by standing in for the allocator.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdlib>
#include <new>

#include "solvers/solver_list.hpp"
#include <cairn/cairn.hpp>
#include <cairn/samples/samples.hpp>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CAIRN_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define CAIRN_TEST_SANITIZED 1
#endif
#endif
#if defined(__GLIBC__) && !defined(CAIRN_TEST_SANITIZED)
#define CAIRN_TEST_COUNTS_MALLOC 1
#endif

namespace {

// The one global that changes: an allocator has nowhere else to keep its count. Each thread has its own, and
// nothing is counted but while an AllocationCount lives.
thread_local long* allocation_counter = nullptr;

void count_allocation() {
  if (allocation_counter != nullptr) ++*allocation_counter;
}

/// Counts what this thread allocates while it lives.
class AllocationCount {
 public:
  AllocationCount() { allocation_counter = &count_; }
  ~AllocationCount() { allocation_counter = nullptr; }
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;
  long value() const { return count_; }

 private:
  long count_ = 0;
};

}  // namespace

#ifdef CAIRN_TEST_COUNTS_MALLOC
// glibc lets a program define malloc. Operator new calls it, and so does Eigen for matrices of any size: all
// that the heap gives is counted. What is returned is glibc's own memory, so that free stays as it is.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) noexcept {
  count_allocation();
  return __libc_malloc(size);
}
#else
// Elsewhere, and where a sanitizer has taken malloc for itself: operator new alone, which every container of
// the standard library uses. Eigen's matrices of any size, of which only dense PGS has some, are not seen.
void* operator new(std::size_t size) {
  count_allocation();
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  count_allocation();
  return std::malloc(size > 0 ? size : 1);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept { return operator new(size, tag); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
#endif

using namespace cairn;
using namespace cairn::testing;

namespace {

/// y_1 + 2 y_2 + y_3 stays what it is: a rope over and under rollers (paper 4.3), as a row of three bodies.
class ThreeBodyRope final : public ConstraintOf<ThreeBodyRope> {
 public:
  std::string name() const override { return "rope on three bodies"; }
  List<Attachment> attachments() const override { return {{{1}}, {{2}}, {{3}}}; }
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
    RowSpec<Real> row;
    row.a = {1};
    row.b = {2};
    row.error = at[{1}].position.y() + 2 * at[{2}].position.y() + at[{3}].position.y();
    row.jacobian_a = {0, 1, 0};
    row.jacobian_b = {0, 2, 0};
    row.extra[0] = {.body = {3}, .jacobian = {0, 1, 0}};
    row.extra_count = 1;
    rows.add(row);
  }
};

struct SceneToCount {
  std::string name = {};
  Scene scene;
};

/// So many shapes that their boxes are sorted.
Scene discs_to_count() {
  Scene scene;
  scene.add_ground();
  samples::add_line(scene, 40, {.shapes = {circle(0.4)}, .position = {-20, 0.4}}, {1, 0});
  return scene;
}

/// A chain with a motor and a limit within reach, beside a damped disc that rolls.
Scene chain_to_count() {
  Scene scene({.friction_rows = FrictionRows::per_manifold});
  scene.add_ground({.height = -20});
  BodyId above = ground;
  for (int i = 0; i < 6; ++i) {
    const BodyId link = scene.add({.shapes = {capsule({-0.3, 0}, {0.3, 0}, 0.1)}, .position = {i + 0.5, 0}});
    RevoluteJoint::Spec pin = {.a = above, .b = link, .anchor = {static_cast<double>(i), 0}};
    if (i == 0) pin.motor = RevoluteJoint::Motor{.speed = 0.5, .max_torque = 1};
    if (i == 1) pin.lower = -2, pin.limit_margin = 10;
    scene.join<RevoluteJoint>(pin);
    above = link;
  }
  scene.add(
      {.shapes = {circle(0.5)}, .position = {-5, -19.5}, .velocity = {1, 0}, .damping = {.angular = 0.1}});
  return scene;
}

Scene rope_to_count() {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    scene.add({.shapes = {box(0.5, 0.5)}, .position = {static_cast<double>(i), 0}, .mass = 1.0 + i});
  }
  scene.join(std::make_shared<const ThreeBodyRope>());
  return scene;
}

List<SceneToCount> scenes_to_count() {
  return {
      {"stack", samples::stack(10)},
      {"stack, soft", samples::stack(10, {.stabilization = {.policy = StabilizationPolicy::soft}})},
      {"stack, split", samples::stack(10, {.stabilization = {.policy = StabilizationPolicy::split_impulse}})},
      {"stack, substeps", samples::stack(10, {.substeps = 2})},
      {"pyramid", samples::pyramid({.base = 5, .pitch = 1.1})},
      {"discs, sorted", discs_to_count()},
      {"chain", chain_to_count()},
      {"rope", rope_to_count()},
  };
}

/// Of 5 steps, once 40 steps have made room for all that a step needs.
template <Scalar Real>
long allocations_of_steady_steps(const Scene& scene, Solver<Real>& solver) {
  World<Real> world(scene);
  for (int step = 0; step < 40; ++step) world.step(solver);
  const AllocationCount count;
  for (int step = 0; step < 5; ++step) world.step(solver);
  return count.value();
}

template <Scalar Real>
void check_steady_steps(const SceneToCount& one, const SolverSettings& settings) {
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    const auto solver = make(settings);
    CAPTURE(one.name);
    CAPTURE(solver->name());
    const long allocations = allocations_of_steady_steps<Real>(one.scene, *solver);
    CHECK(allocations == 0);
  }
}

}  // namespace

TEST_CASE("the counter of allocations counts, and only while it lives") {
  List<double> array;
  array.reserve(10);
  long before = -1, once = -1, twice = -1;
  {
    const AllocationCount count;
    before = count.value();
    array.reserve(100);
    once = count.value();
    array.reserve(200);
    twice = count.value();
  }
  CHECK(before == 0);
  CHECK(once == 1);
  CHECK(twice == 2);
}

#ifdef CAIRN_TEST_COUNTS_MALLOC
TEST_CASE("Newton's method kept warm takes no memory from the heap for a stack at rest, systems and all") {
  NewtonSolver<double> solver({.iterations = 30, .tolerance = 1e-9});
  CHECK(allocations_of_steady_steps<double>(samples::stack(10), solver) == 0);
  World<double> world(samples::stack(10));
  VelocityProblem<double> problem = world.velocity_problem(), harder = problem;
  for (Vec3<double>& velocity : harder.velocity) velocity.y() -= 1;
  solver.solve(problem);
  const AllocationCount count;
  CHECK(solver.solve(harder).iterations == 0);  // steps by kept factors
  CHECK(count.value() == 0);
}

TEST_CASE("the counter sees the matrices of Eigen, which do without operator new") {
  Vector<double> vector;
  long once = -1;
  {
    const AllocationCount count;
    vector.resize(100);
    once = count.value();
  }
  CHECK(once == 1);
}
#endif

TEST_CASE(
    "the scenes whose allocations are counted sort their boxes in one case, and compare all in others") {
  CHECK(make_plan(discs_to_count()).broadphase == BroadphaseKind::grid);
  CHECK(make_plan(samples::pyramid({.base = 5, .pitch = 1.1})).broadphase == BroadphaseKind::all_pairs);
}

TEST_CASE("a world that is new does allocate: the steps that are counted are those that follow") {
  World<double> world(samples::stack(10));
  SequentialImpulse<double> solver;
  long allocations = -1;
  {
    const AllocationCount count;
    world.step(solver);
    allocations = count.value();
  }
  CHECK(allocations > 0);
}

TEST_CASE("placing a body allocates nothing: no text is made for numbers that are right") {
  Scene scene = samples::stack(3);
  const Pose<double> pose = scene.bodies()[{1}].pose;
  const AllocationCount count;
  scene.place({1}, {pose.position + Vec2<double>(1, 0), 0.5}, {1, 2, 3});
  CHECK(count.value() == 0);
}

TEST_CASE_TEMPLATE("a steady step allocates nothing, whatever the scene, the policy and the solver", Real,
                   float, double) {
  for (const SceneToCount& one : scenes_to_count()) check_steady_steps<Real>(one, {.iterations = 4});
}

TEST_CASE_TEMPLATE("nor does one with an order of rows, a tolerance and patience", Real, float, double) {
  const SceneToCount one = {"pyramid", samples::pyramid({.base = 4, .pitch = 1.1})};
  for (const RowOrder order : {RowOrder::alternating, RowOrder::shuffled, RowOrder::coloured}) {
    check_steady_steps<Real>(
        one, {.iterations = 5, .tolerance = 1e-3, .order = order, .relaxation = 1.1, .patience = 2});
  }
}
