// Claims: what a lesson says is true, and whether it was.
#pragma once

#include <string>
#include <string_view>

#include "lessons/kit/card.hpp"

#include <cairn/math/list.hpp>

namespace cairn {

struct Claim {
  std::string text = {};
  std::string shown = {};  // the value in short form
  bool holds = false;
  std::string demand = {};  // "at most 1e-12": said when it fails
  double value = 0;         // for files; of a claim without a number 1 or 0
};

Claim small_claim(std::string_view text, double value, double limit);
Claim equal_claim(std::string_view text, double value, double expected, double tolerance);
Claim plain_claim(std::string_view text, bool holds, std::string_view shown);

/// "CHECK  text ........ value  " with the value in its column, where `width` leaves room for that; the
/// verdict is written behind it.
std::string claim_line(const Claim& claim, int width);

/// Four significant digits for people: "0.7500", "1.1e-17", "1234".
std::string short_number(double value);

/// "42.00, −1.000"
std::string numbers_text(const List<double>& numbers);

/// A reader's guess beside the numbers that were asked for. What is printed alike is right, however small the
/// tolerance: nobody is told that 17.14 is wrong, and 17.14 right. A wrong guess among the known ones is told
/// why.
struct Judgement {
  bool is_right = false;
  std::string words = {};  // "RIGHT    ", or what was said and "it is ": the right numbers follow
};
Judgement judged(const List<double>& guess, const List<double>& right, double tolerance,
                 const List<WrongGuess>& known = {});

/// How many hold.
int holding(const List<Claim>& claims);

}  // namespace cairn
