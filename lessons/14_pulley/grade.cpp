// Exercise 14, graded: a rope on masses of 2, 0.5 and 0.5 kg and a drum, in a loop that knows rows only.
#include "exercise.cpp"

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

/// A drum of 0.4 kg m² with a radius of 0.5 m, 2 kg on one part, and twice 0.5 kg on two and on one.
List<Body> bodies() {
  return {{.inverse_inertia = 2.5}, {.inverse_mass = 0.5}, {.inverse_mass = 2}, {.inverse_mass = 2}};
}

List<Pose> hanging(double drum_angle) { return {{.angle = drum_angle}, {.y = 1.25}, {.y = 2}, {.y = 3.5}}; }

RopeOnDrum rope() {
  return {{{.body = 1, .parts = 1, .top = 5},
           {.body = 2, .parts = 2, .top = 5},
           {.body = 3, .parts = 1, .top = 6}},
          {.body = 0, .radius = 0.5, .grip = 40},
          10.75};
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

/// c = 10.75 + 0.5 · 1.6 − 3.75 − 2 · 3 − 2.5 = −0.7.
void grade_error(Grade& grade, const Row& row) {
  const char* const pays_out = "The drum pays out radius * angle of rope: add it.";
  const char* const every_end = "c has every end: one is missing.";
  grade.number({.what = "c: what is left of the rope (m)",
                .value = -0.7,
                .misconceptions = {{-1.5, pays_out},
                                   {-2.3, pays_out},
                                   {0.1, "A drum that turns by an angle pays out radius * angle."},
                                   {2.3, "Each part of the rope at a mass has the length top − y."},
                                   {-2.7, "Each part of the rope at a mass has the length top − y."},
                                   {-6.7, "c has the parts once."},
                                   {2.8, "A mass hangs from its top: the length of a part is top − y."},
                                   {0.3, "Each end has its own top."},
                                   {-4.95, "Bodies have numbers of their own: end.body, drum.body."},
                                   {1.8, every_end},
                                   {3.05, every_end},
                                   {-11.45, "c begins with the length of the rope."},
                                   {8.25, "Every end takes its part of the rope: subtract, do not set."},
                                   {0.7, "c is the room that is left: positive where the rope is slack."}},
                .tolerance = rope_rounding},
               row.error);
  const bool is_right = std::abs(row.error + 0.7) <= rope_rounding;
  grade.number({.what = "c where the drum has turned by 4 rad more (m)",
                .value = 1.3,
                .misconceptions = {{0, is_right ? "A rope may be slack: c is positive then." : ""}},
                .tolerance = rope_rounding},
               rope().row(hanging(5.6)).error);
}

/// j·v with a speed for one body alone is the entry of that body.
void grade_jacobian(Grade& grade, const Row& row) {
  const char* const one_of_two = "Masses rise, and the drum turns: a term has one of the two entries.";
  const char* const rise = "The rise of a mass leaves more rope: dc/dt is positive.";
  const auto entry = [&row](int body, double vy, double omega) {
    List<Body> moving = bodies();
    moving[body].vy = vy, moving[body].omega = omega;
    return speed_of(row, moving);
  };
  const bool own = entry(1, 1, 0) != 2;  // the body's own term, not that of its neighbour
  grade.number({.what = "j·v where the 0.5 kg on two parts rise at 1 m/s (m/s)",
                .value = 2,
                .misconceptions = {{1, own ? "j has the parts: two parts get shorter together." : ""},
                                   {4, "j has the parts once: the square comes from j M⁻¹ jᵀ."},
                                   {-2, rise}},
                .tolerance = rope_rounding},
               entry(2, 1, 0));
  grade.number(
      {.what = "j·v where the last 0.5 kg rise at 1 m/s (m/s)",
       .value = 1,
       .misconceptions = {{0, own ? "The row needs a term for every end: the last is missing." : ""}},
       .tolerance = rope_rounding},
      entry(3, 1, 0));
  grade.number(
      {.what = "j·v where the drum turns at 1 rad/s (m/s)",
       .value = 0.5,
       .misconceptions =
           {{0, row.terms.size() > 3 ? "The drum turns, it does not rise: its entry is in omega."
                                     : "There is no term for the drum."},
            {-0.5, entry(2, 1, 0) < 0 ? rise : "A drum that pays out leaves more rope: both signs are +."},
            {0.25, "The radius comes in once: rope is paid out at radius * omega."},
            {1, "The radius is in j: rope is paid out at radius * omega."}},
       .tolerance = rope_rounding},
      entry(0, 0, 1));
  grade.number({.what = "j·v where the drum rises, and a mass turns (m/s)",
                .value = 0,
                .misconceptions = {{0.5, one_of_two}, {1, own ? one_of_two : ""}},
                .tolerance = rope_rounding},
               entry(0, 1, 0) + entry(2, 0, 1));
}

/// Four parts of the rope fall at g dt: λ = 4 g / (1/2 + 4 · 2 + 2 + 0.25 · 2.5).
void grade_force(Grade& grade, const Row& row) {
  List<Body> falling = after_falling();
  const bool opens = speed_of(row, falling) < 0;
  grade.number({.what = "λ after one step of falling (N)",
                .value = 4 * gravity / 11.125,
                .misconceptions = {{0, opens ? "λ is bounded from below: the rope pulls with λ ≥ 0." : ""}},
                .tolerance = rope_rounding},
               visit(row, falling));
  List<Body> rising = bodies();
  rising[1].vy = 1;
  grade.number({.what = "λ where the 2 kg rise (N)",
                .value = 0,
                .misconceptions = {{-1 / (11.125 * dt), "A rope cannot push: λ ≥ 0."}},
                .tolerance = rope_rounding},
               visit(row, rising));
  List<Body> torn = bodies();
  torn[1].vy = -20;
  grade.number({.what = "λ where the 2 kg are torn down at 20 m/s (N)",
                .value = 40,
                .misconceptions = {{20 / (11.125 * dt), "The drum slips: λ is at most its grip."},
                                   {20, "The grip is a pull in N, not a moment: no radius."},
                                   {80, "The grip is a pull in N, not a moment: no radius."},
                                   {40 * dt, "The interval is one of λ in N, not of an impulse."}},
                .tolerance = rope_rounding},
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
        const Row row = rope().row(hanging(1.6));
        grade_error(grade, row);
        grade_jacobian(grade, row);
        grade_force(grade, row);
      }};
}

}  // namespace cairn::exercise14
