// Errors of answers to problems whose truth can be written down.
#include "../validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double truth_fall = test_gravity * test_dt;  // [m/s] g dt

/// Three boxes of 1 kg, one on the other, that have fallen for one step. The truth: all at rest, and
/// impulses of 3, 2 and 1 times m g dt.
VelocityProblem<double> fallen_stack() { return stack<double>(3); }

/// A ball of 2 kg, and a turning wheel of 4 kg m^2 that the third row brakes.
VelocityProblem<double> ball_and_wheel() {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId ball = add_body<double>(problem, 2, 1, {1, -3, 0});
  const BodyId wheel = add_body<double>(problem, 1, 4, {0, 0, 0.5});
  const int normal = add_row(problem, floor_row<double>(ball, 0));
  add_row(problem, floor_friction_row<double>(ball, 0, 0.5, normal));
  ConstraintRow<double> brake;
  brake.b = wheel;
  brake.jacobian_b = {0, 0, 1};
  brake.bounds = Bounds<double>::at_most(1);
  add_row(problem, brake);
  return problem;
}

}  // namespace

TEST_CASE("the norm of velocities is the square root of twice the kinetic energy") {
  const VelocityProblem<double> problem = ball_and_wheel();
  // 2 kg (1 + 9) m^2/s^2 + 4 kg m^2 (0.5 rad/s)^2
  CHECK(mass_norm(problem.velocity, problem.inverse_mass) ==
        doctest::Approx(std::sqrt(21.0)).epsilon(4 * double_epsilon));
  PerBody<Vec3<double>> other = problem.velocity;
  other[ground] = {7, 7, 7};  // of the ground: nothing moves it, and it counts nowhere
  CHECK(mass_distance(problem.velocity, other, problem.inverse_mass) == 0);
  other[{1}].x() += 2;
  CHECK(mass_distance(problem.velocity, other, problem.inverse_mass) ==
        doctest::Approx(std::sqrt(8.0)).epsilon(4 * double_epsilon));
  other.pop_back();
  CHECK_THROWS_AS(mass_distance(problem.velocity, other, problem.inverse_mass), std::invalid_argument);
}

TEST_CASE_TEMPLATE("E_M is 1 without impulses, 0 at the truth, and half where half is done", Real, float,
                   double, long double) {
  const VelocityProblem<Real> start = stack<Real>(3);
  const PerBody<Vec3<Real>> rest(4, Vec3<Real>::Zero());
  PerBody<Vec3<Real>> half = start.velocity;
  for (Vec3<Real>& v : half) v /= 2;
  const Real rounding = 8 * std::numeric_limits<Real>::epsilon();
  CHECK(std::abs(velocity_error(start, start.velocity, rest) - 1) <= rounding);
  CHECK(velocity_error(start, rest, rest) == 0);
  CHECK(std::abs(velocity_error(start, half, rest) - Real(0.5)) <= rounding);
}

TEST_CASE("E_M is 0 where nothing was to be done, and infinite where something was done to bodies at rest") {
  VelocityProblem<double> start = fallen_stack();
  for (Vec3<double>& v : start.velocity) v.setZero();
  PerBody<Vec3<double>> moved = start.velocity;
  CHECK(velocity_error(start, moved, start.velocity) == 0);
  moved[{2}].x() = 1;
  CHECK(std::isinf(velocity_error(start, moved, start.velocity)));
}

TEST_CASE("E_M sees no impulse that moves nothing, and takes no NaN for an answer") {
  VelocityProblem<double> start = empty_problem<double>();
  const BodyId box = add_body<double>(start, 1, 1.0 / 6, {0, -truth_fall, 0});
  for (const double x : {-0.5, 0.0, 0.5}) add_row(start, floor_row(box, x));
  // Three feet, and two ways to share the weight.
  for (const PerRow<double>& share : {PerRow<double>{0, 1, 0}, PerRow<double>{0.5, 0, 0.5}}) {
    PerRow<double> impulse;
    for (const double part : share) impulse.push_back(part * truth_fall);
    const VelocityProblem<double> answer = with_impulses(start, impulse);
    const PerBody<Vec3<double>> rest(2, Vec3<double>::Zero());
    CHECK(velocity_error(start, answer.velocity, rest) <= 8 * double_epsilon);
  }
  PerBody<Vec3<double>> broken = start.velocity;
  broken[{1}].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(velocity_error(start, broken, start.velocity)));
}

