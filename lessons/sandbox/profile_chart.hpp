// The chart of performance profiles.
#pragma once

#include <string>

#include "math/list.hpp"
#include "render/image.hpp"
#include "render/theme.hpp"
#include "study/profile.hpp"

namespace cairn::sandbox {

struct ProfileChart {
  std::string title = {};
  std::string note = {};                   // below it
  List<PerformanceProfile> profiles = {};  // at most 4
  int width = 1280;                        // [px]
  int height = 720;
};

/// @throws render::RenderError when nothing can be drawn.
render::Image draw_profile_chart(const ProfileChart& chart, const render::Theme& theme);

}  // namespace cairn::sandbox
