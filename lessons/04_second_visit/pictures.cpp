// The box on its feet, visit by visit, with the clamp on each push and on the sum side by side.
#include "lesson.hpp"

namespace cairn::feet {

namespace {

/// How fast a foot moves: an arrow at its outer edge, and its value beside the box. A foot near the side of
/// the box has its arrow at its inner edge.
void draw_foot_velocity(Page& page, const Camera& camera, const BoxRun& box, const BoxView& view, int i) {
  const double outwards = i == 0 ? -1 : 1;
  const double edge = std::abs(box.foot[i]) > 0.3 ? -0.09 * outwards : 0.09 * outwards;
  const double velocity = cleaned(view.foot_velocity[i]);
  const double metres = 1.1 / view.fastest;  // [s]
  const ArrowScale scale{
      .pixels_per_unit = metres * camera.scale, .longest = 1.1 * camera.scale, .unit = "m/s"};
  if (std::abs(velocity) * scale.pixels_per_unit >= 2) {
    draw_arrow(page, camera, scale,
               {.kind = ArrowKind::velocity,
                .tail = {box.foot[i] + edge, std::max(0.0, -velocity * metres)},
                .value = {0, velocity}});
  }
  TextStyle style = aligned(page.value(), i == 0 ? Align::right : Align::left);
  const Point at = camera.project({0.56 * outwards, 0.12}) + Point(10 * outwards, 0);
  page.canvas().text(at, fixed(velocity, 2, Sign::always) + " m/s", style);
  style.color = page.theme().secondary_text;
  style.mono = false;
  page.canvas().text(at - Point(0, 1.4 * style.size), fmt::format("{} foot", name_of_foot(i)), style);
}

/// The sum of a foot at the tip of its arrow, where there is room.
void label_sum(Page& page, const Camera& camera, const Vec2<double>& tip, const std::string& text, bool lit) {
  TextStyle style = page.value();
  style.bold = lit;
  style.halo = page.theme().body;
  const Point at = camera.project(tip);
  const double width = page.canvas().text_width(text, style);
  const double above = at.y() - 6;
  const double middle = at.x() - width / 2;
  page.place_text({{middle, above},
                   {at.x() + 12, at.y() + style.size},
                   {at.x() - 12 - width, at.y() + style.size},
                   {middle, above - 1.3 * style.size}},
                  camera.viewport, text, style);
}

Equation equation_of(const Page& page, const Landing& landing, double exact, int k) {
  const Visit& visit = landing.visits[k];
  const int foot = visit.foot;
  const std::string before = fixed(visit.before[foot], 2);
  const std::string asked = fixed(std::abs(cleaned(visit.asked)), 2);
  const char* sign = cleaned(visit.asked) < 0 ? "−" : "+";
  const std::string p = fmt::format("p_{{{}}}", name_of_foot(foot));
  Equation equation;
  equation.number = fmt::format("(22): p_{{corr}} = {} N s", fixed(cleaned(visit.asked), 2, Sign::always));
  if (landing.clamped == Clamped::increment) {
    equation.symbols = fmt::format("{} ← {} + max(0, p_{{corr}})", p, p);
    equation.numbers = fmt::format("= {} + max(0, {}{})", before, cleaned(visit.asked) < 0 ? "−" : "", asked);
  } else {
    equation.symbols = fmt::format("{} ← max(0, {} + p_{{corr}})", p, p);
    equation.numbers = fmt::format("= max(0, {} {} {})", before, sign, asked);
  }
  equation.result = fmt::format("= {} N s", fixed(visit.after[foot], 2));
  equation.algorithm = fmt::format("both feet have to give {:.4g} N s in the end", exact);
  equation.color = style_of(page.theme(), landing.clamped).color;
  return equation;
}

double largest_of(const FeetRun& run) {
  return std::max({run.box.by(Clamped::increment).impulse[0], run.box.exact[0], run.box.exact[1]});
}

BoxView view_after(const BoxRun& box, double speed, const Landing& landing, int visit) {
  const Visit& last = landing.visits[visit];
  BoxView view{.impulse = last.after, .foot = last.foot, .before = last.before[last.foot]};
  view.foot_velocity = {-speed + box.A11 * last.after[0] + box.A12 * last.after[1],
                        -speed + box.A12 * last.after[0] + box.A22 * last.after[1]};
  view.fastest = speed;
  return view;
}

void draw_visit(Page& page, const FeetRun& run, int k) {
  const List<Rect> halves = in_columns(page, {0.5, 0.5});
  int at = 0;
  for (const Clamped clamped : {Clamped::increment, Clamped::sum}) {
    const Landing& landing = run.box.by(clamped);
    const List<Rect> parts = in_rows(page, halves[at++], {0.62, 0.38});
    draw_box(page, clamp_panel(page, parts[0], clamped), run.box, largest_of(run),
             view_after(run.box, run.settings.speed, landing, k));
    page.equation(parts[1], equation_of(page, landing, run.box.exact[0], k));
  }
}

QuestionFrame question_frame(const FeetRun& run) {
  return {.state = "after one sweep",
          .alt =
              "A box on two feet after one sweep, with the impulses of its feet and how fast they move, and "
              "the question.",
          .scene = [&run](Page& page, const Rect& rect) {
            BoxView view = view_after(run.box, run.settings.speed, run.box.by(Clamped::sum), 1);
            view.asks = true;
            draw_box(page, page.panel(rect, "after one sweep: pushes (N s)"), run.box, largest_of(run), view);
          }};
}

QuestionFrame answer_frame(const FeetRun& run) {
  return {.state = "sweep 2 · left foot",
          .alt =
              "The second visit of the left foot: with each push clamped nothing is taken back, with the "
              "sum clamped a part of the first push; and the answer.",
          .scene =
              [&run](Page& page, const Rect& rect) {
                const List<Rect> parts = in_columns(page, rect, {0.5, 0.5});
                int at = 0;
                for (const Clamped clamped : {Clamped::increment, Clamped::sum}) {
                  draw_box(page, clamp_panel(page, parts[at++], clamped), run.box, largest_of(run),
                           view_after(run.box, run.settings.speed, run.box.by(clamped), 2));
                }
              },
          .place = ScenePlace::above};
}

std::string answer_text(const FeetRun& run) {
  const Visit& second = run.box.by(Clamped::sum).visits[2];
  const std::string sum = fixed(second.after[0], 2) + " N s: ";
  if (second.given() >= 0) return sum + "it gives more. For feet this far out, both clamps do the same.";
  return sum + "it takes back " + fixed(-second.given(), 2) +
         " N s of its first push, which was too large. A push may be negative; the sum may not.";
}

Shot visit_shot(const FeetRun& run, int k) {
  const Visit& naive = run.box.by(Clamped::increment).visits[k];
  const Visit& sum = run.box.by(Clamped::sum).visits[k];
  return {
      .state = fmt::format("sweep {}/{} · {} foot", sum.sweep, run.settings.sweeps, name_of_foot(sum.foot)),
      .alt = fmt::format("Sweep {}, {} foot: with each push clamped it gives {:.2f} N s, with the sum "
                         "clamped {:.2f} N s; boxes and both formulas side by side.",
                         sum.sweep, name_of_foot(sum.foot), naive.given(), sum.given()),
      .draw = [&run, k](Page& page) { draw_visit(page, run, k); },
      .key = k == 2};
}

List<Shot> visit_shots(const FeetRun& run) {
  List<Shot> shots;
  for (int k = 0; k < run.box.by(Clamped::sum).visits.size(); ++k) shots.push_back(visit_shot(run, k));
  return shots;
}

}  // namespace

SeriesStyle style_of(const Theme& theme, Clamped clamped) {
  if (clamped == Clamped::sum) return theme.si;
  return render::neutral_styles(theme)[0];
}

Rect clamp_panel(Page& page, const Rect& rect, Clamped clamped) {
  const Rect inside =
      page.panel(rect, clamped == Clamped::sum ? "the sum is clamped" : "each push is clamped");
  page.canvas().rect({rect.x, rect.y, rect.width, 5}, {.fill = style_of(page.theme(), clamped).color});
  return inside;
}

void draw_box(Page& page, const Rect& rect, const BoxRun& box, double largest, const BoxView& view) {
  Camera camera = fit(rect, {{-1, -0.1}, {1, 1.17}});
  camera.center.y() = std::min(0.54, 0.5 * rect.height / camera.scale - 0.1);  // little of the ground
  const double tallest = 0.9;                                                  // [m]
  page.canvas().push_clip(rect);
  draw_world(page, camera, box.snapshot, {.numbers = false, .contacts = false, .penetration = false});
  const ArrowScale scale{
      .pixels_per_unit = tallest * camera.scale / largest, .longest = 1.15 * camera.scale, .unit = "N s"};
  for (const int i : {0, 1}) draw_foot_velocity(page, camera, box, view, i);
  for (const int i : {0, 1}) {
    const double x = box.foot[i], sum = view.impulse[i];
    const bool lit = i == view.foot;
    if (sum <= 0.005) continue;
    draw_arrow(page, camera, scale, {.tail = {x, 0}, .value = {0, sum}, .active = lit});
    const double taken = lit ? view.before - sum : 0;
    if (taken > 0.005) {
      draw_arrow(page, camera, scale,
                 {.kind = ArrowKind::negative_correction,
                  .tail = {x, tallest * view.before / largest},
                  .value = {0, -taken},
                  .label = fixed(-taken, 2)});
    }
    const bool asked = view.asks && i == 0;
    const double height = tallest * sum / largest - (taken > 0.005 ? 0.35 : 0);
    label_sum(page, camera, {x, height}, fixed(sum, 2) + (asked ? ", then ?" : ""), lit || asked);
  }
  page.canvas().pop_clip();
}

LessonInfo card_for(const FeetRun& run) {
  LessonInfo info = card();
  info.question = question_of(run);
  return info;
}

List<Shot> feet_shots(const FeetRun& run) {
  List<Shot> shots = {question_shot(card_for(run), question_frame(run))};
  for (const List<Shot>& part : {visit_shots(run), motion_shots(run)})
    shots.insert(shots.end(), part.begin(), part.end());
  shots.push_back(spread_shot(run));
  shots.push_back(answer_shot(card_for(run), answer_frame(run), answer_text(run)));
  return shots;
}

}  // namespace cairn::feet
