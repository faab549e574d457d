// Exercise 15, graded: pucks beyond the circle and within it, rows along v and aslant, and limits that
// change. The expected numbers are those of a vector that is clamped, or of right-angled triangles.
#include "exercise.cpp"

#include <fmt/format.h>

namespace cairn::exercise15 {
namespace {

constexpr double circle_rounding = 1e-13;  // some twenty operations on numbers below 30

/// What an answer gives: both impulses, then both velocities.
using Numbers = FixedList<double, 4>;

struct Case {
  std::string name = {};
  Puck puck = {};
  Rows rows = {};
  List<double> limits = {};  // [N s] of one sweep after the other
  Numbers expected = {};
};

Numbers numbers_of(const Rows& rows, const Puck& puck) { return {rows.first, rows.second, puck.vx, puck.vy}; }

struct Slip {
  const char* words = "";
  enum Kind {
    square,
    bound_before,
    linear,
    corrections,
    no_limit,
    one_way,
    speed,
    per_mass,
    no_mass,
    whole_sum,
    forgets,
    sign,
    other_side,
    second_idle
  } kind = square;
};

const List<Slip> slips = {
    {"Each row for itself: that is a square. The second has what the first leaves of the disc.",
     Slip::square},
    {"The second row looks at what the first has given by now.", Slip::bound_before},
    {"A disc: first² + second² ≤ limit², so the second has a root of squares.", Slip::linear},
    {"Each correction was within its interval, but not their sum. Clamp the sum.", Slip::corrections},
    {"Nothing was clamped: friction has no more than μ λ_n Δt.", Slip::no_limit},
    {"Friction acts both ways: an interval reaches as far below 0 as above.", Slip::one_way},
    {"A speed is no impulse: (22) divides it by 1/m.", Slip::speed},
    {"Equation (22) divides by 1/m: a heavy puck needs more.", Slip::per_mass},
    {"An impulse changes a velocity by p / m.", Slip::no_mass},
    {"The sum has acted before: apply only the difference of the new and the old.", Slip::whole_sum},
    {"Add to what the row has given before, and clamp then.", Slip::forgets},
    {"The sign: an impulse acts against the velocity of its row.", Slip::sign},
    {"The second row acts along (-ay, ax).", Slip::other_side},
    {"The second row has to act, too.", Slip::second_idle}};

void update_with(Slip::Kind slip, double& given, double bound, double x, double y, Puck& puck) {
  const double speed = puck.vx * x + puck.vy * y;
  double correction = -puck.mass * speed;
  if (slip == Slip::speed) correction = -speed;
  if (slip == Slip::per_mass) correction = -speed / puck.mass;
  if (slip == Slip::sign) correction = -correction;
  if (slip == Slip::corrections) correction = std::clamp(correction, -bound, bound);
  const double before = given;
  given = (slip == Slip::forgets ? 0 : before) + correction;
  if (slip != Slip::corrections && slip != Slip::no_limit)
    given = std::clamp(given, -bound, slip == Slip::one_way ? 0 : bound);
  double applied = slip == Slip::whole_sum ? given : given - before;
  if (slip != Slip::no_mass) applied /= puck.mass;
  puck.vx += applied * x;
  puck.vy += applied * y;
}

void sweep_with(Slip::Kind slip, Rows& rows, double limit, Puck& puck) {
  const double before = rows.first;
  update_with(slip, rows.first, limit, rows.ax, rows.ay, puck);
  if (slip == Slip::second_idle) return;
  const double taken = slip == Slip::bound_before ? before : rows.first;
  double bound = std::sqrt(std::max(0.0, limit * limit - taken * taken));
  if (slip == Slip::linear) bound = std::max(0.0, limit - std::abs(taken));
  if (slip == Slip::square) bound = limit;
  const double side = slip == Slip::other_side ? -1 : 1;
  update_with(slip, rows.second, bound, -side * rows.ay, side * rows.ax, puck);
}

/// The words for an answer that gives, to the last number, what one of the mistakes gives.
const char* words_for(const Case& one, const Numbers& got) {
  for (const Slip& slip : slips) {
    Rows rows = one.rows;
    Puck puck = one.puck;
    for (const double limit : one.limits) sweep_with(slip.kind, rows, limit, puck);
    const Numbers wrong = numbers_of(rows, puck);
    bool is_it = true;
    for (int i = 0; i < 4; ++i) is_it = is_it && std::abs(wrong[i] - got[i]) <= circle_rounding;
    if (is_it) return slip.words;
  }
  return "";
}

void grade_case(Grade& grade, const Case& one) {
  Rows rows = one.rows;
  Puck puck = one.puck;
  for (const double limit : one.limits) sweep(rows, limit, puck);
  const Numbers got = numbers_of(rows, puck);
  const FixedList<const char*, 4> names = {"first row (N s)", "second row (N s)", "v_x (m/s)", "v_y (m/s)"};
  bool is_named = false;
  for (int i = 0; i < 4; ++i) {
    ExpectedNumber number{
        .what = one.name + ": " + names[i], .value = one.expected[i], .tolerance = circle_rounding};
    if (!is_named && !(std::abs(got[i] - one.expected[i]) <= circle_rounding)) {
      is_named = true;
      number.misconceptions.push_back({got[i], words_for(one, got)});
    }
    grade.number(number, got[i]);
  }
}

/// All of them: 2 kg at (3, 4) m/s needs 10 N s; 0.5 kg at (−0.06, 0.08) m/s needs 0.05 N s.
List<Case> cases() {
  const Puck heavy{.mass = 2, .vx = 3, .vy = 4}, light{.mass = 0.5, .vx = -0.06, .vy = 0.08};
  const Rows along{.ax = 0.6, .ay = 0.8}, aslant{.ax = 0.8, .ay = 0.6};
  const double rest_of_7 = std::sqrt(7.0 * 7 - 6 * 6), rest_of_slant = std::sqrt(9.7 * 9.7 - 9.6 * 9.6);
  return {{"2 kg, rows along v, limit 4", heavy, along, {4}, {-4, 0, 3 * 0.6, 4 * 0.6}},
          {"2 kg, rows along x, limit 7", heavy, {}, {7}, {-6, -rest_of_7, 0, 4 - rest_of_7 / 2}},
          {"2 kg, rows aslant, limit 9.7",
           heavy,
           aslant,
           {9.7},
           {-9.6, -rest_of_slant, -0.6 * (1.4 - rest_of_slant / 2), 0.8 * (1.4 - rest_of_slant / 2)}},
          {"0.5 kg, rows along x, limit 0.2", light, {}, {0.2}, {0.03, -0.04, 0, 0}},
          {"2 kg, along v, limit 3, then 5", heavy, along, {3, 5}, {-5, 0, 3 * 0.5, 4 * 0.5}},
          {"2 kg, along v, limit 5, then 2", heavy, along, {5, 2}, {-2, 0, 3 * 0.8, 4 * 0.8}},
          {"2 kg, along x, limit 5, then 7", heavy, {}, {5, 7}, {-6, -rest_of_7, 0, 4 - rest_of_7 / 2}}};
}

}  // namespace

Exercise exercise() {
  return {.lesson = 15,
          .task = "A sweep over two friction rows that share a disc: a circle from clamps of single rows.",
          .file = "lessons/15_cone_or_pyramid/exercise.cpp",
          .hints =
              {"What is the velocity of the puck in the direction of a row, and which impulse takes it away?",
               "The second bound is the other side of a right-angled triangle: sqrt(limit² − first²).",
               "first' = clamp(first - m (vx ax + vy ay), -limit, limit); (vx, vy) += (first' - first) / m "
               "(ax, ay). The same for second with (-ay, ax) and its own bound."},
          .grade = [](Grade& grade) {
            for (const Case& one : cases()) grade_case(grade, one);
          }};
}

}  // namespace cairn::exercise15
