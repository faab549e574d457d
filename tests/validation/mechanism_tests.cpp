// Mechanisms, against the geometry that they are made for: a rotor, a slider-crank, Peaucellier's straight
// line and a falling spool.
#include "constraints/distance_joint.hpp"
#include "constraints/prismatic_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double mechanism_beta = 0.2;

/// The error that remains where a step turns an arm a little past where its tangent goes: a point that has
/// the acceleration a [m/s^2] across a row is a dt^2 / 2 off after a step, and beta of the error goes in one.
double steady_drift(double acceleration, double dt) { return acceleration * dt * dt / (2 * mechanism_beta); }

/// A bead on a rod of 1 m around the origin, without gravity, that is `radius` away and goes across at
/// `speed` [m/s].
World<double> rotor(double radius, double speed, double frequency) {
  Scene scene({.gravity = {0, 0}, .dt = 1 / frequency, .stabilization = {.baumgarte = mechanism_beta}});
  const BodyId bead =
      scene.add({.position = {radius, 0}, .velocity = {0, speed}, .mass = 2, .fixed_rotation = true});
  scene.join<DistanceJoint>({.a = ground, .b = bead, .anchor_b = {radius, 0}, .length = 1});
  return World(scene);
}

const double crank_radius = 0.3;    // [m] r
const double crank_rod = 1;         // [m] l
const double crank_speed = 2 * pi;  // [rad/s] w

/// How far the slider of a slider-crank is from r cos f + sqrt(l^2 - r^2 sin^2 f) at most, in two turns. The
/// crank turns at w around the origin; the slider runs along the x axis.
double slider_error(double frequency) {
  Scene scene({.dt = 1 / frequency, .stabilization = {.baumgarte = mechanism_beta}});
  const double r = crank_radius, l = crank_rod;
  const BodyId crank = scene.add({.type = BodyType::kinematic, .angular_velocity = crank_speed});
  const BodyId rod = scene.add({.position = {r + l / 2, 0}, .mass = 1, .inertia = l * l / 12});
  const BodyId slider = scene.add({.position = {r + l, 0}, .mass = 2, .inertia = 0.1});
  scene.join<RevoluteJoint>({.a = crank, .b = rod, .anchor = {r, 0}});
  scene.join<RevoluteJoint>({.a = rod, .b = slider, .anchor = {r + l, 0}});
  scene.join<PrismaticJoint>({.a = ground, .b = slider, .anchor = {r + l, 0}, .axis = {1, 0}});
  World world(scene);
  AcceleratedProjectedGaussSeidel<double> solver({.iterations = 1000, .tolerance = 1e-9});
  double largest = 0;
  const int steps = static_cast<int>(std::lround(2 * frequency));
  for (int step = 0; step < steps; ++step) {
    world.step(solver);
    const double f = pose_of(world, crank).angle;
    const double expected = r * std::cos(f) + std::sqrt(l * l - std::pow(r * std::sin(f), 2));
    largest = std::max(largest, std::abs(pose_of(world, slider).position.x() - expected));
  }
  return largest;
}

/// Checks that an error, given the steps per second, shrinks like dt^2: order 1.8 to 2.2 over two halvings.
void check_second_order(const std::function<double(double)>& error) {
  double coarse = error(120);
  for (const double frequency : {240.0, 480.0}) {
    const double fine = error(frequency);
    CAPTURE(frequency);
    CHECK(std::log2(coarse / fine) >= 1.8);
    CHECK(std::log2(coarse / fine) <= 2.2);
    coarse = fine;
  }
}

/// Peaucellier's inversor: two long bars from the origin to a and b, and four short ones that make the
/// rhombus q a r b. q goes around a circle through the origin, and r then stays on a straight line.
struct Inversor {
  double arm = 2.5;                                                         // [m]
  double side = 1.5;                                                        // [m]
  double circle = 0.7;                                                      // [m] radius
  double line() const { return (arm * arm - side * side) / (2 * circle); }  // x [m]
  Vec2<double> q(double angle) const { return {circle * (1 + std::cos(angle)), circle * std::sin(angle)}; }
  /// r, where q has gone around by the angle: the directions of q and r are half of it.
  Vec2<double> r(double angle) const { return {line(), line() * std::tan(angle / 2)}; }
};

/// The point at distances `first` from p and `second` from q, to the left of the way from p to q.
Vec2<double> meeting_point(const Vec2<double>& p, double first, const Vec2<double>& q, double second) {
  const Vec2<double> way = q - p;
  const double d = way.norm();
  const double along = (d * d + first * first - second * second) / (2 * d);
  return p + way * (along / d) + perpendicular<double>(way) * (std::sqrt(first * first - along * along) / d);
}

