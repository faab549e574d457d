// Mistakes in the arithmetic: what a float forgets, and what a compiler may not do with the formulas.
#include <cfloat>
#include <fstream>
#include <sstream>

#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

#ifdef __FAST_MATH__
#error "Cairn's results need every rounding where the formulas put it: build without -ffast-math"
#endif

namespace {

/// ||v - v_free - M^-1 J^T lambda||_M / ||v - v_free||_M, in double: how far impulses and velocities have
/// come apart.
template <Scalar Real>
double drift_of_velocity(const VelocityProblem<Real>& start, const VelocityProblem<Real>& solved) {
  PerBody<Vec3<double>> given(start.body_count(), Vec3<double>::Zero());  // M^-1 J^T lambda
  for (int i = 0; i < start.row_count(); ++i) {
    for_each_term(start, start.rows[i], [&](BodyId body, const Vec3<Real>& jacobian) {
      const Vec3<double> share =
          start.inverse_mass[body].template cast<double>().cwiseProduct(jacobian.template cast<double>());
      given[body] += share * static_cast<double>(solved.impulse[i]);
    });
  }
  double lost = 0, gained = 0;
  for (const BodyId body : given.indices()) {
    const Vec3<double> change =
        solved.velocity[body].template cast<double>() - start.velocity[body].template cast<double>();
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = static_cast<double>(start.inverse_mass[body](axis));
      if (!(inverse > 0)) continue;
      lost += std::pow(change(axis) - given[body](axis), 2) / inverse;
      gained += std::pow(change(axis), 2) / inverse;
    }
  }
  return std::sqrt(lost / gained);
}

/// Beads on a line that fly along it at 1 m/s, each tied to the next one, the last of 100 kg: the first one
/// was struck, and gives 1 m/s of its own away.
template <Scalar Real>
VelocityProblem<Real> flying_chain() {
  VelocityProblem<Real> problem = empty_problem<Real>();
  BodyId last = ground;
  for (int i = 0; i < 20; ++i) {
    const Real mass = i == 19 ? Real(100) : 1 + Real(i) / 7;
    const Real speed = i == 0 ? Real(2) : Real(1);
    const BodyId bead = add_body<Real>(problem, mass, 1, {0, speed, 0});
    if (i > 0) add_row(problem, vertical_row<Real>(last, bead, Bounds<Real>::equality()));
    last = bead;
  }
  return problem;
}

/// Not known to the compiler before the program runs.
template <typename Number>
Number at_run_time(Number x) {
  volatile Number opaque = x;
  return opaque;
}

}  // namespace

TEST_CASE_TEMPLATE("PGS makes its velocities of its impulses; those of SI lose a rounding with every update",
                   Real, float, double, long double) {
  // The sums of drift_of_velocity are in double.
  const double epsilon = std::max(static_cast<double>(std::numeric_limits<Real>::epsilon()), double_epsilon);
  const VelocityProblem<Real> start = flying_chain<Real>();
  for (const int sweeps : {10, 1000, 10000}) {
    VelocityProblem<Real> by_matrix = start, by_impulses = start;
    ProjectedGaussSeidel<Real>({.iterations = sweeps}).solve(by_matrix);
    SequentialImpulse<Real>({.iterations = sweeps}).solve(by_impulses);
    // A rounding of 2 m/s in every velocity, weighted by sqrt(m) of 153 kg in all, over the 1 m/s that 1 kg
    // loses: 25 epsilon, for each time that velocities are written.
    CHECK(drift_of_velocity(start, by_matrix) <= 25 * epsilon);
    CHECK(drift_of_velocity(start, by_impulses) <= 25 * epsilon * (1 + sweeps));
  }
}

TEST_CASE("after many sweeps in float the velocities of SI are right, and its impulses are not theirs") {
  const VelocityProblem<float> start = flying_chain<float>();
  VelocityProblem<float> by_matrix = start, by_impulses = start;
  const int sweeps = 10000;
  ProjectedGaussSeidel<float>({.iterations = sweeps}).solve(by_matrix);
  SequentialImpulse<float>({.iterations = sweeps}).solve(by_impulses);
  CHECK(drift_of_velocity(start, by_impulses) > 1000 * drift_of_velocity(start, by_matrix));
  // What the eye sees is right all the same: SI corrects the velocities that it has.
  const float ulps = 4 * std::numeric_limits<float>::epsilon();  // of the difference of speeds above 1 m/s
  for (const ConstraintRow<float>& row : start.rows) {
    CHECK(std::abs(row_velocity(by_impulses, row)) <= ulps);
    CHECK(std::abs(row_velocity(by_matrix, row)) <= ulps);
  }
}

TEST_CASE("the compiler rounds every operation, in its order and in its type") {
  const double x = at_run_time(1 + double_epsilon);
  const double rounded = x * x;
  CHECK(x * x - rounded == 0);  // fused, it would be epsilon^2
  const double large = at_run_time(1e16), one = at_run_time(1.0);
  CHECK((large + one) - large == 0);  // not rearranged
  CHECK((one + double_epsilon / 4) - one == 0);
  CHECK(at_run_time(DBL_MIN) / 2 > 0);  // not flushed to 0
  CHECK(std::isnan(at_run_time(std::numeric_limits<double>::quiet_NaN())));
  CHECK(FLT_EVAL_METHOD == 0);  // a float is a float in the middle of a formula
}

TEST_CASE("the build asks for formulas as they are written, and nowhere for anything faster") {
  std::stringstream text;
  for (const std::string file : {"CMakeLists.txt", "CMakePresets.json", "src/CMakeLists.txt"}) {
    std::ifstream stream(CAIRN_SOURCE_DIR "/" + file);
    REQUIRE(stream.good());
    text << stream.rdbuf();
  }
  CHECK(text.str().find("-ffp-contract=off") != std::string::npos);
  for (const char* flag :
       {"fast-math", "-Ofast", "-ffp-contract=fast", "-ffinite-math-only", "-mfpmath=387"}) {
    CHECK(text.str().find(flag) == std::string::npos);
  }
}