TEST_CASE("velocities from impulses are v_free + M^-1 J^T lambda") {
  const VelocityProblem<double> answer = with_impulses(ball_and_wheel(), {6, -1, -2});
  CHECK(answer.velocity[{1}] == Vec3<double>(0.5, 0, 0));
  CHECK(answer.velocity[{2}] == Vec3<double>(0, 0, 0));
  CHECK(answer.impulse == PerRow<double>{6, -1, -2});
  CHECK_THROWS_AS(with_impulses(ball_and_wheel(), {6, -1}), std::invalid_argument);
}

TEST_CASE("the drift of velocities from impulses is their distance, as a part of what the impulses did") {
  const VelocityProblem<double> start = ball_and_wheel();
  VelocityProblem<double> answer = with_impulses(start, {6, -1, -2});
  CHECK(impulse_drift(start, answer) == 0);
  CHECK(impulse_drift(start, start) == 0);  // nothing done, and nothing said
  answer.velocity[{1}].y() = 1e-3;
  // ||v - v(lambda)||_M = 1e-3 sqrt(2), ||v_free - v||_M^2 = 2 (0.5^2 + 3.001^2) + 4 0.5^2
  const double done = std::sqrt(2 * (0.25 + 3.001 * 3.001) + 1);
  CHECK(impulse_drift(start, answer) == doctest::Approx(1e-3 * std::sqrt(2.0) / done).epsilon(1e-12));
}

TEST_CASE("sequential impulses in float let velocities drift from impulses by roundings, in double too") {
  const auto drift_after = [](auto real, int sweeps) {
    using Real = decltype(real);
    const VelocityProblem<Real> start = stack<Real>(10);
    VelocityProblem<Real> answer = start;
    SequentialImpulse<Real>({.iterations = sweeps}).solve(answer);
    return impulse_drift(start, answer) / std::numeric_limits<Real>::epsilon();
  };
  // A rounding for each of 10 rows and 100 sweeps at most; and some there must be in so many.
  for (const double drift : {static_cast<double>(drift_after(float(0), 100)), drift_after(0.0, 100)}) {
    CHECK(drift <= 1000);
    CHECK(drift > 0);
  }
}

TEST_CASE("the gap is the work of impulses at rows that move, and of room that friction leaves unused") {
  // The ball is lifted at 1 m/s by a contact that still presses with 8 N s: 8 J that no contact can do. It
  // slides at 0.5 m/s with friction -1 of -4 N s: 0.5 m/s times 3 N s to the lower bound, 1.5 J. The wheel
  // turns backwards at -0.5 rad/s with 1 - -0.25 N m s to the upper bound of the brake: 0.625 J.
  VelocityProblem<double> answer = ball_and_wheel();
  answer.impulse = {8, -1, -0.25};
  answer.velocity[{1}] = {0.5, 1, 0};
  answer.velocity[{2}].z() = -0.5;
  CHECK(complementarity_gap(answer) == doctest::Approx(8 + 1.5 + 0.625).epsilon(4 * double_epsilon));
  // What sinks into the floor is no gap, for the upper bound is infinite.
  answer.velocity[{1}] = {0, -1, 0};
  answer.velocity[{2}].setZero();
  CHECK(complementarity_gap(answer) == 0);
  CHECK(answer_split(answer).primal == 1);
  answer.velocity[{1}].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(complementarity_gap(answer)));
  CHECK(std::isnan(answer_split(answer).primal));
  CHECK(std::isnan(answer_split(answer).complementarity));
}

