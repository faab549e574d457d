// The stack beside the matrices, the question, and the answer.
#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/draw.hpp"
#include "render/matrix.hpp"

namespace cairn::big {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;

/// Left of the stack what each contact pushes upwards, as far as it is known.
void draw_pushes(Page& page, const render::Camera& camera, const StackRun& run, int known) {
  const double largest = lambda_by_formula(run, 0);
  const render::ArrowScale scale{
      .pixels_per_unit = 0.9 * camera.scale / largest, .longest = camera.scale, .unit = "N"};
  for (int i = run.boxes() - known; i < run.boxes(); ++i) {
    const double lambda = run.lambda(i);
    draw_arrow(page, camera, scale,
               {.kind = render::ArrowKind::normal, .tail = {-0.8, i}, .value = {0, lambda}});
    render::TextStyle style = page.value();
    style.align = render::Align::right;
    const Point at = camera.project({-0.8, i + 0.25});
    const std::string value = fixed(lambda, lambda < 1000 ? 2 : 0);
    const std::string full = fmt::format("λ_{{{}}} = {} N", i + 1, value);
    const double right = at.x() - 14;
    const bool fits = right - page.canvas().text_width(full, style) > camera.viewport.x;
    page.canvas().text({right, at.y() + style.size / 3}, fits ? full : value, style);
  }
}

/// Right of the stack how fast each box moves.
void draw_speeds(Page& page, const render::Camera& camera, const StackRun& run,
                 const Eigen::VectorXd& velocity) {
  const double largest = std::max(gravity * run.settings.dt, velocity.cwiseAbs().maxCoeff());
  const render::ArrowScale scale{
      .pixels_per_unit = 0.5 * camera.scale / largest, .longest = camera.scale, .unit = "m/s"};
  for (int i = 0; i < run.boxes(); ++i) {
    const double v = velocity(3 * i + 1);
    draw_arrow(page, camera, scale,
               {.kind = render::ArrowKind::velocity, .tail = {0.75, i + 0.5}, .value = {0, v}});
    render::TextStyle style = page.value();
    style.color = page.theme().secondary_text;
    const Point at = camera.project({0.75, i + 0.5});
    const std::string value = fixed(v, 3);
    const double left = at.x() + 16;
    const double edge = camera.viewport.x + camera.viewport.width;
    const bool fits = left + page.canvas().text_width(value + " m/s", style) < edge;
    page.canvas().text({left, at.y() + style.size / 3}, fits ? value + " m/s" : value, style);
  }
}

/// "30, 20 and 10": what the contacts carry, from the ground up.
std::string loads(const StackRun& run) {
  std::string text;
  for (int i = 0; i < run.boxes(); ++i) {
    const char* between = i == 0 ? "" : i + 1 < run.boxes() ? ", " : " and ";
    text += between + brief(lambda_by_formula(run, i));
  }
  return text;
}

void draw_question(Page& page, const StackRun& run) {
  std::string unknown = "?";
  for (int i = 1; i < run.boxes(); ++i) unknown += ", ?";
  const List<Rect> halves = columns(page.area(), {0.4, 0.6}, page.sizes().gap);
  draw_stack(page, halves[0], run, {.velocity = run.system.velocity});
  const List<Rect> right = rows(halves[1], {0.6, 0.4}, page.sizes().gap);
  page.note(
      right[0], "The question",
      fmt::format("All boxes fall at {} m/s: gravity has acted for one step. In the end the contacts carry "
                  "{}\u00a0N. b "
                  "has one number for each of them. Is it in the same proportion? What are its numbers?",
                  brief(gravity * run.settings.dt), loads(run)),
      question_growth);
  page.equation(right[1], {.number = "eq (15)",
                           .symbols = "A λ = b,   b = ζ/Δt − J v_{1}/Δt,   ζ = 0",
                           .numbers = "row by row, from the ground up:",
                           .result = fmt::format("b = ({}) m/s²", unknown)});
}

void draw_answer(Page& page, const StackRun& run) {
  const List<Rect> halves = columns(page.area(), {0.4, 0.6}, page.sizes().gap);
  draw_stack(page, halves[0], run, {.known = run.boxes(), .velocity = run.velocity});
  const List<Rect> right = rows(halves[1], {0.5, 0.5}, page.sizes().gap);
  std::string numbers = brief(run.system.b(0));
  for (int i = 1; i < run.boxes(); ++i) numbers += ", " + brief(run.system.b(i));
  const std::string text = fmt::format(
      "b = ({}) m/s². Two boxes that fall together do not close in on each other, however heavy they are: 0. "
      "Only the lowest contact closes in, and A⁻¹ passes that on. Each entry is the mass that stands above "
      "both contacts, and the first column, times b_{{1}}, is λ.",
      numbers);
  page.note(right[0], "The answer", text, question_growth);
  const int n = run.boxes();
  render::MatrixView inverse{.title = "A^{−1} (kg), and b (m/s²)", .row_names = row_names(n)};
  inverse.values.resize(n, n + 1);
  inverse.values << run.inverse, run.system.b;
  inverse.column_names = row_names(n);
  inverse.column_names.push_back("b");
  inverse.column_group = n;
  render::MatrixView lambda{.title = "λ (N)", .values = run.lambda, .row_names = row_names(n)};
  const List<Rect> below = columns(right[1], {0.62, 0.38}, page.sizes().gap);
  draw_matrix(page, below[0], inverse);
  draw_matrix(page, below[1], lambda);
}

}  // namespace

void draw_stack(Page& page, const Rect& rect, const StackRun& run, const StackView& view) {
  const Rect inside = page.panel(rect, "");
  const double n = run.boxes();
  const render::Camera camera = render::fit(inside, {{-2.1, -0.35}, {2.1, n + 0.2}});
  render::WorldLook look;
  look.penetration = false;
  look.active_contact = view.contact;
  if (view.contact >= 0) {
    look.active_a = {view.contact};
    look.active_b = {view.contact + 1};
  }
  if (view.box > 0) look.active_a = {view.box};
  draw_world(page, camera, run.snapshot, look);
  draw_pushes(page, camera, run, view.known);
  if (view.velocity.size() > 0) draw_speeds(page, camera, run, view.velocity);
}

List<std::string> column_names(int boxes) {
  List<std::string> names;
  for (int box = 1; box <= boxes; ++box) {
    for (const char* name : {"x", "y", "θ"}) names.push_back(fmt::format("{}_{{{}}}", name, box));
  }
  return names;
}

List<std::string> row_names(int rows) {
  List<std::string> names;
  for (int row = 1; row <= rows; ++row) names.push_back(fmt::format("{}", row));
  return names;
}

std::string brief(double value) {
  std::string text = fixed(value, 3);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string in_brackets(const std::string& number) {
  return number.starts_with("−") ? "(" + number + ")" : number;
}

List<Shot> stack_shots(const StackRun& recorded) {
  const Run run = std::make_shared<const StackRun>(recorded);
  List<Shot> shots;
  shots.push_back({.state = "before the first row",
                   .alt = "A stack of boxes that all fall at the same speed, and the question.",
                   .draw = [run](Page& page) { draw_question(page, *run); },
                   .key = true});
  for (const List<Shot>& part : {building_shots(run), solving_shots(run)}) {
    shots.insert(shots.end(), part.begin(), part.end());
  }
  shots.push_back({.state = "answer",
                   .alt = "The stack held by its contacts, the inverse of A beside b and λ, and the answer.",
                   .draw = [run](Page& page) { draw_answer(page, *run); },
                   .key = true});
  return shots;
}

}  // namespace cairn::big
