// PNG files come back as they were written, whole or not at all, and differences between pictures are
// counted.
#include "render/picture_files.hpp"
#include "render/pictures.hpp"

using namespace cairn;
using namespace cairn::render;
using namespace cairn::test;
namespace fs = std::filesystem;

namespace {

List<Image> pictures_of_all_kinds() {
  return {random_picture(61, 37, 1),  random_picture(1, 1, 2),  random_picture(1, 300, 3),
          random_picture(300, 1, 4),  flat_picture(100, 50, 0), flat_picture(1, 1, 255),
          flat_picture(640, 360, 128)};
}

bool same_pixels(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The entries of a folder, so that nothing can be left behind unseen.
int entries(const fs::path& folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a picture comes back from its PNG file pixel for pixel") {
  const TemporaryFolder folder;
  for (const Image& image : pictures_of_all_kinds()) {
    write_png(folder / "picture.png", image);
    CHECK(same_pixels(read_png(folder / "picture.png"), image));
    CHECK(entries(folder.path()) == 1);
  }
}

TEST_CASE("a PNG holds a header, one chunk of pixels and an end, each with a valid checksum") {
  for (const Image& image : pictures_of_all_kinds()) {
    const List<PngChunk> chunks = png_chunks(as_text(encode_png(image)));
    REQUIRE(chunks.size() == 3);
    for (const PngChunk& chunk : chunks) CHECK(chunk.checksum == checksum_of(chunk));
    CHECK(chunks[0].name == "IHDR");
    CHECK(number_at(chunks[0].data, 0, 4) == static_cast<std::uint32_t>(image.width));
    CHECK(number_at(chunks[0].data, 4, 4) == static_cast<std::uint32_t>(image.height));
    CHECK(chunks[0].data.substr(8) == std::string("\x08\x02\x00\x00\x00", 5));  // 8 bits, RGB, not interlaced
    CHECK(chunks[1].name == "IDAT");
    CHECK(same_pixels(inflated(image.width, image.height, chunks[1].data), image));
    CHECK(chunks[2].name == "IEND");
    CHECK(chunks[2].data.empty());
  }
}

TEST_CASE("flat colours are stored in a hundredth of their bytes") {
  const Image image = flat_picture(1280, 720, 200);
  CHECK(encode_png(image).size() < image.pixels.size() / 100);
}

TEST_CASE("the alpha channel of a foreign PNG is dropped") {
  const std::string row("\0\x0a\x14\x1e\x80\xc8\xd2\xdc\xff", 9);  // two pixels RGBA
  List<Bytef> compressed(100);
  uLongf length = compressed.bytes();
  REQUIRE(compress(compressed.data(), &length, reinterpret_cast<const Bytef*>(row.data()), 9) == Z_OK);
  const auto number = [](std::uint32_t value) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255);
    return text;
  };
  std::string file = "\x89PNG\r\n\x1a\n";
  for (const PngChunk& chunk :
       {PngChunk{"IHDR", number(2) + number(1) + std::string("\x08\x06\0\0\0", 5)},
        PngChunk{"IDAT", std::string(reinterpret_cast<const char*>(compressed.data()), length)},
        PngChunk{"IEND", ""}}) {
    file += number(static_cast<std::uint32_t>(chunk.data.size())) + chunk.name + chunk.data;
    file += number(checksum_of(chunk));
  }
  const Image image = decode_png(List<std::uint8_t>(file.begin(), file.end()));
  CHECK(same_pixels(image, {.width = 2, .height = 1, .pixels = {10, 20, 30, 200, 210, 220}}));
}

