// Colours, given one after the other.
#include "lesson.hpp"

namespace cairn::everybody {

namespace {

/// The ground cannot be moved: contacts that share it do not disturb each other.
bool can_move(const VelocityProblem<double>& problem, BodyId body) {
  return !problem.inverse_mass[body].isZero(0);
}

}  // namespace

Colouring colour_contacts(const VelocityProblem<double>& problem) {
  Colouring colouring;
  PerBody<std::set<int>> taken(problem.body_count());  // colours
  for (const ConstraintRow<double>& row : problem.rows) {
    const bool is_known = !colouring.contacts.empty() && colouring.contacts.back().a == row.a &&
                          colouring.contacts.back().b == row.b;
    if (is_known) continue;  // another row of the same contact
    // [colour]
    std::set<int>& taken_at_a = taken[row.a];
    std::set<int>& taken_at_b = taken[row.b];
    int colour = 0;
    while (taken_at_a.contains(colour) || taken_at_b.contains(colour)) ++colour;
    if (can_move(problem, row.a)) taken_at_a.insert(colour);
    if (can_move(problem, row.b)) taken_at_b.insert(colour);
    colouring.contacts.push_back({row.a, row.b, colour});
    // [/colour]
    if (colour == colouring.count.size()) colouring.count.push_back(0);
    ++colouring.count[colour];
  }
  for (const std::set<int>& colours : taken)
    colouring.most_on_a_box = std::max(colouring.most_on_a_box, static_cast<int>(colours.size()));
  return colouring;
}

int clashes(const VelocityProblem<double>& problem, const Colouring& colouring) {
  int number = 0;
  const List<ColouredContact>& contacts = colouring.contacts;
  for (int i = 0; i < contacts.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const ColouredContact &one = contacts[i], &other = contacts[k];
      const bool a_shared = can_move(problem, one.a) && (one.a == other.a || one.a == other.b);
      const bool b_shared = can_move(problem, one.b) && (one.b == other.a || one.b == other.b);
      number += one.colour == other.colour && (a_shared || b_shared);
    }
  }
  return number;
}

std::string counts_text(const Colouring& colouring) {
  return fmt::format("{}", fmt::join(colouring.count, " + "));
}

}  // namespace cairn::everybody
