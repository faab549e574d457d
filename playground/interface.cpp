// The C functions: each calls the playground, and turns what it throws into words.
#include "playground/interface.h"

#include <exception>
#include <string>

#include "measure/fingerprint.hpp"
#include "playground/picture.hpp"
#include "playground/playground.hpp"

namespace {

using cairn::BodyId;
using cairn::List;
using cairn::Vec2;
using cairn::playground::Picture;
using cairn::playground::PictureSpot;
using cairn::playground::Playground;
using cairn::playground::SolveLook;

/// All that a page shows, and what was returned last.
struct Session {
  Playground playground;
  std::string refusal;
  std::string text;
  List<double> numbers;
};

Session& session() {
  static Session session;
  return session;
}

template <typename Act>
int done(const Act& act) {
  try {
    act(session().playground);
    session().refusal.clear();
    return 1;
  } catch (const std::exception& error) {
    session().refusal = error.what();
    return 0;
  }
}

const char* returned(std::string text) {
  session().text = std::move(text);
  return session().text.c_str();
}

const double* returned(List<double> numbers) {
  session().numbers = std::move(numbers);
  return session().numbers.data();
}

/// Made once it is asked for. At the end of the process it goes before OpenGL, which began within its
/// constructor.
Picture& picture() {
  static Picture picture;
  return picture;
}

constexpr double finger = 0.1;  // [m] by which it may miss a body

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

const char* cairn_refusal(void) { return session().refusal.c_str(); }

int cairn_open(const char* text, const char* file) {
  return done([&](Playground& p) { p.open(text, file); });
}
const char* cairn_scene_text(void) { return session().playground.text().c_str(); }
int cairn_restart(void) {
  return done([](Playground& p) { p.restart(); });
}

int cairn_set(const char* setting, const char* value) {
  return done([&](Playground& p) { p.set(setting, value); });
}
const char* cairn_settings(void) {
  const Playground& p = session().playground;
  return returned(controls_text(p.controls(), p.recommended()));
}

int cairn_step(int count) {
  return done([&](Playground& p) { p.step(count); });
}
void cairn_move(int is_moving) { session().playground.set_moving(is_moving != 0); }
int cairn_row(int count) {
  return done([&](Playground& p) { p.advance_rows(count); });
}
int cairn_sweep(void) {
  return done([](Playground& p) { p.advance_sweep(); });
}
int cairn_back(void) {
  return done([](Playground& p) { p.back(); });
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
  const cairn::Snapshot snapshot = session().playground.bench(0).snapshot();
  List<double> numbers;
  for (const cairn::SnapshotBody& body : snapshot.bodies) {
    const List<double> one = {
        body.pose.position.x(), body.pose.position.y(), body.pose.angle, body.velocity.x(),
        body.velocity.y(),      body.velocity.z(),      body.mass,       state_of(body)};
    numbers.insert(numbers.end(), one.begin(), one.end());
  }
  return returned(std::move(numbers));
}
int cairn_body_count(void) { return session().playground.bench(0).scene().bodies().size(); }
const char* cairn_body_name(int body) {
  const auto& names = session().playground.names();
  return body >= 0 && body < names.size() ? names[BodyId{body}].c_str() : "";
}

const double* cairn_rows(void) {
  const Playground& p = session().playground;
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
  return returned(std::move(numbers));
}
int cairn_row_count(void) { return session().playground.look(0).given.row_count(); }
void cairn_light_row(int row) { session().playground.light_row(row); }
int cairn_predict(int row, double newtons) {
  return done([&](Playground& p) { p.predict(row, newtons); });
}
void cairn_reveal(void) {
  done([](Playground& p) { p.reveal(); });
}

const double* cairn_numbers(void) {
  const Playground& p = session().playground;
  const cairn::Snapshot snapshot = p.bench(0).snapshot();
  const SolveLook& look = p.look(0);
  const int sweep = p.cursor() && look.last ? look.last->sweep : look.residuals.size() - 1;
  const auto& prediction = p.prediction();
  return returned(List<double>{
      snapshot.time, static_cast<double>(p.bench(0).steps()), static_cast<double>(look.given.row_count()),
      static_cast<double>(snapshot.contacts.size()), static_cast<double>(p.cursor().value_or(0)),
      static_cast<double>(look.all_updates), static_cast<double>(sweep), look.residuals[sweep],
      1e3 * p.step_seconds(), static_cast<double>(p.lit_row()), as_number(p.has_diverged()),
      static_cast<double>(p.steps_back()), prediction ? static_cast<double>(prediction->row) : -1.0,
      prediction ? prediction->force : 0, as_number(prediction && prediction->is_revealed)});
}
const char* cairn_words(void) { return session().playground.words().c_str(); }
const char* cairn_plan(void) { return returned(explain(make_plan(session().playground.bench(0).scene()))); }
const char* cairn_fingerprint(void) {
  return returned(cairn::hexadecimal(fingerprint_of(session().playground.bench(0).snapshot())));
}

int cairn_resize(int width, int height, double scale) {
  return done([&](Playground&) { picture().resize(width, height, scale); });
}
int cairn_theme(const char* theme) {
  return done([&](Playground&) { picture().choose_theme(theme); });
}
int cairn_draw(void) {
  return done([](Playground& p) {
    picture().draw(p);
    picture().page().canvas().show();
  });
}
const double* cairn_at(double x, double y) {
  const PictureSpot spot = picture().at(session().playground, {x, y});
  return returned(List<double>{static_cast<double>(spot.kind), static_cast<double>(spot.number),
                               spot.point.x(), spot.point.y()});
}
const double* cairn_place(double x, double y) {
  const Vec2<double> place = picture().place({x, y});
  return returned(List<double>{place.x(), place.y()});
}
