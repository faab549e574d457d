// The stack beside the matrices, the question, and the answer.
#include "lesson.hpp"

namespace cairn::big {

namespace {

/// Beside the stack: right-aligned at a left side, with its unit if there is room.
void write_beside(Page& page, const Camera& camera, const Point& at, const std::string& text,
                  const std::string& shorter, bool left) {
  TextStyle style = aligned(page.value(), left ? Align::right : Align::left);
  const double width = page.canvas().text_width(text, style);
  const Rect& view = camera.viewport;
  const bool fits = left ? at.x() - width > view.x : at.x() + width < view.x + view.width;
  page.canvas().text({at.x(), at.y() + style.size / 3}, fits ? text : shorter, style);
}

/// Left of the stack what each contact pushes upwards.
void draw_pushes(Page& page, const Camera& camera, const StackRun& run) {
  const ArrowScale scale{.pixels_per_unit = 0.9 * camera.scale / lambda_by_formula(run, 0),
                         .longest = camera.scale,
                         .unit = "N"};
  for (int i = 0; i < run.boxes(); ++i) {
    draw_arrow(page, camera, scale,
               {.kind = ArrowKind::normal, .tail = {-0.7, i}, .value = {0, run.lambda(i)}});
    const std::string value = brief(run.lambda(i)) + " N";
    write_beside(page, camera, camera.project({-0.7, i + 0.25}) - Point(14, 0),
                 fmt::format("λ_{{{}}} = {}", i + 1, value), value, true);
  }
}

/// Right of the stack how fast each box moves.
void draw_speeds(Page& page, const Camera& camera, const StackRun& run, const Eigen::VectorXd& velocity) {
  const double largest = std::max(gravity * run.settings.dt, velocity.cwiseAbs().maxCoeff());
  const ArrowScale scale{
      .pixels_per_unit = 0.5 * camera.scale / largest, .longest = camera.scale, .unit = "m/s"};
  for (int i = 0; i < run.boxes(); ++i) {
    const double v = velocity(3 * i + 1);
    const Vec2<double> tail(0.7, i + 0.5);
    draw_arrow(page, camera, scale, {.kind = ArrowKind::velocity, .tail = tail, .value = {0, v}});
    write_beside(page, camera, camera.project(tail) + Point(16, 0), brief(v) + " m/s", brief(v), false);
  }
}

/// A bracket around the boxes of a row, which are the one below its contact and the one above.
void draw_bracket(Page& page, const Camera& camera, int row, bool left) {
  const double x = left ? -0.7 : 0.7, end = left ? 0.08 : -0.08, bottom = std::max(0, row - 1);
  const FixedList<Point, 4> points = {camera.project({x + end, bottom + 0.06}),
                                      camera.project({x, bottom + 0.06}), camera.project({x, row + 0.94}),
                                      camera.project({x + end, row + 0.94})};
  page.canvas().polyline(points, {.width = page.sizes().active_outline, .color = page.theme().text});
  write_beside(page, camera, camera.project({x, 0.5 * (bottom + row + 1)}) + Point(left ? -10 : 10, 0),
               fmt::format("row {}", row + 1), fmt::format("{}", row + 1), left);
}

/// What each box weighs, all in one size; the heavy one is dark. A name too wide for its box stands above it.
void draw_masses(Page& page, const Camera& camera, const StackRun& run) {
  TextStyle style{.size = std::clamp(0.24 * camera.scale, page.sizes().smallest, page.sizes().body_number),
                  .bold = true,
                  .align = Align::center};
  for (int i = 0; i < run.boxes(); ++i) {
    const bool heavy = run.mass[i] >= heavy_mass;
    if (heavy) {
      const Point corner = camera.project({-0.5, i + 1});
      page.canvas().rect({corner.x(), corner.y(), camera.scale, camera.scale}, {.fill = page.theme().text});
      page.canvas().circle(
          camera.project({0, i}), page.sizes().contact,
          {.fill = page.theme().inactive, .outline = page.theme().outline, .outline_width = 1});
    }
    const std::string name = brief(run.mass[i]) + " kg";
    const bool inside = page.canvas().text_width(name, style) < 0.95 * camera.scale;
    style.color = heavy && inside ? page.theme().panel : page.theme().text;
    style.halo = heavy && inside ? page.theme().text : render::transparent;
    const Point middle = camera.project({0, inside ? i + 0.5 : i + 1});
    page.canvas().text(middle + Point(0, inside ? 0.35 * style.size : -5), name, style);
  }
}

/// What each contact carries in the end, and that its number of b is asked.
void draw_asked(Page& page, const Camera& camera, const StackRun& run) {
  TextStyle style{.size = render::large_text, .color = page.theme().velocity, .bold = true};
  for (int i = 0; i < run.boxes(); ++i) {
    const Point off(0, i == 0 ? 14 : 0);  // the line of the ground
    const std::string force = brief(run.lambda(i)) + " N";
    write_beside(page, camera, camera.project({-0.6, i}) - off, fmt::format("λ_{{{}}} = {}", i + 1, force),
                 force, true);
    page.canvas().text(camera.project({0.7, i}) + Point(16, 5) - off, fmt::format("b_{{{}}} = ?", i + 1),
                       style);
  }
}

/// The stack of the question with either box on top.
void draw_question(Page& page, const Rect& rect, const StackRun& run, const StackRun& heavy) {
  const List<Rect> columns = in_columns(page, rect, {0.5, 0.5});
  draw_stack(page, columns[0], run, {.asked = true, .masses = true, .velocity = run.system.velocity});
  draw_stack(page, columns[1], heavy, {.asked = true, .masses = true, .velocity = heavy.system.velocity});
}

/// The stack that stands, and λ as the first column of the inverse, times the one number of b.
void draw_solution(Page& page, const Rect& rect, const StackRun& run) {
  const List<Rect> parts = in_columns(page, rect, {0.42, 0.58});
  draw_stack(page, parts[0], run, {.pushes = true, .masses = true, .velocity = run.velocity});
  const List<std::string> names = row_names(run.boxes());
  MatrixView inverse{
      .title = "A^{−1} (kg)", .values = run.inverse, .row_names = names, .column_names = names};
  inverse.active_column = 0;
  MatrixView b{.title = "b (m/s²)", .values = run.system.b, .active_row = 0};
  MatrixView lambda{.title = "λ (N)", .values = run.lambda};
  for (MatrixView* view : {&inverse, &b, &lambda}) view->colors = MatrixColors::magnitude;
  draw_product(page, parts[1], {inverse, b, lambda}, {"×", "="});
}

std::string answer_text(const StackRun& run) {
  std::string numbers = brief(run.system.b(0));
  for (int i = 1; i < run.boxes(); ++i) numbers += ",\u00a0" + brief(run.system.b(i));
  return fmt::format(
      "None: b = ({}) m/s² with either box on top. Boxes that fall together do not approach each other, "
      "whatever they weigh. The masses are in A.",
      numbers);
}

}  // namespace

void draw_stack(Page& page, const Rect& rect, const StackRun& run, const StackView& view) {
  const Rect inside = page.panel(rect, "");
  const double n = run.boxes(), bottom = -0.35;
  Camera camera = fit(inside, {{-1.75, bottom}, {1.75, n + 0.2}});
  camera.center.y() =
      bottom + 0.5 * inside.height / camera.scale;  // little of the ground, whatever the panel
  WorldLook look{.numbers = !view.masses, .penetration = false};
  look.active_contact = view.contact;
  if (view.contact >= 0) {
    look.active_a = {view.contact};
    look.active_b = {view.contact + 1};
  }
  draw_world(page, camera, run.snapshot, look);
  if (view.masses) draw_masses(page, camera, run);
  if (view.pushes) draw_pushes(page, camera, run);
  if (view.velocity.size() > 0) draw_speeds(page, camera, run, view.velocity);
  if (view.row >= 0) draw_bracket(page, camera, view.row, true);
  if (view.other_row >= 0) draw_bracket(page, camera, view.other_row, false);
  if (view.asked) draw_asked(page, camera, run);
}

void draw_product(Page& page, const Rect& rect, const List<MatrixView>& factors,
                  const List<std::string>& signs) {
  const Rect inside = page.panel(rect, "");
  const double title = 30, names = 26, gap = 1.4;  // [px, px, cells] above, below and between matrices
  double across = 1 + gap * signs.size();          // [cells] with the first one's row names
  for (const MatrixView& view : factors) across += static_cast<double>(view.values.cols());
  const auto most = static_cast<double>(factors[0].values.rows());
  const double cell = std::min({64.0, inside.width / across, (inside.height - title - names) / most});
  const double top = inside.y + 0.5 * (inside.height - title - names - most * cell);
  const TextStyle sign{
      .size = std::min(30.0, 0.5 * cell), .color = page.theme().text, .bold = true, .align = Align::center};
  double x = inside.x + 0.5 * (inside.width - across * cell) + 0.7 * cell;
  for (int i = 0; i < factors.size(); ++i) {
    const MatrixView& view = factors[i];
    const double left = view.row_names.empty() ? 0 : 24;  // [px] of the row names
    const double below = view.column_names.empty() ? 2 : names;
    const double width = static_cast<double>(view.values.cols()) * cell;
    // A title may be wider than its cells; those are as large as their height allows.
    draw_matrix(page, {x - left, top, left + width + 1.2 * cell, title + below + most * cell}, view);
    x += width;
    if (i < signs.size())
      page.canvas().text({x + 0.5 * gap * cell - 6, top + title + 0.5 * most * cell + 0.35 * sign.size},
                         signs[i], sign);
    x += gap * cell;
  }
}

List<MatrixView> system_views(const StackRun& run, int active) {
  const int n = run.boxes();
  return {{.title = "A (kg^{−1})",
           .values = run.system.A,
           .row_names = row_names(n),
           .column_names = row_names(n),
           .active_row = active},
          {.title = "b (m/s²)", .values = run.system.b, .active_row = active}};
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

List<Shot> stack_shots(const StackRun& run, const StackRun& heavy) {
  List<Shot> shots = {question_shot(
      card(),
      {.state = "before the first row",
       .alt =
           "Three stacked boxes of 1 kg, and the same with 100 kg on top: all fall at the same speed, "
           "their contacts carry 30, 20, 10 and 1020, 1010, 1000 N; beside each contact its number of b, not "
           "known yet; and the question how many of them change",
       .scene = [&run, &heavy](Page& page, const Rect& rect) { draw_question(page, rect, run, heavy); },
       .place = ScenePlace::above})};
  for (const Shot& shot : building_shots(run)) shots.push_back(shot);
  shots.push_back(
      key_shot(run, "λ = A⁻¹ b",
               "The stack of 1 kg boxes, held by its contacts; beside it the inverse of A times b "
               "is λ.",
               [](Page& page, const StackRun& all) { draw_solution(page, page.area(), all); }));
  shots.push_back(answer_shot(
      card(),
      {.state = "answer",
       .alt = "The stack with 100 kg on top, held by its contacts; beside it the inverse of A times b is λ; "
              "and the answer.",
       .scene = [&heavy](Page& page, const Rect& rect) { draw_solution(page, rect, heavy); },
       .place = ScenePlace::above},
      answer_text(run)));
  return shots;
}

}  // namespace cairn::big