TEST_CASE("a picture without pixels, or with too few or too many, is refused by name") {
  CHECK(message_of<std::invalid_argument>([] { encode_png(Image{}); }) ==
        "encode_png: width must be positive px, got 0");
  CHECK(message_of<std::invalid_argument>([] { encode_png({.width = 2, .height = -1}); }) ==
        "encode_png: height must be positive px, got -1");
  for (const int size : {0, 11, 13}) {
    const Image image{.width = 2, .height = 2, .pixels = List<std::uint8_t>(size)};
    CHECK(message_of<std::invalid_argument>([&] { encode_png(image); }) ==
          "encode_png: pixels must be width * height * 3 bytes, got " + std::to_string(size));
  }
  const Image vast{.width = 100000, .height = 100000};
  CHECK(
      mentions(message_of<std::invalid_argument>([&] { encode_png(vast); }), "size must be less than 1 GiB"));
}

TEST_CASE("what is not a whole PNG is refused with the file's name") {
  const TemporaryFolder folder;
  const fs::path path = folder / "picture.png";
  const auto refusal = [&] { return message_of<std::runtime_error>([&] { read_png(path); }); };
  const std::string start = "cannot read " + path.string() + ": ";
  CHECK(refusal() == start + "No such file or directory");
  const std::string whole = as_text(encode_png(random_picture(20, 10, 5)));
  // The last 16 bytes are the checksum of the pixels and the end: a decoder can do without.
  for (std::size_t size = 0; size + 16 < whole.size(); size += 7) {
    write_whole_file(path, whole.substr(0, size));
    CHECK(mentions(refusal(), start + "not a whole PNG ("));
  }
  write_whole_file(path, std::string(10000, 'x'));
  CHECK(mentions(refusal(), start + "not a whole PNG ("));
  fs::remove(path);
  fs::create_directory(path);
  CHECK(refusal() == start + "Is a directory");
}

TEST_CASE("a difference counts pixels, not channels, and keeps the largest step of one channel") {
  const Image expected = flat_picture(8, 4, 100);
  CHECK(compare(expected, expected).same_size);
  CHECK(compare(expected, expected).largest == 0);
  CHECK(compare(expected, expected).differing == 0);
  Image actual = expected;
  channel_at(actual, 7, 3, 2) = 97;
  channel_at(actual, 0, 0, 0) = 101;
  channel_at(actual, 0, 0, 1) = 101;
  for (const ImageDifference& difference : {compare(expected, actual), compare(actual, expected)}) {
    CHECK(difference.same_size);
    CHECK(difference.largest == 3);
    CHECK(difference.differing == 2);
  }
  const ImageDifference other_size = compare(flat_picture(8, 4, 100), flat_picture(4, 8, 100));
  CHECK_FALSE(other_size.same_size);
  CHECK(other_size.largest == 255);
  CHECK(other_size.differing == 32);
}

TEST_CASE("a difference picture is red where pixels differ and pale grey elsewhere") {
  const Image expected = random_picture(9, 5, 6);
  Image actual = expected;
  channel_at(actual, 3, 2, 1) ^= 4;
  Image found = difference_image(expected, actual);
  int red = 0;
  for (int i = 0; i < 45; ++i) {
    const int r = channel_at(found, i % 9, i / 9, 0), g = channel_at(found, i % 9, i / 9, 1);
    CHECK(g == channel_at(found, i % 9, i / 9, 2));
    CHECK((r == g ? r >= 155 : (r == 220 && g == 0)));
    red += r != g ? 1 : 0;
  }
  CHECK(red == 1);
  CHECK(channel_at(found, 3, 2, 0) == 220);
  CHECK(channel_at(found, 3, 2, 1) == 0);
  Image tolerant = difference_image(expected, actual, 4);
  CHECK(channel_at(tolerant, 3, 2, 0) == channel_at(tolerant, 3, 2, 1));
}

TEST_CASE("a difference picture of two sizes covers both and is red where one of them ends") {
  Image found = difference_image(flat_picture(3, 2, 50), flat_picture(2, 4, 50));
  REQUIRE(found.width == 3);
  REQUIRE(found.height == 4);
  REQUIRE(found.pixels.size() == 36);
  for (int i = 0; i < 12; ++i) {
    const int x = i % 3, y = i / 3;
    const bool in_both = x < 2 && y < 2;
    CHECK((channel_at(found, x, y, 1) == 0) == !in_both);
  }
}
