// Wrong guesses that the cards of lessons know: each is wrong, and is told why.
#include <doctest/doctest.h>

#include <string>

#include <fmt/format.h>

#include "child_lesson.hpp"
#include "lessons/kit/card.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {
namespace {

/// In the middle of what the card calls this mistake, as --answer takes it.
std::string middle_of(const WrongGuess& wrong) {
  std::string text;
  for (int i = 0; i < wrong.least.size(); ++i)
    text += fmt::format("{}{}", i > 0 ? "," : "", (wrong.least[i] + wrong.most[i]) / 2);
  return text;
}

/// Without its line ends and what follows them.
std::string unwrapped(const std::string& text) {
  std::string all;
  for (const char c : text) {
    const char next = c == '\n' ? ' ' : c;
    if (next != ' ' || all.empty() || all.back() != ' ') all += next;
  }
  return all;
}

}  // namespace

TEST_CASE("a wrong guess that a lesson knows is wrong, and the lesson says why") {
  int known = 0;
  for (const LessonInfo& info : cards()) {
    for (const WrongGuess& wrong : info.wrong) {
      REQUIRE(wrong.least.size() == wrong.most.size());
      const std::string guess = middle_of(wrong);
      CAPTURE(info.number);
      CAPTURE(guess);
      const Ran ran = run_program(fmt::format("lesson{:02}_{}", info.number, info.name),
                                  {"--frames", "none", "--answer=" + guess});
      if (ran.code == 77) continue;  // built without Box2D
      CHECK(ran.code == 1);
      CHECK(unwrapped(ran.out).find(wrong.why) != std::string::npos);
      ++known;
    }
  }
  CHECK(known >= 30);
}

}  // namespace cairn::testing
