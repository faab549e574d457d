// Which frames --frames means.
#include <doctest/doctest.h>

#include <stdexcept>

#include "lessons/kit/frames.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;

namespace {

using Chosen = List<int>;

FrameSupply supply_of_ten() {
  FrameSupply supply = {.key = List<bool>(10, false), .cover = -2};
  supply.key[0] = supply.key[4] = supply.key[9] = true;
  return supply;
}

Chosen frames_for(const char* text) {
  const auto choice = parse_frames(text);
  REQUIRE_MESSAGE(choice, std::string(text));
  return chosen_frames(*choice, supply_of_ten());
}

}  // namespace

TEST_CASE("frames are counted from one at the front and from minus one at the back") {
  CHECK(frames_for("1") == Chosen{0});
  CHECK(frames_for("10") == Chosen{9});
  CHECK(frames_for("-1") == Chosen{9});
  CHECK(frames_for("-10") == Chosen{0});
}

TEST_CASE("a range holds both its ends, and takes every S-th frame when asked") {
  CHECK(frames_for("3:5") == Chosen{2, 3, 4});
  CHECK(frames_for("2:9:3") == Chosen{1, 4, 7});
  CHECK(frames_for("-3:-1") == Chosen{7, 8, 9});
  CHECK(frames_for("8:-1:2") == Chosen{7, 9});
  CHECK(frames_for("9:200") == Chosen{8, 9});
}

TEST_CASE("key, all, none and cover choose what they say") {
  CHECK(frames_for("key") == Chosen{0, 4, 9});
  CHECK(frames_for("all").size() == 10);
  CHECK(frames_for("none").empty());
  CHECK(frames_for("cover") == Chosen{8});
}

TEST_CASE("a film has every frame of up to 64, and of more every second, with those that are key") {
  const FrameChoice film = {.kind = FrameChoice::Kind::film};
  CHECK(frames_for("film").size() == 10);
  CHECK(chosen_frames(film, {.key = List<bool>(64, false)}).size() == 64);
  FrameSupply supply = {.key = List<bool>(66, false)};
  supply.key[7] = true;
  const Chosen chosen = chosen_frames(film, supply);
  CHECK(chosen.size() == 33 + 2);  // the even ones, number 7, and the last
  CHECK(Chosen{chosen.begin() + 3, chosen.begin() + 6} == Chosen{6, 7, 8});
  CHECK(chosen.back() == 65);
}

TEST_CASE("a choice of frames that cannot be read is refused") {
  for (const char* text :
       {"", "0", "first", "1:", ":3", "1:0", "1:5:0", "1:5:-1", "1:2:3:4", "1.5", "3-5", "KEY"}) {
    CHECK_MESSAGE(!parse_frames(text), std::string(text));
  }
}

TEST_CASE("frames that the sequence does not have are reported") {
  for (const char* text : {"11", "-11", "5:3", "12:20"}) CHECK_THROWS_AS(frames_for(text), NoSuchFrame);
  CHECK_THROWS_AS(chosen_frames({.kind = FrameChoice::Kind::range}, {}), NoSuchFrame);
  CHECK(chosen_frames({.kind = FrameChoice::Kind::all}, {}).empty());
}

TEST_CASE("twelve key frames are allowed, a thirteenth is a mistake of the lesson") {
  const FrameChoice key = {};
  CHECK(chosen_frames(key, {.key = List<bool>(12, true)}).size() == 12);
  CHECK_THROWS_AS(chosen_frames(key, {.key = List<bool>(13, true)}), std::logic_error);
}

TEST_CASE("a cover that is none of the frames is a mistake of the lesson") {
  const FrameChoice cover = {.kind = FrameChoice::Kind::cover};
  CHECK_THROWS_AS(chosen_frames(cover, {.key = {true}, .cover = 2}), std::logic_error);
  CHECK_THROWS_AS(chosen_frames(cover, {.key = {true}, .cover = 0}), std::logic_error);
  CHECK_THROWS_AS(chosen_frames(cover, {.key = {}, .cover = -1}), std::logic_error);
}
