// PNG files of three bytes a pixel, as lessons write them, become files of one byte a pixel.
#include "lessons/driver/small_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#ifdef CAIRN_HAVE_ZLIB
#include <zlib.h>
#endif
#include <cairn/measure/whole_file.hpp>

namespace cairn::driver {

#ifdef CAIRN_HAVE_ZLIB
namespace {

namespace fs = std::filesystem;
using Color = std::uint32_t;  // red, green and blue, a byte each

constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
constexpr int most_colors = 256;
constexpr double most_of_whole = 0.6;  // bytes of changes, where they are worth a second picture below
constexpr int cell = 4;                // [px] the margin around a change is as wide, and up to twice as wide
constexpr Color see_through = 0xFF000000;

struct Picture {
  std::uint32_t width = 0, height = 0;  // [px]
  List<Color> pixels = {};
};

/// How many pixels have a colour.
struct Share {
  Color color = 0;
  long long pixels = 0;
};

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes.at(i));
  return number;
}

std::string bytes_of(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

const Bytef* as_bytes(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

/// The rows of a file, each behind the byte that says how it was filtered.
std::string rows_of(std::string_view file, std::size_t size) {
  std::string packed;
  for (std::size_t at = signature.size(); at + 12 <= file.size();) {
    const std::size_t length = number_at(file, at);
    if (file.substr(at + 4, 4) == "IDAT") packed += file.substr(at + 8, length);
    at += length + 12;
  }
  std::string rows(size, '\0');
  uLongf unpacked = size;
  const bool is_whole =
      uncompress(reinterpret_cast<Bytef*>(rows.data()), &unpacked, as_bytes(packed), packed.size()) == Z_OK;
  return is_whole && unpacked == size ? rows : "";
}

Picture read_picture(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string file(std::istreambuf_iterator<char>(stream), {});
  const auto refuse = [&] { throw std::runtime_error(path.string() + ": not a picture of a lesson"); };
  // Behind the signature the header: its length and name, two sides, 8 bits of red, green and blue.
  if (file.size() < 33 || !file.starts_with(signature) ||
      file.substr(24, 5) != std::string("\x08\x02\0\0\0", 5))
    refuse();
  Picture picture{.width = number_at(file, 16), .height = number_at(file, 20)};
  const std::size_t row = 3 * std::size_t{picture.width} + 1;
  const std::string rows = rows_of(file, row * picture.height);
  if (rows.empty()) refuse();
  for (const char* at = rows.data(); at != rows.data() + rows.size(); at += row) {
    if (*at != 0) refuse();  // filtered
    for (const char* pixel = at + 1; pixel != at + row; pixel += 3) {
      const auto part = [&](int i) { return static_cast<Color>(static_cast<unsigned char>(pixel[i])); };
      picture.pixels.push_back(part(0) << 16 | part(1) << 8 | part(2));
    }
  }
  return picture;
}

/// The colours, but for pixels that are seen through.
List<Share> shares_of(const Picture& picture) {
  std::unordered_map<Color, long long> counts;
  const Color* const end = picture.pixels.data() + picture.pixels.size();
  for (const Color* at = picture.pixels.data(); at != end;) {
    const Color* const other = std::find_if(at, end, [&](Color color) { return color != *at; });
    counts[*at] += other - at;
    at = other;
  }
  counts.erase(see_through);
  List<Share> shares;
  for (const auto& [color, pixels] : counts) shares.push_back({color, pixels});
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.color < b.color; });
  return shares;
}

/// Squared.
long long distance(Color a, Color b) {
  long long sum = 0;
  for (const int shift : {0, 8, 16}) {
    const long long off =
        static_cast<long long>(a >> shift & 0xFF) - static_cast<long long>(b >> shift & 0xFF);
    sum += off * off;
  }
  return sum;
}

/// Colours that stand for all: one after the other the one whose pixels are off most in all.
List<Color> palette_of(const List<Share>& shares, int most) {
  List<Color> palette;
  List<long long> off(shares.size(), 3 * 256 * 256);
  while (palette.size() < std::min(most, shares.size())) {
    int worst = 0;
    for (int i = 1; i < shares.size(); ++i)
      if (off[i] * shares[i].pixels > off[worst] * shares[worst].pixels) worst = i;
    const Color color = shares[worst].color;
    palette.push_back(color);
    for (int i = 0; i < shares.size(); ++i) off[i] = std::min(off[i], distance(shares[i].color, color));
  }
  return palette;
}

void add_chunk(std::string& file, const std::string& name, const std::string& data) {
  const std::string body = name + data;
  const uLong sum = crc32_z(0, as_bytes(body), body.size());
  file +=
      bytes_of(static_cast<std::uint32_t>(data.size())) + body + bytes_of(static_cast<std::uint32_t>(sum));
}

