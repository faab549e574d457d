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
  if (differ(row.j_a[0], -row.j_b[0]) || differ(row.j_a[1], -row.j_b[1]))
    return "Momentum is not kept: x and y of j_a and of j_b have to be opposite.";
  const bool arm_a = differ(row.j_a[2], is.r1x * row.j_a[1] - is.r1y * row.j_a[0]);
  const bool arm_b = differ(row.j_b[2], is.r2x * row.j_b[1] - is.r2y * row.j_b[0]);
  if (!arm_a && !arm_b) return "";
  const std::string body = arm_a && arm_b ? "the arms of both bodies"
                           : arm_a        ? "body a's arm"
                                          : "body b's arm";
  return "Momentum is kept, angular momentum is not: look at " + body + ".";
}

static const char *const rod_unturned_a = "The point of body a is not turned by the angle of body a.",
                         *const rod_unturned_b = "The point of body b is not turned by the angle of body b.";

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
        {first_flat.distance - length, rod_unturned_a},
        {second_flat.distance - length, rod_unturned_b},
        {rod_parts(one, a, two, a).distance - length, "Point b is turned by the angle of body a."},
        {rod_parts(one, b, two, b).distance - length, "Point a is turned by the angle of body b."},
        {0, "c of the row is not set."},
        {rod_parts(one, -a, two, -b).distance - length, "Turned the other way: (c x − s y, s x + c y)."},
        {rod_is.distance, "c is what is left when the length is taken away."}}},
      row.c);
}

static void grade_rod_ends(cairn::Grade& grade, const Row& row, const RodParts& rod_is) {
  const double ux = rod_is.ux;
  grade.number({"the rod: body_a",
                1,
                {{2, "The bodies are swapped."}, {0, "body_a and body_b of the row are not set."}}},
               row.body_a);
  grade.number({"the rod: body_b", 2, {{1, ""}, {0, "body_b of the row is not set."}}}, row.body_b);
  grade.number({"the rod: j_b[0]",
                ux,
                {{-ux, "The sign: c grows when body b moves along u, from point a to point b."},
                 {rod_is.dx, "u is a unit vector: divide by the distance."}}},
               row.j_b[0]);
  grade.number({"the rod: j_a[0]",
                -ux,
                {{ux, "The sign: c shrinks when body a moves along u. j_a has −u."},
                 {-rod_is.dx, "u is a unit vector: divide by the distance."}}},
               row.j_a[0]);
}

static void grade_rod_turns(cairn::Grade& grade, const Row& row, const Body& two, const RodParts& rod_is) {
  const double ux = rod_is.ux, uy = rod_is.uy;
  const double turn_a = rod_is.r1x * uy - rod_is.r1y * ux, turn_b = rod_is.r2x * uy - rod_is.r2y * ux;
  const double from_origin = turn_b + two.position[0] * uy - two.position[1] * ux;
  const bool backwards = std::abs(row.j_b[0] + ux) < 1e-9;  // u leads the other way
  grade.number({"the rod: j_b[2] (m)",
                turn_b,
                {{-turn_b, backwards ? "" : "r × u is r_x u_y − r_y u_x: the order is reversed."},
                 {turn_a, "j_b needs the arm of body b."},
                 {rod_is.r2x * ux + rod_is.r2y * uy, "That is r·u. A turn comes in by r × u."},
                 {-0.5 * uy + ux, rod_unturned_b},
                 {from_origin, "The arm r begins at the body's centre, not at the origin."},
                 {0, "A turn about the centre moves the point, too: r × u."}}},
               row.j_b[2]);
  grade.number({"the rod: j_a[2] (m)",
                -turn_a,
                {{turn_a, row.j_a[0] > 0 || row.j_b[2] * turn_b < 0
                              ? ""
                              : "The sign: all of j_a has a minus, its turn as well."},
                 {-turn_b, "j_a needs the arm of body a."},
                 {-(0.5 * uy - 0.25 * ux), rod_unturned_a},
                 {0, "A turn about the centre moves the point, too: r × u."}}},
               row.j_a[2]);
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
  double part_a = 0, part_b = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    part_a += row.j_a[k] * bodies[1].velocity[k];
    part_b += row.j_b[k] * bodies[2].velocity[k];
  }
  const double turns = row.j_a[2] * bodies[1].velocity[2] + row.j_b[2] * bodies[2].velocity[2];
  grade.number(
      {"j·v of your row, while both boxes move and turn (m/s)",
       part_a + part_b,
       {{part_b, "Body a is missing: a row has six numbers."},
        {part_a, "Body b is missing: a row has six numbers."},
        {part_a + part_b - row.j_a[2] * bodies[1].velocity[2],
         "The turn of body a is missing: the third number belongs to the turn."},
        {part_a + part_b - row.j_b[2] * bodies[2].velocity[2],
         "The turn of body b is missing: the third number belongs to the turn."},
        {part_a + part_b - 2 * row.j_a[2] * bodies[1].velocity[2], "The sign of body a's turn: add all six."},
        {part_a + part_b - 2 * row.j_b[2] * bodies[2].velocity[2], "The sign of body b's turn: add all six."},
        {part_b - part_a, "Add both parts: the minus is in j_a already."},
        {part_a + part_b - turns, "An index too few: the third number belongs to the turn."}}},
      rate(row, bodies));
  const Row other = rod(bodies, 2, {-0.5, -1}, 1, {0.5, 0.25}, 3);
  double fixed = 0;  // as if every row were between bodies 1 and 2
  for (std::size_t k = 0; k < 3; ++k)
    fixed += other.j_a[k] * bodies[1].velocity[k] + other.j_b[k] * bodies[2].velocity[k];
  grade.number(
      {"j·v of the rod from bodies[2] to bodies[1] (m/s)",
       part_a + part_b,
       {{fixed, row.body_a != 1 ? "" : "A row says which bodies it has: row.body_a and row.body_b."}}},
      rate(other, bodies));
  const RodParts rod_is = rod_parts(bodies[1], bodies[1].position[2], bodies[2], bodies[2].position[2]);
  if (!(std::abs(row.c - (rod_is.distance - 3)) < 1e-9)) return;  // the slope of another c says nothing of j
  const double h = 1e-5;
  move_bodies(bodies, h);
  const double later = rod(bodies, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3).c;
  move_bodies(bodies, -2 * h);
  const double earlier = rod(bodies, 1, {0.5, 0.25}, 2, {-0.5, -1}, 3).c;
  grade.number({"that j·v should be dc/dt from two poses (m/s)", (later - earlier) / (2 * h), {}, 1e-6},
               part_a + part_b);
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
