// Animated PNG, read back by a reader of the test's own: every frame as it was given, and only what changed.
#include "render/picture_files.hpp"
#include "render/pictures.hpp"
#include "render/sequence.hpp"

using namespace cairn;
using namespace cairn::render;
using namespace cairn::test;

namespace {

struct AnimationFrame {
  int x = 0, y = 0, width = 0, height = 0;  // [px], the stored rectangle
  double delay = 0;                         // [s]
  Image shown = {};                         // what a viewer sees
};

struct Animation {
  List<AnimationFrame> frames = {};
  List<std::string> names = {};  // of the chunks
  std::uint32_t frame_count = 0, repeats = 99;
};

AnimationFrame frame_from_control(const std::string& data) {
  const auto number = [&](std::size_t offset) { return static_cast<int>(number_at(data, offset, 4)); };
  REQUIRE(data.size() == 26);
  CHECK(number_at(data, 24, 2) == 1);  // nothing is disposed of; pixels cover what was there
  return {.x = number(12),
          .y = number(16),
          .width = number(4),
          .height = number(8),
          .delay = number_at(data, 20, 2) / static_cast<double>(number_at(data, 22, 2))};
}

/// Puts the stored rectangle over what was shown before.
void show(AnimationFrame& frame, const Image& before, const std::string& compressed) {
  Image part = inflated(frame.width, frame.height, compressed);
  frame.shown = before;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const bool is_left_out = channel_at(part, x, y, 0) == 3 && channel_at(part, x, y, 1) == 253 &&
                               channel_at(part, x, y, 2) == 2;
      for (int channel = 0; channel < 3 && !is_left_out; ++channel) {
        channel_at(frame.shown, frame.x + x, frame.y + y, channel) = channel_at(part, x, y, channel);
      }
    }
  }
}

Animation animation_in(const std::filesystem::path& path) {
  Animation animation;
  Image canvas;
  std::uint32_t sequence_number = 0;
  for (const PngChunk& chunk : png_chunks(text_of_file(path))) {
    CHECK(chunk.checksum == checksum_of(chunk));
    animation.names.push_back(chunk.name);
    if (chunk.name == "IHDR") {
      canvas = flat_picture(static_cast<int>(number_at(chunk.data, 0, 4)),
                            static_cast<int>(number_at(chunk.data, 4, 4)), 0);
    } else if (chunk.name == "acTL") {
      animation.frame_count = number_at(chunk.data, 0, 4);
      animation.repeats = number_at(chunk.data, 4, 4);
    } else if (chunk.name == "fcTL") {
      CHECK(number_at(chunk.data, 0, 4) == sequence_number++);
      animation.frames.push_back(frame_from_control(chunk.data));
    } else if (chunk.name == "IDAT") {
      show(animation.frames.back(), canvas, chunk.data);
    } else if (chunk.name == "fdAT") {
      CHECK(number_at(chunk.data, 0, 4) == sequence_number++);
      const Image before = animation.frames.at(animation.frames.size() - 2).shown;
      show(animation.frames.back(), before, chunk.data.substr(4));
    }
  }
  return animation;
}

void write_apng(const std::filesystem::path& path, const List<Image>& images, double frames_per_second) {
  ApngWriter writer(path, images.size(), frames_per_second);
  for (const Image& image : images) writer.add(image);
  writer.finish();
}

/// A square of 10 pixels on grey, with its top left corner at (x, y).
Image picture_of_square(int x, int y) {
  Image image = flat_picture(64, 36, 230);
  for (int i = 0; i < 100; ++i) channel_at(image, x + i % 10, y + i / 10, 0) = 20;
  return image;
}

}  // namespace

