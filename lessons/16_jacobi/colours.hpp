// The contacts of a pyramid in colours: those of one colour share no box, and may be solved at the same time.
#pragma once

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::everybody {

/// Two boxes that touch, or a box and the ground: one manifold.
struct ColouredContact {
  BodyId a = {};
  BodyId b = {};
  int colour = 0;  // from 0
};

struct Colouring {
  List<ColouredContact> contacts = {};  // in the order of the rows
  List<int> count = {};                 // contacts of each colour
  int most_on_a_box = 0;                // no fewer colours will ever do
};

/// Greedy: each contact takes the first colour that is free at both of its boxes.
Colouring colour_contacts(const VelocityProblem<double>& problem);

/// How many pairs of contacts of one colour share a box that can move: 0, if the colours are right.
int clashes(const VelocityProblem<double>& problem, const Colouring& colouring);

/// "6 + 4 + 4 + 2".
std::string counts_text(const Colouring& colouring);

}  // namespace cairn::everybody
