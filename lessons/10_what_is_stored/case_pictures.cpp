// Three pairs of rows for which equation (30) and A do not say the same.
#include <fmt/format.h>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"

namespace cairn::stored {

namespace {

using render::Page;
using render::Point;
using render::Rect;

/// What is written beside one pair.
struct CaseText {
  render::Equation printed = {};
  render::Equation coupling = {};
  std::string note = {};
  std::string brief = {};  // in a small picture
};

FixedList<CaseText, 3> case_texts() {
  return {
      {{{.number = "eq (30)",
         .symbols = "J_{1} · J_{2} = (1 + r_{1} r_{2}) + (1 + x_{1} x_{2})",
         .numbers = "= (1 − 1) + (1 − 1)",
         .result = "= 0: not counted"},
        {.number = "eq (15)",
         .symbols = "A_{12} = 1/m + r_{1} r_{2}/I",
         .numbers = "= 1/6 − 1/1",
         .result = "= −0.833 1/kg"},
        "6 kg, I = 1 kg m², arms r = 1/2 and −2 m. Pushed at 1 it turns, and 2 goes down: they depend on "
        "each "
        "other.",
        "6 kg, I = 1: a push at 1 drives 2 down."},
       {{.number = "eq (30)",
         .symbols = "J_{1} · J_{2} = (1 + r_{1} r_{2}) + (1 + x_{1} x_{2})",
         .numbers = "= (1 − 1/6) + (1 − 1/6)",
         .result = "= 1.667: counted"},
        {.number = "eq (15)",
         .symbols = "A_{12} = 1/m + r_{1} r_{2}/I",
         .numbers = "= 1/6 − (1/6)/1",
         .result = "= 0"},
        "6 kg, I = 1 kg m², arms r = 1/2 and −1/3 m: r_{1}\u00a0r_{2}\u00a0=\u00a0−I/m. Each is the other's "
        "centre "
        "of percussion, "
        "and a blow at one is not felt at the other.",
        "r₁\u00a0r₂\u00a0=\u00a0−I/m: a blow at 1 is not felt at 2."},
       {{.number = "eq (30)",
         .symbols = "J_{1} · J_{2} = 0 + (1 + x_{1} x_{2})",
         .numbers = "= 0 + (1 − 1 × 1.5)",
         .result = "= −0.5: counted"},
        {.number = "eq (15)",
         .symbols = "A_{12} = 0 + 0 · (1 + x_{1} x_{2})",
         .numbers = "the ground: 1/m = 1/I = 0",
         .result = "= 0"},
        "Two boxes that share only the ground. x is measured from the ground's origin: put that elsewhere, "
        "and "
        "(30) counts otherwise.",
        "Only the ground is shared."}}};
}

void draw_case_scene(Page& page, const Rect& rect, const PairCase& one) {
  const Rect inside = page.panel(rect, one.title);
  const render::Camera camera = render::fit(inside, {{-2.6, -0.7}, {2.6, 1.5}});
  render::WorldLook look;
  look.penetration = false;
  look.numbers = false;
  draw_world(page, camera, one.snapshot, look);
  const render::ArrowScale scale{.pixels_per_unit = camera.scale, .longest = 2 * camera.scale, .unit = "N"};
  render::TextStyle style = page.label();
  style.bold = true;
  style.align = render::Align::center;
  int number = 0;
  for (const SnapshotContact& contact : one.snapshot.contacts) {
    draw_arrow(page, camera, scale,
               {.kind = render::ArrowKind::normal, .tail = contact.position, .value = {0, 1}});
    const Point tip = camera.project(contact.position + Vec2<double>(0, 1));
    page.canvas().text({tip.x(), tip.y() - 8}, fmt::format("{}", ++number), style);
  }
  for (const BodyId body : one.snapshot.bodies.indices()) {
    if (body == ground) continue;
    const Point center = camera.project(one.snapshot.bodies[body].pose.position);
    page.canvas().circle(center, page.sizes().contact, {.fill = page.theme().outline});
  }
}

void draw_case(Page& page, const PairCase& one, const CaseText& text) {
  const List<Rect> parts = rows(page.area(), {0.6, 0.4}, page.sizes().gap);
  draw_case_scene(page, parts[0], one);
  const List<Rect> below = columns(parts[1], {0.36, 0.28, 0.36}, page.sizes().gap);
  page.equation(below[0], text.printed);
  page.equation(below[1], text.coupling);
  page.note(below[2], "", text.note);
}

}  // namespace

List<Shot> case_shots(const Run& run) {
  List<Shot> shots;
  for (int i = 0; i < run->cases.size(); ++i) {
    shots.push_back(
        {.state = fmt::format("pair {} of {}", i + 1, run->cases.size()),
         .alt = fmt::format("Two contacts with the product of their rows, {:.4g}, beside their entry "
                            "in A, {:.4g}: {}.",
                            run->cases[i].printed, run->cases[i].coupling, run->cases[i].title),
         .draw = [run, i](Page& page) { draw_case(page, run->cases[i], case_texts()[i]); },
         .key = true});
  }
  return shots;
}

}  // namespace cairn::stored
