#include "fuzz/random_world.hpp"

#include <memory>
#include <optional>
#include <stdexcept>

#include "fuzz/choices.hpp"
#include "fuzz/random_scene.hpp"
#include "geometry/random_shapes.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>

namespace cairn::fuzz {

namespace {

const int most_rounds = 40;  // of something that happens and a step
const int bytes_of_a_world = 2400;
const int most_counted_rows = 8;  // of a problem that the exact solver is given

struct SolverChoice {
  std::string name = "wide";
  SolverSettings settings = {};

  /// What NewtonSolver has kept makes other roundings.
  bool forgets() const { return name != "newton"; }
  template <Scalar Real>
  std::unique_ptr<Solver<Real>> make() const {
    return make_solver<Real>(name, settings);
  }
};

/// Every second time one that takes contacts as they are.
SolverChoice random_solver(Choices& choices) {
  SolverChoice solver;
  solver.settings.iterations = choices.below(12);
  if (choices.one_in(3)) solver.settings.tolerance = 1e-3;
  if (choices.one_in(5)) solver.settings.patience = 3;
  if (choices.one_in(4)) solver.settings.relaxation = choices.between(0.7, 1.5);
  if (choices.one_in(3)) solver.settings.order = static_cast<RowOrder>(choices.below(5));
  if (choices.one_in(2)) return solver;
  solver.name = solver_entries()[choices.below(solver_entries().size())].name;
  return solver;
}

struct Thrown {};

/// Throws in one of the sweeps that it sees.
template <Scalar Real>
class SweepThrower final : public SolveObserver<Real> {
 public:
  explicit SweepThrower(int sweeps) : left_(sweeps) {}
  void after_sweep(int, const VelocityProblem<Real>&) override {
    if (--left_ == 0) throw Thrown{};
  }

 private:
  int left_ = 0;
};

template <Scalar Real>
std::uint64_t bits_of_bodies(const World<Real>& world) {
  Fingerprint bits;
  bits.add(world.clock().time);
  bits.add(static_cast<double>(world.clock().steps));
  bits.add(world.clock().dt);
  for (const BodyId body : world.bodies().pose.indices()) {
    const Pose<Real>& pose = world.bodies().pose[body];
    if (!pose.position.allFinite() || !std::isfinite(pose.angle) ||
        !world.bodies().velocity[body].allFinite()) {
      throw Finding("body " + std::to_string(body.index) + " is not finite, and no report says so");
    }
    bits.add(pose.position);
    bits.add(pose.angle);
    bits.add(world.bodies().velocity[body]);
  }
  return bits.value();
}

template <Scalar Real>
void require_same_bodies(const World<Real>& one, const World<Real>& other, const char* what) {
  if (bits_of_bodies(one) != bits_of_bodies(other)) throw Finding(std::string("other bits: ") + what);
}

template <Scalar Real>
void require_same_bits(const World<Real>& one, const World<Real>& other, const char* what) {
  require_same_bodies(one, other, what);
  for (const BodyId body : one.bodies().pose.indices()) {
    if (one.is_awake(body) != other.is_awake(body)) throw Finding(std::string("only one is awake: ") + what);
  }
  if (fingerprint_of(snapshot(one)) == fingerprint_of(snapshot(other))) return;
  throw Finding(std::string("other bits of contacts or joints: ") + what);
}

/// A world, what happens to it, and who steps it.
template <Scalar Real>
class RandomWorld {
 public:
  RandomWorld(Choices& choices, const Scene& scene)
      : choices_(choices), world_(scene), solver_(choice_.make<Real>()) {}

  void run() {
    for (int round = 0; round < most_rounds && choices_.are_left(); ++round) {
      if (choices_.one_in(5)) take_solver();
      try {
        happen();
      } catch (const std::invalid_argument&) {  // refused, and nothing has changed
      }
      if (!take_step_or_refuse()) return;
      bits_of_bodies(world_);
    }
  }

 private:
  void take_solver() {
    choice_ = random_solver(choices_);
    solver_ = choice_.make<Real>();
  }

  Vec2<double> place() {
    const double x = choices_.between(-9, 9);
    return {x, choices_.between(-9, 9)};
  }

  /// What happens between two steps; mostly nothing.
  void happen() {
    const BodyId body = random_body(world_.scene(), choices_);
    switch (choices_.below(20)) {
      case 1:
        return world_.edit([this](Scene& scene) { edit_randomly(scene, choices_); });
      case 2:
        return world_.edit([this](Scene& scene) { change_rules(scene, choices_); });
      case 3:
        return push(body);
      case 4:
        return world_.set_dt(choices_.between(1e-4, 0.1));
      case 5:
      case 6:
        return grab(body);
      case 7:
        return world_.move_hand(HandInput::drag_to(place()));
      case 8:
        return world_.move_hand(HandInput::let_go());
      case 9:
        return wake(body);
      case 10:
        return go_on_as_copy();
      default:
        return;
    }
  }

