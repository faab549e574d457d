// Stage 04, graded: what a landing box's feet give in total, and the contacts of boxes.
#include "03.cpp"

/// A box of 2 kg with feet 0.25 m to the left and right of its centre comes down at 3 m/s.
struct Landing {
  std::vector<Body> bodies = {make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 2, 0, 0.5)};
  std::vector<Row> rows = {contact(bodies, 0, 1, {-0.25, 0}, {0, 1}, 0),
                           contact(bodies, 0, 1, {0.25, 0}, {0, 1}, 0)};
  Landing() { bodies[1].velocity[1] = -3; }
};

static void grade_landing(cairn::Grade& grade) {
  const double half = 2 * 3 / 2.0,
               q = (1 / 2.0 - 0.0625 * 3) / (1 / 2.0 + 0.0625 * 3);  // A₁₂/A₁₁, with 1/I = 3
  Landing landing;
  for (int k = 0; k < 3; ++k) sweep(landing.rows, landing.bodies);
  const bool is_naive = std::abs(landing.rows[0].impulse - half * (1 + q)) < 1e-9;
  grade.number({"landing on two feet, three sweeps: impulse of the first (N s)",
                half * (1 + std::pow(q, 5)),
                {{half * (1 + q), "A later push may be negative: clamp the sum, not the push."}}},
               landing.rows[0].impulse);
  grade.number(
      {"of the second (N s)",
       half * (1 - std::pow(q, 6)),
       {{half * (1 - q * q), is_naive ? "A later push may be negative: clamp the sum, not the push." : ""}}},
      landing.rows[1].impulse);
}

static void grade_taking_back(cairn::Grade& grade) {
  std::vector<Body> bodies = falling_tower({2}, 1);
  std::vector<Row> rows = {upright_row(0, 1)};
  sweep(rows, bodies);
  bodies[1].velocity[1] += 0.25;
  sweep(rows, bodies);
  grade.number({"2 kg stopped from 1 m/s, then pulled up by 0.25 m/s: impulse (N s)",
                1.5,
                {{2, "A push may be negative: clamp the sum, not the push."}}},
               rows[0].impulse);
  bodies[1].velocity[1] += 4;
  sweep(rows, bodies);
  grade.number({"and by 4 m/s more: impulse (N s)",
                0,
                {{1.5 - 8, "A contact cannot pull: the sum stays above its lower bound."},
                 {2, "A push may be negative: clamp the sum, not the push."}}},
               rows[0].impulse);
  grade.number({"its velocity then (m/s)",
                4 - 1.5 / 2,
                {{0, "Apply the new sum less the old one, not the whole correction."},
                 {4.25, "Apply the new sum less the old one: here it is negative."}}},
               bodies[1].velocity[1]);
}

/// The rows between two bodies, and one of them: the leftmost (k = 0) or rightmost (1) point of the upper
/// body.
static std::vector<Row> rows_between(const std::vector<Row>& rows, int body_a, int body_b) {
  std::vector<Row> found;
  for (const Row& row : rows)
    if (row.body_a == body_a && row.body_b == body_b) found.push_back(row);
  return found;
}

static double count_of(const std::vector<Row>& rows) { return static_cast<double>(rows.size()); }

/// Where a small box touches a large one, and how deep: it is turned by −0.002.
static void grade_places(cairn::Grade& grade, const std::vector<Row>& upper, const std::vector<Row>& lower) {
  grade.number({"large box on the ground, left point: j_b[2] (m)",
                -0.5,
                {{0.5, "Left before right."}, {-5.125, "The points are where both boxes are."}}},
               lower[0].j_b[2]);
  grade.number(
      {"small box on the large one, left point: j_b[2] (m)", -0.375, {{0.125, "Left before right."}}},
      upper[0].j_b[2]);
  grade.number({"right point: j_b[2] (m)",
                0.125,
                {{0.375, "The large box ends there: the points lie within both widths."}}},
               upper[1].j_b[2]);
  const double left = -0.001 - 0.002 * -0.375, right = -0.001 - 0.002 * 0.125;
  grade.number({"gap at the left point (m)",
                left,
                {{-left, "The sign: overlap is a gap below 0."},
                 {-0.001, "The box is turned: its face is not as high at both ends."},
                 {-0.001 + 0.002 * -0.375, "The sign of the slope: a face rises by angle · x."}}},
               upper[0].c);
  grade.number({"gap at the right point (m)",
                right,
                {{-0.001, "The box is turned: its face is not as high at both ends."}}},
               upper[1].c);
}

