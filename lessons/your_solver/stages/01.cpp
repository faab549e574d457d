// Stage 01, graded: c and j of a rod between two boxes that are turned, and j·v.
#include "00.cpp"

/// 2 kg and 0.5 kg, both turned and moving; the ground is body 0.
static std::vector<Body> turned_boxes() {
  std::vector<Body> bodies = {make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 2, 1, 2),
                              make_box(1, 2, 0.5, 4, 6)};
  bodies[1].position[2] = 0.3;
  bodies[2].position[2] = -0.7;
  bodies[1].velocity = {1, -0.5, 2};
  bodies[2].velocity = {-0.25, 3, -1.5};
  return bodies;
}

/// The parts of a rod, worked out here: arms r, direction u.
struct RodParts {
  double r1x = 0, r1y = 0, r2x = 0, r2y = 0, dx = 0, dy = 0, distance = 0, ux = 0, uy = 0;
};

/// The rod of turned_boxes() with its points turned by these angles.
static RodParts rod_parts(const Body& one, double a, const Body& two, double b) {
  const double x1 = 0.5, y1 = 0.25, x2 = -0.5, y2 = -1;
  RodParts parts;
  parts.r1x = std::cos(a) * x1 - std::sin(a) * y1;
  parts.r1y = std::sin(a) * x1 + std::cos(a) * y1;
  parts.r2x = std::cos(b) * x2 - std::sin(b) * y2;
  parts.r2y = std::sin(b) * x2 + std::cos(b) * y2;
  parts.dx = two.position[0] + parts.r2x - one.position[0] - parts.r1x;
  parts.dy = two.position[1] + parts.r2y - one.position[1] - parts.r1y;
  parts.distance = std::sqrt(parts.dx * parts.dx + parts.dy * parts.dy);
  parts.ux = parts.dx / parts.distance;
  parts.uy = parts.dy / parts.distance;
  return parts;
}

/// What is wrong with j of a rod, as forces: a force along it on each body, and a torque by its arm.
static std::string physics_of(const Row& row, const RodParts& is) {
  const auto differ = [](double got, double right) { return !(std::abs(got - right) <= 1e-9); };
  if (differ(row.j1[0], -row.j2[0]) || differ(row.j1[1], -row.j2[1]))
    return "Momentum is not kept: x and y of j1 and of j2 have to be opposite.";
  const bool arm1 = differ(row.j1[2], is.r1x * row.j1[1] - is.r1y * row.j1[0]);
  const bool arm2 = differ(row.j2[2], is.r2x * row.j2[1] - is.r2y * row.j2[0]);
  if (!arm1 && !arm2) return "";
  const std::string body = arm1 && arm2 ? "the arms of both bodies" : arm1 ? "body 1's arm" : "body 2's arm";
  return "Momentum is kept, angular momentum is not: look at " + body + ".";
}

static const char *const rod_unturned1 = "The point of body 1 is not turned by the angle of body 1.",
                         *const rod_unturned2 = "The point of body 2 is not turned by the angle of body 2.";

static void grade_rod_error(cairn::Grade& grade, const Row& row, const Body& one, const Body& two,
                            double length) {
  const double a = one.position[2], b = two.position[2];
  const RodParts rod_is = rod_parts(one, a, two, b), first_flat = rod_parts(one, 0, two, b),
                 second_flat = rod_parts(one, a, two, 0), flat = rod_parts(one, 0, two, 0);
  grade.number(
      {"a rod between two turned boxes: c (m)",
       rod_is.distance - length,
       {{std::hypot(two.position[0] - one.position[0], two.position[1] - one.position[1]) - length,
         "The rod is between points of the bodies, not between their centres."},
        {length - rod_is.distance, "The sign: c is positive where the rod is too long."},
        {rod_is.distance * rod_is.distance - length * length,
         "Those are m²: c is |p2 − p1| − length, without squares."},
        {flat.distance - length, "The points are fixed in their bodies: turn them by the body's angle."},
        {first_flat.distance - length, rod_unturned1},
        {second_flat.distance - length, rod_unturned2},
        {rod_parts(one, a, two, a).distance - length, "Point 2 is turned by the angle of body 1."},
        {rod_parts(one, b, two, b).distance - length, "Point 1 is turned by the angle of body 2."},
        {0, "c of the row is not set."},
        {rod_parts(one, -a, two, -b).distance - length, "Turned the other way: (c x − s y, s x + c y)."},
        {rod_is.distance, "c is what is left when the length is taken away."}}},
      row.c);
}

static void grade_rod_ends(cairn::Grade& grade, const Row& row, const RodParts& rod_is) {
  const double ux = rod_is.ux;
  grade.number(
      {"the rod: body1", 1, {{2, "The bodies are swapped."}, {0, "body1 and body2 of the row are not set."}}},
      row.body1);
  grade.number({"the rod: body2", 2, {{1, ""}, {0, "body2 of the row is not set."}}}, row.body2);
  grade.number({"the rod: j2[0]",
                ux,
                {{-ux, "The sign: c grows when body 2 moves along u, from point 1 to point 2."},
                 {rod_is.dx, "u is a unit vector: divide by the distance."}}},
               row.j2[0]);
  grade.number({"the rod: j1[0]",
                -ux,
                {{ux, "The sign: c shrinks when body 1 moves along u. j1 has −u."},
                 {-rod_is.dx, "u is a unit vector: divide by the distance."}}},
               row.j1[0]);
}

