// Stage 00, graded: what a box is, and one step of falling.

static void grade_box(cairn::Grade& grade) {
  const double mass = 2, width = 2, height = 1;
  const Body box = make_box(width, height, mass, -4, 1);
  const double turning = 12 / (mass * (width * width + height * height));  // 1/I
  grade.number({"make_box(2, 1, 2, -4, 1): x (m)", -4, {{0, "position holds the centre, and is still 0."}}},
               box.position[0]);
  grade.number({"the height of that box (m)",
                height,
                {{width, "Width and height are swapped."}, {0, "width and height of the Body are still 0."}}},
               box.height);
  grade.number({"its width (m)", width, {{0, "width and height of the Body are still 0."}}}, box.width);
  grade.number({"that box: inverse_mass[0] (1/kg)",
                1 / mass,
                {{mass, "That is m. M⁻¹ has 1/m."}, {0, "That is a box that cannot move."}}},
               box.inverse_mass[0]);
  grade.number({"that box: inverse_mass[2] (1/(kg m²))",
                turning,
                {{1 / turning, "That is I. M⁻¹ has 1/I."},
                 {mass * turning, "I grows with the mass: I = m (w² + h²)/12."},
                 {turning / 2, "The divisor is 12: I is m (w² + h²)/12."},
                 {turning / 12, "The 12 is missing: I = m (w² + h²)/12."},
                 {turning / 4, "That is the 3 of half widths: with whole ones I = m (w² + h²)/12."},
                 {1 / mass, "The third number is 1/I, not 1/m."}}},
               box.inverse_mass[2]);
  const double infinite = 1.0 / 0.0;
  grade.number({"a box of mass 0: inverse_mass[1] (1/kg)",
                0,
                {{infinite, "A box of mass 0 cannot move: its inverse masses are 0, not 1/0."}}},
               make_box(10, 1, 0, 0, -0.5).inverse_mass[1]);
  grade.number({"the same: inverse_mass[2] (1/(kg m²))",
                0,
                {{infinite, "A box of mass 0 cannot turn either: its inverse masses are 0, not 1/0."}}},
               make_box(10, 1, 0, 0, -0.5).inverse_mass[2]);
}

/// Gravity on boxes and on the ground: the bodies after it.
static std::vector<Body> grade_gravity(cairn::Grade& grade, double g, double dt) {
  std::vector<Body> bodies = {make_box(1, 1, 0.5, 0, 3), make_box(10, 1, 0, 0, -0.5),
                              make_box(1, 1, 2, 0, 5)};
  bodies[0].velocity = {4, 3, -2};
  add_gravity(bodies, g, dt);
  const bool is_set = bodies[2].velocity[1] != 0;
  grade.number({"add_gravity: 0.5 kg that rose at 3 m/s, after 0.05 s (m/s)",
                3 - g * dt,
                {{3 + g * dt, "The sign: gravity acts downwards."},
                 {-g * dt, "Gravity changes a velocity: take it off, do not set it."},
                 {3, is_set ? "The first body was left out." : "Change the bodies of the list, not copies."},
                 {3 - g, "The factor dt is missing: gravity acts for one step only."},
                 {3 - 0.5 * g * dt, "The mass cancels: all boxes fall equally fast."},
                 {3 - 2 * g * dt, "The mass cancels: all boxes fall equally fast."}}},
               bodies[0].velocity[1]);
  grade.number({"add_gravity: 2 kg that was at rest (m/s)",
                -g * dt,
                {{-2 * g * dt, "The mass cancels: all boxes fall equally fast."},
                 {0, bodies[0].velocity[1] == 3 ? "" : "The last body was left out."}}},
               bodies[2].velocity[1]);
  grade.number(
      {"add_gravity: the ground (m/s)", 0, {{-g * dt, "The ground falls. What has inverse mass 0 stays."}}},
      bodies[1].velocity[1]);
  grade.number({"its velocity to the right (m/s)", 4, {{4 - g * dt, "Gravity acts downwards alone."}}},
               bodies[0].velocity[0]);
  grade.number({"its angular velocity (rad/s)", -2, {{-2 - g * dt, "Gravity does not turn a body."}}},
               bodies[0].velocity[2]);
  return bodies;
}

static void grade_falling(cairn::Grade& grade) {
  const double g = 10, dt = 0.05;
  std::vector<Body> bodies = grade_gravity(grade, g, dt);
  bodies[0].velocity[0] = 4, bodies[0].velocity[2] = -2;
  move_bodies(bodies, dt);
  const double y = 3 + (3 - g * dt) * dt, turn = -2 * dt;
  grade.number({"move_bodies: its x (m)",
                4 * dt,
                {{0, "A body has three numbers: x moves, too."},
                 {4, "move_bodies forgets the factor dt."},
                 {-4 * dt, "The sign: x ← x + v Δt."}}},
               bodies[0].position[0]);
  grade.number({"move_bodies: its height (m)",
                y,
                {{3 + (3 - g * dt), "move_bodies forgets the factor dt."},
                 {3 - (3 - g * dt) * dt, "The sign: x ← x + v Δt."},
                 {(3 - g * dt) * dt, "Add to the position: do not replace it."},
                 {3, "The body has not moved."}}},
               bodies[0].position[1]);
  grade.number(
      {"move_bodies: its angle (rad)",
       turn,
       {{0, "A body has three numbers: the angle moves, too."}, {-2, "move_bodies forgets the factor dt."}}},
      bodies[0].position[2]);
}

static void grade_00(cairn::Grade& grade) {
  grade_box(grade);
  grade_falling(grade);
}

static void stage_00(cairn::Grade& grade) {
  grade.begin(0);
  grade_00(grade);
}
