// The frames: c and its level curves, j by small moves, j·v for several motions, f, and the answer.
#include "lesson.hpp"

namespace cairn::one_row {

namespace {

const char* const coordinate_names[] = {"x", "y", "θ"};

std::string components(const Vec3<double>& v) {
  return fmt::format("({}, {}, {})", significant(v.x()), significant(v.y()), significant(v.z()));
}

/// Left the scene; returns the two parts on the right.
List<Rect> draw_scene(Page& page, const Rod& rod, const RodLook& look, double upper) {
  const List<Rect> parts = in_columns(page, {0.48, {0.52, {upper, 1 - upper}}});
  draw_rod(page, parts[0], rod, look);
  return {parts[1], parts[2]};
}

void draw_where(Page& page, const Story& story) {
  const Rod& rod = story.rod;
  const Vec2<double> along = rod.jacobian.head<2>();
  const List<std::pair<std::string, Vec3<double>>> moves = {{"1 m to the right", {1, 0, 0}},
                                                            {"1 m along the rod", {along.x(), along.y(), 0}},
                                                            {"1 m to the left", {-1, 0, 0}},
                                                            {"turned by 1 rad", {0, 0, 1}}};
  RodLook look{.pose = rod.pose, .close = true, .errors = true, .circles = true};
  TableView table{.header = {"the box, moved", "c"}, .rows = {{"not at all", "0 m"}}};
  for (const auto& [name, move] : moves) {
    const Pose<double> moved = carried(rod.pose, move, 1);
    table.rows.push_back({name, fixed(error_at(rod, moved), 2, Sign::always) + " m"});
    if (look.others.size() < 2) look.others.push_back(moved);  // more would lie on each other
  }
  const List<Rect> parts = draw_scene(page, rod, look, 0.42);
  const Vec2<double>& p = rod.settings.anchor;
  page.equation(parts[0], {.number = "eq (3)",
                           .symbols = "c = |p| − length",
                           .numbers = fmt::format("= √({}² + {}²) − {}", significant(p.x()),
                                                  significant(-p.y()), significant(rod.length)),
                           .result = "= 0 m"});
  page.table(parts[1], "c at other places", table);
}

void draw_jacobian(Page& page, const Story& story) {
  const Rod& rod = story.rod;
  const List<Rect> parts =
      draw_scene(page, rod, {.pose = rod.pose, .circles = true, .direction = true}, 0.24);
  const List<Rect> below = in_rows(page, parts[1], {0.5, 0.5});
  const MatrixView view{.values = rod.jacobian.transpose(), .column_names = {"x", "y", "θ"}};
  const Rect inside = page.panel(parts[0], "j: one row, three numbers for the box");
  draw_matrix(page, {inside.x + 0.3 * inside.width, inside.y, 0.7 * inside.width, inside.height}, view);
  const Vec3<double>& j = rod.jacobian;
  page.equation(below[0], {.number = "eq (5)",
                           .symbols = "j = (u_{x}, u_{y}, r × u)",
                           .numbers = fmt::format("u = ({}, {}), r = ({}, {}) m", significant(j.x()),
                                                  significant(j.y()), significant(rod.arm.x()),
                                                  significant(rod.arm.y())),
                           .result = fmt::format("r × u = {} m", significant(j.z())),
                           .algorithm = "u: along the rod; r: from the centre to the anchor"});
  const auto per_mille = [](double slope) { return fixed(slope, 2, Sign::always) + " mm"; };
  page.table(below[1], "three slopes",
             {.header = {"a small move", "c grows by"},
              .rows = {{"1 mm to the right", per_mille(j.x())},
                       {"1 mm up", per_mille(j.y())},
                       {"a turn by 0.001 rad", per_mille(j.z())}}});
}

/// Coordinate k moved both ways: as far as it is drawn, and less.
void draw_nudge(Page& page, const Rod& rod, int k) {
  const std::string unit = k == 2 ? "rad" : "m";
  const Vec3<double> move = Vec3<double>::Unit(k);
  TableView table{.header = {"h (" + unit + ")", "c(−h) (m)", "c(+h) (m)", "slope"}};
  for (const double h : {0.5, 0.1, 0.01}) {
    const Quotient less = quotient(rod, h);
    table.rows.push_back(
        {significant(h), fixed(less.backward[k], 4), fixed(less.forward[k], 4), fixed(less.slope[k], 4)});
  }
  table.rows.push_back({"j", "", "", fixed(rod.jacobian(k), 4)});
  table.active_row = 0;
  const Quotient q = quotient(rod, 0.5);  // large enough to be seen
  const List<Rect> parts = draw_scene(page, rod,
                                      {.pose = carried(rod.pose, move, q.h),
                                       .close = true,
                                       .others = {carried(rod.pose, move, -q.h), rod.pose},
                                       .errors = true,
                                       .circles = true},
                                      0.46);
  page.equation(parts[0], {.number = fmt::format("dc/d{} by a central difference, h = {} {}, as it is drawn",
                                                 coordinate_names[k], q.h, unit),
                           .symbols = "slope = (c(+h) − c(−h)) / 2h",
                           .numbers = fmt::format("= ({} − ({})) / {}", fixed(q.forward[k], 4),
                                                  fixed(q.backward[k], 4), significant(2 * q.h)),
                           .result = fmt::format("= {}", fixed(q.slope[k], 4))});
  page.table(parts[1], "smaller moves come nearer to j", table);
}

/// c while the box moves on at this velocity, and what j·v makes of it.
void draw_course(Page& page, const Rect& rect, const Rod& rod, const Motion& motion) {
  Plot plot{.title = "c while the box keeps this velocity (m)",
            .x = {.title = "t (s)", .min = -1, .max = 1},
            .cursor = 0};
  plot.series = {
      {.name = "c", .style = {.color = page.theme().outline}, .markers = false},
      {.name = "j·v t", .style = {.color = page.theme().velocity, .dash = {8, 6}}, .markers = false}};
  double largest = 1.2;  // [m] the same for all motions of the question
  for (int k = -20; k <= 20; ++k) {
    const double t = 0.05 * k, c = error_at(rod, carried(rod.pose, motion.velocity, t));
    plot.series[0].add(t, c);
    plot.series[1].add(t, motion.rate * t);
    largest = std::max({largest, std::abs(c), std::abs(motion.rate * t)});
  }
  plot.y = {.min = -largest, .max = largest};
  draw_plot(page, rect, plot);
}

std::string product(double factor, double value) {
  return in_brackets(significant(factor)) + " × " + in_brackets(significant(value));
}

void draw_motion(Page& page, const Rod& rod, const Motion& motion) {
  const List<Rect> parts = draw_scene(
      page, rod, {.pose = rod.pose, .close = true, .circles = true, .velocity = motion.velocity}, 0.42);
  const Vec3<double>&j = rod.jacobian, &v = motion.velocity;
  page.equation(parts[0], {.number = "eq (5)",
                           .symbols = "dc/dt = j·v,   v = " + components(v),
                           .numbers = fmt::format("= {} + {} + {}", product(j.x(), v.x()),
                                                  product(j.y(), v.y()), product(j.z(), v.z())),
                           .result = fmt::format("= {} m/s: {}", significant(motion.rate),
                                                 motion.rate == 0 ? "allowed" : "not allowed")});
  draw_course(page, parts[1], rod, motion);
}

void draw_force(Page& page, const Story& story) {
  const Rod& rod = story.rod;
  const List<Rect> parts = draw_scene(page, rod, {.pose = rod.pose, .force = true}, 0.46);
  const Vec3<double>& f = rod.force;
  page.equation(
      parts[0],
      {.number = "eq (9), (10)",
       .symbols = "f = j^{T} λ",
       .numbers = fmt::format("= {} × ({} N)", components(rod.jacobian), significant(rod.settings.lambda)),
       .result =
           fmt::format("= ({} N, {} N, {} N m)", significant(f.x()), significant(f.y()), significant(f.z())),
       .color = page.theme().normal});
  TableView table{.header = {"motion", "power f·v"}};
  for (const Motion& motion : rod.allowed)
    table.rows.push_back({motion.name, fixed(rod.force.dot(motion.velocity), 3) + " W"});
  table.rows.push_back({"along the rod: forbidden", fixed(rod.settings.lambda, 3) + " W"});
  page.table(parts[1], "the force does no work in a motion that the rod allows", table);
}

void draw_differences(Page& page, const Story& story) {
  const List<Rect> parts = in_columns(page, {0.56, 0.44});
  const List<Quotient>& all = story.rod.quotients;
  const double factor = all[2].error / (all[2].h * all[2].h);
  const double scale = epsilon * story.rod.length, lowest = 1e-13;
  const double least = all.back().h, most = all.front().h;
  const double first = std::sqrt(lowest / factor), last = scale / lowest;  // where the lines leave the chart
  Plot plot{.title = "largest |j − central difference| of the rod"};
  plot.x = {.title = "h (m or rad)", .scale = AxisScale::logarithmic, .min = 3e-12, .max = 1};
  plot.y = {.scale = AxisScale::logarithmic, .min = lowest, .max = 1e-2};
  const Color color = page.theme().text;
  plot.series = {
      {.style = {color, {}, Marker::circle}, .line = false},
      {.style = {.color = color}, .x = {first, most}, .y = {lowest, factor * most * most}, .markers = false},
      {.style = {.color = color, .dash = {8, 6}},
       .x = {least, last},
       .y = {scale / least, lowest},
       .markers = false}};
  for (const Quotient& q : all) plot.series[0].add(q.h, q.error);
  plot.labels = {
      {1e-9, scale / 1e-9, fmt::format("rounding: about ε |p| / h, ε = {}", significant(epsilon, 2))},
      {1e-3, 1e-6 * factor, "falls with h²"}};
  draw_plot(page, parts[0], plot);
  TableView table{.header = {"h = 10^{−5}, 20 poses", "rows", "difference"}};
  for (const KindOfRows& kind : story.kinds)
    table.rows.push_back({kind.name, fmt::format("{}", kind.rows), significant(kind.error, 2)});
  page.table(parts[1], "every kind of row in the library", table);
}

Shot motion_shot(const Story& story, const Motion& motion, const std::string& state) {
  return key_shot(
      story, state,
      fmt::format("The velocities of the box and of its anchor as arrows; j·v = {:.3f} m/s, the slope "
                  "of c at this moment.",
                  motion.rate),
      [motion](Page& page, const Story& all) { draw_motion(page, all.rod, motion); });
}

/// The reader's velocity, and those of the question.
List<Shot> motion_shots(const Story& story) {
  const Rod& rod = story.rod;
  const Vec3<double>& own = rod.settings.velocity;
  List<Shot> shots = {motion_shot(story, {.velocity = own, .rate = rod.jacobian.dot(own)}, "j·v: how fast")};
  shots.back().key = false;
  for (int i = 0; i < rod.asked.size(); ++i)
    shots.push_back(motion_shot(story, rod.asked[i], fmt::format("j·v: velocity {} of 3", i + 1)));
  return shots;
}

Shot nudge_shot(const Story& story, int k) {
  Shot made =
      key_shot(story, fmt::format("the same by trying: {}", coordinate_names[k]),
               fmt::format("The box moved in {} to both sides, and c of each place: c grows by {:.3f} for "
                           "1 of it.",
                           coordinate_names[k], story.rod.quotients[0].slope[k]),
               [k](Page& page, const Story& all) { draw_nudge(page, all.rod, k); });
  made.key = k == 2;
  return made;
}

QuestionFrame frame_of(const Story& story, const std::string& state, const std::string& alt, RodLook look) {
  look.pose = story.rod.pose;
  return {.state = state, .alt = alt, .scene = [&story, look](Page& page, const Rect& rect) {
            draw_rod(page, rect, story.rod, look);
          }};
}

std::string answer_text(const List<Motion>& asked) {
  return fmt::format(
      "{}, {} and {} m/s: a velocity makes the rod longer by j·v. Where that is 0 the rod allows "
      "it: the anchor moves along the circle, whatever the centre does.",
      significant(asked[0].rate), significant(asked[1].rate), significant(asked[2].rate));
}

}  // namespace

List<Shot> rod_shots(const Story& story) {
  List<Shot> shots = {question_shot(
      card(),
      {.state = "before we ask",
       .alt = "A box on a rod, three times, with one of three velocities each, and the question how fast "
              "each makes the rod longer",
       .scene = [&story](Page& page, const Rect& rect) {
         const List<Rect> parts = in_columns(page, rect, {1.0 / 3, 1.0 / 3, 1.0 / 3});
         for (int i = 0; i < 3; ++i)
           draw_rod(page, parts[i], story.rod, {.pose = story.rod.pose, .asked = i});
       }})};
  shots.push_back(
      key_shot(story, "c: where",
               "The rod, the box, circles around the pivot where c is −1, 0 and 1 m, and c of the box at "
               "four other places.",
               draw_where));
  shots.push_back(
      key_shot(story, "j: which way",
               "An arrow along the rod, at right angles to the circle c = 0, and an arc around the box: "
               "j = " +
                   components(story.rod.jacobian),
               draw_jacobian));
  for (int k = 0; k < 3; ++k) shots.push_back(nudge_shot(story, k));
  for (const Shot& next : motion_shots(story)) shots.push_back(next);
  shots.push_back(key_shot(story, "jᵀ λ: which force",
                           "The pull of the rod as an arrow at the anchor and its torque as an arc.",
                           draw_force));
  shots.push_back(key_shot(story, "j against differences",
                           "The error of a central difference against its step: it falls as h squared, then "
                           "rounding takes over. Beside it every kind of row in the library.",
                           draw_differences));
  shots.back().key = false;
  shots.push_back(answer_shot(
      card(),
      frame_of(
          story, "after the lesson",
          "The three velocities as the anchor has them: the first and the third along the circle that the "
          "rod allows, the second along the rod.",
          {.close = true, .circles = true, .answered = true}),
      answer_text(story.rod.asked)));
  return shots;
}

}  // namespace cairn::one_row
