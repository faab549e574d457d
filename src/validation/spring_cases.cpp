// Floor 8. Springs, against their step by hand, continuous swings and statics: B27, B28 and B29.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/LU>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/math/check.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double bob_mass = 3;         // [kg]
const double unloaded_length = 2;  // [m], unloaded

/// A bob under the origin on a spring that is longer by `stretch` than unloaded.
Scene bob_on_spring(const Softness& softness, double stretch, double gravity, double dt) {
  Scene scene({.gravity = {0, -gravity}, .dt = dt});
  const Vec2<double> place(0, -unloaded_length - stretch);
  const BodyId bob = scene.add({.position = place, .mass = bob_mass, .fixed_rotation = true});
  scene.join<DistanceJoint>({.a = ground,
                             .b = bob,
                             .anchor_b = place,
                             .length = unloaded_length,
                             .kind = DistanceJoint::Kind::spring,
                             .softness = softness});
  return scene;
}

double stretch_of(const Motion& bob) { return -bob.position({1}).y() - unloaded_length; }

const int spring_beads = 5;

/// Five beads of 1 kg between two walls, on six springs of 1 N/m, in the shape of mode k: w = 2 sin(k pi /
/// 12).
Scene spring_chain(int mode, double amplitude, double dt) {
  const int n = spring_beads;
  Scene scene({.gravity = {0, 0}, .dt = dt});
  const SpringSoftness spring{.stiffness = 1};
  BodyId left = ground;
  Vec2<double> anchor = {0, 0};
  for (int i = 1; i <= n + 1; ++i) {
    const Vec2<double> place(i + amplitude * std::sin(i * mode * pi / (n + 1)), 0);
    const Vec2<double> end = i <= n ? place : Vec2<double>(n + 1, 0);
    const BodyId bead = i <= n ? scene.add({.position = place, .mass = 1, .fixed_rotation = true}) : ground;
    scene.join<DistanceJoint>({.a = left,
                               .b = bead,
                               .anchor_a = anchor,
                               .anchor_b = end,
                               .length = 1,
                               .kind = DistanceJoint::Kind::spring,
                               .softness = spring});
    left = bead;
    anchor = end;
  }
  return scene;
}

/// How far a mode of the chain is out: its part in the places of the beads [m].
double mode_part(const Motion& chain, int mode) {
  double part = 0;
  for (int i = 1; i <= spring_beads; ++i) {
    part += (chain.position({i}).x() - i) * std::sin(i * mode * pi / (spring_beads + 1));
  }
  return part * 2 / (spring_beads + 1);
}

using Beads = Eigen::Matrix<double, spring_beads, 1>;
using BeadMatrix = Eigen::Matrix<double, spring_beads, spring_beads>;

/// The step of all beads by hand: (1 + h^2 K_a) v' = (1 + h^2 K_b) v - h K x, with K = sum k j^T j over the
/// springs, and in K_a and K_b each spring times the a and the b of its own s = h^2 k j j^T (softness.hpp).
class BeadsByHand {
 public:
  BeadsByHand(const Beads& places, double h) : x_(places), h_(h) {
    BeadMatrix ahead = BeadMatrix::Identity(), behind = ahead;
    for (int i = 0; i <= spring_beads; ++i) {
      Beads j = Beads::Zero();
      if (i > 0) j(i - 1) = -1;
      if (i < spring_beads) j(i) = 1;
      const double s = h * h * j.squaredNorm(), share = 1 / (1 + s * s);
      stiffness_ += j * j.transpose();
      ahead += h * h * (1 - 3 * share / 4) * j * j.transpose();
      behind += h * h * share / 4 * j * j.transpose();
    }
    of_speed_ = ahead.inverse() * behind;
    of_place_ = -h * ahead.inverse() * stiffness_;
  }
  void step() {
    v_ = Beads(of_speed_ * v_ + of_place_ * x_);
    x_ += h_ * v_;
  }
  const Beads& places() const { return x_; }

 private:
  Beads x_;
  Beads v_ = Beads::Zero();
  double h_;
  BeadMatrix stiffness_ = BeadMatrix::Zero(), of_speed_, of_place_;
};

