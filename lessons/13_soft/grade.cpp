// Exercise 13, graded: one visit that begins with an impulse, one that pulls, in a longer step, then sweeps
// over two weights on two springs.
#include "exercise.cpp"

namespace cairn::exercise13 {
namespace {

constexpr double soft_rounding = 1e-12;  // a few dozen operations on numbers up to 10

constexpr double dt = 0.02;

/// 3 kg below and 0.7 kg above, on their way, and a spring that has pushed with 0.3 N s already.
constexpr Body below_before{.inverse_mass = 1 / 3.0, .velocity = 0.25};
constexpr Body above_before{.inverse_mass = 1 / 0.7, .velocity = -0.4};
constexpr Spring spring_before{.stiffness = 240, .damping = 11, .error = -0.15, .impulse = 0.3};

/// The numbers of a visit, for the right one and for those with one mistake.
struct Visit {
  double dt_k = dt * spring_before.stiffness;
  double resisting = spring_before.damping + dt * spring_before.stiffness;  // d + dt k
  double gamma = 1 / (dt * resisting);
  double beta = dt_k / resisting;
  double zeta = -beta * spring_before.error / dt;
  double speed = above_before.velocity - below_before.velocity;
  double given = spring_before.impulse;
  double inverse = below_before.inverse_mass + above_before.inverse_mass;

