// The pyramid: what decides whether Jacobi converges, and what it costs.
#include "lesson.hpp"

#include "render/lint.hpp"

namespace cairn::everybody {

namespace {

/// The pyramid with the number of rows on each box.
void draw_rows_on_boxes(Page& page, const Rect& rect, const PileRun& run) {
  const Rect inside = page.panel(rect, "rows on each box");
  const Camera camera = pyramid_camera(inside, run.settings.base);
  WorldLook look;
  for (const BodyId body : run.rows_on_box.indices())
    look.names.push_back(body == ground ? "" : fmt::format("{}", run.rows_on_box[body]));
  draw_world(page, camera, run.snapshot, look);
}

std::string verdict_of(const PileHistory& history) {
  if (history.method == Method::sequential) return "yes, in turn";
  return history.eigenvalue < 2 ? "yes, below 2" : "no, above 2";
}

void draw_eigenvalues(Page& page, const PileRun& run) {
  const List<Rect> parts = in_columns(page, {0.46, {0.54, {0.42, 0.58}}});
  draw_rows_on_boxes(page, parts[0], run);
  TableView table;
  table.header = {"method", "ω × eigenvalue", "it converges"};
  for (const PileHistory& history : run.histories) {
    const bool in_turn = history.method == Method::sequential;
    table.rows.push_back({method_name(history.method, run.settings.omega),
                          in_turn ? "·" : fixed(history.eigenvalue, 3), verdict_of(history)});
  }
  page.table(parts[1], "the largest eigenvalue of D^{−1} A", table);
  const int most = *std::max_element(run.rows_on_box.begin() + 1, run.rows_on_box.end());
  page.note(parts[2], "What decides",
            fmt::format("Up to {} rows correct one box at the same time. With an eigenvalue above 2 a "
                        "sweep leaves some error larger than before. Damping gives a share of each "
                        "correction; every scene needs its own share. Split masses give each row its share "
                        "of the box, and no eigenvalue is above 1 in any scene.",
                        most));
}

void draw_convergence(Page& page, const PileRun& run) {
  const List<Rect> parts = in_rows(page, {0.6, {0.4, {0.6, 0.4}}});
  Plot plot{.title = "residual R_{E} after each sweep"};
  plot.x = {.title = "sweep", .min = 0, .max = 300};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 5e-4, .max = 1e2};
  for (const PileHistory& history : run.histories) {
    Series series{.name = method_name(history.method, run.settings.omega),
                  .style = style_of(page.theme(), history.method)};
    for (int k = 0; k <= 300; ++k) {
      if (!(history.residual[k] < 1e2 && history.residual[k] > 5e-4)) break;
      series.add(k, history.residual[k]);
    }
    plot.series.push_back(series);
  }
  plot.goals.push_back({0.01, "1 %"});
  draw_plot(page, parts[0], plot);
  TableView table;
  table.header = {"method", "sweeps to 1 %", "turns a sweep", "turns"};
  const auto line = [&](const std::string& name, const PileHistory& history) {
    const int turns = turns_per_sweep(run, history);
    const int needed = history.sweeps_needed;
    table.rows.push_back({name, needed < 0 ? "never" : fmt::format("{}", needed), fmt::format("{}", turns),
                          needed < 0 ? "·" : fmt::format("{}", needed * turns)});
  };
  for (const PileHistory& history : run.histories)
    line(method_name(history.method, run.settings.omega), history);
  line("SI, by colours", run.coloured);
  const int sweeps = run.with_momentum.sweeps_needed;
  table.rows.push_back({"Jacobi, momentum", fmt::format("{}", sweeps), "2", fmt::format("{}", 2 * sweeps)});
  page.table(parts[1], "", table);
  page.note(
      parts[2], "With a processor for each row",
      "All rows of Jacobi work in one turn, not counting the sums into each box. SI takes one row "
      "after the other. With colours, rows that share no box run together, so SI can be parallel, too.");
}

}  // namespace

List<Shot> pile_shots(const PileRun& run) {
  List<Shot> shots;
  shots.push_back(
      key_shot(run, fmt::format("a pyramid, {} rows", run.problem.row_count()),
               "A pyramid with the number of rows on each box, and the largest eigenvalue of each "
               "method.",
               draw_eigenvalues));
  shots.push_back(key_shot(run, "one step of the pyramid",
                           "Residual against sweeps for four methods, and how many turns each needs with a "
                           "processor for each row.",
                           draw_convergence));
  shots.push_back(key_shot(
      run, fmt::format("{} contacts, {} colours", run.contacts.contacts.size(), run.contacts.count.size()),
      fmt::format("The contacts of the pyramid, joined box to box and numbered by colour: "
                  "{} of them go at the same time in {} turns.",
                  counts_text(run.contacts), run.contacts.count.size()),
      draw_colours));
  return shots;
}

// The contacts of the pyramid as a graph: which colour each has, and what goes at the same time.