std::string packed(const std::string& rows) {
  std::string bytes(compressBound(rows.size()), '\0');
  uLongf size = bytes.size();
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, as_bytes(rows), rows.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  bytes.resize(size);
  return bytes;
}

/// The bytes of a file of one byte a pixel: its colour's place in the palette, 0 where it is seen through.
std::string small_png(const Picture& picture, bool is_whole) {
  const List<Share> shares = shares_of(picture);
  const int first = is_whole ? 0 : 1;
  const List<Color> palette = palette_of(shares, most_colors - first);
  std::unordered_map<Color, char> places = {{see_through, '\0'}};
  for (const Share& share : shares) {
    const auto nearest = std::min_element(palette.begin(), palette.end(), [&](Color a, Color b) {
      return distance(a, share.color) < distance(b, share.color);
    });
    places[share.color] = static_cast<char>(nearest - palette.begin() + first);
  }
  std::string colors = is_whole ? "" : std::string(3, '\0');
  for (const Color color : palette) colors += bytes_of(color).substr(1);
  std::string rows;
  const Color* at = picture.pixels.data();
  Color last = see_through;
  char place = '\0';
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    rows += '\0';  // not filtered
    for (std::uint32_t x = 0; x < picture.width; ++x, ++at) {
      if (*at != last) place = places.at(last = *at);
      rows += place;
    }
  }
  std::string file(signature);
  add_chunk(file, "IHDR",
            bytes_of(picture.width) + bytes_of(picture.height) + std::string("\x08\x03\0\0\0", 5));
  add_chunk(file, "PLTE", colors);
  if (!is_whole) add_chunk(file, "tRNS", std::string(1, '\0'));
  add_chunk(file, "IDAT", packed(rows));
  add_chunk(file, "IEND", "");
  return file;
}

/// Which cells of a grid have a pixel that differs, row by row.
List<bool> changed_cells(const Picture& picture, const Picture& below, int columns) {
  List<bool> changed(columns * (static_cast<int>(picture.height) / cell + 1), false);
  const Color *at = picture.pixels.data(), *under = below.pixels.data();
  for (int y = 0; y < static_cast<int>(picture.height); ++y)
    for (int x = 0; x < static_cast<int>(picture.width); ++x)
      if (*at++ != *under++) changed[y / cell * columns + x / cell] = true;
  return changed;
}

/// Without what is as below, but for a margin: where a page shows both smaller, their pixels are mixed there.
Picture changes_of(const Picture& picture, const Picture& below, const fs::path& path) {
  if (picture.width != below.width || picture.height != below.height)
    throw std::runtime_error(fmt::format("{}: {} x {} px, and what it lies upon has {} x {}", path.string(),
                                         picture.width, picture.height, below.width, below.height));
  const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  const int columns = width / cell + 1;
  const List<bool> changed = changed_cells(picture, below, columns);
  const auto is_near = [&](int row, int column) {
    for (int r = std::max(0, row - 1); r <= std::min(height / cell, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
        if (changed[r * columns + c]) return true;
    return false;
  };
  Picture changes = picture;
  for (int row = 0; row <= height / cell; ++row)
    for (int column = 0; column < columns; ++column) {
      if (is_near(row, column)) continue;
      const int end = std::min(width, (column + 1) * cell);
      for (int y = row * cell; y < std::min(height, (row + 1) * cell); ++y)
        for (int x = column * cell; x < end; ++x) changes.pixels[y * width + x] = see_through;
    }
  return changes;
}

}  // namespace

SmallFilm make_small(const List<FilmPicture>& film, const List<int>& bases) {
  SmallFilm made;
  Picture below;
  int base = -1;
  for (int i = 0; i < film.size(); ++i) {
    const Picture picture = read_picture(film[i].from);
    const bool is_open = bases.empty() && !film[i].is_key && base >= 0;
    std::string file;
    if (is_open || (!bases.empty() && bases[i] != i))
      file = small_png(changes_of(picture, below, film[i].from), false);
    if (file.empty() || is_open) {
      const std::string whole = small_png(picture, true);
      if (file.empty() ||
          static_cast<double>(file.size()) > most_of_whole * static_cast<double>(whole.size())) {
        file = whole;
        below = picture;
        base = i;
      }
    }
    write_whole_file(film[i].to, file);
    made.bases.push_back(base);
    made.bytes += file.size();
  }
  return made;
}

#else

SmallFilm make_small(const List<FilmPicture>& film, const List<int>&) {
  if (!film.empty()) throw std::runtime_error("without zlib no lesson draws, and no picture is made small");
  return {};
}

#endif

}  // namespace cairn::driver
