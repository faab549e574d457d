// Words of the card beside a scene.
#include "lessons/question.hpp"

#include "lessons/arguments.hpp"

namespace cairn {
namespace {

/// Draws the scene; returns the two parts of what is free, the first of which takes this share.
List<render::Rect> draw_scene(render::Page& page, const QuestionFrame& frame, double share) {
  const double gap = page.sizes().gap;
  if (frame.place == ScenePlace::above) {
    const List<render::Rect> parts = rows(page.area(), {0.62, 0.38}, gap);
    frame.scene(page, parts[0]);
    return columns(parts[1], {share, 1 - share}, gap);
  }
  const List<render::Rect> parts = columns(page.area(), {0.58, 0.42}, gap);
  frame.scene(page, parts[0]);
  return rows(parts[1], {share, 1 - share}, gap);
}

}  // namespace

Shot question_shot(const LessonInfo& info, const QuestionFrame& frame) {
  const auto draw = [info, frame](render::Page& page) {
    const List<render::Rect> parts = draw_scene(page, frame, 0.78);
    page.note(parts[0], "The question", info.question, question_growth);
    page.note(parts[1], "To answer", typed_command(info) + " --predict");
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

Shot answer_shot(const LessonInfo& info, const QuestionFrame& frame, const std::string& answer) {
  const auto draw = [info, frame, answer](render::Page& page) {
    const List<render::Rect> parts = draw_scene(page, frame, frame.place == ScenePlace::above ? 0.4 : 0.32);
    page.note(parts[0], "The question", info.question);
    page.note(parts[1], "The answer", answer, question_growth);
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

}  // namespace cairn