TEST_CASE("an animation shows exactly the given pictures, for ever") {
  List<Image> images = {random_picture(31, 17, 1), random_picture(31, 17, 2), random_picture(31, 17, 2)};
  images.push_back(images[2]);
  channel_at(images[3], 30, 16, 2) ^= 1;  // one bit in the last corner
  images.push_back(images[3]);
  channel_at(images[4], 0, 0, 0) ^= 1;
  channel_at(images[4], 5, 9, 1) ^= 1;
  const TemporaryFolder folder;
  write_apng(folder / "a.png", images, 10);
  const Animation animation = animation_in(folder / "a.png");
  CHECK(animation.frame_count == images.size());
  CHECK(animation.repeats == 0);
  REQUIRE(animation.frames.size() == images.size());
  for (int i = 0; i < images.size(); ++i) CHECK(animation.frames[i].shown.pixels == images[i].pixels);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a viewer that knows no animation sees the first picture") {
  const List<Image> images = {picture_of_square(5, 7), picture_of_square(40, 20)};
  const TemporaryFolder folder;
  write_apng(folder / "a.png", images, 10);
  CHECK(read_png(folder / "a.png").pixels == images[0].pixels);
  const List<std::string> expected = {"IHDR", "acTL", "tRNS", "fcTL", "IDAT", "fcTL", "fdAT", "IEND"};
  CHECK(animation_in(folder / "a.png").names == expected);
}

TEST_CASE("only the rectangle that changed is stored, and one pixel when nothing did") {
  const List<Image> images = {picture_of_square(5, 7), picture_of_square(6, 7), picture_of_square(6, 7),
                              picture_of_square(26, 17)};
  const TemporaryFolder folder;
  write_apng(folder / "a.png", images, 10);
  const Animation animation = animation_in(folder / "a.png");
  REQUIRE(animation.frames.size() == 4);
  const int expected[4][4] = {{0, 0, 64, 36}, {5, 7, 11, 10}, {0, 0, 1, 1}, {6, 7, 30, 20}};
  for (int i = 0; i < 4; ++i) {
    CHECK(animation.frames[i].x == expected[i][0]);
    CHECK(animation.frames[i].y == expected[i][1]);
    CHECK(animation.frames[i].width == expected[i][2]);
    CHECK(animation.frames[i].height == expected[i][3]);
    CHECK(animation.frames[i].shown.pixels == images[i].pixels);
  }
}

TEST_CASE("what is as before between two changes takes next to nothing") {
  const Image first = random_picture(200, 100, 1);
  Image second = first;
  channel_at(second, 0, 0, 0) ^= 1;
  channel_at(second, 199, 99, 0) ^= 1;  // the rectangle of the changes is the whole picture
  const TemporaryFolder folder;
  write_apng(folder / "one.png", {first}, 10);
  write_apng(folder / "two.png", {first, second}, 10);
  CHECK(animation_in(folder / "two.png").frames[1].shown.pixels == second.pixels);
  CHECK(std::filesystem::file_size(folder / "two.png") <
        std::filesystem::file_size(folder / "one.png") + 1000);
}

TEST_CASE("a film with a palette shows its colours, the nearest where it lacks one, in far fewer bytes") {
  const Image first = picture_of_square(5, 7);
  Image second = picture_of_square(6, 7);
  channel_at(second, 63, 35, 0) = 229;  // the palette has 230
  const TemporaryFolder folder;
  ColorCount count;
  count.add(first);
  ApngWriter writer(folder / "a.png", 2, 10, count.palette(255));
  writer.add(first);
  writer.add(second);
  writer.finish();
  CHECK(read_png(folder / "a.png").pixels == first.pixels);
  const List<PngChunk> chunks = png_chunks(text_of_file(folder / "a.png"));
  List<std::string> names;
  for (const PngChunk& chunk : chunks) names.push_back(chunk.name);
  CHECK(names == List<std::string>{"IHDR", "acTL", "PLTE", "tRNS", "fcTL", "IDAT", "fcTL", "fdAT", "IEND"});
  CHECK(chunks[0].data[9] == 3);                  // indexed colour (ISO/IEC 15948, 11.2.2)
  CHECK(chunks[3].data == std::string(1, '\0'));  // the first entry lets through what was before
  // The rectangle of the change is 11 x 10 pixels: in each row the square gains one and loses one.
  CHECK(number_at(chunks[6].data, 4, 4) == 11);
  CHECK(number_at(chunks[6].data, 8, 4) == 10);
  const std::string rows = inflated_bytes(chunks[7].data.substr(4), 10 * (1 + 11));
  for (std::size_t y = 0; y < 10; ++y) {
    const std::string row = rows.substr(12 * y + 1, 11);
    CHECK(row.substr(1, 9) == std::string(9, '\0'));
    const auto entry = [&](char c) { return chunks[2].data.substr(3 * static_cast<std::size_t>(c), 3); };
    CHECK(entry(row[0]) == "\xE6\xE6\xE6");
    CHECK(entry(row[10]) == "\x14\xE6\xE6");
  }
}

