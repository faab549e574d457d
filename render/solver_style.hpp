// How each solver looks in every picture, and what is no solver.
#pragma once

#include <string_view>

#include <cairn/math/list.hpp>
#include "render/theme.hpp"

namespace cairn::render {

/// The look of a solver by its name, such as "si", "pgs-sparse" or "newton". Its colour is that of its
/// family: PGS, SI, Jacobi or Box2D; Newton's method and what else is exact is grey. Dash and marker tell the
/// members apart.
SeriesStyle style_of_solver(const Theme& theme, std::string_view solver);

/// Looks for series that are no solvers, such as settings of one, or measured quantities: grey, with markers
/// and dashes that tell them apart.
List<SeriesStyle> neutral_styles(const Theme& theme);

}  // namespace cairn::render