/// Whether four contacts are found.
static bool grade_points(cairn::Grade& grade) {
  // The small box hangs over the right end of the large one, comes first in the list, and is slightly turned.
  std::vector<Body> bodies = {make_box(0.75, 0.5, 3, 0.5, 1.249), make_box(1, 1, 2, 0.125, 0.5),
                              make_box(10, 1, 0, 0, -0.5)};
  bodies[0].position[2] = -0.002;
  const std::vector<Row> rows = contacts(bodies), upper = rows_between(rows, 1, 0),
                         lower = rows_between(rows, 2, 1);
  const char* const lower_first = "body a is the lower one of the two, wherever it stands in the list.";
  grade.number({"a small box on a large one on the ground: contacts",
                4,
                {{2, "Two boxes touch at two points: both ends of the width that they share."},
                 {3, "What overlaps touches, however deep: look at the gap, not at its size."},
                 {6, upper.empty() ? lower_first
                                   : "Boxes with another box between them do not touch: look at the gap."}}},
               count_of(rows));
  grade.number({"with the large box as body a, and the small one as body b", 2, {{0, lower_first}}},
               count_of(upper));
  const bool finds = rows.size() == 4;
  if (upper.size() == 2 && lower.size() == 2) grade_places(grade, upper, lower);
  return finds;
}

/// A box of 4 m on a box that is turned: the slope of the lower face, and points that are ends of the lower
/// box.
static void grade_turned_below(cairn::Grade& grade, bool finds) {
  std::vector<Body> bodies = {make_box(1, 1, 0, 0.25, 0.5), make_box(4, 1, 2, 0.5, 1.5)};
  bodies[0].position[2] = -0.004;
  const std::vector<Row> rows = contacts(bodies);
  grade.number({"a box of 4 m on one of 1 m, which is turned by −0.004 rad: contacts",
                1,
                {{2, finds ? "The lower face has a slope as well: each point has a gap of its own." : ""},
                 {0, finds ? "Each point for itself: one may touch where the other is open." : ""}}},
               count_of(rows));
  if (rows.size() != 1) return;
  grade.number({"its point: j_b[2] (m)",
                -0.75,
                {{0.25, "The sign of the slope: a face rises by angle · x."},
                 {-2, "The points lie within both widths."}}},
               rows[0].j_b[2]);
  grade.number({"its gap (m)", -0.002, {{0, "The lower face has a slope as well."}}}, rows[0].c);
}

/// Boxes in any order: not only neighbours in the list touch, and the heavy one need not be the lower.
static void grade_any_order(cairn::Grade& grade, bool finds) {
  const std::vector<Row> rows =
      contacts({make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 2, -2, 0.5), make_box(1, 1, 2, 2, 0.5)});
  grade.number({"two boxes beside each other on the ground: contacts",
                4,
                {{2, finds ? "All pairs of the list count, not only neighbours in it." : ""},
                 {6, "Boxes side by side do not carry each other."}}},
               count_of(rows));
  const std::vector<Row> deep = contacts({make_box(10, 1, 0, 0, -0.5), make_box(1, 1, 2, 0, 0.4)});
  grade.number({"a box 0.1 m deep in the ground: contacts",
                2,
                {{0, finds ? "What overlaps touches, however deep." : ""}}},
               count_of(deep));
}

static void grade_no_contact(cairn::Grade& grade) {
  const Body ground = make_box(10, 1, 0, 0, -0.5);
  grade.number({"2 mm above the ground: contacts", 0, {{2, "A gap of more than 1 mm is no contact."}}},
               count_of(contacts({ground, make_box(1, 1, 2, 0, 0.502)})));
  grade.number({"0.5 mm above the ground: contacts", 2, {{0, "A gap of less than 1 mm is a contact."}}},
               count_of(contacts({ground, make_box(1, 1, 2, 0, 0.5005)})));
  grade.number({"boxes that do not share any width: contacts",
                0,
                {{2, "Boxes side by side do not carry each other."}}},
               count_of(contacts({make_box(1, 1, 2, 0, 0.5), make_box(1, 1, 2, 3, 1.499)})));
  grade.number({"two bodies that cannot move: contacts", 0, {{2, "Neither can move: leave the pair out."}}},
               count_of(contacts({ground, make_box(4, 1, 0, 0, 0.5)})));
}

static void grade_04(cairn::Grade& grade) {
  grade_landing(grade);
  grade_taking_back(grade);
  const bool finds = grade_points(grade);
  grade_turned_below(grade, finds);
  grade_any_order(grade, finds);
  grade_no_contact(grade);
}

/// With those before it.
static void stage_04(cairn::Grade& grade) {
  stage_03(grade);
  grade.begin(4);
  grade_04(grade);
}