struct ModeRun {
  double frequency = 0;  // [rad/s] between the first and the last passage of the middle
  double off = 0;        // [m] the most that a bead is beside where the step by hand has it
};

const int mode_steps = 500;

ModeRun run_mode(const EngineMaker& make, int mode, double dt) {
  const double amplitude = 0.1;
  Motion chain(make, spring_chain(mode, amplitude, dt), 50);
  Beads places;
  for (int i = 1; i <= spring_beads; ++i) places(i - 1) = amplitude * std::sin(i * mode * pi / 6);
  BeadsByHand by_hand(places, dt);
  ModeRun result;
  List<double> passages;  // [s]
  for (int step = 0; step < mode_steps; ++step) {
    const double before = mode_part(chain, mode);
    chain.step();
    by_hand.step();
    const double after = mode_part(chain, mode);
    if (before * after <= 0) passages.push_back(chain.time() - dt * after / (after - before));
    for (int i = 1; i <= spring_beads; ++i)
      result.off = std::max(result.off, std::abs(chain.position({i}).x() - i - by_hand.places()(i - 1)));
  }
  if (passages.size() < 2) return {.frequency = std::numeric_limits<double>::quiet_NaN(), .off = result.off};
  result.frequency = (static_cast<double>(passages.size()) - 1) * pi / (passages.back() - passages.front());
  return result;
}

ValidationResult beads_on_springs(const EngineMaker& make) {
  ValidationResult result;
  const double dt = 0.02;
  Worst place;
  for (int mode = 1; mode <= spring_beads; ++mode) {
    const double omega = 2 * std::sin(mode * pi / 12), turn = omega * dt;
    const ModeRun got = run_mode(make, mode, dt);
    // It turns by 2 atan(w dt / 2) in a step, (w dt)^2 / 12 less than w dt.
    result.add(measured("mode " + std::to_string(mode) + " at 50 Hz", got.frequency, "rad/s")
                   .by("2 sqrt(k/m) sin(" + std::to_string(mode) + " pi/12)", omega)
                   .within_share(1.5 * turn * turn / 12, "1.5 (w dt)^2/12: a step turns by 2 atan(w dt/2)"));
    place.add(measured("beads beside the step by hand, worst of 5 modes and 500 steps", got.off, "m")
                  .by("(1 + h^2 K_a) v' = (1 + h^2 K_b) v - h K x", 0)
                  .within(64 * 6 * double_epsilon * mode_steps,
                          "64 roundings of lengths up to 6 m in each of 500 steps"));
  }
  result.add(place.number());
  return result;
}

/// The largest stretch of the tenth swing after the first, over that at the start.
double amplitude_after_ten_swings(const EngineMaker& make, double frequency, double hertz) {
  const double start = 0.25;
  Motion bob(make, bob_on_spring(SwingSoftness{.frequency = frequency}, start, 0, 1 / hertz), 1);
  bob.run(9.5 / frequency);
  double largest = 0;
  while (bob.time() < 10.5 / frequency) {
    bob.step();
    largest = std::max(largest, std::abs(stretch_of(bob)));
  }
  return largest / start;
}

void add_undamped_swings(const EngineMaker& make, double frequency, ValidationResult& result) {
  const double hertz = 240, turn = 2 * pi * frequency / hertz;
  // The place of the largest stretch is half a step away from a step at most, and that of the start likewise.
  result.add(measured("amplitude left after ten swings of " + shortest(frequency) + " Hz",
                      amplitude_after_ten_swings(make, frequency, hertz))
                 .by("1 - 10 pi (w h)^5", 1 - 10 * pi * std::pow(turn, 5))
                 .within(turn * turn / 4 + 0.1 * 10 * pi * std::pow(turn, 5),
                         "(w h)^2/4: the turning points lie between steps; a tenth of the loss"));
}