  void push(BodyId body) {
    const double most = choices_.one_in(3) ? 100 : 3;
    const double x = choices_.between(-most, most), y = choices_.between(-most, most);
    world_.set_velocity(body, {x, y, choices_.between(-most, most)});
  }

  /// As it moves already; an unknown one is refused.
  void wake(BodyId body) {
    const PerBody<Vec3<Real>>& velocity = world_.bodies().velocity;
    const bool is_known = body.index >= 0 && body.index < velocity.size();
    world_.set_velocity(
        body, is_known ? Vec3<double>(velocity[body].template cast<double>()) : Vec3<double>(0, 0, 0));
  }

  void grab(BodyId body) {
    const Vec2<double> anchor = place();
    world_.move_hand(HandInput::grab({.body = body, .anchor = anchor, .target = place()}));
  }

  void go_on_as_copy() {
    World<Real> copy = world_;
    copy.step(stepper());
    world_ = copy;
  }

  /// The exact solver takes few rows only. How many a step has is known beforehand where it is solved once.
  Solver<Real>& stepper() {
    if (choice_.name != "reference") return *solver_;
    const bool is_short = world_.scene().settings().substeps == 1;
    if (is_short && world_.velocity_problem().row_count() <= most_counted_rows) return *solver_;
    choice_ = {};
    solver_ = choice_.make<Real>();
    return *solver_;
  }

  /// Whether it goes on.
  bool take_step() {
    switch (choices_.below(6)) {
      case 1:
        return step_beside_twin(false);
      case 2:
        return step_beside_twin(true);
      case 3:
        return step_that_throws();
      default:
        return !world_.step(stepper()).not_finite;
    }
  }

  /// An event is refused where a body has gone so far away that no world can be made with it.
  bool take_step_or_refuse() {
    try {
      return take_step();
    } catch (const std::invalid_argument&) {
      return false;
    }
  }

  void read(const World<Real>& world) {
    (void)world.velocity_problem();
    if (choices_.one_in(2)) (void)with_rows(world);
    if (choices_.one_in(2)) (void)snapshot(world);
  }

  /// A twin takes the same step by a solver of its own.
  bool step_beside_twin(bool reads_twin) {
    Solver<Real>& solver = stepper();
    World<Real> twin = world_;
    read(reads_twin ? twin : world_);
    const std::unique_ptr<Solver<Real>> other = choice_.make<Real>();
    const bool is_done = !twin.step(*other).not_finite;
    if (!choice_.forgets()) solver_ = choice_.make<Real>();
    const bool same_done = !world_.step(choice_.forgets() ? solver : *solver_).not_finite == is_done;
    if (!same_done) throw Finding("of a world and its twin, one has no finite numbers");
    if (!is_done) return false;
    require_same_bits(world_, twin, "of a world and its twin");
    return true;
  }

  bool step_that_throws() {
    const World<Real> before = world_;
    Solver<Real>& solver = stepper();
    SweepThrower<Real> thrower(1 + choices_.below(6));
    try {
      return !world_.step(solver, &thrower).not_finite;
    } catch (const Thrown&) {
    }
    require_same_bodies(world_, before, "behind a step that was not done");
    if (world_.scene().settings().substeps > 1) return true;
    World<Real> one = world_, other = before;
    SolverChoice plain;
    const std::unique_ptr<Solver<Real>> its = plain.make<Real>(), others = plain.make<Real>();
    const bool is_done = !one.step(*its).not_finite && !other.step(*others).not_finite;
    if (is_done) require_same_bits(one, other, "of a step behind one that was not done");
    return true;
  }

  Choices& choices_;
  World<Real> world_;
  SolverChoice choice_ = {};
  std::unique_ptr<Solver<Real>> solver_;
};

/// Refused where no world can be made of the scene.
template <Scalar Real>
Outcome run_world(Choices& choices) {
  const Scene scene = random_scene(choices);
  std::optional<RandomWorld<Real>> world;
  try {
    world.emplace(choices, scene);
  } catch (const std::invalid_argument& error) {
    return {.accepted = false, .message = error.what()};
  }
  world->run();
  return {.accepted = true};
}

}  // namespace

Outcome feed_world(const std::string& bytes) {
  Choices choices(bytes);
  return choices.one_in(4) ? run_world<float>(choices) : run_world<double>(choices);
}

std::string world_bytes(std::uint64_t number) {
  test::Random random(number);
  std::string bytes;
  for (int i = 0; i < bytes_of_a_world; ++i) bytes.push_back(static_cast<char>(random.below(256)));
  return bytes;
}

}  // namespace cairn::fuzz
