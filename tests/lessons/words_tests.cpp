// Numbers as people type them, near misses, and Greek spelt out.
#include <doctest/doctest.h>

#include <string>

#include "lessons/kit/words.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;

TEST_CASE("a fraction is the quotient of its numbers, to the last bit") {
  REQUIRE(parse_number("1/60"));
  CHECK(*parse_number("1/60") == 1.0 / 60);
  CHECK(*parse_number("-3/4") == -0.75);
  CHECK(*parse_number("−3/4") == -0.75);
  CHECK(*parse_number("+2.5e-3") == 2.5e-3);
  CHECK(*parse_number("1e2/1e3") == 1e2 / 1e3);
}

TEST_CASE("what is no finite number is refused") {
  for (const char* text :
       {"",      "abc",   "nan",  "NaN", "inf", "-inf", "infinity", "1/0", "0/0", "1/",  "/2", "1/2/3",
        "1e999", "0.02s", "0,02", " 1",  "1 ",  "0x10", "--1",      "+-1", "+",   "−-1", "−"}) {
    CHECK_MESSAGE(!parse_number(text), std::string(text));
  }
}

TEST_CASE("a list of numbers holds one number between every two commas") {
  REQUIRE(parse_numbers("1, -2,1/4"));
  CHECK(*parse_numbers("1, -2,1/4") == List<double>{1, -2, 0.25});
  CHECK_FALSE(parse_numbers("1,,2"));
  CHECK_FALSE(parse_numbers("1,"));
  CHECK_FALSE(parse_numbers(""));
}

TEST_CASE("plain text spells Greek letters, raised and lowered signs out in ASCII") {
  CHECK(transliterated("λ₂ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)") == "lambda_2 = (zeta - j.v) / (j M^-1 j^T dt)");
  CHECK(transliterated("λΔt") == "lambda dt");
  CHECK(transliterated("Mᵀλ") == "M^T lambda");
  CHECK(transliterated("v̄ + 2μ ≤ 10⁻¹³ …") == "v_bar + 2mu <= 10^-13 ...");
  CHECK(transliterated("ratio 1e−3") == "ratio 1e-3");
  CHECK(transliterated("λ_corr, λcorr") == "lambda_corr, lambda corr");
}

TEST_CASE("plain text is ASCII whatever goes in, broken UTF-8 included") {
  const std::string text = transliterated("日本 \xff\xc3 ☃ é \xe2\x82");
  for (const char c : text) CHECK(static_cast<unsigned char>(c) < 0x80);
  CHECK(transliterated("日") == "?");
}

TEST_CASE("a minus sign stands before a number, a hyphen everywhere else") {
  CHECK(with_minus_signs("-1 (-0.5) [-2,-3] x=-4") == "−1 (−0.5) [−2,−3] x=−4");
  const std::string hyphens = "1e-9, lines 2-6, g-1, --sweeps - -v";
  CHECK(with_minus_signs(hyphens) == hyphens);
  CHECK(display_width(with_minus_signs("  -0.2000")) == 9);
}

TEST_CASE("the width of text counts letters, not bytes") {
  CHECK(display_width("λ₂ = 5") == 6);
  CHECK(display_width("v̄") == 1);
  CHECK(padded("λ", 3) == "λ  ");
  CHECK(padded("long", 3) == "long");
}

TEST_CASE("text is broken at blanks, and lines after the first are indented") {
  CHECK(wrapped("Idea: a bb ccc dddd", 10, 6) == "Idea: a bb\n      ccc\n      dddd");
  CHECK(wrapped("short", 10, 2) == "short");
  CHECK(wrapped("λλλ λλλ", 7, 0) == "λλλ λλλ");  // seven letters, thirteen bytes
  CHECK(wrapped("unbreakable", 4, 2) == "unbreakable");
}

TEST_CASE("a word that a shell would take apart is quoted") {
  CHECK(shell_quoted("out/lesson03") == "out/lesson03");
  CHECK(shell_quoted("my folder") == "'my folder'");
  CHECK(shell_quoted("it's") == "'it'\\''s'");
  CHECK(shell_quoted("") == "''");
}
