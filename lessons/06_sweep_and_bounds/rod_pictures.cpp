// The rod on its supports, beside the plane of its two lambda.
#include "lesson.hpp"

namespace cairn::sweeps {

namespace {

using Pair = FixedList<double, 2>;

Pair pair_of(const PerRow<double>& lambda) { return {lambda[0], lambda[1]}; }

/// "1 m" below a line between two places along the rod.
void draw_distance(Page& page, const Camera& camera, double from, double to) {
  const double y = -0.17;
  draw_length(page, camera.project({from, y}), camera.project({to, y}),
              {.width = 1.5, .color = page.theme().secondary_text});
  TextStyle style = aligned(page.value(), Align::center);
  page.canvas().text(camera.project({(from + to) / 2, y}) + Point(0, 6 + style.size), brief(to - from) + " m",
                     style);
}

/// What the picture of the rod shows besides the rod.
struct RodScene {
  Pair lambda = {};                  // [N] what the supports give
  double instead_of = 0;             // [N] an earlier push of the right one, drawn pale; 0: none
  bool clamped = false;              // the left one has just asked for a pull
  bool asks = false;                 // with distances, and a question mark
  Span<const Snapshot> motion = {};  // where the rod goes
};

/// The name of a force, beside its arrow or a line lower or higher; `align` says where `at` is in it.
void name_force(Page& page, const Rect& within, const Point& at, Align align, const std::string& name) {
  TextStyle style = aligned(page.value(), align);
  style.halo = page.theme().background;
  style.color = page.theme().normal;
  style.bold = !page.compact();
  if (!page.compact()) style.size = std::max(style.size, render::large_text);
  List<Point> places;
  for (const double down : {0.0, 1.3, -1.5, -3.0}) places.push_back(at + Point(0, down * style.size));
  page.place_text(places, within, name, style);
}

void draw_forces(Page& page, const Camera& camera, const SweepRun& run, const RodScene& shown) {
  const double weight = rod_mass * gravity;
  const double largest = std::max({std::abs(run.rod.statics[0]), run.rod.statics[1], weight});
  const double metres = 1.5 / largest;  // [m/N]
  const ArrowScale scale{
      .pixels_per_unit = metres * camera.scale, .longest = 1.6 * camera.scale, .unit = "N"};
  const auto arrow = [&](ArrowKind kind, double x, double force, const std::string& label) {
    const double tail = force < 0 ? 0.12 - metres * force : 0.12;  // both ways upon the rod
    draw_arrow(page, camera, scale, {.kind = kind, .tail = {x, tail}, .value = {0, force}, .label = label});
  };
  const double shift = std::abs(run.rod.arm[1]) < 0.2 ? 0.2 : 0;  // not upon the push
  const double middle = rod_length / 2 + shift;
  page.avoid({camera.project({middle, 0.12}), camera.project({middle, 0.12 + metres * weight})});
  const double support = run.settings.support;
  if (shown.instead_of > 0) {
    arrow(ArrowKind::inactive, support, shown.instead_of,
          fmt::format("not {} N", brief(shown.instead_of, 2)));
  }
  const double height = metres * shown.lambda[1];  // [m]
  arrow(ArrowKind::normal, support, shown.lambda[1], "");
  const bool stays = shown.lambda[0] != 0 || shown.motion.empty();  // else the rod leaves this support
  if (stays) {
    arrow(ArrowKind::normal, 0.02, shown.lambda[0], "");
    const Point at = camera.project({0.02, 0.12 + metres * std::abs(shown.lambda[0]) / 2}) + Point(-14, 6);
    name_force(page, camera.viewport, at, Align::right,
               fmt::format("λ_{{1}} = {} N", brief(shown.lambda[0], 2)));
    if (shown.lambda[0] < 0 || shown.clamped)
      name_force(page, camera.viewport, at + Point(0, 23), Align::right,
                 shown.clamped ? "clamped" : "a pull");
  }
  // Beside a long arrow, above a short one; on the side where the weight is not.
  const bool is_long = height > 0.5, is_left = support < middle;
  const Point aside = is_long ? Point(is_left ? -14 : 14, 6) : Point(is_left ? 12 : -12, -8);
  name_force(page, camera.viewport, camera.project({support, 0.12 + (is_long ? height / 2 : height)}) + aside,
             is_left ? Align::right : Align::left, fmt::format("λ_{{2}} = {} N", brief(shown.lambda[1], 2)));
  arrow(ArrowKind::external, middle, -weight, fmt::format("m g = {} N", brief(weight)));
}

/// The rod, what its supports give, its weight, and how far from each other they act.
void draw_rod(Page& page, const Rect& rect, const SweepRun& run, const RodScene& shown) {
  std::string title = "forces (N)";
  if (shown.motion.size() > 1)
    title += fmt::format("; an outline every {} s", brief(shown.motion[1].time - shown.motion[0].time));
  const Rect inside = page.panel(rect, title);
  Camera camera = fit(inside, {{-0.8, -0.75}, {rod_length + 0.2, 1.75}});
  camera.center.y() = std::min(0.5, 0.5 * inside.height / camera.scale - 0.75);  // little of the ground
  page.canvas().push_clip(inside);
  if (!shown.motion.empty()) draw_ghosts(page, camera, shown.motion);
  draw_world(page, camera, run.rod.snapshot, {.numbers = false, .contacts = false, .penetration = false});
  const double middle = rod_length / 2, support = run.settings.support;
  draw_forces(page, camera, run, shown);
  if (shown.asks) {
    draw_distance(page, camera, 0, std::min(support, middle));
    if (std::abs(middle - support) > 0.2)
      draw_distance(page, camera, std::min(support, middle), std::max(support, middle));
    TextStyle style{.size = 24, .color = page.theme().normal, .bold = true};
    style.align = Align::center;
    page.canvas().text(camera.project({std::min(support, 1.8), 1.75}), "if no support pulls: λ_{2} = ?",
                       style);
  }
  page.canvas().pop_clip();
}

List<Pair> way_of(const Swept& swept, int count) {
  List<Pair> way = {{0, 0}};
  for (int k = 0; k < count; ++k) way.push_back(pair_of(swept.after[k]));
  return way;
}

/// Whether the row asked for a pull and was clamped.
bool is_cut(const RowUpdate<double>& update) { return update.impulse_before + update.corrective < -1e-12; }

/// Rod at the top left, plane right; returns what is free below the rod.
Rect draw_rod_moment(Page& page, const SweepRun& run, const RodScene& shown, const PlaneView& view) {
  const List<Rect> parts = in_columns(page, {{0.57, {0.54, 0.46}}, 0.43});
  draw_plane(page, parts[2], run, view);
  draw_rod(page, parts[0], run, shown);
  return parts[1];
}

/// So many updates of the solve without the clamp as can be told apart.
int visible_updates(const RodRun& rod) { return std::min(rod.unbounded.after.size(), 300); }

void draw_unbounded(Page& page, const SweepRun& run) {
  const RodRun& rod = run.rod;
  const PlaneView view{.other = way_of(rod.unbounded, visible_updates(rod))};
  const Rect rest = draw_rod_moment(page, run, {.lambda = rod.statics}, view);
  const List<Rect> parts = in_columns(page, rest, {0.42, 0.58});
  draw_system(page, parts[0], rod.system, -1);
  page.equation(parts[1],
                {.number = "eq (14), no bounds",
                 .symbols = "A λ = b",
                 .result = fmt::format("λ = ({}, {}) N", brief(rod.statics[0], 2), brief(rod.statics[1], 2)),
                 .algorithm = rod.tips() ? "a support that pulls" : "both supports push"});
}

/// Strikes a result out and writes beside it what the clamp makes of it.
void strike_result(Page& page, const std::string& result, double clamped) {
  for (const render::TextBox& box : page.canvas().text_boxes()) {
    if (box.text != result) continue;
    const Rect at = box.rect;
    TextStyle style = box.style;
    const double y = at.y + at.height / 2;
    page.canvas().line({at.x + page.canvas().text_width("= ", style) - 4, y}, {at.x + at.width + 4, y},
                       {.width = 3, .color = page.theme().text});
    style.color = page.theme().normal;
    page.canvas().text({at.x + at.width + 24, at.y + at.height}, fmt::format("→ {} N", brief(clamped)),
                       style);
    return;
  }
}

void draw_rod_update(Page& page, const SweepRun& run, int k) {
  const RodRun& rod = run.rod;
  PlaneView view{.way = way_of(rod.bounded, k + 1)};
  const RowUpdate<double>& update = rod.bounded.updates[k];
  view.asked = view.way[k];
  view.asked[update.row] = (update.impulse_before + update.corrective) / run.settings.dt;
  const bool cut = is_cut(update);
  const Rect rest =
      draw_rod_moment(page, run, {.lambda = pair_of(rod.bounded.after[k]), .clamped = cut}, view);
  const Equation equation = equation_28(page, rod.system, rod.bounded, k);
  page.equation(rest, equation);
  if (cut) strike_result(page, equation.result, rod.bounded.after[k][update.row]);
}

/// w = A lambda - b of both rows, beside lambda.
void draw_complement(Page& page, const SweepRun& run) {
  const RodRun& rod = run.rod;
  const PlaneView view{.way = way_of(rod.bounded, rod.bounded.after.size())};
  const Rect rest = draw_rod_moment(page, run, {.lambda = pair_of(rod.settled.after.back())}, view);
  TableView table;
  table.header = {"row", "λ (N)", "w = A λ − b (m/s²)", "λ w"};
  for (int i = 0; i < 2; ++i) {
    const double lambda = rod.settled.after.back()[i];
    table.rows.push_back({fmt::format("{}", i + 1), brief(lambda), brief(rod.leaving[i]), "0"});
  }
  table.active_row = rod.tips() ? 0 : -1;
  page.table(rest, "A contact pushes, or it opens; never both", table);
}

std::string answer_text(const RodRun& rod) {
  if (!rod.tips()) return "Nothing changes. Both push anyway, so the clamp never acts.";
  return fmt::format(
      "{} N, not {}. The right support had to push against the pull as well as against the weight. Without "
      "the "
      "pull, the rod tips about the right support.",
      brief(rod.formula[1], 2), brief(rod.statics[1], 2));
}

Shot rod_update_shot(const SweepRun& run, int k, int first_cut) {
  const Swept& swept = run.rod.bounded;
  const RowUpdate<double>& update = swept.updates[k];
  return {.state = fmt::format("the rod · sweep {}/{} · row {} of 2", update.sweep, run.settings.sweeps,
                               update.row + 1),
          .alt = fmt::format("Sweep {}, row {} of the rod: λ is ({:.4g}, {:.4g}) N{}; one more step of the "
                             "zig-zag in the plane.",
                             update.sweep, update.row + 1, swept.after[k][0], swept.after[k][1],
                             is_cut(update) ? ", the row having been clamped" : ""),
          .draw = [&run, k](Page& page) { draw_rod_update(page, run, k); },
          .key = k == first_cut};
}

}  // namespace

List<Shot> rod_shots(const SweepRun& run) {
  const Swept& swept = run.rod.bounded;
  int first_cut = 4;  // of a rod that does not tip: any two frames
  for (int k = swept.updates.size() - 1; k >= 0; --k) {
    if (is_cut(swept.updates[k])) first_cut = k;
  }
  List<Shot> shots;
  shots.push_back(
      key_shot(run, "the rod · without clamp",
               "The rod with the pull that A λ = b asks for, and a zig-zag to that answer, through "
               "the hatched part of the plane where λ is negative.",
               draw_unbounded));
  for (int k = 0; k < swept.updates.size(); ++k) shots.push_back(rod_update_shot(run, k, first_cut));
  shots.push_back(key_shot(run, "the rod · solved",
                           "λ and w of both supports: one is zero where the other is not.", draw_complement));
  return shots;
}

/// The card, whose question is about a support at 1 m.
LessonInfo card_for(const SweepRun& run) {
  LessonInfo info = card();
  if (run.settings.support != 1) {
    info.question = fmt::format(
        "A\u00a0λ\u00a0=\u00a0b says: λ₁ = {} N, λ₂ = {} N. No support can pull. How hard does the right "
        "one push, in N?",
        brief(run.rod.statics[0], 2), brief(run.rod.statics[1], 2));
  }
  return info;
}

Shot question_shot(const SweepRun& run) {
  return cairn::question_shot(card_for(run),
                              {.state = "before the first sweep",
                               .alt = "A rod on two supports, both left of its middle, the forces that "
                                      "hold it, one of them a pull, and the question.",
                               .scene = [&run](Page& page, const Rect& rect) {
                                 draw_rod(page, rect, run, {.lambda = run.rod.statics, .asks = true});
                               }});
}

Shot answer_shot(const SweepRun& run) {
  const bool tips = run.rod.tips();
  const auto scene = [&run, tips](Page& page, const Rect& rect) {
    RodScene shown{.lambda = run.rod.formula};
    if (tips) shown.instead_of = run.rod.statics[1], shown.motion = run.rod.motion;
    draw_rod(page, rect, run, shown);
  };
  return cairn::answer_shot(
      card_for(run),
      {.state = "answer",
       .alt = "The rod with the push of the right support alone, half as long as the arrow of A λ = b "
              "behind it; the rod tips; and the answer.",
       .scene = scene},
      answer_text(run.rod));
}

}  // namespace cairn::sweeps
