// cairn extremes --atlas: its pictures, and what it says of their layout.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <cairn/math/list.hpp>
#include "render/image.hpp"
#include "sandbox_program.hpp"

namespace cairn::testing {

namespace {

namespace fs = std::filesystem;

const FixedList<const char*, 5> atlas_maps = {"mass-ratio", "stack", "chain", "springs", "origin"};

/// A journal of all cells, with endings that a run would not give: the three lines of `begun` that name
/// study, build and columns, and then classes in turns, a few cells long.
void write_made_up_journal(const fs::path& begun, const fs::path& path, int cells) {
  const FixedList<const char*, 6> endings = {"holds", "strained", "failed", "exploded", "refused", "not run"};
  std::ifstream in(begun);
  std::ofstream out(path);
  std::string line;
  for (int i = 0; i < 3 && std::getline(in, line); ++i) out << line << '\n';
  for (int cell = 0; cell < cells; ++cell) {
    out << cell << ",m,s,p,1,1," << endings[cell / 4 % 6] << ",0,0\n";
  }
}

/// From "3 of 880 cells; journal: ...".
int cells_in(const std::string& text) {
  const std::size_t end = text.find(" cells; ");
  REQUIRE(end != std::string::npos);
  return std::stoi(text.substr(text.rfind(" of ", end) + 4));
}

}  // namespace

TEST_CASE("the atlas draws a map for each pair of axes, whose layout has no fault whatever its cells are") {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/atlas";
  const Ran few = run_cairn({"extremes", "--atlas", folder, "--quick", "--shard", "1/400"});
  CHECK(few.code == 0);
  const fs::path begun = fs::path(folder) / "atlas-quick_1_of_400.csv";
  REQUIRE(fs::exists(begun));
  const std::string made_up = scratch.path() + "/made-up.csv";
  write_made_up_journal(begun, made_up, cells_in(few.out + few.err));
  for (const char* theme : {"light", "dark"}) {
    const Ran drawn =
        run_cairn({"extremes", "--atlas", folder, "--quick", "--merge", made_up, "--theme", theme});
    CHECK(drawn.code == 0);
    for (const char* map : atlas_maps) {
      const std::string name = std::string("atlas_") + map + "_" + theme + ".png";
      CAPTURE(name);
      // A fault of the layout is told with the name of the picture.
      CHECK_FALSE(text_has(drawn.err + drawn.out, name));
      const render::Image image = render::read_png(folder + "/" + name);
      CHECK(image.width == 1280);
      CHECK(image.height == 1047);  // three rows
    }
  }
}

TEST_CASE("what belongs to the atlas and what belongs to the list of cases do not mix") {
  CHECK(run_cairn({"extremes", "--theme", "dark"}).code == 2);
  CHECK(run_cairn({"extremes", "--atlas", "somewhere", "--only", "stack"}).code == 2);
  CHECK(run_cairn({"extremes", "--atlas", "somewhere", "--theme", "pink"}).code == 2);
  CHECK_FALSE(fs::exists("somewhere"));
}

}  // namespace cairn::testing
