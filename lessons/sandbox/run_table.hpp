// What runs have come to, as a table for people and as JSON for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lessons/sandbox/scene_run.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {

/// "box2d cannot run weld-beam: ...", of a run that was refused.
std::string refusal_text(const SceneEntry& scene, const SceneRun& run);

/// Whether the run ended where the scene does.
bool judges_places(const SceneEntry& scene, const SceneRun& run);

/// One line a number, such as "worst penetration  1.2 mm   expected at most 5 mm  ok". Not of a refused run.
void print_run(const SceneEntry& scene, const SceneRun& run, Console& console);

/// One row a run.
void print_runs(const SceneEntry& scene, const List<SceneRun>& runs, Console& console);

nlohmann::ordered_json run_json(const SceneEntry& scene, const SceneRun& run);

/// 0, 1 where an expectation is missed, 2 where the engine refused, 4 where it diverged.
int exit_code(const SceneRun& run);

}  // namespace cairn::sandbox
