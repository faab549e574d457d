// Lesson 02. The pushes in lines and rows, and what has to be true of them.
#include "lesson.hpp"

namespace cairn::one_push {

namespace {

const Vec3<double>& velocity_after(const Push& push) { return push.after.bodies[{2}].velocity; }

}  // namespace

void print_scene(Lesson& lesson, const PegSettings& settings) {
  lesson.print(
      fmt::format("Scene: a unit box of {:g} kg, I = m (1² + 1²)/12 = {:.4g} kg m², falls at {:g} m/s on a "
                  "fixed peg; Δt = {:g} s, "
                  "no gravity",
                  settings.mass, inertia_of(settings.mass), settings.speed, settings.dt));
}

void print_pair(Lesson& lesson, const Pushes& all) {
  const Push& push = all.at.back();
  const Vec3<double>& a = push.row.jacobian_a;
  const Vec3<double>& b = push.row.jacobian_b;
  const Vec3<double>& v = push.before.bodies[{2}].velocity;
  const Vec3<double>& w = push.inverse_mass[{2}];
  lesson.print(fmt::format("The peg at x = {:g} m:", push.x));
  lesson.print("              peg (a): x, y, θ            box (b): x, y, θ");
  const auto line = [&](const char* name, const Vec3<double>& of_a, const Vec3<double>& of_b) {
    lesson.print(fmt::format("  {:<8}{:>8}{:>8}{:>8}    {:>8}{:>8}{:>8}", name, fixed(of_a.x(), 3),
                             fixed(of_a.y(), 3), fixed(of_a.z(), 3), fixed(of_b.x(), 3), fixed(of_b.y(), 3),
                             fixed(of_b.z(), 3)));
  };
  line("v₁ (16)", push.before.bodies[{1}].velocity, v);
  line("M⁻¹ (17)", push.inverse_mass[{1}], w);
  line("j", a, b);
  line("p_c (18)", a * push.impulse, b * push.impulse);
  line("v₂ (19)", push.after.bodies[{1}].velocity, velocity_after(push));
  lesson.print(fmt::format("  j M⁻¹ jᵀ = 1²·{:.4g} + {:g}²·{:.4g} = {:.6f} 1/kg: {:.6f} kg", w.y(), push.x,
                           w.z(), push.inverse, 1 / push.inverse));
  lesson.print(fmt::format("  (22)  λ = (0 − (−{:g})) / ({:.6f} × {:g}) = {:.3f} N", all.settings.speed,
                           push.inverse, all.settings.dt, push.impulse / all.settings.dt));
  lesson.print();
}

void print_places(Lesson& lesson, const Pushes& all) {
  lesson.print(
      "  x (m)   j M⁻¹ jᵀ (1/kg)  1 over it (kg)  λΔt (N s)      λ (N)   v_y after   ω after   energy (J)");
  for (const Push& push : all.at) {
    const Vec3<double>& v = velocity_after(push);
    lesson.print(fmt::format(
        "  {:<8.4g} {:>14.6f} {:>15.4f} {:>10.4f} {:>10.3f} {:>11} {:>9} {:>6.3f} → {:.3f}", push.x,
        push.inverse, 1 / push.inverse, push.impulse, push.impulse / all.settings.dt, fixed(v.y(), 4),
        fixed(v.z(), 4), kinetic_energy(push.before), kinetic_energy(push.after)));
  }
  lesson.print();
  lesson.print(fmt::format("This way: below the centre the box is {:.4f} kg upwards and {:.4f} kg sideways.",
                           1 / all.at[0].inverse, all.sideways));
  std::string pegs = "Against what, in the middle: peg (kg) ";
  std::string masses = "                    effective mass (kg)";
  for (const OtherMass& other : all.others) {
    pegs += fmt::format("{:>9}", other.mass > 0 ? fmt::format("{:g}", other.mass) : "fixed");
    masses += fmt::format("{:>9.4g}", other.effective);
  }
  lesson.print(pegs);
  lesson.print(masses);
  lesson.print(
      "Words: the paper uses \"effective mass\" for j M⁻¹ jᵀ and for A; most texts, and the code here,");
  lesson.print("use it for the inverse, which is a mass.");
  lesson.print();
}

void check_row(Lesson& lesson, const Pushes& all) {
  const PegSettings& settings = all.settings;
  double formula = 0, matrices = 0, contact = 0, impulse = 0, by_hand = 0;
  for (const Push& push : all.at) {
    const double inverse = 1 / settings.mass + push.x * push.x / inertia_of(settings.mass);
    formula = std::max(formula, std::abs(push.inverse / inverse - 1));
    matrices = std::max(matrices, std::abs(push.by_matrices / inverse - 1));
    by_hand = std::max({by_hand, std::abs(push.by_hand.impulse / push.impulse - 1),
                        (push.by_hand.v_b - velocity_after(push)).norm() / settings.speed});
    contact = std::max(contact, std::abs(push.rate_after));
    impulse = std::max(impulse, std::abs(push.impulse * inverse / settings.speed - 1));
  }
  // Sums of a few products: some four roundings each. The contact may be a rounding of 1 m away, which ζ asks
  // for within one step.
  const double gap = epsilon / settings.dt;
  lesson.check_small("j M⁻¹ jᵀ = 1/m + x²/I, relative", formula, 16 * epsilon);
  lesson.check_small("the same as A of (15) from the big matrices, relative", matrices, 16 * epsilon);
  lesson.check_small("λ Δt = the effective mass times the speed, eq (23), relative", impulse,
                     16 * epsilon + 2 * gap / settings.speed);
  lesson.check_small("the library's solver: the same push, the same v₂, relative", by_hand, 16 * epsilon);
  lesson.check_small("the contact stands still after one push, j·v₂ = 0, eq (20) (m/s)", contact,
                     16 * epsilon * settings.speed + 2 * gap);
}

namespace {

/// (16), (18), (21) and (22) of the two bodies, each by itself.
void check_pair(Lesson& lesson, const Pushes& all) {
  const PegSettings& settings = all.settings;
  const double rounding = 32 * epsilon * settings.speed + 2 * epsilon / settings.dt;
  double rate = 0, action = 0, impulse = 0, lambda = 0;
  for (const Push& push : all.at) {
    rate = std::max(rate, std::abs(push.rate_before + settings.speed));
    const Vec3<double> p_a = push.row.jacobian_a * push.impulse, p_b = push.row.jacobian_b * push.impulse;
    const double moments = p_a.z() + push.x * p_a.y() + p_b.z();  // about the middle of the underside
    action = std::max({action, (p_a + p_b).head<2>().norm(), std::abs(moments)});
    const double inverse = 1 / settings.mass + push.x * push.x / inertia_of(settings.mass);
    const double by_formula = settings.speed / inverse;
    impulse = std::max(impulse, (p_b - Vec3<double>(0, by_formula, push.x * by_formula)).norm());
    lambda = std::max(lambda, std::abs(push.by_hand.impulse / by_formula - 1));
  }
  lesson.check_small("(16) v of two bodies: j·v₁ = −speed (m/s)", rate, rounding);
  lesson.check_small("(18) p_c: what one body gets, the other gives, moments too (N s)", action,
                     8 * settings.mass * rounding);
  lesson.check_small("(21) p_c = jᵀ λ Δt: λ Δt upwards and x λ Δt around the centre (N s)", impulse,
                     8 * settings.mass * rounding);
  lesson.check_small("(22) λ = speed / ((1/m + x²/I) Δt), relative", lambda,
                     16 * epsilon + 2 * epsilon / settings.dt / settings.speed);
}

}  // namespace

void check_motion(Lesson& lesson, const Pushes& all) {
  const PegSettings& settings = all.settings;
  const double gap = epsilon / settings.dt;
  const double rounding = 32 * epsilon * settings.speed + 2 * gap;
  double momentum = 0, loss = 0;
  check_pair(lesson, all);
  for (const Push& push : all.at) {
    const Vec3<double> change = velocity_after(push) - push.before.bodies[{2}].velocity;
    momentum = std::max({momentum, std::abs(change.y() - push.impulse / settings.mass), std::abs(change.x()),
                         std::abs(change.z() - push.x * push.impulse / inertia_of(settings.mass))});
    // What the push takes is the kinetic energy of the effective mass.
    const double lost = kinetic_energy(push.before) - kinetic_energy(push.after);
    loss = std::max(loss, std::abs(lost - 0.5 / push.inverse * settings.speed * settings.speed));
  }
  lesson.check_small("v₂ − v₁ = M⁻¹ p_c: the push, and its moment x λΔt, eq (19)", momentum, 8 * rounding);
  lesson.check_small("energy lost = ½ · effective mass · speed² (J)", loss,
                     8 * settings.mass * settings.speed * rounding);
  const Push& right = all.at.back();
  lesson.check_small("the peg on the other side: the same push (N s)", right.impulse - all.mirrored.impulse,
                     settings.mass * rounding);
  lesson.check_small("and the box turns the other way (rad/s)",
                     velocity_after(right).z() + velocity_after(all.mirrored).z(), 8 * rounding);
}

void check_others(Lesson& lesson, const Pushes& all) {
  double worst = 0;
  for (const OtherMass& other : all.others) {
    const double inverse = 1 / all.settings.mass + (other.mass > 0 ? 1 / other.mass : 0);
    worst = std::max(worst, std::abs(other.effective * inverse - 1));
  }
  lesson.check_small("two bodies: 1/m of both, and 0 for what cannot move, relative", worst, 16 * epsilon);
  // r = (0, -1/2) and d = (1, 0): (r x d)^2 / I = 6 / (4 m).
  lesson.check_equal("sideways below the centre: 1 / (1/m + (1/2)²/I) (kg)", all.sideways,
                     all.settings.mass / 2.5, 16 * epsilon * all.settings.mass);
}

CsvTable places_table(const Pushes& all) {
  CsvTable table{.header = {"x_metre", "inverse_per_kilogram", "impulse_newton_second", "lambda_newton",
                            "v_y_metre_per_second", "omega_radian_per_second", "energy_joule"}};
  for (const Push& push : all.at) {
    const Vec3<double>& v = velocity_after(push);
    table.rows.push_back({push.x, push.inverse, push.impulse, push.impulse / all.settings.dt, v.y(), v.z(),
                          kinetic_energy(push.after)});
  }
  return table;
}

}  // namespace cairn::one_push
