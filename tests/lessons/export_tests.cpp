// Pictures for documents: their names, their alt texts, their forms.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "exported.hpp"
#include "render/image.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

bool tells(const Ran& ran, const std::string& part) { return ran.err.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("exported pictures keep the number of their frame, and have their alt text beside them") {
  const ScratchFolder folder;
  CHECK(export_six(folder, {"--frames", "2:3", "--scale", "0.75"}).code == 0);
  CHECK(folder.names("out") ==
        Names{"03_sequential_impulses_0002.txt", "03_sequential_impulses_0002_dark.png",
              "03_sequential_impulses_0002_light.png", "03_sequential_impulses_0003.txt",
              "03_sequential_impulses_0003_dark.png", "03_sequential_impulses_0003_light.png"});
  CHECK(folder.text("out/03_sequential_impulses_0002.txt") == alt_of(2) + "\n");
  const render::Image image = render::read_png(folder.path() + "/out/03_sequential_impulses_0002_dark.png");
  CHECK(image.width == 960);
  CHECK(image.height == 540);
}

TEST_CASE("a panel alone is exported as PNG and as SVG, with a background or none") {
  const ScratchFolder folder;
  for (const char* format : {"png", "svg"}) {
    CHECK(export_six(folder, {"--frames", "2", "--theme", "light", "--panel", "EQ (22)", "--format", format,
                              "--transparent"})
              .code == 0);
  }
  const render::Image image = render::read_png(folder.path() + "/out/03_sequential_impulses_0002_light.png");
  CHECK(image.width < 1280);
  CHECK(image.height < 720);
  const std::string png = folder.text("out/03_sequential_impulses_0002_light.png");
  CHECK(png[25] == 6);  // the colour type of PNG with an alpha channel (ISO/IEC 15948, 11.2.2)
  const std::string svg = folder.text("out/03_sequential_impulses_0002_light.svg");
  CHECK(svg.starts_with("<svg "));
  CHECK(svg.find("<title>" + alt_of(2) + "</title>") != std::string::npos);
}

TEST_CASE("the labels of a picture are text in SVG where that is asked for, and outlines else") {
  const ScratchFolder folder;
  const Names flags = {"--frames", "2", "--theme", "light", "--format", "svg"};
  CHECK(export_six(folder, flags).code == 0);
  const std::string outlines = folder.text("out/03_sequential_impulses_0002_light.svg");
  CHECK(outlines.find("<text") == std::string::npos);
  Names with_text = flags;
  with_text.push_back("--text");
  CHECK(export_six(folder, with_text).code == 0);
  const std::string text = folder.text("out/03_sequential_impulses_0002_light.svg");
  CHECK(text.find("<use") == std::string::npos);
  const ScratchFolder other;
  run_program("lesson03_sequential_impulses", {"--frames", "2", "-o", other.path()});
  const auto index = nlohmann::json::parse(other.text("frames.json"));
  // Parts of a label that are slanted or lowered are elements within it.
  const std::string words = std::regex_replace(text, std::regex("<[^>]*>"), "");
  int labels = 0;
  for (const auto& word : index["frames"][0]["words"]) {
    const std::string label = word;
    if (label.find_first_of("_^&<>{") != std::string::npos) continue;  // marked up there, or escaped
    CAPTURE(label);
    CHECK(words.find("\n" + label + "\n") != std::string::npos);
    ++labels;
  }
  CHECK(labels > 5);
}

TEST_CASE("what cannot be exported is refused, and leaves nothing behind") {
  const ScratchFolder folder;
  const struct {
    Names flags;
    std::string message;
  } cases[] = {
      {{"--scale", "9"}, "--scale must be a number from 0.75 to 3, got 9"},
      {{"--theme", "blue"}, "--theme must be light or dark or both, got blue"},
      {{"--format", "jpg"}, "--format must be png or svg or apng or gif or webp or mp4, got jpg"},
      {{"--format"}, "--format needs a value"},
      {{"--fps", "0"}, "--fps must be a number from 0.1 to 30, got 0"},
      {{"--bodiez", "4"}, "did you mean --bodies?"},
      {{"--frames", "999"}, "there is no frame 999"},
      {{"--frames", "2", "--panel", "nobody's"}, "--panel must be in the title of a panel of these frames"},
      {{"--format", "apng", "--transparent"}, "--transparent must come with --format png or svg"},
      {{"--text"}, "--text must come with --format svg"}};
  for (const auto& [flags, message] : cases) {
    const std::string shown = message;
    CAPTURE(shown);
    const Ran ran = export_six(folder, flags);
    CHECK(ran.code == 2);
    CHECK(tells(ran, message));
    CHECK(folder.names("out").empty());
  }
  CHECK(run_program("lessons", {"export"}).code == 2);
  CHECK(tells(run_program("lessons", {"export", "99"}), "there is no lesson 99"));
}

TEST_CASE("a value of a lesson's flag is its own, also where it is part of the name of another flag") {
  const ScratchFolder folder;
  for (const char* title : {"out", "theme", "scale", "format", "o", "-"}) {
    CAPTURE(title);
    const Ran ran = export_six(folder, {"--frames", "2", "--panel", title});
    CAPTURE(ran.err);
    CHECK_FALSE(tells(ran, "needs a value"));
    CHECK((ran.code == 0 || tells(ran, "--panel must be in the title of a panel of these frames")));
  }
}

TEST_CASE("folders of the reader's own beside the pictures are left alone, whatever their names are") {
  const ScratchFolder folder;
  const std::string mine = "out/unfinished_03_sequential_impulses_light";
  std::filesystem::create_directories(folder.path() + "/" + mine);
  folder.write(mine + "/mine.txt", "mine");
  CHECK(export_six(folder, {"--frames", "2", "--theme", "light"}).code == 0);
  CHECK(folder.names("out") == Names{"03_sequential_impulses_0002.txt",
                                     "03_sequential_impulses_0002_light.png",
                                     "unfinished_03_sequential_impulses_light"});
  CHECK(folder.text(mine + "/mine.txt") == "mine");
}
