// The committed pictures of the documents are those that the lessons draw.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "../images/golden.hpp"
#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {

namespace {

/// Draws all covers into a folder, as the target `images` does.
int draw_images(const ScratchFolder& scratch) {
  const std::string command = "bash '" CAIRN_SOURCE_DIR "/lessons/images.sh' '" CAIRN_BIN_DIR "' '" +
                              scratch.path() + "/frames' '" + scratch.path() + "/images'";
  return std::system(command.c_str());
}

/// Lesson 17 and the picture on top of the README need Box2D.
bool needs_box2d(const std::string& name) { return name.starts_with("17_") || name.starts_with("cairn_"); }

/// The maps of the stability atlas take minutes, and have a target of their own.
bool is_of_the_atlas(const std::string& name) { return name.starts_with("atlas_"); }

}  // namespace

TEST_CASE("the pictures of the documents are what the lessons draw now") {
  const ScratchFolder scratch;
  REQUIRE(draw_images(scratch) == 0);
  const List<std::string> drawn = scratch.names("images");
  CHECK(drawn.size() >= 8);  // two themes of at least four lessons
  test::golden::Place place = test::golden::default_place();
  place.goldens = std::filesystem::path(CAIRN_SOURCE_DIR) / "images";
  for (const std::string& name : drawn) {
    test::check_golden(place, std::filesystem::path(name).stem().string(),
                       render::read_png(scratch.path() + "/images/" + name));
  }
  const bool has_box2d = std::filesystem::exists(scratch.path() + "/images/17_tower_light.png");
  for (const auto& entry : std::filesystem::directory_iterator(place.goldens)) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    if (is_of_the_atlas(name)) continue;
    CHECK((std::filesystem::exists(scratch.path() + "/images/" + name) || (needs_box2d(name) && !has_box2d)));
  }
}

}  // namespace cairn::testing