struct InversorWorld {
  World<double> world;
  BodyId crank;  // with q at its end
  BodyId r;
};

/// The crank starts at -60 degrees and turns at 1 rad/s.
InversorWorld make_inversor(const Inversor& inversor, double frequency) {
  Scene scene({.gravity = {0, 0}, .dt = 1 / frequency, .stabilization = {.baumgarte = mechanism_beta}});
  const double start = -pi / 3, s = inversor.side;
  const Vec2<double> q = inversor.q(start), r = inversor.r(start), o(0, 0);
  const Vec2<double> a = meeting_point(o, inversor.arm, q, s), b = meeting_point(q, s, o, inversor.arm);
  const BodyId crank = scene.add(
      {.type = BodyType::kinematic, .position = {inversor.circle, 0}, .angle = start, .angular_velocity = 1});
  const auto bead = [&scene](const Vec2<double>& place) {
    return scene.add({.position = place, .mass = 1, .fixed_rotation = true});
  };
  const BodyId body_a = bead(a), body_b = bead(b), body_r = bead(r);
  const auto bar = [&scene](BodyId first, const Vec2<double>& from, BodyId second, const Vec2<double>& to) {
    scene.join<DistanceJoint>({.a = first, .b = second, .anchor_a = from, .anchor_b = to});
  };
  bar(ground, o, body_a, a);
  bar(ground, o, body_b, b);
  bar(crank, q, body_a, a);
  bar(crank, q, body_b, b);
  bar(body_a, a, body_r, r);
  bar(body_b, b, body_r, r);
  return {World(scene), crank, body_r};
}

struct InversorError {
  double across = 0;    // [m] from the line, the most
  double along = 0;     // [m] from where r should be on it, at the end
  double expected = 0;  // [m] of along
};

/// While the crank turns from -60 to 60 degrees.
InversorError inversor_error(double frequency) {
  const Inversor inversor;
  InversorWorld made = make_inversor(inversor, frequency);
  World<double>& world = made.world;
  AcceleratedProjectedGaussSeidel<double> solver({.iterations = 1000, .tolerance = 1e-9});
  InversorError result;
  const int steps = static_cast<int>(std::lround(2 * pi / 3 * frequency));
  for (int step = 0; step < steps; ++step) {
    world.step(solver);
    const double angle = pose_of(world, made.crank).angle;
    const Vec2<double> error = pose_of(world, made.r).position - inversor.r(angle);
    result.across = std::max(result.across, std::abs(error.x()));
    result.along = error.y();
    // The second derivative of tan(t / 2).
    const double t = std::tan(angle / 2);
    result.expected = -steady_drift(inversor.line() * (1 + t * t) * t / 2, 1 / frequency);
  }
  return result;
}

/// The string of a spool that hangs from a fixed point beside it: C = y - y_0 + R q, which is 0 while the
/// spool sinks by as much string as it unwinds.
class UnwindingString final : public ConstraintOf<UnwindingString> {
 public:
  UnwindingString(BodyId spool, double height, double radius)
      : spool_(spool), height_(height), radius_(radius) {}
  std::string name() const override { return "unwinding string"; }
  std::vector<Attachment> attachments() const override {
    return {{ground, {0, height_}}, {spool_, {radius_, 0}}};
  }
  template <Scalar Real>
  void rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
    const Pose<Real>& pose = poses[static_cast<std::size_t>(spool_.index)];
    const Real radius = static_cast<Real>(radius_);
    RowSpec<Real> row;
    row.b = spool_;
    row.error = pose.position.y() - static_cast<Real>(height_) + radius * pose.angle;
    row.jacobian_b = {0, 1, radius};
    rows.push_back(row);
  }

 private:
  BodyId spool_;
  double height_;  // [m]
  double radius_;  // [m]
};

}  // namespace

// B23
TEST_CASE("a rotor that turns by f in a step is stretched by L (1 - cos f) / (beta - 1 + cos f), for ever") {
  // The rod takes beta C back along its direction, which turns meanwhile: beta C = (L + C) (1 - cos f).
  for (const double turn : {0.02, 0.0833, 0.17}) {
    const double stretch = (1 - std::cos(turn)) / (mechanism_beta - 1 + std::cos(turn));
    const double radius = 1 + stretch;
    World world = rotor(radius, radius * std::sin(turn) * 60, 60);
    SequentialImpulse<double> solver({.iterations = 1});
    for (int step = 0; step < 600; ++step) {
      const Vec2<double> before = pose_of(world, {1}).position;
      world.step(solver);
      const Vec2<double> after = pose_of(world, {1}).position;
      // Each step rounds a length of about 1 m a few times, and the rod takes beta of that back.
      const double tolerance = 64 * double_epsilon / mechanism_beta;
      CHECK(std::abs(after.norm() - radius) <= tolerance * radius);
      CHECK(std::abs(std::atan2(cross<double>(before, after), before.dot(after)) - turn) <= 1e-12);
    }
  }
}

