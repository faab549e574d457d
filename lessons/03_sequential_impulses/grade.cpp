// Exercise 03, graded: three boxes that fall onto each other, and a contact that takes back what it gave.
#include "exercise.cpp"

namespace cairn::exercise03 {
namespace {

constexpr double push_rounding = 64 * 2.2204e-16;  // a dozen operations on numbers near 1

/// After k sweeps over the contacts, from the ground up.
struct Swept {
  List<Box> boxes = {};
  List<Contact> contacts = {};
};

Swept swept(List<Box> boxes, int sweeps) {
  Swept result{.boxes = std::move(boxes)};
  const int count = result.boxes.size();
  for (int i = 1; i < count; ++i) result.contacts.push_back({.below = i - 1, .above = i});
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Contact& contact : result.contacts) update(contact, result.boxes);
  }
  return result;
}

/// Ground, and boxes of 2, 0.5 and 2 kg with the speed of one step of falling: g dt = 0.2 m/s.
List<Box> tower() { return {{0, 0}, {0.5, -0.2}, {2, -0.2}, {0.5, -0.2}}; }

// The numbers below are Gauss-Seidel on A = [0.5 -0.5 0; -0.5 2.5 -2; 0 -2 2.5], b = (0.2, 0, 0), by hand.
void grade_impulses(Grade& grade, const Swept& one) {
  const bool stands = one.boxes[1].velocity == -0.2, ground_moves = one.boxes[0].velocity != 0;
  const double ground = one.contacts[0].impulse, between = one.contacts[1].impulse;
  const char* const inverse =
      "The ground has 1/m = 0 and no mass: add inverse masses, and do not invert them first.";
  grade.number({.what = "1 sweep: impulse of the ground (N s)",
                .value = 0.4,
                .misconceptions =
                    {{-0.4, "The sign: boxes that approach have to be pushed apart."},
                     {0, stands ? "Nothing was given: boxes that approach have to be pushed apart. The sign?"
                                : "Nothing was added to the contact's impulse."},
                     {std::nan(""), inverse},
                     {0.1, "A heavy box needs more impulse, not less: divide by j M⁻¹ jᵀ."},
                     {0.2, "(22): a speed is no impulse; divide it by j M⁻¹ jᵀ."}},
                .tolerance = push_rounding},
               ground);
  ExpectedNumber second{
      .what = "1 sweep: impulse between boxes 1 and 2 (N s)", .value = 0.08, .tolerance = push_rounding};
  if (std::abs(ground - 0.4) <= push_rounding) {
    second.misconceptions = {
        {0, ground_moves ? "The ground has moved: each body has its own inverse mass."
                         : "The velocities have not changed: apply the impulse immediately, to both bodies."},
        {0.1, "Two bodies give way here: the effective mass has both in it."},
        {0.4, "Two bodies give way here: the effective mass has both in it."},
        {0.5, "Add the inverse masses of both, not the masses: the lighter one gives way more."}};
  }
  grade.number(second, between);
}

void grade_tower(Grade& grade) {
  const Swept one = swept(tower(), 1), two = swept(tower(), 2), ground = swept({{0, 0}, {0.5, -0.2}}, 1);
  const bool first_is_right = std::abs(one.contacts[0].impulse - 0.4) <= push_rounding;
  const bool is_right_alone = std::abs(ground.boxes[1].velocity) <= push_rounding;
  grade_impulses(grade, one);
  grade.number(
      {.what = "1 sweep, one box: velocity of the box (m/s)",
       .value = 0,
       .misconceptions = {{0.2, "(23): an impulse is no change of velocity; multiply it by 1/m."},
                          {0.6, "(23): inverse_mass is 1/m already; multiply by it."},
                          {-0.1, first_is_right ? "Each body gets the whole impulse, not half of it." : ""}},
       .tolerance = push_rounding},
      ground.boxes[1].velocity);
  grade.number({.what = "1 sweep, one box: velocity of the ground (m/s)",
                .value = 0,
                .misconceptions = {{-0.2, "The ground has moved: each body has its own inverse mass."}},
                .tolerance = push_rounding},
               ground.boxes[0].velocity);
  grade.number(
      {.what = "1 sweep: velocity of box 1 (m/s)",
       .value = -0.04,
       .misconceptions = {{0, "Action and reaction: contact 2 pushes box 1 down."},
                          {0.04, is_right_alone ? "Action and reaction: contact 2 pushes box 1 down, not up."
                                                : ""}},
       .tolerance = push_rounding},
      one.boxes[1].velocity);
  grade.number({.what = "2 sweeps: impulse of the ground (N s)",
                .value = 0.48,
                .misconceptions = {{0.08, "The second correction has replaced the first: add it."}},
                .tolerance = push_rounding},
               two.contacts[0].impulse);
}

/// A box of 0.5 kg comes down on one of 2 kg at 1 m/s, and is pulled up afterwards: the contact first gives
/// 0.4 N s, and then has to take back some of it, and at last the rest.
void grade_taking_back(Grade& grade) {
  List<Box> boxes = {{0.5, 0}, {2, -1}};
  Contact contact{.below = 0, .above = 1};
  update(contact, boxes);
  const bool moved = std::abs(boxes[0].velocity + 0.2) <= push_rounding &&
                     std::abs(boxes[1].velocity + 0.2) <= push_rounding;
  const char* const both_move =
      moved ? "j·v is the velocity of the box above less that of the box below." : "";
  boxes[1].velocity += 0.6;
  update(contact, boxes);
  grade.number(
      {.what = "pulled up by 0.6 m/s afterwards: impulse (N s)",
       .value = 0.16,
       .misconceptions = {{0.4, "A correction may be negative: only the sum may not. Clamp the sum."},
                          {0.24, both_move},
                          {0.32, both_move}},
       .tolerance = push_rounding},
      contact.impulse);
  boxes[1].velocity += 2;
  update(contact, boxes);
  grade.number({.what = "pulled up by 2 m/s more: impulse (N s)",
                .value = 0,
                .misconceptions = {{-0.64, "A contact cannot pull: its impulse is never below 0."}},
                .tolerance = push_rounding},
               contact.impulse);
  grade.number(
      {.what = "and what the box below keeps of it (m/s)",
       .value = 0,
       .misconceptions = {{0.32, contact.impulse < 0
                                     ? ""
                                     : "Apply what the clamp has left of the correction, not all of it."},
                          {-0.28, "Apply the change of the sum, not the sum: it was given before in part."}},
       .tolerance = push_rounding},
      boxes[0].velocity);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 3,
      .task = "One row update of Algorithm 1: the correction, the sum and its clamp, and both velocities.",
      .file = "lessons/03_sequential_impulses/exercise.cpp",
      .hints =
          {"What is j·v of this contact, and how much impulse makes it 0?",
           "j = (-1, 1), so j M⁻¹ jᵀ = 1/m_below + 1/m_above. Add the correction to what was given so far.",
           "Which of the two must not be negative, what it gives now or what it has given? The boxes feel "
           "the other."},
      .grade = [](Grade& grade) {
        grade_tower(grade);
        grade_taking_back(grade);
      }};
}

}  // namespace cairn::exercise03