static void grade_rod_turns(cairn::Grade& grade, const Row& row, const Body& two, const RodParts& rod_is) {
  const double ux = rod_is.ux, uy = rod_is.uy;
  const double turn1 = rod_is.r1x * uy - rod_is.r1y * ux, turn2 = rod_is.r2x * uy - rod_is.r2y * ux;
  const double from_origin = turn2 + two.position[0] * uy - two.position[1] * ux;
  const bool backwards = std::abs(row.j2[0] + ux) < 1e-9;  // u leads the other way
  grade.number({"the rod: j2[2] (m)",
                turn2,
                {{-turn2, backwards ? "" : "r × u is r_x u_y − r_y u_x: the order is reversed."},
                 {turn1, "j2 needs the arm of body 2."},
                 {rod_is.r2x * ux + rod_is.r2y * uy, "That is r·u. A turn comes in by r × u."},
                 {-0.5 * uy + ux, rod_unturned2},
                 {from_origin, "The arm r begins at the body's centre, not at the origin."},
                 {0, "A turn about the centre moves the point, too: r × u."}}},
               row.j2[2]);
  grade.number(
      {"the rod: j1[2] (m)",
       -turn1,
       {{turn1,
         row.j1[0] > 0 || row.j2[2] * turn2 < 0 ? "" : "The sign: all of j1 has a minus, its turn as well."},
        {-turn2, "j1 needs the arm of body 1."},
        {-(0.5 * uy - 0.25 * ux), rod_unturned1},
        {0, "A turn about the centre moves the point, too: r × u."}}},
      row.j1[2]);
}

static void grade_rod(cairn::Grade& grade) {
  const std::vector<Body> bodies = turned_boxes();
  const Body &one = bodies[1], &two = bodies[2];
  const RodParts rod_is = rod_parts(one, one.position[2], two, two.position[2]);
  const Row row = rod(bodies, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3);
  grade_rod_error(grade, row, one, two, 3);
  grade_rod_ends(grade, row, rod_is);
  grade_rod_turns(grade, row, two, rod_is);
  grade.explain(physics_of(row, rod_is));
}

static void grade_rate(cairn::Grade& grade) {
  std::vector<Body> bodies = turned_boxes();
  const Row row = rod(bodies, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3);
  double part1 = 0, part2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    part1 += row.j1[k] * bodies[1].velocity[k];
    part2 += row.j2[k] * bodies[2].velocity[k];
  }
  const double turns = row.j1[2] * bodies[1].velocity[2] + row.j2[2] * bodies[2].velocity[2];
  grade.number(
      {"j·v of your row, while both boxes move and turn (m/s)",
       part1 + part2,
       {{part2, "Body 1 is missing: a row has six numbers."},
        {part1, "Body 2 is missing: a row has six numbers."},
        {part1 + part2 - row.j1[2] * bodies[1].velocity[2],
         "The turn of body 1 is missing: the third number belongs to the turn."},
        {part1 + part2 - row.j2[2] * bodies[2].velocity[2],
         "The turn of body 2 is missing: the third number belongs to the turn."},
        {part1 + part2 - 2 * row.j1[2] * bodies[1].velocity[2], "The sign of body 1's turn: add all six."},
        {part1 + part2 - 2 * row.j2[2] * bodies[2].velocity[2], "The sign of body 2's turn: add all six."},
        {part2 - part1, "Add both parts: the minus is in j1 already."},
        {part1 + part2 - turns, "An index too few: the third number belongs to the turn."}}},
      rate(row, bodies));
  const Row other = rod(bodies, 2, {-0.5, -1}, 1, {0.5, 0.25}, 3);
  double fixed = 0;  // as if every row were between bodies 1 and 2
  for (std::size_t k = 0; k < 3; ++k)
    fixed += other.j1[k] * bodies[1].velocity[k] + other.j2[k] * bodies[2].velocity[k];
  grade.number({"j·v of the rod from body 2 to body 1 (m/s)",
                part1 + part2,
                {{fixed, row.body1 != 1 ? "" : "A row says which bodies it has: row.body1 and row.body2."}}},
               rate(other, bodies));
  const RodParts rod_is = rod_parts(bodies[1], bodies[1].position[2], bodies[2], bodies[2].position[2]);
  if (!(std::abs(row.c - (rod_is.distance - 3)) < 1e-9)) return;  // the slope of another c says nothing of j
  const double h = 1e-5;
  move_bodies(bodies, h);
  const double later = rod(bodies, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3).c;
  move_bodies(bodies, -2 * h);
  const double earlier = rod(bodies, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3).c;
  grade.number({"that j·v should be dc/dt from two poses (m/s)", (later - earlier) / (2 * h), {}, 1e-6},
               part1 + part2);
}

static void grade_01(cairn::Grade& grade) {
  grade_rod(grade);
  grade_rate(grade);
}

/// With those before it.
static void stage_01(cairn::Grade& grade) {
  stage_00(grade);
  grade.begin(1);
  grade_01(grade);
}