TEST_CASE("the split tells sinking, pulling, unfinished sliding and a violated cone from each other") {
  VelocityProblem<double> answer = ball_and_wheel();
  answer.velocity[{2}].setZero();

  answer.velocity[{1}] = {0, -0.25, 0};  // sinks, though everything else is right
  answer.impulse = {8, 0, 0};
  CHECK(answer_split(answer).primal == 0.25);
  CHECK(answer_split(answer).dual == 0);
  CHECK(answer_split(answer).complementarity == 0);

  answer.velocity[{1}].setZero();
  answer.impulse = {-2, 0, 0};  // pulls
  CHECK(answer_split(answer).primal == 0);
  CHECK(answer_split(answer).dual == 2);
  CHECK(answer_split(answer).cone == 0);

  answer.velocity[{1}] = {0.5, 0, 0};  // slides at 0.5 m/s and 2 kg: asks for 1 N s more, and may have 3
  answer.impulse = {8, -1, 0};
  CHECK(answer_split(answer).primal == 0);
  CHECK(answer_split(answer).dual == 0);
  CHECK(answer_split(answer).complementarity == 1);

  answer.velocity[{1}].setZero();
  answer.impulse = {8, 5, 0};  // 1 N s beyond a cone of 4
  CHECK(answer_split(answer).dual == 1);
  CHECK(answer_split(answer).cone == doctest::Approx(0.25).epsilon(1e-11));  // 1e-12 max |lambda| beside 4
  answer.impulse = {0, 5, 0};  // friction of a contact that is not there: 5 / (0 + 5e-12)
  CHECK(answer_split(answer).cone == doctest::Approx(1e12).epsilon(8 * double_epsilon));
}

TEST_CASE("a joint that moves apart is primal, whichever way, and has no gap") {
  for (const double speed : {-2.0, 2.0}) {
    VelocityProblem<double> answer = empty_problem<double>();
    const BodyId bead = add_body<double>(answer, 1, 1, {0, speed, 0});
    add_row(answer, vertical_row<double>(ground, bead, Bounds<double>::equality()));
    answer.impulse[0] = 3;
    CHECK(answer_split(answer).primal == 2);
    CHECK(answer_split(answer).dual == 0);
    CHECK(complementarity_gap(answer) == 0);
  }
}

TEST_CASE("a soft row lacks j v + gamma lambda - bias") {
  VelocityProblem<double> answer = empty_problem<double>();
  const BodyId bead = add_body<double>(answer, 1, 1, {0, 2, 0});
  ConstraintRow<double> spring = vertical_row<double>(ground, bead, Bounds<double>::equality());
  spring.softness = 0.5;
  spring.bias = 1;
  add_row(answer, spring);
  answer.impulse[0] = -2;
  CHECK(row_velocity_error(answer, 0) == 0);  // 2 + 0.5 (-2) - 1
  answer.impulse[0] = 4;
  CHECK(row_velocity_error(answer, 0) == 3);
  CHECK(natural_correction(answer, 0) == 2);  // 3 m/s over A_ii = 1 + 0.5 per kg
}

TEST_CASE("the speed of a row on angles counts with the length of what it turns") {
  VelocityProblem<double> answer = ball_and_wheel();
  answer.velocity[{1}].setZero();
  answer.impulse = {0, 0, 0};
  // The brake of 1 N m s at 4 kg m^2 changes 0.25 rad/s of the wheel's 0.5.
  CHECK(worst_row_speed(answer, {9, 9, 3}) == 0.75);
  answer.velocity[{1}] = {0, -2, 0};
  CHECK(worst_row_speed(answer, {9, 9, 3}) == 2);  // a row in metres has no need of a length
  CHECK(worst_row_speed(answer, {9, 9, 100}) == 25);
  CHECK_THROWS_AS(worst_row_speed(answer, {9, 9}), std::invalid_argument);
}

TEST_CASE("all errors of an answer are 0 at the truth, and each at both velocities where they differ") {
  const VelocityProblem<double> start = fallen_stack();
  VelocityProblem<double> answer = with_impulses(start, {3 * truth_fall, 2 * truth_fall, truth_fall});
  for (Vec3<double>& v : answer.velocity) v.setZero();
  const PerBody<Vec3<double>> rest(4, Vec3<double>::Zero());
  const AnswerError<double> none = answer_error<double>(start, answer, rest);
  CHECK(none.returned.energy == 0);
  CHECK(none.from_impulses.energy <= 8 * double_epsilon);
  CHECK(none.drift <= 8 * double_epsilon);
  CHECK(none.gap == 0);
  CHECK(none.split.primal == 0);
  CHECK(none.velocity == 0.0);

  answer.impulse = {0, 0, 0};  // says that it did nothing
  const AnswerError<double> liar = answer_error(start, answer);
  CHECK(liar.returned.energy == 0);
  CHECK(liar.from_impulses.energy == doctest::Approx(1).epsilon(4 * double_epsilon));
  CHECK(liar.drift == doctest::Approx(1).epsilon(4 * double_epsilon));
  CHECK_FALSE(liar.velocity.has_value());
  CHECK_THROWS_AS(answer_error(stack<double>(2), answer), std::invalid_argument);
}
