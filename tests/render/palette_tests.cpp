// The colours that a film keeps.
#include "render/palette.hpp"
#include "render/picture_files.hpp"
#include "render/pictures.hpp"

using namespace cairn;
using namespace cairn::render;
using namespace cairn::test;

namespace {

/// One row of pixels.
Image row_of(const List<std::uint32_t>& colors) {
  Image image{.width = colors.size(), .height = 1};
  for (const std::uint32_t color : colors)
    for (const unsigned shift : {16U, 8U, 0U})
      image.pixels.push_back(static_cast<std::uint8_t>(color >> shift));
  return image;
}

}  // namespace

TEST_CASE("a palette has every colour where there is room, the most frequent first") {
  ColorCount count;
  count.add(row_of({0x000102, 0xFFFFFF, 0xFFFFFF}));
  count.add(row_of({0xFFFFFF, 0x805030, 0x805030}));
  const List<std::uint32_t> colors = count.palette(3);
  CHECK(colors.front() == 0xFFFFFF);
  CHECK(std::set<std::uint32_t>(colors.begin(), colors.end()) ==
        std::set<std::uint32_t>{0xFFFFFF, 0x805030, 0x000102});
  CHECK(count.palette(255).size() == 3);
}

TEST_CASE("too many colours leave those that many pixels have, and one near each other") {
  // All greys, of which two fill the picture: four colours are these two, and two between them.
  List<std::uint32_t> colors;
  for (std::uint32_t grey = 0; grey < 256; ++grey) colors.push_back(grey * 0x010101);
  for (int i = 0; i < 20000; ++i) colors.push_back(i % 2 == 0 ? 0x000000 : 0xFFFFFF);
  ColorCount count;
  count.add(row_of(colors));
  const List<std::uint32_t> chosen = count.palette(4);
  CHECK(std::set<std::uint32_t>(chosen.begin(), chosen.end()).count(0x000000) == 1);
  CHECK(std::set<std::uint32_t>(chosen.begin(), chosen.end()).count(0xFFFFFF) == 1);
  Palette palette(chosen);
  for (int grey = 0; grey < 256; ++grey) {
    const std::uint32_t near = palette.colors()[palette.nearest(static_cast<std::uint32_t>(grey) * 0x010101)];
    CHECK(std::abs(grey - static_cast<int>(near & 0xFF)) <= 64);  // a quarter of the way between two of four
  }
}

TEST_CASE("a palette is the same in whatever order the pictures come") {
  const Image one = random_picture(40, 30, 1), other = random_picture(40, 30, 2);
  ColorCount forth, back;
  forth.add(one);
  forth.add(other);
  back.add(other);
  back.add(one);
  CHECK(forth.palette(100) == back.palette(100));
}
