// Formulas that the pages write as plain text, as MathML.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace cairn::driver {

/// Where a symbol is explained: "ζ" -> "notation.html#symbol-7".
using SymbolPages = std::map<std::string, std::string>;

/// `<math>` of a formula such as "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)"; nothing where it is no formula: a word of
/// English, a bracket that is not closed.
std::optional<std::string> math_of(std::string_view formula, const SymbolPages& symbols = {});

/// A block of lines as rows of cells, formulas as MathML and the words beside them as text; nothing for
/// what is laid out by its blanks, as a matrix or an algorithm is.
std::optional<std::string> formula_block(const std::string& block, const SymbolPages& symbols = {});

}  // namespace cairn::driver
