// Checks of a page's layout that need no picture to compare with.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "render/page.hpp"

namespace cairn::render {

/// What is wrong with the page as drawn so far, one sentence each; empty if nothing is: text outside the
/// page, text upon text, text on a curve without a halo, text below the smallest size of the page, text with
/// less contrast against what is behind it than 4.5 : 1 (3 : 1 for bold of at least 18 px). Behind it is its
/// halo, if it has one; else the background or the panel, whichever is worse. So text upon anything else (a
/// body, a cell) has a halo in the colour it stands on.
List<std::string> lint(const Page& page);

/// WCAG 2 contrast ratio of two opaque colours, 1 to 21.
double contrast(Color first, Color second);

/// Black or white, whichever reads better upon an opaque `fill`: never less than 4.5 : 1.
Color ink_on(Color fill);

}  // namespace cairn::render
