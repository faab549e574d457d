// The rule of the golden pictures, itself shown to fail.
#include <cstdlib>
#include <optional>

#include "render/picture_files.hpp"
#include "render/pictures.hpp"

using namespace cairn;
using namespace cairn::render;
using namespace cairn::test;
namespace fs = std::filesystem;

namespace {

/// A place with one golden picture, "scene", and that picture.
struct GoldenRoom {
  TemporaryFolder folder = {};
  golden::Place place = {.goldens = folder / "images", .failures = folder / "failures"};
  Image scene = random_picture(40, 30, 8);

  GoldenRoom() {
    for (std::uint8_t& channel : scene.pixels) channel = static_cast<std::uint8_t>(50 + channel / 2);
    fs::create_directory(place.goldens);
    write_png(place.goldens / "scene.png", scene);
  }

  /// The verdict on the scene with one channel of one pixel changed.
  std::string objection_to_step(int channel, int step) const {
    Image actual = scene;
    std::uint8_t& value = channel_at(actual, 17, 21, channel);
    value = static_cast<std::uint8_t>(value + step);
    return golden::objection(place, "scene", actual);
  }
};

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a golden picture forgives 2 steps in a channel and not 3, in one pixel as in all") {
  const GoldenRoom room;
  CHECK(golden::objection(room.place, "scene", room.scene).empty());
  for (const int channel : {0, 1, 2}) {
    for (const int step : {-2, -1, 1, 2}) CHECK(room.objection_to_step(channel, step).empty());
    for (const int step : {-50, -3, 3, 50}) CHECK_FALSE(room.objection_to_step(channel, step).empty());
  }
  Image shifted = room.scene;
  for (std::uint8_t& channel : shifted.pixels) channel = static_cast<std::uint8_t>(channel + 2);
  CHECK(golden::objection(room.place, "scene", shifted).empty());
}

TEST_CASE("a failure tells how much, where the evidence lies and how to renew") {
  const GoldenRoom room;
  Image actual = room.scene;
  channel_at(actual, 4, 5, 0) += 7;
  channel_at(actual, 9, 5, 2) -= 1;
  const std::string found = golden::objection(room.place, "scene", actual);
  CHECK(tells(found,
              "picture scene: largest difference of a channel 7, allowed 2; pixels that differ at all: 2"));
  CHECK(tells(found, (room.folder / "images/scene.png").string()));
  CHECK(tells(found, (room.folder / "failures/scene_actual.png").string()));
  CHECK(tells(found, (room.folder / "failures/scene_difference.png").string()));
  CHECK(tells(found, "bash tests/run --update"));
  CHECK(read_png(room.folder / "failures/scene_actual.png").pixels == actual.pixels);
  Image difference = read_png(room.folder / "failures/scene_difference.png");
  CHECK(channel_at(difference, 4, 5, 1) == 0);  // red
  CHECK(channel_at(difference, 9, 5, 1) > 0);   // within the tolerance
  CHECK(read_png(room.folder / "images/scene.png").pixels == room.scene.pixels);
}

TEST_CASE("a picture of another size fails") {
  const GoldenRoom room;
  const std::string found = golden::objection(room.place, "scene", random_picture(30, 40, 8));
  CHECK(tells(found, "picture scene: is 30x40 pixels, the golden one 40x30"));
  CHECK(read_png(room.folder / "failures/scene_difference.png").pixels.size() == 3 * 40 * 40);
}

TEST_CASE("a golden picture that is missing fails with the same advice") {
  const GoldenRoom room;
  const std::string found = golden::objection(room.place, "lessons/new", room.scene);
  CHECK(tells(found, "picture lessons/new: there is no golden picture yet"));
  CHECK(tells(found, "bash tests/run --update"));
  CHECK_FALSE(fs::exists(room.folder / "images/lessons/new.png"));
  CHECK(read_png(room.folder / "failures/lessons/new_actual.png").pixels == room.scene.pixels);
}

TEST_CASE("a golden picture that is broken is an error that names it") {
  const GoldenRoom room;
  write_whole_file(room.folder / "images/scene.png", "no picture");
  const auto ask = [&] { golden::objection(room.place, "scene", room.scene); };
  CHECK(tells(message_of<std::runtime_error>(ask), (room.folder / "images/scene.png").string()));
}

TEST_CASE("renewing writes the golden picture, and the next comparison passes") {
  GoldenRoom room;
  const Image other = random_picture(12, 13, 9);
  for (const std::string name : {"scene", "lessons/new"}) {
    CHECK_FALSE(golden::objection(room.place, name, other).empty());
    room.place.mode = golden::Mode::renew;
    CHECK(golden::objection(room.place, name, other).empty());
    room.place.mode = golden::Mode::compare;
    CHECK(golden::objection(room.place, name, other).empty());
    CHECK(read_png(room.place.goldens / (name + ".png")).pixels == other.pixels);
  }
}

TEST_CASE("a picture that passes takes the evidence of its earlier failure away") {
  const GoldenRoom room;
  CHECK_FALSE(room.objection_to_step(0, 9).empty());
  CHECK(fs::exists(room.folder / "failures/scene_actual.png"));
  CHECK(room.objection_to_step(0, 1).empty());
  CHECK(fs::is_empty(room.folder / "failures"));
}

TEST_CASE("a picture that is not the golden one fails its test case" * doctest::should_fail()) {
  const GoldenRoom room;
  Image actual = room.scene;
  channel_at(actual, 0, 0, 1) += 3;
  check_golden(room.place, "scene", actual);
}

TEST_CASE("goldens are renewed when CAIRN_UPDATE_GOLDENS is 1, and only then") {
  const char* const before = std::getenv("CAIRN_UPDATE_GOLDENS");
  const std::optional<std::string> kept =
      before == nullptr ? std::nullopt : std::optional<std::string>(before);
  unsetenv("CAIRN_UPDATE_GOLDENS");
  CHECK(golden::default_place().mode == golden::Mode::compare);
  setenv("CAIRN_UPDATE_GOLDENS", "0", 1);
  CHECK(golden::default_place().mode == golden::Mode::compare);
  setenv("CAIRN_UPDATE_GOLDENS", "1", 1);
  CHECK(golden::default_place().mode == golden::Mode::renew);
  unsetenv("CAIRN_UPDATE_GOLDENS");
  if (kept) setenv("CAIRN_UPDATE_GOLDENS", kept->c_str(), 1);
  CHECK(golden::default_place().goldens == fs::path(CAIRN_SOURCE_DIR) / "tests" / "images");
}