  double added() const { return (zeta - speed - gamma * given) / (inverse + gamma); }
};

/// With another gamma, or with another beta.
Visit with_softness(double gamma, double beta) {
  return {.gamma = gamma, .beta = beta, .zeta = -beta * spring_before.error / dt};
}

/// What a visit with a mistake in γ or β makes of the impulse, and the words for it.
std::vector<Misconception> wrong_softness(const Visit& right) {
  const double before = spring_before.impulse, gamma = right.gamma;
  const double stiff = spring_before.damping + spring_before.stiffness;  // in different units
  const char* const mixed = "d + Δt k: a stiffness is a damping when it is multiplied by Δt.";
  return {
      {before + with_softness(1 / right.resisting, right.beta).added(),
       "γ = 1 / (Δt (d + Δt k)): a Δt is lacking."},
      {before + with_softness(dt * right.resisting, right.beta).added(),
       "γ is large for soft springs: the inverse."},
      {before + with_softness(gamma / dt, right.beta).added(), "γ = 1 / (Δt (d + Δt k)): a Δt too many."},
      {before + with_softness(1 / (dt * stiff), right.beta).added(), mixed},
      {before + with_softness(1 / (dt * stiff), right.dt_k / stiff).added(), mixed},
      {before + with_softness(gamma, spring_before.stiffness / stiff).added(), mixed},
      {before + with_softness(gamma, 1).added(), "Where is β? The row takes a share of the error."},
      {before + dt * (-spring_before.stiffness * spring_before.error - spring_before.damping * right.speed),
       "That is the force of now, times Δt: it knows nothing of γ, and of what the impulse does."},
      {before + with_softness(1 / (dt * right.dt_k), 1).added(), "The damper stands beside Δt k: d + Δt k."},
      {before + with_softness(1 / (dt * right.dt_k), right.beta).added(),
       "γ: the damper stands beside Δt k."},
      {before + with_softness(gamma, spring_before.damping / right.resisting).added(),
       "β: d + Δt k goes below, Δt k above. Yours is what is left of the error."},
      {before + with_softness(gamma, right.beta / dt).added(),
       "β = Δt k / (d + Δt k) is a share, without a unit."},
      {before + with_softness(right.beta, gamma).added(), "γ and β have changed places."}};
}

/// The same with any mistake.
std::vector<Misconception> known_impulses(const Visit& right) {
  const double before = spring_before.impulse, inverse = right.inverse, gamma = right.gamma;
  const double lacking = right.zeta - right.speed - gamma * before;
  std::vector<Misconception> known = {
      {before, "Nothing was added to the impulse."},
      {right.added(), "The impulse is a sum over all visits: add to it."},
      {before + Visit{.given = 0}.added(),
       "The row is content with γ less for all that it has given before."},
      {before + Visit{.given = -before}.added(), "γ times the impulse stands beside j·v: it is subtracted."},
      {before + (right.zeta - right.speed - before) / (inverse + gamma),
       "γ times the impulse, not the impulse."},
      {before + lacking / inverse, "γ stands beside the inverse masses, too."},
      {before + lacking / gamma, "The inverse masses stand beside γ: both bodies give way."},
      {before + lacking / (above_before.inverse_mass + gamma), "j M⁻¹ jᵀ has a term of the body below."},
      {before + lacking / (below_before.inverse_mass + gamma), "j M⁻¹ jᵀ has a term of the body above."},
      {before + lacking / ((inverse + gamma) * dt), "That is a force: an impulse has no Δt in (22)."},
      {before + Visit{.zeta = -right.zeta}.added(), "ζ = −β c / Δt: a spring that is pressed pushes."},
      {before + Visit{.zeta = right.zeta * dt}.added(), "ζ is a velocity: β c / Δt."},
      {before + Visit{.zeta = 0}.added(), "Where is ζ = −β c / Δt?"},
      {before + Visit{.speed = -right.speed}.added(), "j·v is the speed of the one above less that below."},
      {before + Visit{.speed = 0}.added(), "Where is j·v?"},
      {before - right.added(), "The sign of what is added: ζ − j·v is what is lacking."}};
  const std::vector<Misconception> softness = wrong_softness(right);
  known.insert(known.end(), softness.begin(), softness.end());
  return known;
}

/// Whether the visit adds anything.
bool grade_visit(Grade& grade) {
  Spring spring = spring_before;
  Body below = below_before, above = above_before;
  visit(spring, below, above, dt);
  const Visit right;
  const double added = right.added();
  grade.number({.what = "impulse after the visit (N s)",
                .value = spring_before.impulse + added,
                .misconceptions = known_impulses(right),
                .tolerance = soft_rounding},
               spring.impulse);
  grade.number({.what = "velocity of the 0.7 kg above (m/s)",
                .value = above_before.velocity + added * above_before.inverse_mass,
                .misconceptions = {{above_before.velocity, "The impulse acts on the body above."},
                                   {above_before.velocity - added * above_before.inverse_mass,
                                    "A push is upwards for the body above."},
                                   {above_before.velocity + added, "Divide by the mass."},
                                   {above_before.velocity + added / above_before.inverse_mass,
                                    "inverse_mass is 1/m already: multiply by it."},
                                   {above_before.velocity + added * below_before.inverse_mass,
                                    "Each body has its own inverse mass."},
                                   {above_before.velocity + (right.given + added) * above_before.inverse_mass,
                                    "Apply what this visit adds: the rest was applied before."}},
                .tolerance = soft_rounding},
               above.velocity);
  grade.number({.what = "velocity of the 3 kg below (m/s)",
                .value = below_before.velocity - added * below_before.inverse_mass,
                .misconceptions = {{below_before.velocity, "The impulse acts on the body below, too."},
                                   {below_before.velocity - added, "Divide by the mass."},
                                   {below_before.velocity - (right.given + added) * below_before.inverse_mass,
                                    "Apply what this visit adds: the rest was applied before."},
                                   {below_before.velocity + added * below_before.inverse_mass,
                                    "What pushes the body above up pushes the one below down."}},
                .tolerance = soft_rounding},
               below.velocity);
  return spring.impulse != spring_before.impulse;
}

/// What a stretched spring between the two gives in its first visit, if both stand still.
double pull(double of_dt) {
  const double resisting = spring_before.damping + of_dt * spring_before.stiffness;
  const double zeta = -spring_before.stiffness / resisting * 0.15;  // β c / Δt
  return zeta / (below_before.inverse_mass + above_before.inverse_mass + 1 / (of_dt * resisting));
}

void grade_pull(Grade& grade, bool adds) {
  Spring spring = spring_before;
  spring.error = 0.15;
  spring.impulse = 0;
  Body below{.inverse_mass = below_before.inverse_mass}, above{.inverse_mass = above_before.inverse_mass};
  visit(spring, below, above, 0.05);
  grade.number(
      {.what = "stretched by 0.15 m, a step of 0.05 s: impulse (N s)",
       .value = pull(0.05),
       .misconceptions = {{0, adds ? "A spring pulls as well: nothing is clamped." : ""},
                          {pull(dt), "The step has 0.05 s here: take dt, not a number of your own."}},
       .tolerance = soft_rounding},
      spring.impulse);
}

/// One step of 3 kg on the ground's spring and 0.7 kg on a spring upon it: 200 sweeps. Two rows with two
/// unknown impulses p: (A + γ) p = ζ − j·v, solved by Cramer's rule.
void grade_tower(Grade& grade, bool adds) {
  Body ground, lower{.inverse_mass = 1 / 3.0, .velocity = -0.2},
      upper{.inverse_mass = 1 / 0.7, .velocity = -0.2};
  Spring first = spring_before, second = spring_before;
  first.impulse = second.impulse = 0;
  bool is_none = false;  // in one sweep, and not because the sweeps diverge
  for (int sweep = 0; sweep < 200; ++sweep) {
    visit(first, ground, lower, dt);
    if (sweep == 0) is_none = std::isnan(first.impulse);
    visit(second, lower, upper, dt);
  }
  const Visit row;
  const double a11 = lower.inverse_mass + row.gamma, a12 = -lower.inverse_mass;
  const double a22 = lower.inverse_mass + upper.inverse_mass + row.gamma;
  const double b1 = row.zeta + 0.2, b2 = row.zeta;
  grade.number(
      {.what = "two weights, 200 sweeps: impulse of the lower spring (N s)",
       .value = (b1 * a22 - a12 * b2) / (a11 * a22 - a12 * a12),
       .misconceptions = {{std::nan(""), is_none ? "The ground has 1/m = 0, and no mass to divide by." : ""},
                          {0, adds ? "The ground carries a spring as well: its 1/m is 0, and no more." : ""}},
       .tolerance = soft_rounding},
      first.impulse);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 13,
      .task = "One visit of a soft row, between two bodies: the impulse is a sum, and γ counts all of it.",
      .file = "lessons/13_soft/exercise.cpp",
      .hints = {"Begin with γ = 1 / (Δt (d + Δt k)), β = Δt k / (d + Δt k) and ζ = −β c / Δt.",
                "(22) times Δt: added = (ζ − j·v − γ · impulse) / (1/m below + 1/m above + γ).",
                "Add it to the impulse; the body above gets it upwards, the one below downwards."},
      .grade = [](Grade& grade) {
        const bool adds = grade_visit(grade);
        grade_pull(grade, adds);
        grade_tower(grade, adds);
      }};
}

}  // namespace cairn::exercise13
