// Lesson 13. A weight that stands on a soft row, on a rigid row with the same beta, and on a spring that is a
// force; and three weights on three soft rows.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::soft {

inline constexpr double gravity = 10;        // [m/s^2]
inline constexpr double rest_length = 1;     // [m] of a spring without load
inline constexpr double half_height = 0.15;  // [m] of the weight, which stands on the spring's end
inline constexpr double seconds = 1.5;       // that the weight is followed
inline constexpr int column_weights = 3;     // one upon the other, each on a spring of its own
inline constexpr int column_sweeps = 12;     // of one step
inline constexpr double harsh_hertz = 100;   // a spring that no step of 0.005 s and more can follow
inline constexpr int harsh_steps = 20;

struct SoftSettings {
  double frequency = 2;  // f [Hz]
  double damping = 0.5;  // zeta, the ratio: 1 is the fastest return without overshoot
  double dt = 0.02;      // [s]
  double mass = 1;       // [kg]
  double pressed = 0.2;  // [m] by which the spring is pressed together at the start
};

/// What (22) has to know of one step, and its answer.
struct StepRow {
  double zeta = 0;    // [m/s] of the row
  double free = 0;    // [m/s] j v with gravity, before the row has acted
  double lambda = 0;  // [N] upwards
};

/// A weight on one row. Index: the step; 0 is the start. rows[0] is empty.
struct WeightRun {
  double gamma = 0;  // [1/kg]
  double beta = 0;   // rate times dt
  List<Snapshot> steps = {};
  List<double> error = {};  // c [m]: length less rest_length, negative where pressed
  List<double> speed = {};  // [m/s] upwards
  List<StepRow> rows = {};
};

/// One stiffness after the other, at the same dt, damping ratio and mass.
struct StiffRun {
  double frequency = 0;  // [Hz]
  double gamma = 0;      // [1/kg]
  double beta = 0;
  double sag = 0;           // [m] at rest, by m g / k
  List<double> error = {};  // c [m] after each step
};

/// Three weights, one step, one lambda per spring [N]. Index 0 of lambdas: before the first sweep.
struct ColumnRun {
  Snapshot start = {};
  double gamma = 0;  // [1/kg] 0: three rigid rows
  Matrix<double> A = {};
  List<List<double>> by_pgs = {};  // after each sweep
  List<List<double>> by_si = {};
};

/// How much a step enlarges an oscillation, at most, and what twenty steps made of it.
struct Growth {
  double frequency = 0;  // [Hz]
  double row = 0;        // by formula, of a soft row
  double force = 0;      // by formula, of a force -k c - d v in the step of lesson 00
};

struct SoftRuns {
  SoftSettings settings = {};
  WeightRun spring = {};   // the soft row
  WeightRun rigid = {};    // a rod with beta of the soft row
  double rest_error = 0;   // c [m] of the soft row once it has come to rest
  double rest_lambda = 0;  // [N] there
  List<StiffRun> stiff = {};
  ColumnRun rigid_column = {};
  ColumnRun soft_column = {};
  List<Growth> growth = {};
  List<double> harsh_row = {};    // c [m], harsh_hertz, step by step, by the engine
  List<double> harsh_force = {};  // the same as a force
};

SoftRuns run_soft(const SoftSettings& settings);

/// 2 pi f [rad/s], m w^2 [N/m], 2 m zeta w [N s/m].
double angular_frequency(double frequency);
double stiffness(const SoftSettings& settings);
double damping_constant(const SoftSettings& settings);

/// c [m] at time t of the same spring with no steps at all, begun at rest and pressed by settings.pressed.
double exact_error(const SoftSettings& settings, double t);

// What the lesson is about stands in lesson.cpp.

/// c [m] after each of `steps` steps of a row with gamma and beta, and of a force taken at the beginning of
/// the step.
List<double> by_row(const SoftSettings& settings, int steps);
List<double> by_force(const SoftSettings& settings, int steps);
/// The same with no row and no force but the formula of implicit Euler.
List<double> by_implicit_euler(const SoftSettings& settings, int steps);

/// gamma [1/kg] and beta of the spring's row: those of the springs that the library puts under rigid rows
/// (src/constraints/softness.hpp, policy soft).
double gamma_of(const SoftSettings& settings);
double beta_of(const SoftSettings& settings);

/// Sequential impulses for rows that all give way by gamma.
class SoftRows final : public Solver<double> {
 public:
  SoftRows(double gamma, const SolverSettings& settings) : gamma_(gamma), solver_(settings) {}
  std::string name() const override { return "soft rows"; }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* observer) override {
    for (ConstraintRow<double>& row : problem.rows) row.softness = gamma_;
    return solver_.solve(problem, observer);
  }

 private:
  double gamma_;  // [1/kg]
  SequentialImpulse<double> solver_;
};

/// A weight on a rod from the ground with this beta; and what the library makes of it where the rod's row
/// gives way by gamma.
Scene weight_scene(const SoftSettings& settings, double beta);
WeightRun run_weight(const SoftSettings& settings, double gamma, double beta, int steps);
/// Adds the state of the world as it is now.
void record(WeightRun& run, const World<double>& world);

/// The energy of oscillating about the place of rest [J], from c and speed.
double swing_energy(const SoftSettings& settings, double error, double speed);

// What is printed, checked and drawn.

SoftSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const SoftSettings& settings);
void print_runs(Lesson& lesson, const SoftRuns& all);
void check_runs(Lesson& lesson, const SoftRuns& all);
CsvTable steps_table(const SoftRuns& all);

/// Every step of a weight on two rows, and all that follows.
List<Shot> soft_shots(const SoftRuns& all);

/// Stiffer springs; three weights; the spring as a force.
List<Shot> stiff_shots(const SoftRuns& all);
List<Shot> column_shots(const SoftRuns& all);
List<Shot> harsh_shots(const SoftRuns& all);

/// A zig-zag from the foot of a spring at x up to its end [m].
void draw_spring(Page& page, const Camera& camera, double x, double bottom, double top,
                 const SeriesStyle& style);

/// The soft row in the look of sequential impulses, the row without gamma in that of a further solver.
SeriesStyle style_of_soft(const Page& page);
SeriesStyle style_of_rigid(const Page& page);

}  // namespace cairn::soft
