// Lesson 20. A scene of four things that do not touch, stepped under switches that each leave something out.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::needs {

inline constexpr double time_step = 0.02;  // [s]
inline constexpr int base = 5;             // boxes in the lowest row of the pyramid
inline constexpr int pyramid_boxes = base * (base + 1) / 2;
inline constexpr double reference_tolerance = 1e-6;  // of R_E

struct NeedsSettings {
  int sweeps = 50;          // in every step; where a step may end sooner, at most
  double tolerance = 1e-3;  // of R_E, at which it may
  int tower = 10;           // boxes
  int links = 5;            // of the chain
  int steps = 140;
};

/// What is left out.
struct Switches {
  std::string name = {};
  bool ends_early = false;  // a step ends at the tolerance
  bool by_island = false;   // and each island has an end of its own
  bool sleeps = false;
};

/// In this order: everything, early exit, early exit by islands, sleep.
List<Switches> all_switches();
inline constexpr int everything = 0, early = 1, by_islands = 2, sleeping = 3;

/// Rows and sweeps of one stage in one step.
struct StageBill {
  int rows = 0;
  int sweeps = 0;
};

/// What one step has cost.
struct StepBill {
  List<StageBill> stages = {};  // the whole scene, or pyramid with ball, tower, chain
  int rows = 0;
  int sweeps = 0;         // the most that any island has taken
  long long updates = 0;  // of rows: rows x sweeps
  double residual = 0;    // the largest R_E of a solve that has ended at the tolerance
  int awake = 0;          // bodies
};

struct BillRun {
  Switches switches = {};
  List<Snapshot> frames = {};  // one for each step, the start first
  List<StepBill> steps = {};   // from step 1
  long long updates = 0;       // of all steps
  double seconds = 0;          // that the steps took, on this machine
  double off_before = 0;       // [m] from the reference, before the ball touches anything
};

struct NeedsRun {
  NeedsSettings settings = {};
  BillRun reference = {};   // everything, until R_E is 1e-6, islands by themselves
  List<BillRun> runs = {};  // as all_switches()
  double alone = 0;         // [m] how far bodies go another way if their island is a scene of its own
  int touch = 0;            // the step in which the ball reaches the pyramid; 0: never
};

/// What a stage takes in a step, on average.
struct StageMean {
  double sweeps = 0;
  double updates = 0;
};
StageMean mean_of(const BillRun& run, int stage);

/// The least rows of any step.
int least_rows(const BillRun& run);

/// Remembers the scale of R_E, which needs the velocities before the warm start.
class ScaleObserver final : public SolveObserver<double> {
 public:
  void before_solve(const VelocityProblem<double>& problem) override { scale_ = residual_scale(problem); }
  double scale() const { return scale_; }

 private:
  double scale_ = 0;
};

/// A world of a run: the whole scene, or one of its islands.
struct Stage {
  World<double> world;
  SequentialImpulse<double> solver;
  ScaleObserver scale = {};
};

List<Stage> stages_of(const NeedsSettings& settings, const Switches& switches, double tolerance);
/// All stages as one world.
Snapshot together(const List<Stage>& stages);
/// R_E after the last step.
double residual_left(const Stage& stage);

/// The first frame in which the ball touches anything but the ground; 0: never.
int first_touch(const List<Snapshot>& frames, BodyId ball);

/// The island that a body is in at the start, by number; 0: it is alone.
enum class Group { loose, pyramid, tower, chain };
Group group_of(const NeedsSettings& settings, BodyId body);

/// The things by themselves, in the order of the whole scene.
enum class Thing { pyramid_and_ball, tower, chain };
/// The whole scene holds all things.
Scene scene_of(const NeedsSettings& settings, const Switches& switches, const List<Thing>& things);
BodyId ball_of(const NeedsSettings& settings);

/// The largest distance of any of the first `bodies` in any frame [m], up to `last`.
double largest_distance(const List<Snapshot>& first, const List<Snapshot>& second, int from, int last,
                        int bodies);

/// Rows of the scene in step 1.
int rows_by_formula(const NeedsSettings& settings);

// What is printed, checked and drawn.

/// Prints all bills and the answer, and checks every claim.
void report(Lesson& lesson, const NeedsRun& all);

CsvTable bills_table(const NeedsRun& all);

/// The scene of a run after so many steps, and a line above each island.
struct SceneView {
  std::string title = {};
  int run = by_islands;
  int step = 0;
  List<std::string> lines = {};
};
void draw_scene(Page& page, const Rect& rect, const NeedsRun& all, const SceneView& view);

/// "40 rows × 50 sweeps": what each island takes in a step; before the first step only its rows.
List<std::string> swept_lines(const NeedsRun& all, int run, int step);

/// The question, the bill step by step, asleep and awake, and the answer.
List<Shot> needs_shots(const NeedsRun& all);

}  // namespace cairn::needs
