// Lessons as films: their captions, their sizes, and the programs that encode them.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "exported.hpp"
#include "render/image.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

bool has_ffmpeg() {
  if (std::system("ffmpeg -v quiet -version >/dev/null 2>&1") == 0) return true;
  MESSAGE("skipped: there is no ffmpeg to make a film with");
  return false;
}

/// The pictures of a film as ffmpeg plays them, ten a second, and without what is odd of their size.
List<render::Image> played(const ScratchFolder& folder, const std::string& file) {
  const std::string pictures = folder.path() + "/played";
  std::filesystem::create_directories(pictures);
  const std::string command = "ffmpeg -v error -nostdin -i '" + folder.path() + "/" + file +
                              "' -vf fps=10 '" + pictures + "/%04d.png' >/dev/null 2>&1";
  REQUIRE(std::system(command.c_str()) == 0);
  List<render::Image> images;
  for (const std::string& name : folder.names("played"))
    images.push_back(render::read_png(pictures + "/" + name));
  return images;
}

/// The mean difference of a channel, over what the two have in common.
double mean_difference(const render::Image& one, const render::Image& other) {
  double sum = 0;
  const int width = std::min(one.width, other.width), height = std::min(one.height, other.height);
  for (int y = 0; y < height; ++y)
    for (int i = 0; i < 3 * width; ++i)
      sum += std::abs(one.pixels[3 * y * one.width + i] - other.pixels[3 * y * other.width + i]);
  return sum / (3 * width * height);
}

/// The part of a film of WebP that says so: [ms] that each frame stays (container of WebP, ANMF).
List<int> webp_durations(const std::string& file) {
  const auto byte = [&file](std::size_t at) { return int{static_cast<unsigned char>(file[at])}; };
  List<int> durations;
  for (std::size_t at = file.find("ANMF"); at != std::string::npos; at = file.find("ANMF", at + 1))
    durations.push_back(byte(at + 20) + 256 * byte(at + 21) + 65536 * byte(at + 22));
  return durations;
}

}  // namespace

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
  const Ran ran = export_six(folder, {"--theme", "light", "--format", "apng", "--fps", "4", "--sweeps", "2"});
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

TEST_CASE("the film of a whole lesson is below one megabyte, where frames are many or colours") {
  for (const char* lesson : {"0", "3", "21"}) {
    CAPTURE(lesson);
    const ScratchFolder folder;
    const Ran ran = run_program("lessons", {"export", lesson, "--theme", "light", "--format", "apng", "--out",
                                            folder.path() + "/out"});
    CHECK(ran.code == 0);
    for (const std::string& name : folder.names("out"))
      if (name.ends_with(".png")) CHECK(std::filesystem::file_size(folder.path() + "/out/" + name) < 1000000);
  }
}

TEST_CASE("a film whose encoder is not there is refused before anything is drawn") {
  const ScratchFolder folder;
  const Ran ran = run_program("/usr/bin/env", {"PATH=" + folder.path(), CAIRN_BIN_DIR "/lessons", "export",
                                               "6", "--format", "mp4", "--out", folder.path() + "/out"});
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
  CHECK(folder.text("out/03_sequential_impulses_dark.gif").find("-f apng -i ") != std::string::npos);
}

TEST_CASE("a film as MP4 plays the frames with their captions, each for its time") {
  if (!has_ffmpeg()) return;
  const ScratchFolder folder;
  const Names flags = {"--frames", "2:4", "--theme", "light", "--format"};
  for (const char* format : {"apng", "mp4"}) {
    Names words = flags;
    words.push_back(format);
    const Ran ran = export_six(folder, words);
    CAPTURE(ran.err);
    REQUIRE(ran.code == 0);
  }
  const render::Image first = render::read_png(folder.path() + "/out/03_sequential_impulses_light.png");
  const List<render::Image> images = played(folder, "out/03_sequential_impulses_light.mp4");
  CHECK(images.front().width == first.width);
  CHECK(std::abs(images.front().height - first.height) <= 1);
  CHECK(mean_difference(images.front(), first) < 2);
  // The first change comes when the first caption is read: 1 s and a quarter for each word.
  const std::string captions = folder.text("out/03_sequential_impulses.vtt");
  const std::size_t arrow = captions.find(" --> ");
  const double seconds =
      60 * std::stod(captions.substr(arrow + 8, 2)) + std::stod(captions.substr(arrow + 11));
  int change = 1;
  while (change < images.size() && mean_difference(images[change], images.front()) < 0.15) ++change;
  CHECK(std::abs(change - 10 * seconds) <= 1);
}

TEST_CASE("a film as WebP has a frame for each of the lesson's, each for its time") {
  if (!has_ffmpeg()) return;
  const ScratchFolder folder;
  const Ran ran =
      export_six(folder, {"--frames", "2:4", "--theme", "light", "--fps", "2", "--format", "webp"});
  CAPTURE(ran.err);
  REQUIRE(ran.code == 0);
  const List<int> durations = webp_durations(folder.text("out/03_sequential_impulses_light.webp"));
  CHECK(durations.size() == 3);
  for (int i = 0; i + 1 < durations.size(); ++i) CHECK(std::abs(durations[i] - 500) <= 1);
  CHECK(durations.back() >= 499);  // ffmpeg may let the last stand longer
}
