// Floor 8. What is cheap, and what is not.
#include <cairn/scenes/default_setting.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace cairn {

namespace {

// Where everything slides, falls or rolls, NewtonSolver solves all of its systems: 0.1 to 0.15 ms a loose
// body in a step of four substeps. So many freedoms are 100 loose bodies: some 10 ms a step, and up to 16 at
// worst, a 60th of a second. A tower of so many boxes stands under exact solves alone. What hangs on joints
// takes a fifteenth of that, and has few freedoms.
constexpr int most_exact_freedoms = 300;
constexpr int exact_systems = 20;
// All else in a step takes as long as some 40 sweeps. So 20 leave half the error of 10 for a tenth to a
// quarter more time.
constexpr int wide_sweeps = 20;
// One substep with four times the sweeps takes half the time, and leaves two to ten times the error.
constexpr int usual_substeps = 4;

/// Three for each body that moves and turns, less one for each row of a rigid joint.
int freedoms(const Scene& scene) {
  int count = 0;
  PerBody<Pose<double>> poses;
  for (const SceneBody& body : scene.bodies()) {
    poses.push_back(body.pose);
    const bool moves = !body.removed && body.spec.type == BodyType::dynamic;
    if (moves) count += body.inertia > 0 ? 3 : 2;
  }
  RowSpecs<double> rows;
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) joint->append_rows(poses, rows);
  return count - static_cast<int>(std::count_if(rows.begin(), rows.end(), [](const RowSpec<double>& row) {
           return row.bounds.is_equality() && !row.softness && !row.max_force;
         }));
}

}  // namespace

DefaultSetting default_setting(const Scene& scene) {
  const SceneSettings& settings = scene.settings();
  Setting setting{.dt = settings.dt,
                  .substeps = std::max(usual_substeps, settings.substeps),
                  .contact_search = settings.contact_search,
                  .stabilization = settings.stabilization,
                  .warm_start = settings.warm_start};
  const int ways = freedoms(scene);
  const bool is_exact = ways <= most_exact_freedoms;
  setting.solver = is_exact ? "newton" : "wide";
  setting.sweeps.iterations = is_exact ? exact_systems : wide_sweeps;
  const char* const how = is_exact ? "all rows are solved at once up to" : "rows are swept in lanes above";
  return {setting, fmt::format("{} freedoms: {} {}", ways, how, most_exact_freedoms)};
}

}  // namespace cairn
