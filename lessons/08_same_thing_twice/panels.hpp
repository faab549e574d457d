// What the pictures of lesson 08 are made of.
#pragma once

#include <string>

#include "math/list.hpp"
#include "render/page.hpp"
#include "twice.hpp"

namespace cairn::twice {

/// Lambda of both solvers at one moment [N].
struct Moment {
  PerRow<double> pgs = {};
  PerRow<double> si = {};
  int active = -1;
  PerRow<double> unclamped = {};  // what each row asked for; empty: not known
};

/// From the least to the largest lambda [N] of all moments, clamped or not.
struct Range {
  double low = 0;
  double high = 0;
};

Range range_of(const TwiceRun& run);

/// Two bars for every row, side by side: they never part.
void draw_pairs(render::Page& page, const render::Rect& rect, const Moment& moment, const Range& range);

/// A as colours, with one row framed.
void draw_system(render::Page& page, const render::Rect& rect, const TwiceRun& run, int active);

/// Two bodies, and the two ends of a push between them.
void draw_two_bodies(render::Page& page, const render::Rect& rect);

/// A number with its name, in a column of numbers.
struct Digits {
  std::string name = {};
  std::string digits = {};
};

/// Numbers below each other: grey as far as all agree, lit from the first digit on that differs.
void draw_digits(render::Page& page, const render::Rect& rect, const std::string& title,
                 const List<Digits>& lines, const std::string& below);

}  // namespace cairn::twice
