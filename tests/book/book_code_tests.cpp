// The colours of code, and the words that become links.
#include "lessons/driver/book_code.hpp"

#include <doctest/doctest.h>

#include <string>

#include "lessons/driver/book_text.hpp"

using namespace cairn;
using namespace cairn::driver;

TEST_CASE("C++ is taken apart into keywords, comments, texts and numbers") {
  CHECK(coloured("int x", "cpp") == "<span class=\"k\">int</span> x");
  CHECK(coloured("integer int_x", "cpp") == "integer int_x");
  CHECK(coloured("x; // if <0>\ny", "cpp") == "x; <span class=\"c\">// if &lt;0&gt;</span>\ny");
  CHECK(coloured("\"a \\\" // b\" c", "cpp") == "<span class=\"s\">&quot;a \\&quot; // b&quot;</span> c");
  CHECK(coloured("'\\'' c", "cpp") == "<span class=\"s\">'\\''</span> c");
  CHECK(coloured("1e-9*x2", "cpp") == "<span class=\"n\">1e-9</span>*x2");
  CHECK(coloured("10'000-1", "cpp") == "<span class=\"n\">10'000</span>-<span class=\"n\">1</span>");
  CHECK(coloured("#include <map>", "cpp") == "<span class=\"k\">#include</span> &lt;map&gt;");
  CHECK(coloured("\"not closed\nint", "cpp") ==
        "<span class=\"s\">&quot;not closed\n</span><span class=\"k\">int</span>");
}

TEST_CASE("of a command the first word, flags and comments have a colour, of other languages nothing") {
  CHECK(coloured("bash run 6 --size 2 # large\nls", "bash") ==
        "<span class=\"k\">bash</span> run 6<span class=\"n\"> --size</span> 2 <span class=\"c\"># "
        "large</span>\n"
        "<span class=\"k\">ls</span>");
  CHECK(coloured("int <x>", "toml") == "int &lt;x&gt;");
}

TEST_CASE("the first use of a term is a link, in text and nowhere else") {
  const List<Term> terms = {
      {.name = "row", .anchor = "row", .meaning = "a \"constraint\""},
      {.name = "λ", .anchor = "symbol-7", .meaning = "a force", .page = "notation.html"}};
  const std::string to_row = "<a class=\"term\" href=\"glossary.html#row\" title=\"a &quot;constraint&quot;\">";
  const std::string to_lambda = "<a class=\"term\" href=\"notation.html#symbol-7\" title=\"a force\">λ</a>";
  CHECK(with_terms("<p>Rows and rows</p>", terms) == "<p>" + to_row + "Rows</a> and rows</p>");
  CHECK(with_terms("<p>arrow, rowing, row-wise</p>", terms) ==
        "<p>arrow, rowing, " + to_row + "row</a>-wise</p>");
  CHECK(with_terms("<h2>Row</h2><code>row</code><p>a row</p>", terms) ==
        "<h2>Row</h2><code>row</code><p>a " + to_row + "row</a></p>");
  CHECK(with_terms("<p>Δλ, −λ, then λ₁ and λ</p>", terms) == "<p>Δλ, −λ, then " + to_lambda + "₁ and λ</p>");
}

TEST_CASE("indented blocks are formulas, but for those of a list and of a fence") {
  CHECK(with_formulas_fenced("a\n\n    x = y\n\nb\n") == "a\n\n```formula\nx = y\n```\n\nb\n");
  CHECK(with_formulas_fenced("- a\n\n    b\n") == "- a\n\n    b\n");
  CHECK(with_formulas_fenced("```\n\n    b\n```\n") == "```\n\n    b\n```\n");
  CHECK(with_formulas_fenced("a\n    b\n") == "a\n    b\n");  // goes on with the paragraph
}