// B23
TEST_CASE("a rotor let go at its length comes to a stretch of L w^2 dt^2 / (2 beta)") {
  for (const double omega : {1.0, 5.0, 10.0}) {
    const double turn = omega / 60;
    World world = rotor(1, omega, 60);
    SequentialImpulse<double> solver({.iterations = 1});
    run(world, solver, 5);
    const double stretch = pose_of(world, {1}).position.norm() - 1;
    // Longer by C, it turns slower by 2 C / L, as r^2 w is kept: that takes 4 C / L of w^2.
    const double ideal = steady_drift(omega * omega, test_dt);
    CHECK(std::abs(stretch / ideal - 1) <= 4 * ideal);
    if (turn > 0.16) continue;
    CHECK(stretch == doctest::Approx(ideal).epsilon(0.06));
  }
}

// B21
TEST_CASE("a slider-crank's slider is at r cos f + sqrt(l^2 - r^2 sin^2 f), with a drift of order dt^2") {
  // The crank's end has r w^2 and the rod turns at up to r w / l, so that l (r w / l)^2 comes on top; an
  // error of the rod counts 1 / cos of its slope, of which the sine is up to r / l.
  const double r = crank_radius, l = crank_rod;
  const double acceleration = (r + r * r / l) * crank_speed * crank_speed;
  const double slope_cosine = std::sqrt(1 - r * r / (l * l));
  for (const double frequency : {60.0, 120.0, 240.0}) {
    CHECK(slider_error(frequency) <= steady_drift(acceleration, 1 / frequency) / slope_cosine);
  }
  check_second_order(slider_error);
}

// B22
TEST_CASE("Peaucellier's seven bars turn a circle into a straight line, and drift along it, not across") {
  // Along an exact motion d^2 C / dt^2 = j a + v H v = 0. A step adds v H v dt^2 / 2 to C and takes beta C,
  // so that C = -j a dt^2 / (2 beta): every point is off by -a dt^2 / (2 beta), and on a line a lies along
  // it.
  InversorError coarse = inversor_error(120);
  for (const double frequency : {240.0, 480.0, 960.0}) {
    const InversorError fine = inversor_error(frequency);
    CAPTURE(frequency);
    CHECK(std::log2(coarse.across / fine.across) >= 2.8);
    CHECK(std::log2(coarse.across / fine.across) <= 3.2);
    // C follows 1 / beta - 1/2 steps late; what is left is another order of dt.
    const double order = std::log2((coarse.along - coarse.expected) / (fine.along - fine.expected));
    CHECK(order >= 2.8);
    CHECK(order <= 3.2);
    // At 60 degrees a grows by sqrt(3) of itself a second: 1.5 times 4.5 steps of that.
    CHECK(std::abs(fine.along - fine.expected) <=
          1.5 * 4.5 * std::sqrt(3.0) / frequency * std::abs(fine.expected));
    coarse = fine;
  }
}

// B19
TEST_CASE("a falling spool unwinds its string at 2 g / 3, with a third of its weight in the string") {
  const double radius = 0.2, mass = 3;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double share :
         {0.5, 1.0, 0.1}) {  // I / m R^2: a disc, a hoop, a yo-yo's thin axle turned round
      Scene scene;
      const BodyId spool =
          scene.add({.position = {0, 2}, .mass = mass, .inertia = share * mass * radius * radius});
      scene.add_joint(std::make_shared<const UnwindingString>(spool, 2, radius));
      World world(scene);
      const auto solver = make({.iterations = 1});
      run(world, *solver, 1);
      const double a = test_gravity / (1 + share);  // 2 g / 3 for the disc
      const double tension = mass * (test_gravity - a);
      CHECK(velocity_of(world, spool).y() == doctest::Approx(-a).epsilon(1e-12));
      CHECK(velocity_of(world, spool).z() == doctest::Approx(a / radius).epsilon(1e-12));
      CHECK(pose_of(world, spool).position.y() ==
            doctest::Approx(2 - a / 2 - a * test_dt / 2).epsilon(1e-12));
      CHECK(world.last_step().problem.impulse[0] / test_dt == doctest::Approx(tension).epsilon(1e-12));
    }
  }
}
