// Lesson 11. The pictures: forces with their limits, the slide in two engines, angles, masses.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lessons/lesson.hpp"
#include "study.hpp"

namespace cairn::friction {

using SharedStudy = std::shared_ptr<const Study>;

/// All frames, from the question to the answer.
std::vector<Shot> pictures(const Study& study, const std::string& question);

// The parts that pictures() puts together.

Shot question_shot(const SharedStudy& study, const std::string& question);
/// The block at rest, or about to slide: needed and limit.
Shot force_shot(const SharedStudy& study, const Slide& slide);
/// The first step, sweep by sweep: bounds that move.
Shot sweep_shot(const SharedStudy& study);
Shot answer_shot(const SharedStudy& study, const std::string& question);

/// The slippery block after `step` steps, in Cairn and in Box2D, and its speed over time.
Shot slide_shot(const SharedStudy& study, int step);
/// Both blocks on four slopes.
Shot trial_shot(const SharedStudy& study);
/// Acceleration over the angle.
Shot curve_shot(const SharedStudy& study);

}  // namespace cairn::friction
