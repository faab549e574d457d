// The advice of CHOOSING.md holds: both scenes of each row keep to what they expect, with the row's flags.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

namespace cairn::testing {

namespace {

/// A row of its table.
struct Advice {
  List<std::string> scenes = {};  // paths
  List<std::string> flags = {};   // none: by default
};

List<Advice> advice_of_page(const std::filesystem::path& page) {
  const std::regex row(R"(\| .* \| (\[.*\.toml\)) \| (by default|`(--.*)`) \|)"),
      scene(R"(\(([^)]*\.toml)\))");
  std::ifstream in(page);
  List<Advice> all;
  for (std::string line; std::getline(in, line);) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    Advice advice;
    const std::string scenes = found[1];
    for (std::sregex_iterator at(scenes.begin(), scenes.end(), scene), end; at != end; ++at)
      advice.scenes.push_back((page.parent_path() / (*at)[1].str()).string());
    std::istringstream flags(found[3]);
    for (std::string flag; flags >> flag;) advice.flags.push_back(flag);
    all.push_back(advice);
  }
  return all;
}

}  // namespace

TEST_CASE("each setting that is advised keeps two scenes of its kind to all that they expect") {
  const List<Advice> all = advice_of_page(CAIRN_SOURCE_DIR "/lessons/sandbox/CHOOSING.md");
  CHECK(all.size() >= 10);
  for (const Advice& advice : all) {
    CHECK(advice.scenes.size() == 2);
    for (const std::string& scene : advice.scenes) {
      List<std::string> words = {"run", scene, "--quiet"};
      words.insert(words.end(), advice.flags.begin(), advice.flags.end());
      const Ran ran = run_cairn(words);
      CAPTURE(scene);
      CAPTURE(ran.out);
      CAPTURE(ran.err);
      CHECK(ran.code == 0);
      CHECK(text_has(ran.out, "meets what is expected"));  // so it expects something
    }
  }
}

}  // namespace cairn::testing
