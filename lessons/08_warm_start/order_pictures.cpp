// Impulses that come to the wrong row.
#include "lesson.hpp"

namespace cairn::warm {

namespace {

/// The step in which loads by number are most wrong, once the tower has come to rest.
int worst_guest_step(const WarmStart& all) {
  const List<List<double>>& loads = all.guest.by_number;
  int worst = loads.size() / 2;
  for (int k = worst; k < loads.size(); ++k) {
    const double weight = all.settings.weight();
    if (std::abs(loads[k][0] - weight) > std::abs(loads[worst][0] - weight)) worst = k;
  }
  return worst;
}

void draw_guest(Page& page, const WarmStart& all) {
  const List<Rect> parts = in_columns(page, {0.36, {0.64, {0.68, 0.32}}});
  const int step = worst_guest_step(all);
  const Rect inside = page.panel(parts[0], "");
  const Camera camera = fit(inside, {{-2.4, -0.6}, {1.2, all.settings.boxes + 0.4}});
  draw_world(page, camera, all.guest.frames[step],
             {.numbers = false, .contacts = false, .penetration = false});
  Plot plot{.title = "load λ_{1} on the lowest box (N)"};
  const int first = all.guest.by_key.size() / 4;  // once the first swings are over
  plot.x = {.title = "step", .min = first, .max = all.settings.steps};
  plot.series = {{.name = "by key", .style = start_styles(page.theme())[1]},
                 {.name = "by number", .style = start_styles(page.theme())[2], .markers = false}};
  Series touches{
      .name = "ball touches", .style = {page.theme().external, {}, Marker::triangle}, .line = false};
  for (int k = first; k < all.guest.by_key.size(); ++k) {
    plot.series[0].add(k, all.guest.by_key[k][0]);
    plot.series[1].add(k, all.guest.by_number[k][0]);
    if (!all.guest.ball_touches[k]) continue;
    touches.add(k, all.guest.by_number[k][0]);
  }
  plot.series.push_back(touches);
  plot.cursor = step;
  draw_plot(page, parts[1], plot);
  page.note(parts[2], "",
            "A ball bounces beside the tower and never touches it. While the ball touches the "
            "ground, its contact is the first row, and all others shift by one. Matched by number, this "
            "shakes the tower. Matched by key, not one bit of its loads changes.");
}

}  // namespace

Shot order_shot(const WarmStart& all) {
  return key_shot(
      all, "a ball bounces beside it",
      "A tower with a ball beside it, and the lowest load by key, steady, and by number, shaken at "
      "every bounce.",
      draw_guest);
}

}  // namespace cairn::warm
