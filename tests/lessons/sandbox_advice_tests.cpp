// The advice of CHOOSING.md holds: both scenes of each row keep to what they expect, with the row's flags.
// What tune and recommend advise is told in flags, too.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
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

/// The words of a line, apart at blanks.
void add_words(List<std::string>& words, const std::string& line) {
  std::istringstream in(line);
  for (std::string word; in >> word;) words.push_back(word);
}

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
    add_words(advice.flags, found[3]);
    all.push_back(advice);
  }
  return all;
}

/// The setting by which `run` steps a scene that names none.
std::string setting_by(const std::string& flags) {
  List<std::string> words = {"run", "stack", "--seconds", "0.1s"};
  add_words(words, flags);
  return cairn_json(words)["setting"].get<std::string>();
}

/// The rest of the line that has it.
std::string text_after(const std::string& begin, const std::string& text) {
  const std::size_t at = text.find(begin);
  REQUIRE(at != std::string::npos);
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find('\n', from) - from);
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

TEST_CASE("what tune advises is told in flags, with which run steps by it") {
  for (const char* solver : {"si", "newton", "wide-accelerated"}) {
    const List<std::string> words = {"tune", "stack",    "--solvers", solver,      "--time",
                                     "2s",   "--starts", "1",         "--seconds", "0.2s"};
    const nlohmann::json answer = cairn_json(words);
    CAPTURE(answer.dump());
    CHECK(setting_by(answer["best"]["flags"]) == answer["best"]["setting"].get<std::string>());
    for (const nlohmann::json& next : answer["runners_up"])
      CHECK(setting_by(next["flags"]) == next["setting"].get<std::string>());
    CHECK(text_after("to run it: cairn run stack ", run_cairn(words).out).rfind("--solver ", 0) == 0);
  }
}

TEST_CASE("a scene of one's own keeps to what it expects with the flags that tune ends with") {
  const std::string scene = CAIRN_SOURCE_DIR "/tests/study/cases/crates.toml";
  const std::string told =
      run_cairn({"tune", scene, "--solvers", "newton", "--starts", "2", "--time", "6s"}).out;
  CAPTURE(told);
  List<std::string> words;
  add_words(words, text_after("to run it: cairn ", told));
  const Ran ran = run_cairn(words);
  CAPTURE(ran.out);
  CHECK(ran.code == 0);
  CHECK(text_has(ran.out, "meets what is expected"));
}

TEST_CASE("each recommendation is told in flags, with which run steps by it") {
  for (const char* kind : {"stack", "chain", "mechanism", "granular", "fast", "far"}) {
    const std::string told = run_cairn({"recommend", kind, "--quiet"}).out;
    CAPTURE(told);
    CHECK(setting_by(text_after("with a scene of yours: cairn run FILE ", told)) ==
          text_after("recommended: ", told));
  }
}

}  // namespace cairn::testing
