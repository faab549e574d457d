// Words of the card beside a scene.
#include "lessons/kit/question.hpp"

#include "lessons/kit/arguments.hpp"

namespace cairn {
namespace {

constexpr double least_evidence = 120;  // [px] of height that a chart or a table needs

/// Draws the scene and returns the room for the words.
render::Rect draw_scene(render::Page& page, const QuestionFrame& frame) {
  const double gap = page.sizes().gap;
  const bool above = frame.place == ScenePlace::above;
  const List<render::Rect> parts =
      above ? rows(page.area(), {0.7, 0.3}, gap) : columns(page.area(), {0.62, 0.38}, gap);
  frame.scene(page, parts[0]);
  return parts[1];
}

/// A scene that the reader has changed: nothing is asked of it.
Shot silent_shot(const QuestionFrame& frame) {
  const auto draw = [frame](render::Page& page) {
    if (!frame.evidence) return frame.scene(page, page.area());
    const List<render::Rect> parts = columns(page.area(), {0.62, 0.38}, page.sizes().gap);
    frame.scene(page, parts[0]);
    frame.evidence(page, parts[1]);
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

}  // namespace

Shot question_shot(const LessonInfo& info, const QuestionFrame& frame) {
  if (info.question.empty()) {
    QuestionFrame bare = frame;
    bare.evidence = {};
    return silent_shot(bare);
  }
  const auto draw = [info, frame](render::Page& page) {
    const render::Rect room = draw_scene(page, frame);
    if (frame.place == ScenePlace::above) {
      page.note(room, "The question", info.question, question_growth);
    } else {
      page.card(room, "The question", info.question, question_growth);
    }
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

Shot answer_shot(const LessonInfo& info, const QuestionFrame& frame, const std::string& answer) {
  if (info.question.empty()) return silent_shot(frame);
  const auto draw = [info, frame, answer](render::Page& page) {
    render::Rect rest = draw_scene(page, frame);
    if (frame.place == ScenePlace::above) {
      const List<render::Rect> parts = columns(rest, {0.4, 0.6}, page.sizes().gap);
      page.note(parts[0], "The question", info.question);
      page.note(parts[1], "The answer", answer, question_growth);
      return;
    }
    rest = page.card(rest, "The question", info.question);
    rest = page.card(rest, "The answer", answer);
    if (frame.evidence && rest.height > least_evidence) frame.evidence(page, rest);
  };
  return {.state = frame.state, .alt = frame.alt, .draw = draw, .key = true};
}

}  // namespace cairn
