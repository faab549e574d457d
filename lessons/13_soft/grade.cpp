// Exercise 13, graded: springs under 2 and 0.5 kg, and a mass on a soft row beside one on a spring in plain
// loops.
#include "exercise.cpp"

namespace cairn::exercise13 {
namespace {

constexpr double soft_rounding = 1e-12;  // a dozen operations on numbers up to 400

struct Case {
  double mass = 0;       // [kg]
  double frequency = 0;  // [Hz]
  double ratio = 0;
  double dt = 0;  // [s]
};

struct Spring {
  double stiffness = 0;  // [N/m]
  double damping = 0;    // [N s/m]
};

Spring spring_of(const Case& one, double omega) {
  return {one.mass * omega * omega, 2 * one.mass * one.ratio * omega};
}

Soft softness_of(const Spring& s, double dt) {
  return {1 / (dt * (s.damping + dt * s.stiffness)), dt * s.stiffness / (s.damping + dt * s.stiffness)};
}

/// Where the mass is after 50 steps with gravity, by a soft row.
double by_row(const Case& one, const Soft& soft) {
  double y = 0.1, v = 0;
  for (int step = 0; step < 50; ++step) {
    v -= 10 * one.dt;
    // j·v + γ impulse = −β c / dt, with c = y.
    const double impulse = (-soft.beta * y / one.dt - v) / (1 / one.mass + soft.gamma);
    v += impulse / one.mass;
    y += one.dt * v;
  }
  return y;
}

/// The same by implicit Euler: v' = v + dt (-g - k y'/m - d v'/m), y' = y + dt v'.
double by_spring(const Case& one, const Spring& s) {
  double y = 0.1, v = 0;
  for (int step = 0; step < 50; ++step) {
    v = (v - 10 * one.dt - one.dt * s.stiffness * y / one.mass) /
        (1 + one.dt * s.damping / one.mass + one.dt * one.dt * s.stiffness / one.mass);
    y += one.dt * v;
  }
  return y;
}

/// The softness of springs that are wrong, with what went wrong.
struct Wrong {
  Soft soft = {};
  std::string what = {};
};

List<Wrong> wrong_springs(const Case& one) {
  const double omega = 2 * pi * one.frequency;
  const Spring s = spring_of(one, omega);
  const auto soft = [&one](double stiffness, double damping) {
    return softness_of({stiffness, damping}, one.dt);
  };
  return {{softness_of(spring_of(one, one.frequency), one.dt), "omega is 2 pi times the frequency."},
          {soft(s.stiffness / one.mass, s.damping), "k has the mass in it: k = m omega squared."},
          {soft(s.stiffness, s.damping / one.mass), "d has the mass in it: d = 2 m (ratio) omega."},
          {soft(s.stiffness / one.mass, s.damping / one.mass), "k and d have the mass in them."},
          {soft(s.stiffness, s.damping / 2), "The damping is 2 m (ratio) omega: where is the 2?"},
          {soft(s.stiffness / omega, s.damping), "k has the square of omega."},
          {soft(s.stiffness / one.dt, s.damping), "In d + dt k stands the stiffness times dt."}};
}

void grade_spring(Grade& grade, const Case& one) {
  const Spring spring = spring_of(one, 2 * pi * one.frequency);
  const Soft right = softness_of(spring, one.dt), got = soften(one.mass, one.frequency, one.ratio, one.dt);
  const std::string name = std::to_string(one.mass).substr(0, 3) + " kg: ";
  ExpectedNumber gamma{
      .what = name + "gamma (1/kg)",
      .value = right.gamma,
      .tolerance = soft_rounding,
      .misconceptions = {
          {right.gamma * one.dt,
           "One dt is missing: an impulse is a force times dt, so 1 / (dt (d + dt k))."},
          {1 / right.gamma, "gamma is large for soft springs: the inverse."},
          {right.beta, "gamma and beta have changed places."},
          {1 / (one.dt * one.dt * spring.stiffness), "The damper stands beside dt k: d + dt k."}}};
  ExpectedNumber beta{
      .what = name + "beta",
      .value = right.beta,
      .tolerance = soft_rounding,
      .misconceptions = {{1 - right.beta, "That is what is left of the error, not what a step takes back."},
                         {spring.damping / (spring.damping + one.dt * spring.stiffness),
                          "That is what is left of the error, not what a step takes back."},
                         {right.beta / one.dt, "beta is a share, without a unit."}}};
  for (const Wrong& wrong : wrong_springs(one)) {
    gamma.misconceptions.push_back({wrong.soft.gamma, wrong.what});
    beta.misconceptions.push_back({wrong.soft.beta, wrong.what});
  }
  grade.number(gamma, got.gamma);
  grade.number(beta, got.beta);
  grade.number({.what = name + "height after 50 steps on the soft row (m)",
                .value = by_spring(one, spring),
                .tolerance = soft_rounding},
               by_row(one, got));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 13,
          .task = "gamma and beta of a spring: what makes a row soft.",
          .file = "lessons/13_soft/exercise.cpp",
          .hints = {"Implicit Euler: the force is -k (c + dt v') - d v' with the new v'. Write that as j·v' "
                    "+ gamma impulse = -beta c / dt.",
                    "Divide impulse = -dt k c - dt (d + dt k) v' by dt (d + dt k).",
                    "gamma = 1 / (dt (d + dt k)), beta = dt k / (d + dt k)."},
          .grade = [](Grade& grade) {
            grade_spring(grade, {.mass = 2, .frequency = 2, .ratio = 0.5, .dt = 0.02});
            grade_spring(grade, {.mass = 0.5, .frequency = 3, .ratio = 0.25, .dt = 0.01});
          }};
}

}  // namespace cairn::exercise13
