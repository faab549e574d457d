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

void draw_where(Page& page, const Rod& rod) {
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

void draw_jacobian(Page& page, const Rod& rod) {
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

std::string product(double factor, double value) {
  return in_brackets(significant(factor)) + " × " + in_brackets(significant(value));
}

void draw_motion(Page& page, const Rod& rod) {
  const List<Rect> parts =
      draw_scene(page, rod, {.pose = rod.pose, .close = true, .circles = true, .velocity = true}, 0.42);
  const Vec3<double>&j = rod.jacobian, &v = rod.motion.velocity;
  page.equation(parts[0], {.number = "eq (5)",
                           .symbols = "dc/dt = j·v,   v = " + components(v),
                           .numbers = fmt::format("= {} + {} + {}", product(j.x(), v.x()),
                                                  product(j.y(), v.y()), product(j.z(), v.z())),
                           .result = fmt::format("= {} m/s: {}", significant(rod.motion.rate),
                                                 rod.motion.rate == 0 ? "allowed" : "not allowed")});
  TableView table{.header = {"the box", "m/s, rad/s", "c grows by, m/s"}};
  const char* const names[] = {"moves right", "moves up", "turns"};
  for (int k = 0; k < 3; ++k)
    table.rows.push_back({names[k], significant(v[k]), fixed(j(k) * v[k], 2, Sign::always)});
  page.table(parts[1], "what each of the three adds", table);
}

void draw_force(Page& page, const Rod& rod) {
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
  table.rows.push_back({"1 m/s along the rod: forbidden", fixed(rod.settings.lambda, 3) + " W"});
  page.table(parts[1], "the force does no work in a motion that the rod allows", table);
}

/// Question and answer beside the rod.
QuestionFrame frame_of(const Rod& rod, const std::string& state, const std::string& alt, RodLook look) {
  look.pose = rod.pose;
  return {.state = state, .alt = alt, .scene = [&rod, look](Page& page, const Rect& rect) {
            draw_rod(page, rect, rod, look);
          }};
}

}  // namespace

List<Shot> rod_shots(const Rod& rod) {
  List<Shot> shots = {question_shot(
      card(), frame_of(rod, "before we ask",
                       "A box on a rod, with an arrow and an arc for its velocity, and the question how fast "
                       "the rod gets longer",
                       {.asked = true}))};
  shots.push_back(
      key_shot(rod, "c: where",
               "The rod, the box, circles around the pivot where c is −1, 0 and 1 m, and c of the box at "
               "four other places.",
               draw_where));
  shots.push_back(
      key_shot(rod, "j: which way",
               "An arrow along the rod, at right angles to the circle c = 0, and an arc around the box: "
               "j = " +
                   components(rod.jacobian),
               draw_jacobian));
  shots.push_back(key_shot(
      rod, "j·v: how fast",
      fmt::format(
          "At the anchor the velocity of the box, what its turning adds, and their sum; j·v = {:.3f} m/s.",
          rod.motion.rate),
      draw_motion));
  shots.push_back(key_shot(rod, "jᵀ λ: which force",
                           "The pull of the rod as an arrow at the anchor and its torque as an arc.",
                           draw_force));
  shots.push_back(answer_shot(
      card(),
      frame_of(
          rod, "after the lesson",
          "At the anchor the velocity of the box and what its turning adds: their sum is along the circle.",
          {.close = true, .circles = true, .velocity = true}),
      fmt::format("{} m/s. Only motion of the anchor along the rod counts. Where that is 0, the anchor moves "
                  "along the circle, whatever the centre does.",
                  significant(rod.motion.rate))));
  return shots;
}

}  // namespace cairn::one_row
