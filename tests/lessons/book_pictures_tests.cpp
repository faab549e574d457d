// The pictures of the lesson book: all frames of a lesson, small.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "book_pages.hpp"
#include "child_lesson.hpp"
#include "html.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

constexpr int most_off = 24;  // of 255, of a colour that has no place among 256

render::Image book_picture(const fs::path& folder, int frame, const char* kind = "light") {
  char name[64] = {};
  std::snprintf(name, sizeof(name), "lesson03_%04d_%s.png", frame, kind);
  return render::read_png(folder / "frames" / name);
}

/// Those beside the text are there as the lesson draws them large, and for dense screens only.
void check_sharp_frames(const fs::path& book, const std::string& page) {
  const ScratchFolder out;
  REQUIRE(run_program("lesson03_sequential_impulses", {"--size", "large", "-o", out.path()}).code == 0);
  const auto film = nlohmann::json::parse(out.text("frames.json"));
  int sharp = 0;
  for (const auto& frame : film["frames"]) {
    const int number = frame["frame"];
    if (page.find("<figcaption><a href=\"#frame-" + std::to_string(number) + "\"") == std::string::npos)
      continue;
    CAPTURE(number);
    const render::Image drawn = render::read_png(out.path() + "/" + frame["file"].get<std::string>());
    const render::Image shown = book_picture(book, number, "sharp_light");
    REQUIRE(shown.pixels.size() == drawn.pixels.size());
    int off = 0;
    for (int i = 0; i < drawn.pixels.size(); ++i)
      off = std::max(off, std::abs(drawn.pixels[i] - shown.pixels[i]));
    CHECK(off <= most_off);
    ++sharp;
  }
  CHECK(sharp >= 2);
  CHECK(all_matches(page, std::regex("(_sharp_light\\.png 1920w\" sizes=)")).size() == sharp);
}

}  // namespace

TEST_CASE(
    "without flags every frame is in the book, some as what differs from another, and no page is heavy") {
  const ScratchFolder scratch, out;
  const std::string driver = driver_apart(scratch, "tree", {"lesson03_sequential_impulses"});
  const Ran ran = run_program(driver, {"book", scratch.path() + "/book"});
  if (ran.code == 3) {
    MESSAGE("there is no book to look at: " << ran.err);
    return;
  }
  REQUIRE(ran.code == 0);
  REQUIRE(run_program("lesson03_sequential_impulses", {"--frames", "all", "-o", out.path()}).code == 0);
  const std::string page = scratch.text("book/lesson03.html");
  const auto film = nlohmann::json::parse(out.text("frames.json"));
  const std::regex below("lesson03_([0-9]{4})_light.png\" width=\"1280\" height=\"720\" alt=\"\"");
  std::uintmax_t bytes = page.size();
  int differences = 0;
  for (const auto& frame : film["frames"]) {
    const int number = frame["frame"];
    CAPTURE(number);
    const std::size_t item = page.find("<li id=\"frame-" + std::to_string(number) + "\"");
    REQUIRE(item != std::string::npos);
    const std::string markup = page.substr(item, page.find("</li>", item) - item);
    const render::Image drawn = render::read_png(out.path() + "/" + frame["file"].get<std::string>());
    const render::Image upper = book_picture(scratch.path() + "/book", number);
    std::smatch found;
    const bool differs = std::regex_search(markup, found, below);
    const render::Image lower =
        differs ? book_picture(scratch.path() + "/book", std::stoi(found[1].str())) : upper;
    differences += differs ? 1 : 0;
    int off = 0;  // of each pixel from one of the two pictures
    for (int i = 0; i < drawn.pixels.size(); ++i)
      off = std::max(off, std::min(std::abs(drawn.pixels[i] - upper.pixels[i]),
                                   std::abs(drawn.pixels[i] - lower.pixels[i])));
    CHECK(off <= most_off);
    char name[64] = {};
    std::snprintf(name, sizeof(name), "book/frames/lesson03_%04d_light.png", number);
    bytes += fs::file_size(scratch.path() + "/" + name);
  }
  CHECK(differences > 10);
  CHECK(bytes < 1'500'000);
  check_sharp_frames(scratch.path() + "/book", page);
}

TEST_CASE("each frame that a lesson's text asks for stands there, and so does what the reader has in hand") {
  const WholeBook& book = whole_book();  // of key frames, which no page leaves out
  if (book_is_missing(book.ran)) return;
  int frames = 0, hands = 0;
  for (const auto& entry : fs::directory_iterator(CAIRN_SOURCE_DIR "/lessons")) {
    const auto page = book.pages.find("lesson" + entry.path().filename().string().substr(0, 2) + ".html");
    if (page == book.pages.end() || page->second.find("<li id=\"frame-") == std::string::npos) continue;
    CAPTURE(page->first);
    const std::string readme = bytes_of(entry.path() / "README.md");
    const auto wanted = all_matches(readme, std::regex("<!-- frame: ([0-9]+) -->"));
    CHECK(all_matches(page->second, std::regex("<figcaption><a href=\"#frame-([0-9]+)\"")) == wanted);
    frames += wanted.size();
    if (readme.find("<!-- in your hand -->") == std::string::npos) continue;
    ++hands;
    CHECK(page->second.find(">In your hand") < page->second.find("<h2 id=\"what-to-look-at\""));
  }
  CHECK(frames >= 3 * 20);
  CHECK(hands >= 8);
}

TEST_CASE("handouts are one small file of all lessons, and one of each, which is tagged") {
  const ScratchFolder scratch;
  const std::string driver = driver_apart(scratch, "tree", {"lesson03_sequential_impulses"});
  const Ran ran = run_program(driver, {"handouts", scratch.path() + "/out/all.pdf"});
  if (ran.code == 3) {
    MESSAGE("nothing can be printed here: " << ran.err);
    return;
  }
  CAPTURE(ran.err);
  REQUIRE(ran.code == 0);
  CHECK(scratch.names("out") == List<std::string>{"all.pdf", "all_03.pdf"});
  const std::string all = scratch.text("out/all.pdf"), one = scratch.text("out/all_03.pdf");
  CHECK(one.find("/StructTreeRoot") != std::string::npos);
  CHECK(all.find("/StructTreeRoot") == std::string::npos);
  CHECK(all.size() < 10'000'000 / 20);  // there are some twenty lessons
}

}  // namespace cairn::testing
