// Exercise 02, graded: two bodies that move, a fixed peg, a push off the centre and one that slows. The
// expected numbers come from j and M⁻¹ as arrays of six; what a mistake would give, from the push with that
// mistake in it.
#include "exercise.cpp"

#include <fmt/format.h>

namespace cairn::exercise02 {
namespace {

constexpr double rounding = 1e-13;  // some thirty operations on numbers below 20

struct Meeting {
  std::string name = {};
  Body first = {}, second = {};
  Contact contact = {};
};

/// The impulse, then the velocities of the first body, then those of the second.
using Numbers = FixedList<double, 7>;

Numbers numbers_of(double impulse, const Body& a, const Body& b) {
  return {impulse, a.vx, a.vy, a.spin, b.vx, b.vy, b.spin};
}

Numbers expected_of(const Meeting& m) {
  const Contact& c = m.contact;
  const auto turn = [&c](const Body& body) { return (c.x - body.x) * c.ny - (c.y - body.y) * c.nx; };
  const FixedList<double, 6> j = {-c.nx, -c.ny, -turn(m.first), c.nx, c.ny, turn(m.second)};
  const FixedList<double, 6> w = {m.first.inverse_mass,  m.first.inverse_mass,  m.first.inverse_inertia,
                                  m.second.inverse_mass, m.second.inverse_mass, m.second.inverse_inertia};
  Numbers result = numbers_of(0, m.first, m.second);
  double jv = 0, gives = 0;
  for (int i = 0; i < 6; ++i) {
    jv += j[i] * result[i + 1];
    gives += j[i] * w[i] * j[i];
  }
  result[0] = (c.wanted - jv) / gives;
  for (int i = 0; i < 6; ++i) result[i + 1] += w[i] * j[i] * result[0];
  return result;
}

struct Slip {
  const char* words = "";
  enum Kind {
    sign,
    multiplies,
    undivided,
    no_turn_in_mass,
    arm_once,
    one_body,
    no_mass,
    inverted,
    no_wanted,
    minus_wanted,
    no_speed,
    no_spin,
    clamps,
    from_origin,
    other_cross,
    both_along,
    only_second,
    only_first,
    no_turning,
    by_impulse,
    by_mass
  } kind = sign;
};

const List<Slip> slips = {
    {"The sign: (22) has ζ − j·v, and the push must take the speed away, not double it.", Slip::sign},
    {"Divide by j M⁻¹ jᵀ: what yields easily needs less.", Slip::multiplies},
    {"That is the change of velocity. Divide it by j M⁻¹ jᵀ.", Slip::undivided},
    {"The bodies turn as well: j M⁻¹ jᵀ has (r × n)² / I of each.", Slip::no_turn_in_mass},
    {"The arm comes in twice: once in j, once in jᵀ.", Slip::arm_once},
    {"Both bodies yield: j M⁻¹ jᵀ has a part of each.", Slip::one_body},
    {"The bodies move as a whole, too: where is 1/m?", Slip::no_mass},
    {"These are inverses already: do not invert them again.", Slip::inverted},
    {"ζ is what j·v₂ has to be: it is not always 0.", Slip::no_wanted},
    {"The signs: (22) has ζ − j·v, not −ζ − j·v.", Slip::minus_wanted},
    {"How fast are the points before? (22) has ζ − j·v₁.", Slip::no_speed},
    {"The points move with the turning of their bodies, too: j·v has the spins in it.", Slip::no_spin},
    {"Nothing is clamped here: where they part too fast, the impulse is negative.", Slip::clamps},
    {"An arm begins at the centre of its body, not at the origin.", Slip::from_origin},
    {"The order: r × n is r_x n_y − r_y n_x.", Slip::other_cross},
    {"Action and reaction: the first body is pushed against n.", Slip::both_along},
    {"Every push has two ends: the first body's velocities change, too.", Slip::only_second},
    {"Every push has two ends: the second body's velocities change, too.", Slip::only_first},
    {"The push also turns the bodies: their spins change by (r × n) / I.", Slip::no_turning},
    {"An impulse is no change of velocity: multiply it by the inverse mass and the inverse inertia.",
     Slip::by_impulse},
    {"The spin changes by 1/I, not by 1/m.", Slip::by_mass}};

double turn_with(Slip::Kind slip, const Body& body, const Contact& c) {
  const double x = slip == Slip::from_origin ? c.x : c.x - body.x;
  const double y = slip == Slip::from_origin ? c.y : c.y - body.y;
  return slip == Slip::other_cross ? y * c.nx - x * c.ny : x * c.ny - y * c.nx;
}

double yield_with(Slip::Kind slip, const Body& body, double turn) {
  double mass = body.inverse_mass, inertia = body.inverse_inertia;
  if (slip == Slip::inverted) mass = 1 / mass, inertia = 1 / inertia;
  if (slip == Slip::no_turn_in_mass) inertia = 0;
  if (slip == Slip::no_mass) mass = 0;
  return mass + (slip == Slip::arm_once ? std::abs(turn) : turn * turn) * inertia;
}

void move_with(Slip::Kind slip, Body& body, const Contact& c, double turn, double impulse) {
  const bool raw = slip == Slip::by_impulse;
  body.vx += (raw ? 1 : body.inverse_mass) * c.nx * impulse;
  body.vy += (raw ? 1 : body.inverse_mass) * c.ny * impulse;
  if (slip == Slip::no_turning) return;
  const double inertia = slip == Slip::by_mass ? body.inverse_mass : body.inverse_inertia;
  body.spin += (raw ? 1 : inertia) * turn * impulse;
}

Numbers pushed_with(Slip::Kind slip, Meeting m) {
  const Contact& c = m.contact;
  const double turn1 = turn_with(slip, m.first, c), turn2 = turn_with(slip, m.second, c);
  double parting = c.nx * (m.second.vx - m.first.vx) + c.ny * (m.second.vy - m.first.vy);
  if (slip != Slip::no_spin) parting += turn2 * m.second.spin - turn1 * m.first.spin;
  const double gives =
      yield_with(slip, m.second, turn2) + (slip == Slip::one_body ? 0 : yield_with(slip, m.first, turn1));
  double change = c.wanted - parting;
  if (slip == Slip::sign) change = -change;
  if (slip == Slip::no_wanted) change = -parting;
  if (slip == Slip::minus_wanted) change = -c.wanted - parting;
  if (slip == Slip::no_speed) change = c.wanted;
  double impulse = change / gives;
  if (slip == Slip::multiplies) impulse = change * gives;
  if (slip == Slip::undivided) impulse = change;
  if (slip == Slip::clamps) impulse = std::max(impulse, 0.0);
  if (slip != Slip::only_second)
    move_with(slip, m.first, c, turn1, slip == Slip::both_along ? impulse : -impulse);
  if (slip != Slip::only_first) move_with(slip, m.second, c, turn2, impulse);
  return numbers_of(impulse, m.first, m.second);
}

/// The words for an answer that gives, to the last number, what one of the mistakes gives.
const char* words_for(const Meeting& meeting, const Numbers& got) {
  for (const Slip& slip : slips) {
    const Numbers wrong = pushed_with(slip.kind, meeting);
    bool is_it = true;
    for (int i = 0; i < 7; ++i)
      is_it = is_it && std::abs(wrong[i] - got[i]) <= rounding * (1 + std::abs(wrong[i]));
    if (is_it) return slip.words;
  }
  return "";
}

void grade_meeting(Grade& grade, const Meeting& meeting) {
  Meeting m = meeting;
  const double impulse = push(m.first, m.second, m.contact);
  const Numbers got = numbers_of(impulse, m.first, m.second), expected = expected_of(meeting);
  const FixedList<const char*, 7> names = {"impulse (N s)",   "first v_x (m/s)",  "first v_y (m/s)",
                                           "first ω (rad/s)", "second v_x (m/s)", "second v_y (m/s)",
                                           "second ω (rad/s)"};
  bool is_named = false;
  for (int i = 0; i < 7; ++i) {
    ExpectedNumber number{
        .what = meeting.name + ": " + names[i], .value = expected[i], .tolerance = rounding};
    if (!is_named && !(std::abs(got[i] - expected[i]) <= rounding)) {
      is_named = true;
      number.misconceptions.push_back({got[i], words_for(meeting, got)});
    }
    grade.number(number, got[i]);
  }
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 2,
      .task = "A push between two bodies: equation (22) times Δt, and what it does to both, (19) and (21).",
      .file = "lessons/02_effective_mass/exercise.cpp",
      .hints =
          {"What are the six numbers of j? Those of the first body have a minus.",
           "r × n = (x − x_i) n_y − (y − y_i) n_x for each body; j M⁻¹ jᵀ is the sum of 1/m + (r × n)²/I.",
           "j·v = n·(v_2 − v_1) + (r_2 × n) ω_2 − (r_1 × n) ω_1. The impulse is (ζ − j·v) / (j M⁻¹ jᵀ); "
           "v changes by ∓ n/m times it, ω by ∓ (r × n)/I times it."},
      .grade = [](Grade& grade) {
        // 2 kg and 0.4 kg m²; 0.5 kg and 0.05 kg m².
        const Body peg{.x = 0.25, .y = -1},
            low{.x = -1, .y = -0.5, .inverse_mass = 2, .inverse_inertia = 20, .vx = 1, .vy = 0.5, .spin = -2};
        const Body box{
            .x = 0.5, .y = 0.5, .inverse_mass = 0.5, .inverse_inertia = 2.5, .vx = -1, .vy = -3, .spin = 0.5};
        const Contact under{.x = 0.25, .y = 0, .ny = 1};
        const Contact aslant{.x = -0.2, .y = 0.1, .nx = 0.6, .ny = 0.8, .wanted = 0.3};
        Meeting parting{"0.5 and 2 kg, part too fast", low, box, aslant};
        parting.second.vx = 3, parting.second.vy = 1;
        grade_meeting(grade, {"a fixed peg and 2 kg", peg, box, under});
        grade_meeting(grade, {"0.5 and 2 kg, to part at 0.3 m/s", low, box, aslant});
        grade_meeting(grade, parting);
      }};
}

}  // namespace cairn::exercise02
