// The rod, its pin's impulses in the plane of lambda_1 and lambda_2, and the way of both solvers through it.
#include "lesson.hpp"

namespace cairn::blocks {

namespace {

/// What a frame of the rod shows: the rod under these impulses, and the way to them.
struct RodMoment {
  Pair lambda = {0, 0};        // [N]
  Vec2<double> slip = {0, 0};  // [m/s] of the pinned end
  List<Pair> way = {};         // through the plane, from the start
  bool block = false;
};

RodMoment after_update(const RodRun& rod, int last) {
  RodMoment moment{
      .lambda = rod.updates[last].after, .slip = rod.updates[last].slip, .way = {rod.by_block[0]}};
  for (int i = 0; i <= last; ++i) moment.way.push_back(rod.updates[i].after);
  return moment;
}

RodMoment after_block(const RodRun& rod) {
  return {.lambda = rod.by_block[1], .way = {rod.by_block[0], rod.by_block[1]}, .block = true};
}

/// And the weight, in the same scale, at x = `beside`.
void draw_pin_force(Page& page, const Camera& camera, const Pair& lambda, double beside) {
  const ArrowScale scale{.pixels_per_unit = 0.13 * camera.scale, .longest = 1.5 * camera.scale, .unit = "N"};
  for (const int row : {0, 1}) {
    if (!(lambda[row] > 0.05)) continue;
    render::Arrow arrow{.kind = ArrowKind::joint,
                        .label = fmt::format("λ_{{{}}} = {} N", row + 1, fixed(lambda[row], 2))};
    arrow.value[row] = lambda[row];
    draw_arrow(page, camera, scale, arrow);
  }
  draw_arrow(
      page, camera, scale,
      {.kind = ArrowKind::external, .tail = {beside, 1.2}, .value = {0, -gravity}, .label = "m g = 10 N"});
}

void draw_rod(Page& page, const Rect& rect, const RodRun& rod, const RodMoment& moment) {
  const Rect inside = page.panel(
      rect, fmt::format("pull of the pin; its end of the rod moves at ({}, {}) m/s",
                        significant(cleaned(moment.slip.x()), 2), significant(cleaned(moment.slip.y()), 2)));
  const double angle = rod.start.bodies[{1}].pose.angle;
  const Vec2<double> end = Vec2<double>(std::cos(angle), std::sin(angle)) * rod_length;
  const double beside = std::max(end.x(), 1.0) + 0.5;
  const Camera camera = fit(inside, {{-1.4, -0.7}, {beside + 0.3, std::max(end.y(), 1.3) + 0.1}});
  page.canvas().push_clip(inside);
  draw_world(page, camera, rod.start, {.numbers = false, .contacts = false});
  draw_pin_force(page, camera, moment.lambda, beside);
  page.canvas().pop_clip();
}

/// Where row `i` is satisfied: A_i1 lambda_1 + A_i2 lambda_2 = b_i.
void draw_row_line(Page& page, const Camera& camera, const RodRun& rod, int i) {
  const Matrix<double>& A = rod.system.A;
  const Vec2<double> along = Vec2<double>(-A(i, 1), A(i, 0)).normalized() * 20;
  const Vec2<double> middle = {rod.formula[0], rod.formula[1]};
  page.canvas().line(camera.project(middle - along), camera.project(middle + along),
                     {.width = 1.5, .color = page.theme().inactive, .dash = {8, 6}});
}

/// Which row each dashed line belongs to, at its end.
void name_row_lines(Page& page, const Camera& camera, const RodRun& rod) {
  const Matrix<double>& A = rod.system.A;
  TextStyle text = page.label();
  text.halo = page.theme().panel;
  text.align = Align::right;
  const double low = -0.9;
  Point at = camera.project({std::min((rod.system.b(0) - A(0, 1) * low) / A(0, 0), 0.0), low});
  page.canvas().text({at.x() - 8, at.y()}, "row 1", text);
  // To the right of the ring and below the line, clear of the axes and their numbers.
  const double right = camera.unproject({camera.viewport.x + camera.viewport.width - 6, 0}).x();
  at = camera.project({right, (rod.system.b(1) - A(1, 0) * right) / A(1, 1)});
  page.canvas().text({at.x(), at.y() + 2.6 * text.size}, "row 2", text);
}

void draw_axes(Page& page, const Camera& camera, const RodRun& rod) {
  const Stroke axis{.width = page.sizes().axis, .color = page.theme().outline};
  const Rect& view = camera.viewport;
  const Point origin = camera.project({0, 0});
  page.canvas().line({view.x, origin.y()}, {view.x + view.width, origin.y()}, axis);
  page.canvas().line({origin.x(), view.y}, {origin.x(), view.y + view.height}, axis);
  const Point exact = camera.project({rod.formula[0], rod.formula[1]});
  const Stroke guide{.width = 1, .color = page.theme().secondary_text, .dash = {2, 4}};
  page.canvas().line(exact, {exact.x(), origin.y()}, guide);
  page.canvas().line(exact, {origin.x(), exact.y()}, guide);
  TextStyle text = page.label();
  text.halo = page.theme().panel;
  text.align = Align::center;
  page.canvas().text({exact.x(), origin.y() + text.size + 4}, fixed(rod.formula[0], 2), text);
  text.align = Align::right;
  page.canvas().text({origin.x() - 6, exact.y() + 0.35 * text.size}, fixed(rod.formula[1], 2), text);
  page.canvas().text({view.x + view.width - 6, origin.y() - 8}, "λ_{1}", text);
  text.align = Align::left;
  page.canvas().text({origin.x() + 8, view.y + text.size}, "λ_{2}", text);
}

void draw_way(Page& page, const Camera& camera, const RodMoment& moment, const SeriesStyle& style) {
  List<Point> points;
  for (const Pair& stop : moment.way) points.push_back(camera.project({stop[0], stop[1]}));
  page.canvas().polyline(points, {.width = page.sizes().curve, .color = style.color});
  for (const Point& point : points)
    draw_marker(page.canvas(), point, style.marker, page.sizes().marker, style.color);
}

/// Start and first two stops of the rows, in numbers.
void name_stops(Page& page, const Camera& camera, const RodRun& rod) {
  TextStyle text = page.label();
  text.halo = page.theme().panel;
  const auto name = [&](const Pair& stop, double down) {
    const Point at = camera.project({stop[0], stop[1]});
    page.canvas().text({at.x() + 10, at.y() + down * text.size},
                       fmt::format("({}, {})", significant(stop[0], 3), significant(stop[1], 3)), text);
  };
  name(rod.by_rows[0], -0.6);
  name(rod.updates[0].after, 1.4);
  const double apart = rod.updates[0].after[1] - rod.updates[1].after[1];
  if (camera.scale * apart > 2 * text.size) name(rod.updates[1].after, 1.4);
}

void draw_plane(Page& page, const Rect& rect, const RodRun& rod, const RodMoment& moment) {
  const Rect inside = page.panel(rect, "λ of the pin's two rows (N)");
  const Camera camera = fit(inside, {{-1.5, -1.3}, {rod.updates[0].after[0] + 1.9, rod_weight + 1.3}});
  page.canvas().push_clip(inside);
  draw_row_line(page, camera, rod, 0);
  draw_row_line(page, camera, rod, 1);
  draw_axes(page, camera, rod);
  name_row_lines(page, camera, rod);
  SeriesStyle pale = style_of_rows(page);
  pale.color = page.theme().inactive;
  if (moment.block) draw_way(page, camera, after_update(rod, rod.updates.size() - 1), pale);
  if (moment.block) name_stops(page, camera, rod);
  draw_way(page, camera, moment, moment.block ? style_of_blocks(page) : style_of_rows(page));
  page.canvas().circle(camera.project({rod.formula[0], rod.formula[1]}), page.sizes().joint,
                       {.outline = page.theme().exact.color, .outline_width = page.sizes().outline});
  page.canvas().pop_clip();
}

/// Rod and plane; returns what is free below the rod.
Rect draw_moment(Page& page, const RodRun& rod, const RodMoment& moment) {
  const List<Rect> parts = in_columns(page, {{0.55, {0.6, 0.4}}, 0.45});
  draw_plane(page, parts[2], rod, moment);
  draw_rod(page, parts[0], rod, moment);
  return parts[1];
}

void draw_update(Page& page, const BlocksRuns& all, int i) {
  const RodUpdate& update = all.rod.updates[i];
  const Rect panel = draw_moment(page, all.rod, after_update(all.rod, i));
  const int row = update.row;
  const double diagonal = all.rod.system.A(row, row);
  page.equation(panel, {.number = fmt::format("eq (22), row {}", row + 1),
                        .symbols = fmt::format("Δλ_{{{0}}} = (ζ − j_{{{0}}}·v) / (A_{{{0}{0}}} Δt)", row + 1),
                        .numbers = fmt::format("= (0 − ({})) / ({} × {:g})", fixed(update.jv, 4),
                                               fixed(diagonal, 2), all.settings.dt),
                        .result = fmt::format("= {} N", fixed(update.corrective, 3)),
                        .algorithm = fmt::format("λ_{{{}}}: {} → {}", row + 1, fixed(update.before[row], 3),
                                                 fixed(update.after[row], 3)),
                        .color = style_of_rows(page).color});
}

void draw_block(Page& page, const BlocksRuns& all) {
  const Rect panel = draw_moment(page, all.rod, after_block(all.rod));
  const Matrix<double>& A = all.rod.system.A;
  const Vec2<double> before = {all.rod.by_block[0][0], all.rod.by_block[0][1]};
  const Vec2<double> missing = all.rod.system.b - A * before;
  const auto line = [&](int row) {
    return fmt::format("{} Δλ_{{1}} {} {} Δλ_{{2}} = {}", fixed(A(row, 0), 2), A(row, 1) < 0 ? "−" : "+",
                       fixed(std::abs(A(row, 1)), 2), significant(missing(row), 3));
  };
  page.equation(panel,
                {.number = "4.3: A_{BB} Δλ = (ζ − J v) / Δt, both rows together",
                 .symbols = line(0),
                 .numbers = line(1),
                 .result = fmt::format("Δλ = ({}, {}) N", fixed(all.rod.by_block[1][0] - before.x(), 2),
                                       fixed(all.rod.by_block[1][1] - before.y(), 2)),
                 .algorithm = "after sweep 1 nothing is left to do",
                 .color = style_of_blocks(page).color});
}

List<Shot> rod_shots(const BlocksRuns& all) {
  List<Shot> shots;
  for (int i = 0; i < all.rod.updates.size(); ++i) {
    const RodUpdate& update = all.rod.updates[i];
    shots.push_back(
        {.state = fmt::format("rod · rows · sweep {} · row {} of 2", update.sweep, update.row + 1),
         .alt =
             fmt::format("Sweep {}, row {}: the impulses are {:.3f} and {:.3f} N; one more step "
                         "of the zig-zag, and the pinned end moves at {:.4f} m/s.",
                         update.sweep, update.row + 1, update.after[0], update.after[1], update.slip.norm()),
         .draw = [&all, i](Page& page) { draw_update(page, all, i); },
         .key = i == 1});
  }
  shots.push_back(key_shot(
      all, "rod · the block · sweep 1",
      "The block goes from the start to the answer in one step, straight between the lines of the rows.",
      draw_block));
  return shots;
}

/// The beams beside what is known of their sweeps, in the answer all of it.
QuestionFrame question_frame(const BlocksRuns& all, bool asked) {
  const auto draw = [&all, asked](Page& page, const Rect& rect) {
    const List<Rect> parts = asked ? in_rows(page, rect, {0.5, 0.5}) : in_rows(page, rect, {0.34, 0.66});
    draw_start(page, parts[0], all.chains[welded_ten]);
    draw_sweep_bars(page, parts[1], all, asked);
  };
  return {.state = asked ? "before the first sweep" : "answer",
          .alt = asked ? "Ten beams in a chain, the first welded to a wall; bars of the share of sweeps that "
                         "blocks leave of one beam; and the question."
                       : "Bars of the share of sweeps that blocks leave, of one, two, three and ten beams: "
                         "more and more; and the answer.",
          .scene = draw,
          .place = ScenePlace::above};
}

std::string answer_text(const BlocksRuns& all) {
  const ChainRun& ten = all.chains[welded_ten];
  return fmt::format(
      "{} %. A block saves what the rows of its own joint couple. What couples one joint with another stays, "
      "and in a long chain that is nearly all.",
      fixed(share_left(ten), 0));
}

}  // namespace

SeriesStyle style_of_rows(const Page& page) { return render::neutral_styles(page.theme())[1]; }
SeriesStyle style_of_blocks(const Page& page) { return {page.theme().si.color, {}, Marker::circle}; }

List<Shot> blocks_shots(const BlocksRuns& all) {
  List<Shot> shots = {question_shot(card(), question_frame(all, true))};
  for (const List<Shot>& more : {rod_shots(all), chain_shots(all), bob_shots(all)})
    shots.insert(shots.end(), more.begin(), more.end());
  shots.push_back(answer_shot(card(), question_frame(all, false), answer_text(all)));
  return shots;
}

}  // namespace cairn::blocks
