// Words of the card beside a scene.
#include "lessons/question.hpp"

#include "lessons/arguments.hpp"

namespace cairn {
namespace {

/// Draws the scene; returns what is free beside it.
render::Rect draw_scene(render::Page& page, const QuestionFrame& frame) {
  const List<render::Rect> parts = columns(page.area(), {0.58, 0.42}, page.sizes().gap);
  frame.scene(page, parts[0]);
  return parts[1];
}

}  // namespace

Shot question_shot(const LessonInfo& info, const QuestionFrame& frame) {
  const auto draw = [info, frame](render::Page& page) {
    const List<render::Rect> parts = rows(draw_scene(page, frame), {0.78, 0.22}, page.sizes().gap);
    page.note(parts[0], "The question", info.question);
    page.note(parts[1], "To answer", typed_command(info) + " --predict");
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

Shot answer_shot(const LessonInfo& info, const QuestionFrame& frame, const std::string& answer) {
  const auto draw = [info, frame, answer](render::Page& page) {
    const List<render::Rect> parts = rows(draw_scene(page, frame), {0.4, 0.6}, page.sizes().gap);
    page.note(parts[0], "The question", info.question);
    page.note(parts[1], "The answer", answer);
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

}  // namespace cairn
