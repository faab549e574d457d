// The table from above, the plane of the friction forces with its two limits, and where all pucks stop.
#include "lesson.hpp"

namespace cairn::top_view {

namespace {

/// What (22) asks for and what the clamps leave, as far as the step has come: row x, row y, the vector.
void draw_clamps(Page& page, const Rect& rect, const Slides& all, int known) {
  const SlideSettings& settings = all.settings;
  const Vec2<double> wanted = stopping_lambda(settings, settings.velocity);
  const Vec2<double> parts = parts_clamped(settings, wanted);
  const Vec2<double> vector = vector_clamped(settings, wanted);
  const auto entry = [&](int needed, double force, int decimals) -> std::string {
    return known >= needed ? fixed(force + 0.0, decimals) : "?";
  };
  TableView table{.header = {"λ (N)", "asked for", "parts clamped", "vector clamped"}};
  table.rows = {{"λ_{x}", entry(1, wanted.x(), 1), entry(1, parts.x(), 2), entry(3, vector.x(), 2)},
                {"λ_{y}", entry(2, wanted.y(), 1), entry(2, parts.y(), 2), entry(3, vector.y(), 2)},
                {"|λ|", entry(2, wanted.norm(), 1), entry(2, parts.norm(), 2), entry(3, vector.norm(), 2)}};
  if (known < 3) table.active_row = known - 1;
  page.table(rect, "", table);
}

/// A moment of the first step: the forces, the equation that gives the last of them, and a word about it.
void draw_first_step(Page& page, const Slides& all, const Forces& forces, const Equation& equation, int known,
                     const std::string& title, const std::string& text) {
  const List<Rect> parts = in_columns(page, {0.46, {0.54, {0.32, 0.34, 0.34}}});
  draw_limits(page, parts[0], all, forces);
  page.equation(parts[1], equation);
  draw_clamps(page, parts[2], all, known);
  page.note(parts[3], title, text);
}

/// One of the two rows: from what its equation asks for to what its clamp leaves.
void draw_row(Page& page, const Slides& all, int i) {
  const SlideSettings& settings = all.settings;
  const Vec2<double> wanted = stopping_lambda(settings, settings.velocity);
  const Vec2<double> parts = parts_clamped(settings, wanted);
  const Vec2<double> first(parts.x(), 0);
  const ConstraintRow<double>& row = all.first.rows[i];
  const double off = std::abs(std::atan2(parts.y(), parts.x()) - std::atan2(wanted.y(), wanted.x()));
  draw_first_step(
      page, all,
      {.grey = i == 0 ? List<Vec2<double>>{} : List<Vec2<double>>{first},
       .active = {i == 0 ? first : parts},
       .velocity = settings.velocity},
      {.number = "eq (22)",
       .symbols = "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)",
       .numbers = fmt::format("= (0 − {:g}) / ({:g} × {:g}) = {} N", row_velocity(all.first, row),
                              inverse_effective_mass(all.first, row), settings.dt, fixed(wanted[i] + 0.0, 1)),
       .result = fmt::format("clamped: λ_{} = {} N", i == 0 ? "x" : "y", fixed(parts[i] + 0.0, 2)),
       .color = page.theme().friction},
      i + 1, i == 0 ? "Row x" : "Row y",
      i == 0
          ? fmt::format("This row sees v_{{x}} alone. Stopping it within the step would take {} times "
                        "μ λ_{{n}}, so the clamp leaves −μ λ_{{n}}: the side of the square.",
                        significant(-wanted.x() / settings.limit()))
          : fmt::format("This row sees v_{{y}} alone. Together the rows brake with {} N, which is {} times "
                        "μ λ_{{n}}, {}° off the dashed line against v.",
                        fixed(parts.norm(), 2), fixed(parts.norm() / settings.limit(), 2),
                        fixed(std::min(off, 2 * pi - off) * 180 / pi, 1)));
}

void draw_vector(Page& page, const Slides& all) {
  const SlideSettings& settings = all.settings;
  const Vec2<double> wanted = stopping_lambda(settings, settings.velocity);
  const Vec2<double> vector = vector_clamped(settings, wanted);
  draw_first_step(
      page, all,
      {.grey = {parts_clamped(settings, wanted)}, .active = {vector}, .velocity = settings.velocity},
      {.number = "paper 4.5",
       .symbols = "λ ← λ min(1, μ λ_{n} / |λ|)",
       .numbers = fmt::format("= {} × {:g} / {:g}", pair_text(wanted, 0), settings.limit(), wanted.norm()),
       .result = fmt::format("= {} N", pair_text(vector, 2)),
       .color = page.theme().friction},
      3, "Both rows together",
      "One clamp, of the length. λ still points against v, and its length is μ λ_{n} in every direction: "
      "Coulomb's "
      "circle.");
}

/// The two rows of FrictionJoint: the first along v, with an example of what it leaves of the disc to the
/// other.
void draw_shared_disc(Page& page, const Slides& all) {
  const SlideSettings& settings = all.settings;
  const double limit = settings.limit(), taken = 0.6 * limit, left = 0.8 * limit;
  const Vec2<double> along = settings.velocity / settings.speed();
  const Vec2<double> first = -taken * along, across(along.y(), -along.x());
  const List<Rect> parts = in_columns(page, {0.5, {0.5, {0.5, 0.5}}});
  const Camera camera = draw_limits(page, parts[0], all, {.active = {first}, .velocity = settings.velocity});
  draw_length(page, camera.project(first + left * across), camera.project(first - left * across),
              {.width = 3, .color = page.theme().friction});
  page.equation(parts[1], {.number = "the bounds of the row across v",
                           .symbols = "|λ_{2}| ≤ √((μ λ_{n})² − λ_{1}²)",
                           .numbers = fmt::format("= √({:g}² − {:g}²)", limit, taken),
                           .result = fmt::format("= {:g} N", left),
                           .color = page.theme().friction});
  page.note(
      parts[2], "Two rows, one disc",
      fmt::format("The row along v may give μ λ_{{n}}. If it gives {:g} N, the arrow, the row across may "
                  "give {:g} N to either side: the line from rim to rim. Each row has a clamp of its own, "
                  "and λ stays in the circle.",
                  taken, left));
}

Series speed_series(const std::string& name, const SeriesStyle& style, const Slides& all,
                    const Slide& slide) {
  Series series{.name = name, .style = style};
  for (int i = 0; i < slide.steps.size(); ++i)
    series.add(i * all.settings.dt, slide.steps[i].velocity.norm());
  return series;
}

void draw_speeds(Page& page, const Rect& rect, const Slides& all, int k) {
  Plot plot{.title = "speed (m/s)"};
  const int last = all.circle.steps.size() - 1;
  plot.x = {.title = "t (s)", .min = 0, .max = last * all.settings.dt};
  plot.y = {.title = "", .min = 0, .max = 1.1 * all.settings.speed()};
  plot.series = {speed_series("square", limit_style(page, false), all, all.square),
                 speed_series("circle", limit_style(page, true), all, all.circle)};
  plot.now = k * all.settings.dt;
  draw_plot(page, rect, plot);
}

void draw_step(Page& page, const Slides& all, int k) {
  const List<Rect> parts = in_columns(page, {0.46, {0.54, {0.58, 0.42}}});
  draw_table(page, parts[0], all, k);
  const Vec2<double> circle = all.circle.steps[k].lambda, square = all.square.steps[k].lambda;
  const Camera camera = draw_limits(page, parts[1], all, {.active = {circle, square}});
  double base = camera.viewport.y;
  for (const bool is_circle : {false, true}) {  // at the head of each force its limit's marker
    const Vec2<double>& lambda = is_circle ? circle : square;
    const SeriesStyle style = limit_style(page, is_circle);
    draw_marker(page.canvas(), camera.project(lambda), style.marker, 1.3 * page.sizes().marker, style.color);
    base += 1.4 * page.sizes().title;
    TextStyle text = aligned(name_style(page, page.sizes().title, style.color), Align::right);
    page.canvas().text({camera.viewport.x + camera.viewport.width, base},
                       fmt::format("{}: {:.2f} N", is_circle ? "circle" : "square", lambda.norm()), text);
  }
  draw_speeds(page, parts[2], all, k);
}

Shot step_shot(const Slides& all, int k, bool key) {
  const SlideStep& circle = all.circle.steps[k];
  const SlideStep& square = all.square.steps[k];
  return {
      .state = fmt::format("step {} · t = {:.2f} s", k, k * all.settings.dt),
      .alt = fmt::format(
          "After {:.2f} s: the puck with the circle is at ({:.2f}, {:.2f}) m and pulled with {:.2f} N, the "
          "one with the square at ({:.2f}, {:.2f}) m with {:.2f} N.",
          k * all.settings.dt, circle.place.x(), circle.place.y(), circle.lambda.norm(), square.place.x(),
          square.place.y(), square.lambda.norm()),
      .draw = [&all, k](Page& page) { draw_step(page, all, k); },
      .key = key};
}

Shot direction_shot(const Slides& all, int count) {
  const int last = all.directions.size();
  return {.state = fmt::format("{} of {} directions", count, last),
          .alt = fmt::format(
              "Where the pucks stop for {} of {} directions: with the circle on a circle, with the square on "
              "a diamond inside it; and how far, and where to, over the direction.",
              count, last),
          .draw = [&all, count](Page& page) { draw_directions(page, all, count); },
          .key = count == last};
}

std::string answer_text(const Slides& all) {
  const Vec2<double> circle = all.circle.steps.back().place;
  const Vec2<double> square = all.square.steps.back().place;
  return fmt::format(
      "At {1}\u00a0m, {0}\u00a0m from the start: each axis stops by itself. With the vector clamped the puck "
      "goes "
      "{2}\u00a0m, "
      "straight, in every direction. With the square turned along v there is no difference.",
      fixed(square.norm(), 2), pair_text(square, 2), fixed(circle.norm(), 2));
}

/// "circle: 2.45 m" beside its way, and below it the place where it ends.
void draw_way(Page& page, const Camera& camera, const Slide& slide, double aside) {
  const bool is_circle = slide.shape == FrictionShape::circle;
  const Vec2<double> end = slide.steps.back().place;
  draw_dimension(page, camera, end, aside,
                 {fmt::format("{}: {:.2f} m", is_circle ? "circle" : "square", end.norm()),
                  fmt::format("to {} m", pair_text(end, 2))},
                 limit_style(page, is_circle).color);
}

/// The table before the first step with the way that is known, and what limits the friction.
void draw_question(Page& page, const Rect& rect, const Slides& all) {
  const List<Rect> halves = in_columns(page, rect, {0.5, 0.5});
  const Camera camera = draw_table(page, halves[0], all, 0);
  const SeriesStyle known = limit_style(page, true);
  const Point start = camera.project({0, 0}), stop = camera.project(all.circle.steps.back().place);
  page.canvas().line(start + 0.36 * (stop - start), stop,
                     {.width = 1.5, .color = known.color, .dash = {8, 6}});
  page.canvas().circle(stop, all.settings.puck_radius() * camera.scale,
                       {.outline = known.color, .outline_width = page.sizes().outline});
  draw_way(page, camera, all.circle, 40);
  TextStyle asked =
      aligned(name_style(page, page.sizes().title, limit_style(page, false).color), Align::right);
  page.canvas().text(camera.project(0.4 * all.circle.steps.back().place) - Point(50, 0), "square: (?, ?) m",
                     asked);
  draw_limits(page, halves[1], all, {.velocity = all.settings.velocity});
}

/// The table with both pucks at rest, and how far that is from the start.
void draw_ends(Page& page, const Rect& rect, const Slides& all) {
  const Camera camera = draw_table(page, rect, all, all.circle.steps.size() - 1);
  draw_way(page, camera, all.circle, 40);
  draw_way(page, camera, all.square, -40);
}

}  // namespace

List<Shot> slide_shots(const Slides& all) {
  const int last = all.circle.steps.size() - 1;
  List<Shot> shots;
  shots.push_back(question_shot(
      card(), {.state = "before the first step",
               .alt = "A puck on a table from above with its velocity, a square and a circle "
                      "as limits of the friction force, and the question",
               .scene = [&all](Page& page, const Rect& rect) { draw_question(page, rect, all); },
               .place = ScenePlace::above}));
  for (int i = 0; i < 2; ++i) {
    shots.push_back(
        {.state = fmt::format("step 1 · row {} of 2", i + 1),
         .alt = fmt::format("The plane of the friction forces with a square and a circle as limits: "
                            "row {} is clamped to the square.",
                            i == 0 ? "x" : "y"),
         .draw = [&all, i](Page& page) { draw_row(page, all, i); },
         .key = true});
  }
  shots.push_back(key_shot(all, "step 1 · the vector",
                           "The same plane: the vector is clamped to the circle, and stays against v.",
                           draw_vector));
  const int stride = (last + 59) / 60;
  std::set<int> keys;
  for (const double part : {0.4, 0.65}) keys.insert(static_cast<int>(part * last) / stride * stride);
  for (int k = stride; k < last; k += stride) shots.push_back(step_shot(all, k, keys.contains(k)));
  shots.push_back(step_shot(all, last, false));
  const int directions = all.directions.size();
  for (int count = 1; count <= directions; ++count) shots.push_back(direction_shot(all, count));
  shots.push_back(
      key_shot(all, "two rows, one disc",
               "The circle of limits with an arrow against v, and across it a line from rim to rim: "
               "what the first row leaves to the second.",
               draw_shared_disc));
  shots.push_back(answer_shot(
      card(),
      {.state = "all at rest",
       .alt = "Both pucks at rest, each at the end of its path, with its distance from the start, and "
              "the answer.",
       .scene = [&all](Page& page, const Rect& rect) { draw_ends(page, rect, all); }},
      answer_text(all)));
  return shots;
}

}  // namespace cairn::top_view
