// Formulas as they are typed, and the MathML that says the same.
#include "lessons/driver/book_math.hpp"

#include <doctest/doctest.h>

#include <string>

using cairn::driver::formula_block;
using cairn::driver::math_of;
using cairn::driver::SymbolPages;

namespace {

/// Without the elements that hold a formula, and without the thin blanks between two factors.
std::string inside_of(const std::string& formula, const SymbolPages& symbols = {}) {
  std::string html = math_of(formula, symbols).value_or("no formula");
  for (const std::string piece :
       {"<math displaystyle=\"true\">", "</math>", "<mspace width=\"0.2em\"></mspace>"}) {
    for (std::size_t at = 0; (at = html.find(piece)) != std::string::npos;) html.erase(at, piece.size());
  }
  return html;
}

std::string mi(const std::string& name) { return "<mi>" + name + "</mi>"; }
std::string mo(const std::string& sign) { return "<mo>" + sign + "</mo>"; }
std::string mn(const std::string& digits) { return "<mn>" + digits + "</mn>"; }
std::string row(const std::string& parts) { return "<mrow>" + parts + "</mrow>"; }
std::string over(const std::string& top, const std::string& below) {
  return "<mfrac>" + row(top) + row(below) + "</mfrac>";
}

}  // namespace

TEST_CASE("letters, numbers and signs each have their element") {
  CHECK(inside_of("a + 2.5") == mi("a") + mo("+") + mn("2.5"));
  CHECK(inside_of("λ ≥ 0") == mi("λ") + mo("≥") + mn("0"));
  CHECK(inside_of("Δt") == mi("Δt"));
  CHECK(inside_of("a < b") == mi("a") + mo("&lt;") + mi("b"));
}

TEST_CASE("a stroke between blanks divides the whole product, one without blanks what it touches") {
  CHECK(inside_of("a b / c") == over(mi("a") + mi("b"), mi("c")));
  CHECK(inside_of("a b/c") == mi("a") + over(mi("b"), mi("c")));
  CHECK(inside_of("a + b / c") == mi("a") + mo("+") + over(mi("b"), mi("c")));
  CHECK(inside_of("(a + b) / (c d)") == over(mi("a") + mo("+") + mi("b"), mi("c") + mi("d")));
  CHECK(inside_of("1 / −c") == over(mn("1"), mo("−") + mi("c")));
}

TEST_CASE("raised and lowered characters are scripts of what stands before them") {
  CHECK(inside_of("v²") == "<msup>" + row(mi("v")) + row(mn("2")) + "</msup>");
  CHECK(inside_of("λ₁") == "<msub>" + row(mi("λ")) + row(mn("1")) + "</msub>");
  CHECK(inside_of("v₁²") == "<msubsup>" + row(mi("v")) + row(mn("1")) + row(mn("2")) + "</msubsup>");
  CHECK(inside_of("M⁻¹") == "<msup>" + row(mi("M")) + row(mo("−") + mn("1")) + "</msup>");
  CHECK(inside_of("x_old") == "<msub>" + row(mi("x")) + row(mi("old")) + "</msub>");
  CHECK(inside_of("q^{k + 1}") == "<msup>" + row(mi("q")) + row(mi("k") + mo("+") + mn("1")) + "</msup>");
}

TEST_CASE("roots, sums, matrices and units are read as such") {
  CHECK(inside_of("√(a)") == "<msqrt>" + mi("a") + "</msqrt>");
  CHECK(inside_of("Σ_i a") == "<munder>" + mo("Σ") + row(mi("i")) + "</munder>" + mi("a"));
  const auto cells = [](const std::string& a, const std::string& b) {
    return "<mtr><mtd>" + mn(a) + "</mtd><mtd>" + mn(b) + "</mtd></mtr>";
  };
  CHECK(inside_of("[1 0; 0 2]") ==
        row(mo("[") + "<mtable>" + cells("1", "0") + cells("0", "2") + "</mtable>" + mo("]")));
  CHECK(inside_of("10 N") == mn("10") + "<mi mathvariant=\"normal\">N</mi>");
  CHECK(inside_of("N + 1") == mi("N") + mo("+") + mn("1"));
}

TEST_CASE("a symbol that is explained somewhere is a link to there") {
  const SymbolPages symbols = {{"ζ", "notation.html#symbol-4"}};
  CHECK(inside_of("ζ", symbols) == "<mi><a href=\"notation.html#symbol-4\" tabindex=\"-1\">ζ</a></mi>");
  CHECK(inside_of("β", symbols) == mi("β"));
}

TEST_CASE("what is no formula is not made one") {
  for (const char* text : {"the bias", "a (b", "a) b", "/ b", "a_", "a → § b", "[1 2", "Δ 3", "is"}) {
    CAPTURE(text);
    CHECK_FALSE(math_of(text).has_value());
  }
}

TEST_CASE("a block of formulas has a row a line and a cell wherever two blanks part them") {
  const auto html = formula_block("(22)  λ = a   the bias\n      b\n");
  REQUIRE(html.has_value());
  CHECK(html->find("<span class=\"tag\">(22)</span><span><math") != std::string::npos);
  CHECK(html->find("<span>the bias</span>") != std::string::npos);
  CHECK(html->find("<div><span></span><span><math") !=
        std::string::npos);  // under the formula, not the number
}

TEST_CASE("lines that their blanks lay out, numbered lines and words alone stay as they are") {
  CHECK_FALSE(formula_block("1  2  3\n4  5  6\n").has_value());
  CHECK_FALSE(formula_block("a = b\n    c\n").has_value());  // under no cell
  CHECK_FALSE(formula_block("only the words\n").has_value());
}
