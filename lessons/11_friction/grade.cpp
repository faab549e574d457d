// Exercise 11, graded: blocks of 2 and 0.5 kg on two corners, beside sweeps
// over A λ = b in plain loops; and what a mistake would have given, from the
// same sweeps with that mistake in them.
#include "exercise.cpp"

#include <fmt/format.h>

namespace cairn::exercise11 {
namespace {

constexpr double rounding = 1e-13;  // some hundred operations on numbers below 10

struct Slide {
  std::string name = {};
  Block block = {};
  List<Corner> corners = {};
  double friction = 0;
};

/// A box of this mass and size, after gravity has acted for 0.02 s on a slope
/// of 30 degrees.
Slide on_slope(const std::string& name, double mass, double width, double height, double friction,
               double speed) {
  const double inertia = mass * (width * width + height * height) / 12;
  return {.name = name,
          .block = {.inverse_mass = 1 / mass,
                    .inverse_inertia = 1 / inertia,
                    .x_velocity = speed + 0.1,
                    .y_velocity = -0.1 * std::sqrt(3)},
          .corners = {{.x = -width / 2, .y = -height / 2}, {.x = width / 2, .y = -height / 2}},
          .friction = friction};
}

/// The numbers that an answer gives: the impulses of each corner, then the
/// velocities.
List<double> numbers_of(const Slide& slide) {
  List<double> all;
  for (const Corner& corner : slide.corners) {
    all.push_back(corner.normal_impulse);
    all.push_back(corner.tangent_impulse);
  }
  for (const double velocity : {slide.block.x_velocity, slide.block.y_velocity, slide.block.spin})
    all.push_back(velocity);
  return all;
}

/// Row 2 c is the normal row of corner c, row 2 c + 1 its friction row.
List<FixedList<double, 3>> rows_of(const Slide& slide) {
  List<FixedList<double, 3>> rows;
  for (const Corner& corner : slide.corners) {
    rows.push_back({0, 1, corner.x});
    rows.push_back({1, 0, -corner.y});
  }
  return rows;
}

/// What is right: projected Gauss-Seidel on A λ = b, which looks at no velocity
/// until the end.
List<double> expected_of(const Slide& slide, int sweeps) {
  const List<FixedList<double, 3>> j = rows_of(slide);
  const FixedList<double, 3> w = {slide.block.inverse_mass, slide.block.inverse_mass,
                                  slide.block.inverse_inertia};
  FixedList<double, 3> v = {slide.block.x_velocity, slide.block.y_velocity, slide.block.spin};
  List<double> numbers = numbers_of(slide);  // the first ones are λ
  const List<double> before = numbers;
  const auto between = [&](int a, int b) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += j[a][k] * w[k] * j[b][k];
    return sum;
  };
  for (int visit = 0; visit < sweeps * j.size(); ++visit) {
    const int i = visit % j.size();
    double left = 0;
    for (int k = 0; k < 3; ++k) left -= j[i][k] * v[k];
    for (int n = 0; n < j.size(); ++n) left -= between(i, n) * (numbers[n] - before[n]);
    const bool is_normal = i % 2 == 0;
    const double upper = is_normal ? 1e300 : slide.friction * numbers[i - 1];
    numbers[i] = std::clamp(numbers[i] + left / between(i, i), is_normal ? 0 : -upper, upper);
  }
  for (int n = 0; n < j.size(); ++n) {
    for (int k = 0; k < 3; ++k) v[k] += w[k] * j[n][k] * (numbers[n] - before[n]);
  }
  for (int k = 0; k < 3; ++k) numbers[j.size() + k] = v[k];
  return numbers;
}

/// What a mistake is called.
struct Slip {
  const char* words = "";
  enum Kind {
    pulls,
    corrections,
    old_bound,
    friction_first,
    shared_bound,
    no_mu,
    one_way,
    no_limit,
    no_inertia,
    arms_swapped,
    no_spin,
    spin_sign,
    whole_sum,
    forgets,
    sign,
    stale_sliding,
    inverse_twice,
    speed_as_impulse
  } kind = pulls;
};

const List<Slip> slips = {
    {"A contact pushes and never pulls: the sum of its normal impulses is at "
     "least 0.",
     Slip::pulls},
    {"Each correction was within its interval, but not their sum. Clamp the "
     "sum.",
     Slip::corrections},
    {"The bound of friction is that of the normal impulse as it is now.", Slip::old_bound},
    {"First the normal row: the bound of friction is what that row has given.", Slip::friction_first},
    {"Each corner has a bound of its own: mu times its own normal impulse.", Slip::shared_bound},
    {"The bound is the whole normal impulse. Where is mu?", Slip::no_mu},
    {"Friction acts both ways: its interval is -mu N to +mu N.", Slip::one_way},
    {"Friction is at most mu times the normal impulse.", Slip::no_limit},
    {"The block also yields by turning: j M⁻¹ jᵀ has a term with the inverse "
     "inertia.",
     Slip::no_inertia},
    {"The arm of the normal row is x, that of the friction row y.", Slip::arms_swapped},
    {"An impulse at a corner also turns the block: its spin changes.", Slip::no_spin},
    {"The sign of the spin: an impulse along x at y turns the block by -y "
     "times it.",
     Slip::spin_sign},
    {"The sum has acted before: apply only the difference of the new and the "
     "old.",
     Slip::whole_sum},
    {"Add to what the row has given before, and clamp then.", Slip::forgets},
    {"The sign: an impulse acts against the velocity of its row.", Slip::sign},
    {"The normal row has just changed the spin: look at the sliding after it.", Slip::stale_sliding},
    {"Equation (22): divide by j M⁻¹ jᵀ.", Slip::inverse_twice},
    {"A speed is no impulse: divide it by j M⁻¹ jᵀ.", Slip::speed_as_impulse}};

/// One row of a corner, as the mistake has it: takes its velocity away, within
/// [lower, upper].
struct RowWithSlip {
  Slip::Kind slip = Slip::pulls;
  Block& block;
  double& velocity;  // of the block, in the direction of the row
  double arm = 0;    // [m] with its sign in j

