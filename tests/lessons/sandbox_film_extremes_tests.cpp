// Films of scenes that leave the numbers, fly apart, or are far away.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/image.hpp"
#include "render/theme.hpp"
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// The part of a frame of 1280 x 720 that shows the world, and the caption below it.
constexpr int world_top = 60, world_bottom = 640, caption_bottom = 678;

bool rows_differ(const render::Image& first, const render::Image& second, int top, int bottom) {
  const auto row = [](const render::Image& image, int y) {
    return image.pixels.begin() + 3 * std::ptrdiff_t{image.width} * y;
  };
  return !std::equal(row(first, top), row(first, bottom), row(second, top));
}

/// Pixels of the colour that bodies have in the light theme, to a few levels.
int body_pixels(const render::Image& image) {
  const render::Color body = render::light_theme().body;
  const FixedList<float, 3> wanted = {body.r, body.g, body.b};
  int count = 0;
  for (int i = 0; i < image.pixels.size(); i += 3) {
    bool is_near = true;
    for (int k = 0; k < 3; ++k)
      is_near = is_near && std::abs(image.pixels[i + k] - 255 * static_cast<double>(wanted[k])) < 4;
    count += is_near ? 1 : 0;
  }
  return count;
}

std::string tower_and(const std::string& others) {
  return "title = \"tower\"\ngravity = [0, 0]\n[ground]\nhalf_width = 8\n[[stack]]\nn = 5\nbox = [1, 1]\n" +
         others;
}

std::string flying_ball(const std::string& position, const std::string& velocity) {
  return "[[body]]\ncircle = 0.5\nposition = " + position + "\nvelocity = " + velocity + "\n";
}

}  // namespace

TEST_CASE("a film of a step that could not be done ends with a frame of the state before, and says why") {
  const ScratchFolder folder;
  folder.write("bomb.toml", tower_and(flying_ball("[3, 2]", "[1.7e308, 0]")));
  const std::string film = folder.path() + "/film";
  const Ran ran = run_cairn({"run", folder.path() + "/bomb.toml", "--dt", "10", "--seconds", "40", "--frames",
                             film, "--show", "none"});
  CHECK(ran.code == 4);
  // In the first of four steps, to 10 s, the ball would get to 1.7e309 m.
  CHECK(text_has(ran.out, "nan after 10 s: body.1 would not be finite"));
  CHECK_FALSE(text_has(ran.out, "inf m"));  // how far bodies came means nothing then
  CHECK(folder.names("film") == List<std::string>{"0000.png", "0001.png", "frames.json"});
  const render::Image start = render::read_png(film + "/0000.png");
  const render::Image end = render::read_png(film + "/0001.png");
  CHECK_FALSE(rows_differ(start, end, world_top, world_bottom));
  CHECK(rows_differ(start, end, world_bottom, caption_bottom));
}

TEST_CASE("a film of a run that diverges ends with the frame in which it did, due or not") {
  const ScratchFolder folder;
  // On three pins above each other plain Jacobi doubles every error in a sweep.
  std::string pins;
  for (const std::string y : {"-0.25", "0", "0.25"})
    pins += "[[joint]]\ntype = \"revolute\"\nb = \"body.1\"\nanchor = [6, " + y + "]\n";
  folder.write("fast.toml", "[[body]]\ncircle = 0.5\nposition = [6, 0]\n" + pins);
  const Ran ran =
      run_cairn({"run", folder.path() + "/fast.toml", "--fps", "10", "--size", "small", "--solver",
                 "jacobi:60", "--substeps", "1", "--frames", folder.path() + "/film"});
  CHECK(ran.code == 4);
  CHECK(text_has(ran.out, "diverged after 0.0167 s"));
  CHECK(folder.names("film") == List<std::string>{"0000.png", "0001.png", "frames.json"});
}

TEST_CASE("what flies off does not make the rest of a film small") {
  const ScratchFolder folder;
  const auto last_frame = [&folder](const std::string& name, const std::string& scene) {
    folder.write(name + ".toml", scene);
    const std::string film = folder.path() + "/" + name;
    CHECK(run_cairn({"run", folder.path() + "/" + name + ".toml", "--fps", "10", "--seconds", "3", "--frames",
                     film, "--show", "none"})
              .code == 0);
    return render::read_png(film + "/0030.png");
  };
  const std::string resting = flying_ball("[-3, 2]", "[0, 0]") + flying_ball("[3, 2]", "[0, 1e-9]");
  const std::string flying = flying_ball("[-3, 2]", "[-900, 30]") + flying_ball("[3, 2]", "[700, 400]");
  const render::Image all = last_frame("resting", tower_and(resting));
  const render::Image rest = last_frame("flying", tower_and(flying));
  // The same view: what is missing are two discs of pi / 4 m^2 among 5 m^2 of boxes, outlines aside.
  const double share = body_pixels(rest) / static_cast<double>(body_pixels(all));
  CHECK(share == doctest::Approx(5 / (5 + pi / 2)).epsilon(0.05));
  CHECK(rows_differ(all, rest, world_top, world_bottom));
}

TEST_CASE("a film ten thousand kilometres from the origin is the film at the origin") {
  const ScratchFolder folder;
  const auto first_frame = [&folder](const std::string& name, const std::string& x) {
    const auto placed = [&x](const std::string& y) { return "position = [" + x + ", " + y + "]\n"; };
    folder.write(name + ".toml", "title = \"tower\"\n[[body]]\ntype = \"static\"\nbox = [16, 1]\n" +
                                     placed("0") + "[[body]]\nbox = [1, 1]\n" + placed("1") +
                                     "[[body]]\nbox = [1, 1]\n" + placed("2"));
    const std::string film = folder.path() + "/" + name;
    const Ran ran = run_cairn({"run", folder.path() + "/" + name + ".toml", "--seconds", "0.1", "--show",
                               "none", "--frames", film});
    CHECK(ran.code == 0);
    return render::read_png(film + "/0000.png");
  };
  const render::Image far = first_frame("film", "8388608");
  const render::Image near = first_frame("film2", "0");
  CHECK(body_pixels(near) > 20000);  // two boxes that fill most of the height
  // The camera is placed to 1e-9 m: a pixel's coverage may round to the next of its 256 levels.
  CHECK(render::compare(near, far).largest <= 1);
}