void add_stiff_step(const EngineMaker& make, ValidationResult& result) {
  const double start = 0.25, s = std::pow(2 * pi * 1e4 * standard_dt, 2);
  Motion bob(make, bob_on_spring(SwingSoftness{.frequency = 1e4}, start, 0, standard_dt), 1);
  bob.step();
  result.add(
      measured("stretch of an undamped spring of 10 kHz after one step of 1/60 s", stretch_of(bob), "m")
          .by("x/(1 + w^2 h^2)", start / (1 + s))
          .within(64 * double_epsilon * 2 + start / (s * s),
                  "64 roundings of a place of 2 m; 1/(w h)^4 of the middle of the step"));
}

/// How far a bob on a damped spring of 0.2 Hz is after 2 s from where it should be [m].
double damped_error(const EngineMaker& make, double zeta, double hertz) {
  const double swing = 0.2, omega = 2 * pi * swing, t = 2, start = 0.25;  // [Hz], [rad/s], [s], [m]
  const double damped = omega * std::sqrt(1 - zeta * zeta);
  const double ideal = start * std::exp(-zeta * omega * t) *
                       (std::cos(damped * t) + zeta / std::sqrt(1 - zeta * zeta) * std::sin(damped * t));
  Motion bob(make,
             bob_on_spring(SwingSoftness{.frequency = swing, .damping_ratio = zeta}, start, 0, 1 / hertz), 1);
  bob.run(t);
  return stretch_of(bob) - ideal;
}

ValidationResult damped_swing(const EngineMaker& make) {
  ValidationResult result;
  for (const double frequency : {0.5, 1.6, 5.0}) add_undamped_swings(make, frequency, result);
  add_stiff_step(make, result);
  result.convergence =
      converges("place of a spring of 0.2 Hz after 2 s, worse of zeta = 0 and 0.2", [&](double hertz) {
        return std::max(std::abs(damped_error(make, 0, hertz)), std::abs(damped_error(make, 0.2, hertz)));
      });
  return result;
}

ValidationResult static_sag(const EngineMaker& make) {
  const double stiffness = 150, seconds = 30;
  const std::string reason = "1e-9: swings fade by e^-25 and more in 30 s";
  Worst sag, load;
  for (const double damping : {5.0, 50.0}) {
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
      const SpringSoftness spring{.stiffness = stiffness, .damping = damping};
      Motion bob(make, bob_on_spring(spring, 0, standard_gravity, dt), 1);
      bob.run(seconds);
      sag.add(measured("sag, worst of two dampings and three steps", stretch_of(bob), "m")
                  .by("m g/k", bob_mass * standard_gravity / stiffness)
                  .within_share(1e-9, reason));
      load.add(measured("tension, worst of two dampings and three steps",
                        bob.now().joints[0].impulse.norm() / dt, "N")
                   .by("m g", bob_mass * standard_gravity)
                   .within_share(1e-9, reason));
    }
  }
  const double omega = 2 * pi * 2;
  const SwingSoftness swing{.frequency = 2, .damping_ratio = 0.7};
  Motion bob(make, bob_on_spring(swing, 0, standard_gravity, standard_dt), 1);
  bob.run(seconds);
  return {.numbers = {sag.number(), load.number(),
                      measured("sag of a spring given by its frequency of 2 Hz", stretch_of(bob), "m")
                          .by("g/w^2", standard_gravity / (omega * omega))
                          .within_share(1e-9, reason)}};
}

}  // namespace

void add_spring_cases(ValidationCases& cases) {
  cases.push_back({.id = "B27",
                   .title = "Five beads on springs swing in mode k with w = 2 sqrt(k / m) sin(k pi / 12)",
                   .source = "J. L. Lagrange, 1759",
                   .run = beads_on_springs});
  cases.push_back(
      {.id = "B28",
       .title =
           "A soft joint keeps the swings that steps can follow, takes others back, and converges like dt",
       .source = "N. Newmark, 1959; derived",
       .run = damped_swing});
  cases.push_back({.id = "B29",
                   .title = "A soft joint sags by m g / k, whatever its damping and the step",
                   .source = "R. Hooke, 1678",
                   .run = static_sag});
}

}  // namespace cairn