  double speed() const { return velocity + arm * block.spin; }
  void update(double& given, double jv, double measured_arm, double lower, double upper) const {
    const double turning = slip == Slip::no_inertia ? 0 : measured_arm * measured_arm * block.inverse_inertia;
    const double inverse = block.inverse_mass + turning;
    double correction = -jv / inverse;
    if (slip == Slip::inverse_twice) correction = -jv * inverse;
    if (slip == Slip::speed_as_impulse) correction = -jv;
    if (slip == Slip::sign) correction = -correction;
    if (slip == Slip::corrections) correction = std::clamp(correction, lower, upper);
    const double before = given;
    given = (slip == Slip::forgets ? 0 : before) + correction;
    if (slip != Slip::corrections) given = std::clamp(given, lower, upper);
    const double applied = slip == Slip::whole_sum ? given : given - before;
    velocity += block.inverse_mass * applied;
    if (slip != Slip::no_spin) block.spin += arm * block.inverse_inertia * applied;
  }
};

void visit_with(Slip::Kind slip, Slide& slide, Corner& corner) {
  const double without = 1e300;
  const double bound_before = slide.friction * corner.normal_impulse;
  const RowWithSlip normal{slip, slide.block, slide.block.y_velocity, corner.x};
  const RowWithSlip tangent{slip, slide.block, slide.block.x_velocity,
                            slip == Slip::spin_sign ? corner.y : -corner.y};
  const RowWithSlip right{slip, slide.block, slide.block.x_velocity, -corner.y};
  const double sliding_before = right.speed();
  const bool swapped = slip == Slip::arms_swapped;
  const auto push = [&] {
    normal.update(corner.normal_impulse, normal.speed(), swapped ? corner.y : corner.x,
                  slip == Slip::pulls ? -without : 0, without);
  };
  if (slip != Slip::friction_first) push();
  double bound = slide.friction * corner.normal_impulse;
  if (slip == Slip::old_bound) bound = bound_before;
  if (slip == Slip::no_mu) bound = corner.normal_impulse;
  if (slip == Slip::no_limit) bound = without;
  if (slip == Slip::pulls) bound = std::abs(bound);
  if (slip == Slip::shared_bound)
    bound = slide.friction * (slide.corners[0].normal_impulse + slide.corners[1].normal_impulse);
  tangent.update(corner.tangent_impulse, slip == Slip::stale_sliding ? sliding_before : right.speed(),
                 swapped ? corner.x : corner.y, -bound, slip == Slip::one_way ? 0 : bound);
  if (slip == Slip::friction_first) push();
}

bool are_equal(const List<double>& a, const List<double>& b) {
  for (int i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i] - b[i]) <= rounding * std::max(1.0, std::abs(b[i])))) return false;
  }
  return true;
}

