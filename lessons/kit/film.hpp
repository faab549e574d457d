// Draws the wanted frames of a lesson and keeps its folder of pictures in order.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/kit/arguments.hpp"
#include "lessons/kit/console.hpp"
#include "lessons/kit/lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn {

struct FilmReport {
  int pictures = 0;
  std::string backend = {};         // that drew them
  std::string index = {};           // the text of frames.json
  List<std::string> findings = {};  // about the layout: "frame 3: ..."
};

/// Writes lNN_0001.png ... and frames.json into options.out, and removes the frames that an earlier
/// frames.json of that folder names and that were not written again. When a frame cannot be written, those of
/// this run are removed too.
/// @throws render::RenderError, NoSuchFrame; WriteError, also for a frames.json that no lesson wrote;
/// std::logic_error for a shot without alt text.
FilmReport draw_film(const LessonInfo& info, const Options& options, const List<Shot>& shots,
                     Console& console);

}  // namespace cairn
