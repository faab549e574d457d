// Exercise 14, graded: a rope on masses of 2, 0.5 and 0.5 kg and a drum, in a loop that knows rows only.
#include "exercise.cpp"

#include <algorithm>
#include <cmath>

namespace cairn::exercise14 {
namespace {

constexpr double rope_rounding = 1e-12;  // a few dozen operations on numbers up to 40
constexpr double gravity = 10, dt = 0.02;

struct Body {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m²)]
  double vy = 0;               // [m/s]
  double omega = 0;            // [rad/s]
};

/// 2 kg on one part, twice 0.5 kg on two and on one, and a drum of 0.4 kg m² with a radius of 0.5 m.
List<Body> bodies() {
  return {{.inverse_mass = 0.5}, {.inverse_mass = 2}, {.inverse_mass = 2}, {.inverse_inertia = 2.5}};
}

const List<Pose> hanging = {{.y = 1}, {.y = 2}, {.y = 3}, {.angle = 2}};

RopeOnDrum rope() {
  return {{{.body = 0, .parts = 1, .top = 5},
           {.body = 1, .parts = 2, .top = 5},
           {.body = 2, .parts = 1, .top = 6}},
          {.body = 3, .radius = 0.5, .grip = 40},
          11.5};
}

double speed_of(const Row& row, const List<Body>& bodies) {
  double speed = 0;
  for (const Term& term : row.terms) {
    speed += term.vy * bodies[term.body].vy + term.omega * bodies[term.body].omega;
  }
  return speed;
}

/// One visit, equations (22) and (23): λ [N], clamped.
double visit(const Row& row, List<Body>& bodies) {
  double inverse = 0;  // [1/kg] j M⁻¹ jᵀ
  for (const Term& term : row.terms) {
    inverse += term.vy * term.vy * bodies[term.body].inverse_mass +
               term.omega * term.omega * bodies[term.body].inverse_inertia;
  }
  if (!(inverse > 0)) return 0;
  const double lambda = std::clamp(-speed_of(row, bodies) / (inverse * dt), row.lower, row.upper);
  for (const Term& term : row.terms) {
    bodies[term.body].vy += bodies[term.body].inverse_mass * term.vy * lambda * dt;
    bodies[term.body].omega += bodies[term.body].inverse_inertia * term.omega * lambda * dt;
  }
  return lambda;
}

List<Body> after_falling() {
  List<Body> result = bodies();
  for (Body& body : result) {
    if (body.inverse_mass > 0) body.vy = -gravity * dt;
  }
  return result;
}

/// c = 11.5 + 0.5 · 2 − 4 − 2 · 3 − 3 = −0.5.
void grade_error(Grade& grade, const Row& row) {
  grade.number({.what = "c: what is left of the rope (m)",
                .value = -0.5,
                .tolerance = rope_rounding,
                .misconceptions = {{-1.5, "The drum pays out radius * angle of rope: add it."},
                                   {-2.5, "The drum pays out radius * angle of rope: add it."},
                                   {2.5, "Each part of the rope at a mass has the length top − y."},
                                   {4.5, "A mass hangs from its top: the length of a part is top − y."},
                                   {0.5, "c is the room that is left: positive where the rope is slack."}}},
               row.error);
}

/// j·v with a speed for one body alone is the entry of that body.
void grade_jacobian(Grade& grade, const Row& row) {
  const auto entry = [&row](int body, double vy, double omega) {
    List<Body> moving = bodies();
    moving[body].vy = vy, moving[body].omega = omega;
    return speed_of(row, moving);
  };
  grade.number({.what = "j·v where the 0.5 kg on two parts rise at 1 m/s (m/s)",
                .value = 2,
                .tolerance = rope_rounding,
                .misconceptions = {{1, "j has the parts: two parts get shorter at once."},
                                   {4, "j has the parts once: the square comes from j M⁻¹ jᵀ."},
                                   {-2, "The rise of a mass leaves more rope: dc/dt is positive."}}},
               entry(1, 1, 0));
  grade.number({.what = "j·v where the last 0.5 kg rise at 1 m/s (m/s)",
                .value = 1,
                .tolerance = rope_rounding,
                .misconceptions = {{0, "The row needs a term for every end: the last is missing."}}},
               entry(2, 1, 0));
  grade.number({.what = "j·v where the drum turns at 1 rad/s (m/s)",
                .value = 0.5,
                .tolerance = rope_rounding,
                .misconceptions = {{0, row.terms.size() > 3
                                           ? "The drum turns, it does not rise: its entry is in omega."
                                           : "There is no term for the drum."},
                                   {-0.5, "A drum that pays out leaves more rope: both signs are +."},
                                   {1, "The radius is in j: rope is paid out at radius * omega."}}},
               entry(3, 0, 1));
}

/// Four parts of the rope fall at g dt: λ = 4 g / (1/2 + 4 · 2 + 2 + 0.25 · 2.5).
void grade_force(Grade& grade, const Row& row) {
  List<Body> falling = after_falling();
  grade.number({.what = "λ after one step of falling (N)",
                .value = 4 * gravity / 11.125,
                .tolerance = rope_rounding,
                .misconceptions = {{0, "λ is bounded from below: the rope pulls with λ ≥ 0."}}},
               visit(row, falling));
  List<Body> rising = bodies();
  rising[0].vy = 1;
  grade.number({.what = "λ where the 2 kg rise (N)",
                .value = 0,
                .tolerance = rope_rounding,
                .misconceptions = {{-1 / (11.125 * dt), "A rope cannot push: λ ≥ 0."}}},
               visit(row, rising));
  List<Body> torn = bodies();
  torn[0].vy = -20;
  grade.number({.what = "λ where the 2 kg are torn down at 20 m/s (N)",
                .value = 40,
                .tolerance = rope_rounding,
                .misconceptions = {{20 / (11.125 * dt), "The drum slips: λ is at most its grip."},
                                   {40 * dt, "The interval is one of λ in N, not of an impulse."}}},
               visit(row, torn));
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 14,
      .task = "A joint class: the row of a rope on any number of masses and a drum. No solver knows of it.",
      .file = "lessons/14_pulley/exercise.cpp",
      .hints = {"c is the length, more what the drum has paid out, less what hangs at each mass. And dc/dt?",
                "A mass that rises at v_y leaves parts * v_y more rope, a drum radius * omega. A rope cannot "
                "push.",
                "For each end: error -= parts (top − y), and a term with vy = parts. For the drum: error += "
                "radius * angle, and a term with omega = radius. lower = 0, upper = the grip."},
      .grade = [](Grade& grade) {
        const Row row = rope().row(hanging);
        grade_error(grade, row);
        grade_jacobian(grade, row);
        grade_force(grade, row);
      }};
}

}  // namespace cairn::exercise14
