// The first and the last frame of a lesson: the question of its card, and the same with the answer.
#pragma once

#include <functional>
#include <string>

#include "lessons/kit/lesson.hpp"

namespace cairn {

/// How much larger the type of a question and of its answer may be than that of other notes.
inline constexpr double question_growth = 1.15;

/// Where the scene stands: one that is wide goes above the words.
enum class ScenePlace { left, above };

/// What both frames show beside the words, drawn anew for each.
struct QuestionFrame {
  std::string state = {};  // right of the header
  std::string alt = {};
  std::function<void(render::Page&, const render::Rect&)> scene = {};
  ScenePlace place = ScenePlace::left;
  /// What the answer shows in the room below its words, such as the chart that proves it; may be none.
  std::function<void(render::Page&, const render::Rect&)> evidence = {};
};

/// The scene, and beside it the question. A key frame, and the cover: let `cover` of the card be its number,
/// and let neither scene nor alt give the answer away.
Shot question_shot(const LessonInfo& info, const QuestionFrame& frame);

/// The scene, and beside it the question again and the answer. A key frame.
Shot answer_shot(const LessonInfo& info, const QuestionFrame& frame, const std::string& answer);

}  // namespace cairn
