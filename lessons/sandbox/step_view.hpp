// One step taken apart: the problem that its solver was given, and all that the solver did with it.
#pragma once

#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/measure/recorder.hpp>
#include "render/image.hpp"
#include "render/theme.hpp"
#include <cairn/scenes/scene_list.hpp>
#include <cairn/solvers/exact/reference_solver.hpp>

namespace cairn::sandbox {

struct StepRow {
  std::string kind = {};  // "revolute", "contact", "friction"
  std::string a = {}, b = {};
  double velocity = 0;               // [m/s or rad/s] j v before the solve
  double bias = 0;                   // [m/s or rad/s]
  double lower = 0, upper = 0;       // [N s] at the impulses of the answer
  double impulse = 0;                // [N s] of the answer
  double correction = 0;             // [N s] that the row still asks for: natural_correction()
  std::optional<double> exact = {};  // [N s] of the reference
};

/// Beside the exact answer.
struct StepReference {
  ReferenceReport report = {};
  double velocity_gap = 0;  // [m/s or rad/s] the largest of any body
  double impulse_gap = 0;   // [N s] the largest of any row
  double energy_error = 0;  // [1] sqrt(dv M dv) over the same of what the exact solve changes
};

struct StepView {
  int step = 0;
  double time = 0;  // [s] at its end
  Setting setting = {};
  VelocityProblem<double> given = {};  // with the warm start
  VelocityProblem<double> solved = {};
  List<SweepRecord> sweeps = {};
  PerRow<StepRow> rows = {};
  std::optional<StepReference> reference = {};
  std::string no_reference = {};  // why there is none
};

/// Steps the scene to the end of `step` (from 1), and looks at that step's last substep.
/// @throws std::invalid_argument where the scene is no longer finite before.
StepView view_step(const SceneEntry& scene, const Setting& setting, int step);

/// Sweeps that are worth a line, at most about 12: the first, then ever fewer, and the last.
List<int> shown_sweeps(int count);

/// A as a heat map, and the residual over the sweeps.
render::Image draw_step(const StepView& view, const std::string& title, const render::Theme& theme, int width,
                        int height);

}  // namespace cairn::sandbox