/// The words for an answer that gives, to the last number, what one of the
/// mistakes gives.
const char* words_for(const Slide& start, int sweeps, const List<double>& got) {
  for (const Slip& slip : slips) {
    Slide slide = start;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (Corner& corner : slide.corners) visit_with(slip.kind, slide, corner);
    }
    if (are_equal(numbers_of(slide), got)) return slip.words;
  }
  return "";
}

void grade_slide(Grade& grade, const Slide& start, int sweeps) {
  Slide slide = start;
  for (int i = 0; i < sweeps; ++i) sweep(slide.corners, slide.friction, slide.block);
  const List<double> got = numbers_of(slide), expected = expected_of(start, sweeps);
  const List<std::string> names = {"upper corner, normal (N s)",
                                   "upper corner, friction (N s)",
                                   "lower corner, normal (N s)",
                                   "lower corner, friction (N s)",
                                   "slides on at (m/s)",
                                   "rises at (m/s)",
                                   "turns at (rad/s)"};
  bool is_named = false;
  for (int i = 0; i < got.size(); ++i) {
    ExpectedNumber number{.what = start.name + ": " + names[i], .value = expected[i], .tolerance = rounding};
    const bool is_wrong = !(std::abs(got[i] - expected[i]) <= rounding);
    if (is_wrong && !is_named) {
      is_named = true;
      number.misconceptions.push_back({got[i], words_for(start, sweeps, got)});
    }
    grade.number(number, got[i]);
  }
}

/// After many sweeps both corners are at rest: then they carry the block and
/// hold it, together.
void grade_standing(Grade& grade) {
  Slide slide = on_slope("2 kg, mu = 0.7", 2, 1, 1, 0.7, 0);
  for (int i = 0; i < 400; ++i) sweep(slide.corners, slide.friction, slide.block);
  const List<double> got = numbers_of(slide);
  grade.number({.what = "400 sweeps, both normal rows: m g Δt cos 30° (N s)",
                .value = 0.2 * std::sqrt(3),
                .tolerance = rounding},
               got[0] + got[2]);
  grade.number(
      {.what = "400 sweeps, both friction rows: −m g Δt sin 30° (N s)", .value = -0.2, .tolerance = rounding},
      got[1] + got[3]);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 11,
          .task =
              "One sweep over a block on two corners: at each a normal row, "
              "and a friction row within mu times "
              "it.",
          .file = "lessons/11_friction/exercise.cpp",
          .hints = {"Four rows, visited one after the other. What does each of "
                    "them change that the next one sees?",
                    "A row along y at x has j M⁻¹ jᵀ = 1/m + x²/I; one along x at "
                    "y has 1/m + y²/I.",
                    "Normal: sum' = max(0, sum - (y_velocity + x spin) / (1/m + "
                    "x²/I)); y_velocity and spin take the "
                    "difference. Friction: the same with x_velocity - y spin, "
                    "clamped to ± mu times the new normal "
                    "sum; the spin takes -y/I times the difference."},
          .grade = [](Grade& grade) {
            grade_slide(grade, on_slope("2 kg, mu = 0.6", 2, 1, 1, 0.6, 0), 1);
            grade_slide(grade, on_slope("0.5 kg, mu = 0.3, 3 sweeps", 0.5, 0.8, 0.4, 0.3, 1), 3);
            grade_slide(grade, on_slope("2 kg, uphill at 1 m/s", 2, 1, 0.5, 0.5, -1.1), 2);
            Slide lifted = on_slope("2 kg, upper corner lifts off", 2, 1, 0.5, 0.5, 0);
            lifted.block.y_velocity = 0.1;
            lifted.block.spin = -0.6;
            for (Corner& corner : lifted.corners)
              corner.normal_impulse = 0.05, corner.tangent_impulse = -0.02;
            grade_slide(grade, lifted, 1);
            grade_standing(grade);
          }};
}

}  // namespace cairn::exercise11
