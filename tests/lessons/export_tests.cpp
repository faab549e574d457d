// Pictures for documents: their names, their alt texts, their forms.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

using Names = List<std::string>;

/// `lessons export 3` into a folder.
Ran export_six(const ScratchFolder& folder, Names flags) {
  Names words = {"export", "3", "--out", folder.path() + "/out"};
  words.insert(words.end(), flags.begin(), flags.end());
  return run_program("lessons", words);
}

/// What lesson 3 itself says of one of its frames.
std::string alt_of(int frame) {
  const ScratchFolder folder;
  run_program("lesson03_sequential_impulses", {"--frames", std::to_string(frame), "-o", folder.path()});
  return nlohmann::json::parse(folder.text("frames.json"))["frames"][0]["alt"];
}

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

TEST_CASE("a film is one file, and its text names every frame") {
  const ScratchFolder folder;
  CHECK(export_six(folder, {"--frames", "2:4", "--theme", "dark", "--format", "apng"}).code == 0);
  CHECK(folder.names("out") ==
        Names{"03_sequential_impulses.txt", "03_sequential_impulses.vtt", "03_sequential_impulses_dark.png"});
  CHECK(folder.text("out/03_sequential_impulses.txt") ==
        "2. " + alt_of(2) + "\n3. " + alt_of(3) + "\n4. " + alt_of(4) + "\n");
}

TEST_CASE(
    "a film is of all frames, at the rate that is asked for, and each caption lasts as long as its frame") {
  const ScratchFolder folder;
  const Ran ran = export_six(
      folder, {"--theme", "light", "--format", "apng", "--scale", "0.75", "--fps", "4", "--sweeps", "2"});
  CHECK(ran.code == 0);
  CHECK(ran.out.rfind("1 film with what it shows: ", 0) == 0);
  const std::string film = folder.text("out/03_sequential_impulses_light.png");
  const auto number_at = [&film](std::size_t at) {
    return (static_cast<unsigned char>(film[at]) << 8) + static_cast<unsigned char>(film[at + 1]);
  };
  const std::size_t control = film.find("acTL");
  REQUIRE(control != std::string::npos);
  const int frames = number_at(control + 6);
  CHECK(frames > 6);
  const std::size_t first = film.find("fcTL");  // delay in 100/hundredths s behind six numbers of four bytes
  CHECK(4 * number_at(first + 24) == number_at(first + 26));
  const std::string captions = folder.text("out/03_sequential_impulses.vtt");
  CHECK(captions.rfind("WEBVTT\n\n00:00:00.000 --> 00:00:00.250\n" + alt_of(1).substr(0, 20), 0) == 0);
  int shown = 0;
  for (std::size_t at = captions.find(" --> "); at != std::string::npos; at = captions.find(" --> ", at + 1))
    ++shown;
  CHECK(shown == frames);
}

TEST_CASE("a film of ten seconds of a whole lesson is below one megabyte") {
  const ScratchFolder folder;
  CHECK(export_six(folder, {"--theme", "light", "--format", "apng", "--scale", "0.75", "--fps", "3"}).code ==
        0);
  CHECK(std::filesystem::file_size(folder.path() + "/out/03_sequential_impulses_light.png") < 1000000);
}

TEST_CASE("a film whose encoder is not there is refused before anything is drawn") {
  const ScratchFolder folder;
  const Ran ran = run_program("/usr/bin/env", {"PATH=" + folder.path(), CAIRN_BIN_DIR "/lessons", "export",
                                               "3", "--format", "mp4", "--out", folder.path() + "/out"});
  CHECK(ran.code == 3);
  CHECK(ran.err ==
        "lessons: --format mp4 needs the program ffmpeg (apt-get install ffmpeg); apng needs none\n");
  CHECK_FALSE(std::filesystem::exists(folder.path() + "/out"));
}

TEST_CASE("a film as GIF is made by the ffmpeg that PATH leads to") {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() + "/programs");
  // A stand-in that writes its arguments where it should write the film.
  folder.write("programs/ffmpeg",
               "#!/bin/sh\n[ \"$1\" = -version ] && exit\nfor last; do :; done\necho \"$@\" > \"$last\"\n");
  std::filesystem::permissions(folder.path() + "/programs/ffmpeg", std::filesystem::perms::owner_all);
  const Ran ran =
      run_program("/usr/bin/env",
                  {"PATH=" + folder.path() + "/programs", CAIRN_BIN_DIR "/lessons", "export", "3", "--frames",
                   "2:3", "--theme", "dark", "--format", "gif", "--out", folder.path() + "/out"});
  CAPTURE(ran.err);
  CHECK(ran.code == 0);
  CHECK(folder.text("out/03_sequential_impulses_dark.gif").find("-framerate 1 -i ") != std::string::npos);
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
      {{"--format", "apng", "--transparent"}, "--transparent must come with --format png or svg"}};
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
