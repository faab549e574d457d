// Three pairs of rows for which equation (30) and A do not say the same.
#include "lesson.hpp"

namespace cairn::stored {

namespace {

/// What is written beside one pair.
struct CaseText {
  std::string product = {};  // (30), in letters and in numbers
  std::string product_numbers = {};
  std::string coupling = {};  // (15)
  std::string coupling_numbers = {};
  std::string arm = {};  // the letter of the distances
  std::string note = {};
};

FixedList<CaseText, 3> case_texts() {
  const std::string product = "J_{1} · J_{2} = (1 + r_{1} r_{2}) + (1 + x_{1} x_{2})";
  const std::string coupling = "A_{12} = 1/m + r_{1} r_{2}/I";
  return {
      {{product, "= (1 − 1) + (1 − 1)", coupling, "= 1/6 − 1/1", "r",
        "A box of 6 kg with I = 1 kg m² and light arms. Pushed at 2, it turns, and 1 goes down: the two "
        "depend on each other."},
       {product, "= (1 − 1/6) + (1 − 1/6)", coupling, "= 1/6 − (1/6)/1", "r",
        "A box of 6 kg with I = 1 kg m², and r_{1}\u00a0r_{2}\u00a0=\u00a0−I/m. Each point is the other's "
        "centre of percussion: a blow at one is not felt at the other."},
       {"J_{1} · J_{2} = 0 + (1 + x_{1} x_{2})", "= 0 + (1 − 1 × 1.5)", "A_{12} = 0 + 0 · (1 + x_{1} x_{2})",
        "the ground: 1/m = 1/I = 0", "x",
        "Two boxes that share only the ground. x is measured from the ground's origin. With another "
        "origin, (30) gives another number."}}};
}

/// Both contacts, and how far they are from the centre of the body or the origin of the ground, both at x =
/// 0.
void draw_contact_arms(Page& page, const Camera& camera, const PairCase& one, const std::string& letter) {
  const Stroke thin{.width = 1.5, .color = page.theme().secondary_text};
  const ArrowScale scale{.pixels_per_unit = camera.scale, .longest = 2 * camera.scale};
  const Point zero = camera.project({0, 0.7});
  const Point middle = camera.project({0, letter == "r" ? 0.25 : 0});
  page.canvas().line(middle, zero, thin);
  page.canvas().circle(middle, page.sizes().contact, {.fill = page.theme().outline});
  int number = 0;
  for (const SnapshotContact& contact : one.snapshot.contacts) {
    draw_arrow(page, camera, scale, {.kind = ArrowKind::normal, .tail = contact.position, .value = {0, 1.1}});
    const Point tip = camera.project(contact.position + Vec2<double>(0, 1.1));
    TextStyle style{.size = 26, .color = page.theme().text, .bold = true, .align = Align::center};
    page.canvas().text(tip - Point(0, 10), fmt::format("{}", ++number), style);
    const Point end(tip.x(), zero.y());
    page.canvas().line(zero, end, thin);
    const std::string text =
        fmt::format("{}_{{{}}} = {} m", letter, number, significant(contact.position.x(), 2));
    style = page.label();
    style.align = Align::center;
    const double width = page.canvas().text_width(text, style);
    const bool fits = std::abs(end.x() - zero.x()) > width + 24;
    const Point beside(end.x() + (number == 1 ? -1 : 1) * (0.5 * width + 12), end.y() + 6);
    page.canvas().text(fits ? 0.5 * (zero + end) - Point(0, 8) : beside, text, style);
  }
}

void draw_case(Page& page, const PairCase& one, const CaseText& text) {
  const List<Rect> parts = in_columns(page, {{0.62, {0.68, 0.32}}, {0.38, {0.5, 0.5}}});
  const Rect inside = page.panel(parts[0], one.title);
  const double from = one.snapshot.contacts[0].position.x(), to = one.snapshot.contacts[1].position.x();
  const Camera camera = fit(inside, {{std::min(from, -to) - 0.7, -0.4}, {std::max(to, -from) + 0.7, 1.5}});
  draw_world(page, camera, one.snapshot, {.numbers = false, .penetration = false});
  draw_contact_arms(page, camera, one, text.arm);
  page.note(parts[1], "", text.note);
  page.equation(parts[2], {.number = "eq (30) as printed",
                           .symbols = text.product,
                           .numbers = text.product_numbers,
                           .result = fmt::format("= {}: {}", significant(one.printed),
                                                 one.printed == 0 ? "not counted" : "counted")});
  page.equation(parts[3], {.number = "eq (15)",
                           .symbols = text.coupling,
                           .numbers = text.coupling_numbers,
                           .result = one.coupling == 0 ? "= 0" : "= " + significant(one.coupling) + " 1/kg"});
}

}  // namespace

List<Shot> case_shots(const StoredRun& run) {
  List<Shot> shots;
  for (int i = 0; i < run.cases.size(); ++i) {
    shots.push_back(
        {.state = fmt::format("pair {} of {}", i + 1, run.cases.size()),
         .alt = fmt::format("Two contacts with their distances and the product of their rows, {:.4g}, beside "
                            "their entry in A, {:.4g}: {}.",
                            run.cases[i].printed, run.cases[i].coupling, run.cases[i].title),
         .draw = [&run, i](Page& page) { draw_case(page, run.cases[i], case_texts()[i]); },
         .key = true});
  }
  return shots;
}

}  // namespace cairn::stored
