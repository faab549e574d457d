// Names that were nearly right.
#include <cairn/math/nearest.hpp>

#include <doctest/doctest.h>

#include <stdexcept>

using namespace cairn;

TEST_CASE("the edit distance counts letters put in, left out and replaced") {
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("", "dt") == 2);
  CHECK(edit_distance("sweeps", "sweps") == 1);
  CHECK(edit_distance("theme", "theme") == 0);
}

TEST_CASE("a word two letters off finds its word, a word three letters off does not") {
  CHECK(nearest("boddies", {"dt", "bodies", "sweeps"}) == "bodies");
  CHECK(nearest("swep", {"dt", "bodies", "sweeps"}) == "sweeps");
  CHECK(nearest("swp", {"bodies", "sweeps"}) == "");
  CHECK(nearest("x", {"dt"}) == "");  // every letter of it would be wrong
}

TEST_CASE("a word is known by its letters: blanks, hyphens and underscores are the same") {
  const List<std::string> known = {"soft", "split-impulse", "every step"};
  for (const char* word : {"split-impulse", "split impulse", "split_impulse"})
    CHECK(known_word(word, known) == "split-impulse");
  CHECK(known_word("every-step", known) == "every step");
  CHECK(known_word("soft", known) == "soft");
  for (const char* word : {"", "splitimpulse", "split--impulse", "sof", "softer", "Soft"})
    CHECK(known_word(word, known) == "");
}

TEST_CASE("an unknown word is refused with the nearest one known, or with all of them") {
  require_known("bodies", {"dt", "bodies"}, "Place", "field");
  CHECK_THROWS_WITH_AS(require_known("boddies", {"dt", "bodies"}, "Place", "field"),
                       "Place: field must be a known name (bodies?), got boddies", std::invalid_argument);
  CHECK_THROWS_WITH_AS(require_known("sweeps", {"dt", "bodies"}, "Place", "field"),
                       "Place: field must be one of dt, bodies, got sweeps", std::invalid_argument);
  CHECK_THROWS_WITH_AS(require_known("dt", {}, "Place", "field"), "Place: field must be one of none, got dt",
                       std::invalid_argument);
}
