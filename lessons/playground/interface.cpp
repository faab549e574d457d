// The C functions: each calls the playground. What that throws ends here, as words.
#include "lessons/playground/interface.h"

#include <string>

#include <cairn/measure/fingerprint.hpp>
#include "lessons/playground/picture.hpp"
#include "lessons/playground/playground.hpp"
#include "lessons/playground/session.hpp"
#include <cairn/scenes/scene_file.hpp>

namespace {

using cairn::BodyId;
using cairn::List;
using cairn::Vec2;
using namespace cairn::playground;

/// Made once it is asked for. At the end of the process it goes before OpenGL, which began within its
/// constructor.
Picture& picture() {
  static Picture picture;
  return picture;
}

constexpr double finger = 0.1;  // [m] by which it may miss a body

// What is told where nothing can be: no row is lit or predicted, and nothing is there.
constexpr double no_numbers[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, -1, 0, 0, 0, 0};
constexpr double no_place[] = {0, -1, 0, 0};

bool is_shown_whole = true;  // the next picture shows all of the scene

double as_number(bool flag) { return flag ? 1 : 0; }

/// As cairn_bodies() tells it.
double state_of(const cairn::SnapshotBody& body) {
  if (body.removed) return 0;
  return body.type == cairn::BodyType::dynamic ? 2 : 1;
}

double kind_of(const cairn::ConstraintRow<double>& row) {
  if (row.bounds.is_friction()) return 2;
  return row.bounds.is_unilateral() ? 1 : 0;
}

}  // namespace

const char* cairn_refusal(void) { return last_refusal().c_str(); }

int cairn_patience(double seconds) {
  return done([&](Playground& p) { p.set_patience(seconds); });
}
int cairn_most_text(void) { return cairn::most_scene_bytes; }

int cairn_open(const char* text, const char* file) {
  return done([&](Playground& p) {
    p.open(given(text, "open", "text"), given(file, "open", "file"));
    is_shown_whole = true;
  });
}
const char* cairn_scene_text(void) {
  return told([](const Playground& p) -> const std::string& { return p.text(); });
}
int cairn_restart(void) {
  return done([](Playground& p) { p.restart(); });
}

int cairn_set(const char* setting, const char* value) {
  return done([&](Playground& p) { p.set(given(setting, "set", "setting"), given(value, "set", "value")); });
}
const char* cairn_settings(void) {
  return told([](const Playground& p) { return controls_text(p.controls(), p.recommended()); });
}

int cairn_step(int count) {
  return done([&](Playground& p) { p.step(count); });
}
int cairn_step_for(int count, double milliseconds) {
  return done([&](Playground& p) { p.step(count, milliseconds / 1000); });
}
void cairn_move(int is_moving) {
  done([&](Playground& p) { p.set_moving(is_moving != 0); });
}
int cairn_row(int count) {
  return done([&](Playground& p) { p.advance_rows(count); });
}
int cairn_sweep(void) {
  return done([](Playground& p) { p.advance_sweep(); });
}
int cairn_back(void) {
  return done([](Playground& p) { p.back(); });
}

int cairn_visit(int step) {
  return done([&](Playground& p) { p.visit(step); });
}
int cairn_visit_row(int updates) {
  return done([&](Playground& p) { p.visit_row(updates); });
}

int cairn_grab(double x, double y) {
  return done([&](Playground& p) { p.grab({x, y}, finger); });
}
int cairn_drag(double x, double y) {
  return done([&](Playground& p) { p.drag({x, y}); });
}
void cairn_let_go(void) {
  done([](Playground& p) { p.let_go(); });
}

int cairn_add_box(double x, double y, double width, double height) {
  return done([&](Playground& p) { p.add_box({x, y}, {width, height}); });
}
int cairn_add_ball(double x, double y, double radius) {
  return done([&](Playground& p) { p.add_ball({x, y}, radius); });
}
int cairn_add_walls(void) {
  return done([](Playground& p) { p.add_walls(picture().room()); });
}
int cairn_add_rope(int body_a, double ax, double ay, int body_b, double bx, double by) {
  return done([&](Playground& p) { p.add_rope({body_a}, {ax, ay}, {body_b}, {bx, by}); });
}
int cairn_remove(int body) {
  return done([&](Playground& p) { p.remove({body}); });
}
int cairn_pin(int body_a, int body_b, double x, double y) {
  return done([&](Playground& p) { p.pin({body_a}, {body_b}, {x, y}); });
}
int cairn_undo(void) {
  return done([](Playground& p) { p.undo(); });
}

const double* cairn_bodies(void) {
  return listed(no_numbers, [](const Playground& p) {
    const cairn::Snapshot snapshot = p.bench(0).snapshot();
    List<double> numbers;
    for (const cairn::SnapshotBody& body : snapshot.bodies) {
      const List<double> one = {
          body.pose.position.x(), body.pose.position.y(), body.pose.angle, body.velocity.x(),
          body.velocity.y(),      body.velocity.z(),      body.mass,       state_of(body)};
      numbers.insert(numbers.end(), one.begin(), one.end());
    }
    return numbers;
  });
}
int cairn_body_count(void) {
  return guarded(0, [](Session& now) { return now.playground.bench(0).scene().bodies().size(); });
}
const double* cairn_body_history(int body) {
  return listed(no_numbers, [&](const Playground& p) { return p.history().of_body({body}); });
}
const double* cairn_pair_history(int body_a, int body_b) {
  return listed(no_numbers, [&](const Playground& p) { return p.history().of_pair({body_a}, {body_b}); });
}
int cairn_history_count(void) {
  return guarded(0, [](Session& now) { return now.playground.history().size(); });
}
const char* cairn_body_name(int body) {
  static const std::string nobody;
  return told([&](const Playground& p) -> const std::string& {
    const auto& names = p.names();
    return body >= 0 && body < names.size() ? names[BodyId{body}] : nobody;
  });
}

