// Tells letters that stand for quantities from words, names and units.
#pragma once

#include <string_view>

namespace cairn::render {

/// Whether a letter, Latin or small Greek, is a variable and so slanted, from the markup before and behind it:
/// small letters that stand alone are, except units, the article and names of bodies; capitals where a formula
/// is around them, as in "A λ = b". Δ and Σ are signs of operations.
bool is_variable(std::string_view before, char32_t sign, std::string_view behind);

}  // namespace cairn::render
