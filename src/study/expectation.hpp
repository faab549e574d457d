// Floor 9. Whether a run keeps to what its scene expects.
#pragma once

#include <string>

#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The options under which a trial of the scene can be held against its expectations.
TrialOptions trial_options(const SceneEntry& scene);

/// What the run does not keep to, each as "worst penetration 0.012 m, expected at most 0.01 m"; empty: it
/// meets all. A run that did not end ok meets nothing. Places are those of the end: the run must have been
/// one with these in its options. Bodies without a name go by their number.
List<std::string> unmet(const Expectations& expectations, const TrialResult& result,
                        const PerBody<std::string>& names = {});

}  // namespace cairn