double cairn_fall(int world) {
  return guarded(0.0, [&](Session& now) {
    const Playground& p = now.playground;
    if (world < 0 || world >= p.bench_count()) return 0.0;
    const auto& begun = p.first().bodies;
    int top = -1;
    for (const BodyId body : begun.indices()) {
      const bool is_higher = top < 0 || begun[body].pose.position.y() > begun[BodyId{top}].pose.position.y();
      if (begun[body].type == cairn::BodyType::dynamic && is_higher) top = body.index;
    }
    if (top < 0) return 0.0;
    const auto& then = p.bench(world).snapshot().bodies;
    return begun[BodyId{top}].pose.position.y() - then[BodyId{top}].pose.position.y();
  });
}

const double* cairn_rows(void) {
  return listed(no_numbers, [](const Playground& p) {
    const SolveLook& look = p.look(0);
    const SolveLook* other = p.bench_count() > 1 ? &p.look(1) : nullptr;
    const auto& ends = p.ends();
    const double dt = look.given.dt;
    List<double> numbers;
    for (int i = 0; i < look.given.row_count(); ++i) {
      const cairn::ConstraintRow<double>& row = look.given.rows[i];
      const bool has_other = other && i < other->impulse.size();
      const List<double> one = {look.impulse[i] / dt,
                                ends[i] / dt,
                                has_other ? other->impulse[i] / dt : 0,
                                kind_of(row),
                                static_cast<double>(row.a.index),
                                static_cast<double>(row.b.index)};
      numbers.insert(numbers.end(), one.begin(), one.end());
    }
    return numbers;
  });
}
int cairn_row_count(void) {
  return guarded(0, [](Session& now) { return now.playground.look(0).given.row_count(); });
}
void cairn_light_row(int row) {
  done([&](Playground& p) { p.light_row(row); });
}
int cairn_predict(int row, double newtons) {
  return done([&](Playground& p) { p.predict(row, newtons); });
}
void cairn_reveal(void) {
  done([](Playground& p) { p.reveal(); });
}

const double* cairn_numbers(void) {
  return listed(no_numbers, [](const Playground& p) {
    const cairn::Snapshot snapshot = p.bench(0).snapshot();
    const SolveLook& look = p.look(0);
    const int sweep = p.cursor() && look.last ? look.last->sweep : look.residuals.size() - 1;
    const auto& prediction = p.prediction();
    return List<double>{snapshot.time,
                        static_cast<double>(p.bench(0).steps()),
                        static_cast<double>(look.given.row_count()),
                        static_cast<double>(snapshot.contacts.size()),
                        static_cast<double>(p.cursor().value_or(0)),
                        static_cast<double>(look.all_updates),
                        static_cast<double>(sweep),
                        look.residuals[sweep],
                        1e3 * p.step_seconds(),
                        static_cast<double>(p.lit_row()),
                        as_number(p.has_diverged()),
                        static_cast<double>(p.steps_back()),
                        prediction ? static_cast<double>(prediction->row) : -1.0,
                        prediction ? prediction->force : 0,
                        as_number(prediction && prediction->is_revealed),
                        static_cast<double>(p.last_step()),
                        as_number(p.is_touched())};
  });
}
const char* cairn_words(void) {
  return told([](const Playground& p) -> const std::string& { return p.words(); });
}
const char* cairn_plan(void) {
  return told([](const Playground& p) { return explain(make_plan(p.bench(0).scene())); });
}
const char* cairn_fingerprint(void) {
  return told([](const Playground& p) { return cairn::hexadecimal(fingerprint_of(p.bench(0).snapshot())); });
}

int cairn_resize(int width, int height, double scale) {
  return done([&](Playground&) { picture().resize(width, height, scale); });
}
int cairn_theme(const char* theme) {
  return done([&](Playground&) { picture().choose_theme(given(theme, "theme", "theme")); });
}
int cairn_show(int has_panels, int all_rows) {
  return done([&](Playground&) { picture().show(has_panels != 0, all_rows != 0); });
}
int cairn_moment(double share) {
  return done([&](Playground&) { picture().set_moment(share); });
}
int cairn_draw(void) {
  return done([](Playground& p) {
    if (is_shown_whole) picture().show_all();
    is_shown_whole = false;
    picture().draw(p);
    picture().page().canvas().show();
  });
}
int cairn_zoom(double factor, double x, double y) {
  return done([&](Playground&) { picture().zoom(factor, {x, y}); });
}
int cairn_pan(double x, double y) {
  return done([&](Playground&) { picture().pan({x, y}); });
}
void cairn_show_all(void) { is_shown_whole = true; }
const double* cairn_at(double x, double y) {
  return listed(no_place, [&](const Playground& p) {
    const PictureSpot spot = picture().at(p, {x, y});
    return List<double>{static_cast<double>(spot.kind), static_cast<double>(spot.number), spot.point.x(),
                        spot.point.y()};
  });
}
const double* cairn_place(double x, double y) {
  return listed(no_place + 2, [&](const Playground&) {
    const Vec2<double> place = picture().place({x, y});
    return List<double>{place.x(), place.y()};
  });
}
