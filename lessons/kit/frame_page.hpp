// The page that shows a lesson's frames one at a time.
#pragma once

#include <string>

#include "lessons/kit/card.hpp"

namespace cairn {

/// An HTML page that stands beside the pictures that `index`, a frames.json, names. Arrow keys, buttons and a
/// slider step through them; without scripts they stand one below the other.
std::string frame_page(const LessonInfo& info, const std::string& index);

}  // namespace cairn
