// A lesson as one film: what is below its frames, and how long each stays.
#include "lessons/kit/captioned_film.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A film of shots with these alt texts.
Ran film_of(const ScratchFolder& folder, const List<std::string>& alts, List<std::string> flags) {
  flags.insert(flags.end(), {"--format", "apng", "--frames", "all", "-o", folder.path() + "/out"});
  return run_in_child(
      [&alts](Lesson& run) {
        List<Shot> shots;
        for (const std::string& alt : alts) {
          shots.push_back(word_shot("one"));
          shots.back().alt = alt;
        }
        run.film(shots);
      },
      flags);
}

/// How long each frame of an animated PNG stays [s]: fcTL has the fraction behind six numbers of four bytes.
List<double> delays_in(const std::string& film) {
  const auto number_at = [&film](std::size_t at) {
    return 256 * static_cast<unsigned char>(film[at]) + static_cast<unsigned char>(film[at + 1]);
  };
  List<double> delays;
  for (std::size_t at = film.find("fcTL"); at != std::string::npos; at = film.find("fcTL", at + 1))
    delays.push_back(double{1} * number_at(at + 24) / number_at(at + 26));
  return delays;
}

/// The rows of a picture, from one on, that have a pixel as dark as text.
List<int> dark_rows(const render::Image& image, int from) {
  List<int> rows;
  for (int y = from; y < image.height; ++y) {
    bool is_dark = false;
    for (int x = 0; x < image.width; ++x) is_dark |= image.pixels[3 * (y * image.width + x)] < 80;
    if (is_dark) rows.push_back(y);
  }
  return rows;
}

}  // namespace

TEST_CASE("a caption stays for a second, and a quarter for each word that the one before has not") {
  CHECK(reading_time("", "") == 1);
  CHECK(reading_time("one two three four", "") == doctest::Approx(2));
  CHECK(reading_time("one two three five", "one two three four") == doctest::Approx(1.3));  // 1.25 in tenths
  CHECK(reading_time("the same again", "the same again") == 1);
}

TEST_CASE("a film has its captions below its frames, and each frame stays until they are read") {
  const ScratchFolder folder;
  const List<std::string> alts = {"A ball falls down.", "A ball falls down and HHHHH."};
  REQUIRE(film_of(folder, alts, {"--size", "small"}).code == 0);
  const std::string film = folder.text("out/l42.png");
  const List<double> delays = delays_in(film);
  REQUIRE(delays.size() == 2);
  CHECK(delays[0] == doctest::Approx(reading_time(alts[0], "")));
  CHECK(delays[1] == doctest::Approx(reading_time(alts[1], alts[0])));
  const auto index = nlohmann::json::parse(folder.text("out/frames.json"));
  CHECK(index["frames"][1]["seconds"].get<double>() == doctest::Approx(delays[1]));
  const render::Image first = render::read_png(folder.path() + "/out/l42.png");
  CHECK(first.width == 960);
  CHECK(first.height > 540 + 20);
  // A capital of type of 11 px is eight pixels high.
  CHECK(dark_rows(first, 540).size() >= 8);
}

TEST_CASE("the strip of captions is as high as the longest needs, and a rate is kept as it was asked for") {
  const ScratchFolder one, many;
  std::string text;
  for (int i = 0; i < 60; ++i) text += "seven words that fill a line soon ";
  REQUIRE(film_of(one, {"short"}, {"--fps", "4"}).code == 0);
  REQUIRE(film_of(many, {"short", text}, {"--fps", "4"}).code == 0);
  for (const double delay : delays_in(many.text("out/l42.png"))) CHECK(delay == 0.25);
  const int low = render::read_png(one.path() + "/out/l42.png").height;
  const int high = render::read_png(many.path() + "/out/l42.png").height;
  CHECK(low < 720 + 70);
  CHECK(high > low + 10 * 20);
}
