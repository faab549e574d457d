// Two rows that share only the ground: equation (30) counts them, and A has no entry for them.
#include "lesson.hpp"

namespace cairn::stored {

namespace {

/// Both contacts, and how far they are from the origin of the ground, at x = 0.
void draw_contact_arms(Page& page, const Camera& camera, const PairCase& one) {
  const Stroke thin{.width = 1.5, .color = page.theme().secondary_text};
  const ArrowScale scale{.pixels_per_unit = camera.scale, .longest = 2 * camera.scale};
  const Point origin = camera.project({0, 0}), zero = camera.project({0, 0.7});
  page.canvas().line(origin, zero, thin);
  page.canvas().circle(origin, page.sizes().contact, {.fill = page.theme().outline});
  int number = 0;
  for (const SnapshotContact& contact : one.snapshot.contacts) {
    draw_arrow(page, camera, scale, {.kind = ArrowKind::normal, .tail = contact.position, .value = {0, 1.1}});
    const Point tip = camera.project(contact.position + Vec2<double>(0, 1.1));
    TextStyle style{.size = 26, .color = page.theme().text, .bold = true, .align = Align::center};
    page.canvas().text(tip - Point(0, 10), fmt::format("{}", ++number), style);
    const Point end(tip.x(), zero.y());
    page.canvas().line(zero, end, thin);
    style = page.label();
    style.align = Align::center;
    page.canvas().text(0.5 * (zero + end) - Point(0, 8),
                       fmt::format("x_{{{}}} = {} m", number, significant(contact.position.x(), 2)), style);
  }
}

void draw_case(Page& page, const PairCase& one) {
  const List<Rect> parts = in_columns(page, {{0.62, {0.68, 0.32}}, {0.38, {0.5, 0.5}}});
  const Rect inside = page.panel(parts[0], one.title);
  const double from = one.snapshot.contacts[0].position.x(), to = one.snapshot.contacts[1].position.x();
  const Camera camera = fit(inside, {{std::min(from, -to) - 0.7, -0.4}, {std::max(to, -from) + 0.7, 1.5}});
  draw_world(page, camera, one.snapshot, {.numbers = false, .penetration = false});
  draw_contact_arms(page, camera, one);
  page.note(parts[1], "",
            "Two boxes that share only the ground. x is measured from the ground's origin. With another "
            "origin, (30) gives another number.");
  page.equation(parts[2], {.number = "eq (30) as printed",
                           .symbols = "J_{1} · J_{2} = 0 + (1 + x_{1} x_{2})",
                           .numbers = "= 0 + (1 − 1 × 1.5)",
                           .result = fmt::format("= {}: counted", significant(one.printed))});
  page.equation(parts[3], {.number = "eq (15)",
                           .symbols = "A_{12} = 0 + 0 · (1 + x_{1} x_{2})",
                           .numbers = "the ground: 1/m = 1/I = 0",
                           .result = "= 0"});
}

}  // namespace

Shot case_shot(const StoredRun& run) {
  const PairCase& one = run.cases.back();
  return key_shot(
      run, "only the ground is shared",
      fmt::format("Two contacts with their distances and the product of their rows, {:.4g}, beside "
                  "their entry in A, {:.4g}: {}.",
                  one.printed, one.coupling, one.title),
      [](Page& page, const StoredRun& stored) { draw_case(page, stored.cases.back()); });
}

}  // namespace cairn::stored
