// The two stacks, step by step.
#include "lesson.hpp"

#include "render/lint.hpp"

namespace cairn::edges {

namespace {

/// A word in a box with its right end at a point.
void draw_verdict(Page& page, const Point& base, bool is_good) {
  TextStyle text = page.label();
  text.bold = true;
  const Color fill = is_good ? page.theme().panel : page.theme().positive;
  text.color = render::ink_on(fill);
  text.halo = fill;
  const std::string word = verdict(is_good);
  const double width = page.canvas().text_width(word, text) + 10;
  page.canvas().rect({base.x() - width, base.y() - 1.05 * text.size, width, 1.45 * text.size},
                     {.fill = fill, .outline = page.theme().text, .outline_width = page.sizes().axis}, 3);
  page.canvas().text({base.x() - width + 5, base.y()}, word, text);
}

/// A dashed line where the top of a stack belongs, with its height.
void draw_top(Page& page, const Camera& camera) {
  const Point left = camera.project({-1.2, stack_height}), right = camera.project({1.2, stack_height});
  page.canvas().line(left, right, {.width = 2, .color = page.theme().normal, .dash = {6, 4}});
  TextStyle text = aligned(page.tick(), Align::right);
  page.canvas().text(right + Point(0, 1.3 * text.size), fmt::format("{:g} m", stack_height), text);
}

/// By how much the top has been off, and which way when it was off most.
std::string off_line(const StackCourse& course, int step) {
  const auto at = std::max_element(course.off_by_step.begin(), course.off_by_step.begin() + step + 1);
  std::string line = fmt::format("top off by {} % of the height", fixed(100 * *at, 1));
  if (*at <= 0.001) return line;
  const double top =
      course.frames[static_cast<int>(at - course.off_by_step.begin())].bodies.back().pose.position.y() + 0.5;
  return line + (top > stack_height ? ", upwards" : ", downwards");
}

void draw_course(Page& page, const Rect& rect, const StackCourse& course, int step) {
  const Rect inside = page.panel(rect, name_of(course.ratio));
  const double line = 1.5 * page.label().size;
  const Rect view = {inside.x, inside.y, inside.width, inside.height - 2 * line - 6};
  const Camera camera = fit(view, {{-1.3, -0.35}, {1.3, 1.15 * stack_height}});
  page.canvas().push_clip(view);
  draw_boxes(page, camera, course.frames[step], course.ratio);
  draw_top(page, camera);
  page.canvas().pop_clip();
  const double base = inside.y + inside.height - 0.35 * page.label().size;
  const double energy = 100 * std::max(0.0, worst(course.energy_by_step, step));
  page.canvas().text({inside.x, base - line}, off_line(course, step), page.label());
  page.canvas().text({inside.x, base}, fmt::format("energy up by {} %", fixed(energy, 1)), page.label());
  draw_verdict(page, {inside.x + inside.width, base}, is_ok(course, step));
}

void draw_step(Page& page, const ExtremesRun& run, int step) {
  const List<Rect> parts = in_rows(page, {{0.8, {1, 1}}, 0.2});
  for (int i = 0; i < run.courses.size(); ++i) draw_course(page, parts[i], run.courses[i], step);
  page.note(
      parts[2], "OK or BROKEN",
      "OK: so far the top has been off by at most 1 % of the height, and the energy up by at most 1 %.");
}

Shot step_shot(const ExtremesRun& run, int step) {
  std::string alt = fmt::format("Both stacks after step {}:", step);
  for (const StackCourse& course : run.courses)
    alt += fmt::format(" {}: {};", name_of(course.ratio), verdict(is_ok(course, step)));
  alt.back() = '.';
  return {.state = fmt::format("step {}", step),
          .alt = alt,
          .draw = [&run, step](Page& page) { draw_step(page, run, step); },
          .key = step == run.settings.steps};
}

}  // namespace

List<Shot> step_shots(const ExtremesRun& run) {
  List<Shot> shots;
  for (int step = 0; step <= run.settings.steps; ++step) shots.push_back(step_shot(run, step));
  return shots;
}

}  // namespace cairn::edges