namespace {

/// From the middle of one box to the middle of the other; from the ground straight up.
struct Edge {
  Point from = {0, 0};
  Point to = {0, 0};
};

Edge edge_of(const Camera& camera, const Snapshot& snapshot, const ColouredContact& contact) {
  const Vec2<double> upper = snapshot.bodies[contact.b].pose.position;
  Vec2<double> lower = snapshot.bodies[contact.a].pose.position;
  if (contact.a == ground) lower = {upper.x(), 0};
  return {camera.project(lower), camera.project(upper)};
}

/// What a colour of the graph looks like.
Color color_of(const Page& page, int colour) {
  const Theme& theme = page.theme();
  const FixedList<Color, 4> colors = {theme.positive, theme.velocity, theme.penetration, theme.negative};
  return colors[colour % colors.size()];
}

/// All contacts, each in its colour, with the number of that.
void draw_graph(Page& page, const Rect& rect, const PileRun& run) {
  const Rect inside = page.panel(rect, "contacts, each in its colour");
  const Camera camera = pyramid_camera(inside, run.settings.base);
  draw_world(page, camera, run.snapshot, {.numbers = false, .contacts = false});
  for (const ColouredContact& contact : run.contacts.contacts) {
    const Edge edge = edge_of(camera, run.snapshot, contact);
    page.canvas().line(edge.from, edge.to,
                       {.width = page.sizes().arrow, .color = color_of(page, contact.colour)});
  }
  TextStyle text = page.value();
  text.bold = true;
  text.align = Align::center;
  const double radius = 0.72 * text.size;
  for (const ColouredContact& contact : run.contacts.contacts) {
    const Edge edge = edge_of(camera, run.snapshot, contact);
    const double share = contact.a == ground ? 0.0 : 0.5;
    const Point middle = edge.from + share * (edge.to - edge.from);
    const Color fill = color_of(page, contact.colour);
    page.canvas().circle(middle, radius, {.fill = fill, .outline = page.theme().outline, .outline_width = 1});
    text.color = render::ink_on(fill);
    text.halo = fill;
    page.canvas().text({middle.x(), middle.y() + 0.36 * text.size}, fmt::format("{}", contact.colour + 1),
                       text);
  }
}

/// One turn: the contacts of a colour, and the boxes that they hold; every box has one at most.
void draw_turn(Page& page, const Rect& rect, const PileRun& run, int colour) {
  const int count = run.contacts.count[colour];
  const Rect inside =
      page.panel(rect, fmt::format("turn {}: {} contact{}", colour + 1, count, count == 1 ? "" : "s"));
  const Camera camera = pyramid_camera(inside, run.settings.base);
  for (const SnapshotBody& body : run.snapshot.bodies) {
    if (body.type != BodyType::dynamic) continue;
    const Point low = camera.project(body.pose.position - Vec2<double>(0.5, 0.5));
    const Point high = camera.project(body.pose.position + Vec2<double>(0.5, 0.5));
    page.canvas().rect({low.x(), high.y(), high.x() - low.x(), low.y() - high.y()},
                       {.fill = page.theme().body, .outline = page.theme().inactive, .outline_width = 1});
  }
  const Point left = camera.project({-0.625 * run.settings.base, 0});
  const Point right = camera.project({0.625 * run.settings.base, 0});
  page.canvas().line(left, right, {.width = page.sizes().axis, .color = page.theme().outline});
  const render::Paint dot{
      .fill = color_of(page, colour), .outline = page.theme().outline, .outline_width = 1};
  for (const ColouredContact& contact : run.contacts.contacts) {
    if (contact.colour != colour) continue;
    const Edge edge = edge_of(camera, run.snapshot, contact);
    page.canvas().line(edge.from, edge.to, {.width = 1.4 * page.sizes().arrow, .color = dot.fill});
    page.canvas().circle(edge.to, 1.4 * page.sizes().contact, dot);
    if (contact.a != ground) page.canvas().circle(edge.from, 1.4 * page.sizes().contact, dot);
  }
}

}  // namespace

Camera pyramid_camera(const Rect& inside, int base) {
  const double half = 0.625 * base + 0.2;
  return fit(inside, {{-half, -0.3}, {half, base + 0.1}});
}

void draw_colours(Page& page, const PileRun& run) {
  const List<Rect> parts = in_columns(page, {0.44, {0.56, {0.77, 0.23}}});
  draw_graph(page, parts[0], run);
  const int turns = run.contacts.count.size();
  const int across = (turns + 1) / 2;
  const List<Rect> lines = in_rows(page, parts[1], {1, 1});
  for (int k = 0; k < turns; ++k) {
    const List<Rect> panels = in_columns(page, lines[k / across], List<Cut>(across, 1.0));
    draw_turn(page, panels[k % across], run, k);
  }
  const int contacts = run.contacts.contacts.size();
  page.note(
      parts[2], "Gauss-Seidel in parallel",
      fmt::format(
          "In one turn no box has two contacts, so no contact waits for another: {} turns for {} contacts. "
          "{} boxes at the bottom: {} turns of {}.",
          turns, contacts, larger_base, run.larger.count.size(), counts_text(run.larger)));
}

}  // namespace cairn::everybody