TEST_CASE("the colour that means as before is shown as its neighbour") {
  Image green = flat_picture(2, 1, 9);
  for (int x = 0; x < 2; ++x) {
    channel_at(green, x, 0, 0) = 3;
    channel_at(green, x, 0, 1) = 253;
    channel_at(green, x, 0, 2) = 2;
  }
  const TemporaryFolder folder;
  write_apng(folder / "a.png", {flat_picture(2, 1, 9), green}, 10);
  CHECK(animation_in(folder / "a.png").frames[1].shown.pixels == List<std::uint8_t>{3, 253, 3, 3, 253, 3});
}

TEST_CASE("a picture stays for one over the frame rate, to a hundredth of a frame per second") {
  const List<Image> images = {flat_picture(2, 2, 0), flat_picture(2, 2, 1)};
  const TemporaryFolder folder;
  for (const double rate : {0.01, 0.5, 10.0, 23.97, 30.0, 60.0, 655.0}) {
    write_apng(folder / "a.png", images, rate);
    for (const AnimationFrame& frame : animation_in(folder / "a.png").frames) {
      CHECK(1 / frame.delay == doctest::Approx(rate).epsilon(1e-12));
    }
  }
}

TEST_CASE("a picture that is added several times as one stays that many times as long") {
  const TemporaryFolder folder;
  ApngWriter writer(folder / "a.png", 2, 10);
  writer.add(flat_picture(2, 2, 0), 7);
  writer.add(flat_picture(2, 2, 1));
  writer.finish();
  const Animation animation = animation_in(folder / "a.png");
  CHECK(animation.frames[0].delay == doctest::Approx(0.7));
  CHECK(animation.frames[1].delay == doctest::Approx(0.1));
}

TEST_CASE("an animation of one picture is a picture") {
  const TemporaryFolder folder;
  write_apng(folder / "a.png", List<Image>{flat_picture(1, 1, 77)}, 1);
  const Animation animation = animation_in(folder / "a.png");
  REQUIRE(animation.frames.size() == 1);
  CHECK(animation.frames[0].shown.pixels == List<std::uint8_t>{77, 77, 77});
}

TEST_CASE("an animation of nothing, of two sizes or at a rate the format cannot say is refused") {
  const TemporaryFolder folder;
  const List<Image> pair = {flat_picture(2, 2, 0), flat_picture(2, 2, 1)};
  const auto refusal = [&](const List<Image>& images, double rate) {
    return message_of<std::invalid_argument>([&] { write_apng(folder / "a.png", images, rate); });
  };
  CHECK(refusal({}, 10) == "ApngWriter: frames must be at least one, got 0");
  CHECK(refusal({pair[0], flat_picture(3, 2, 0)}, 10) ==
        "ApngWriter: width must be that of the first image, got 3");
  CHECK(refusal({pair[0], flat_picture(2, 1, 0)}, 10) ==
        "ApngWriter: height must be that of the first image, got 1");
  CHECK(refusal({pair[0], Image{}}, 10) == "ApngWriter: width must be positive px, got 0");
  for (const double rate : {0.0, -1.0, 0.001, 656.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(refusal(pair, rate).find("ApngWriter: frames_per_second must be 0.01 to 655 1/s") == 0);
  }
  CHECK(message_of<std::invalid_argument>([&] {
          ApngWriter(folder / "a.png", 1, 10, List<std::uint32_t>(256));
        }) == "ApngWriter: palette must be at most 255 colours, got 256");
  CHECK(std::filesystem::is_empty(folder.path()));
  CHECK_THROWS_AS(write_apng("/dev/null/a.png", pair, 10), WriteError);
}

TEST_CASE("frames are on disk as they come, and an animation that is not finished leaves nothing") {
  const TemporaryFolder folder;
  {
    ApngWriter writer(folder / "a.png", 3, 10);
    const auto written = [&folder] {
      return file_size(std::filesystem::directory_iterator(folder.path())->path());
    };
    writer.add(random_picture(100, 100, 1));
    const std::uintmax_t first = written();
    CHECK(first > 30000);  // noise does not compress
    writer.add(random_picture(100, 100, 2));
    CHECK(written() > 2 * first - 1000);
    CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
    CHECK_THROWS_WITH_AS(writer.finish(), "ApngWriter: frames added must be 3, got 2", std::invalid_argument);
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}
