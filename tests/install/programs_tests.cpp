// The installed programs: every verb from another folder, with nothing but what was installed beside it.
#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "installed.hpp"
#include <cairn/math/list.hpp>

namespace {

using cairn::List;
using namespace cairn::testing;

namespace fs = std::filesystem;

/// The programs, and a folder to stand in that has nothing to do with the sources.
struct InstalledPrograms {
  fs::path folder;
  fs::path prefix = installed_component(folder, "programs");
  fs::path elsewhere = folder / "elsewhere";

  explicit InstalledPrograms(const std::string& name) : folder(scratch(name)) {
    fs::create_directories(elsewhere);
  }
  CommandResult run(const std::string& words) const {
    return run_line(folder, "cd " + quoted(elsewhere.string()) +
                                " && env -i HOME=" + quoted(elsewhere.string()) +
                                " PATH=/usr/bin:/bin ASAN_OPTIONS=detect_leaks=0 " +
                                quoted((prefix / "bin").string()) + "/" + words);
  }
};

/// The bytes of the name in a file.
bool file_has(const fs::path& file, const std::string& name) {
  return text_of(file).find(name) != std::string::npos;
}

#ifdef CAIRN_HAVE_SANDBOX

/// A quick command of each verb, and a word of its answer.
const std::map<std::string, std::pair<std::string, std::string>> command_of_verb = {
    {"run", {"run stack --seconds 0.1s", "stack"}},
    {"compare", {"compare stack --solvers si,block --seconds 0.1s", "block"}},
    {"inspect", {"inspect stack --step 2", "row"}},
    {"explain", {"explain stack", "si"}},
    {"freeze", {"freeze stack --step 2 --out frozen", "frozen"}},
    {"list", {"list scenes", "stack"}},
    {"tune", {"tune stack --penetration 1m --solvers si --starts 1 --seconds 0.1s", "best"}},
    {"recommend", {"recommend stack", "recommended: "}},
    {"tradeoff", {"tradeoff stack10 --level 1 --quick --solvers si --out trade", "stack10"}},
    {"extremes", {"extremes --only mass --quick --out extremes", "cases: "}},
    {"validate", {"validate", "held"}},
    {"completion", {"completion bash", "complete"}}};

std::set<std::string> verbs_in(const std::string& help) {
  std::set<std::string> verbs;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string program, verb;
    if (line.rfind("  cairn ", 0) == 0 && words >> program >> verb) verbs.insert(verb);
  }
  return verbs;
}

#endif

}  // namespace

#ifdef CAIRN_HAVE_SANDBOX
TEST_CASE("every verb of an installed cairn does its work, wherever it is moved and run from") {
  const InstalledPrograms installed("verbs");
  std::set<std::string> tried;
  for (const auto& entry : command_of_verb) {
    const auto& [words, answer] = entry.second;
    const CommandResult result = installed.run("cairn " + words);
    INFO(words);
    INFO(result.output);
    CHECK(result.code == 0);
    CHECK(result.output.find(answer) != std::string::npos);
    tried.insert(entry.first);
  }
  CHECK(verbs_in(installed.run("cairn --help").output) == tried);
}

TEST_CASE("an installed cairn finds the scenes that were installed with it, wherever it is moved") {
  const InstalledPrograms installed("scenes");
  const fs::path scenes = installed.prefix / "share" / "cairn" / "scenes";
  fs::copy_file(scenes / "stack.toml", scenes / "only-here.toml");
  const CommandResult result = installed.run("cairn list");
  CHECK(result.code == 0);
  CHECK(result.output.find("only-here") != std::string::npos);
  fs::rename(installed.prefix / "share", installed.folder / "share");
  const CommandResult without = installed.run("cairn list");
  CHECK(without.code != 0);
  CHECK(without.output.find((installed.prefix / "share" / "cairn" / "scenes").string()) != std::string::npos);
}

TEST_CASE("the installed driver makes a book, and knows what the lessons cover") {
  const InstalledPrograms installed("book");
  for (const auto& entry : fs::directory_iterator(installed.prefix / "bin")) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("lesson", 0) == 0 && name != "lessons" && name != "lesson03_sequential_impulses")
      fs::remove(entry.path());
  }
  CHECK(installed.run("lessons coverage").code == 0);
  CHECK(installed.run("lessons list").code == 0);
  const CommandResult made = installed.run("lessons book made --frames cover");
  if (made.output.find("made by pandoc") != std::string::npos) return;
  INFO(made.output);
  CHECK(made.code == 0);
  const fs::path book = installed.elsewhere / "made";
  CHECK(file_has(book / "lesson03.html", "Your code begins here"));
  CHECK(file_has(book / "lesson03.html", "your_solver.html"));  // it is a stage
  for (const char* page :
       {"conclusion", "glossary", "notation", "prerequisites", "your_solver", "teachers", "index"})
    CHECK(file_has(book / (page + std::string(".html")), "</p>"));
  for (const char* file : {"book.css", "book.js"}) CHECK(fs::file_size(book / file) > 0);
}
#endif

// What a debugger reads names the sources, and a sanitizer says where it found something.
#ifndef CAIRN_HAVE_SANITIZERS
TEST_CASE("nothing that is installed knows where it was built") {
  const fs::path folder = scratch("paths");
  List<fs::path> prefixes = {installed_component(folder / "library", "library")};
#ifdef CAIRN_HAVE_SANDBOX
  prefixes.push_back(installed_component(folder / "programs", "programs"));
#endif
  int files = 0;
  for (const fs::path& prefix : prefixes) {
    for (const auto& entry : fs::recursive_directory_iterator(prefix)) {
      if (!entry.is_regular_file()) continue;
      INFO(entry.path().string());
      if (entry.path().extension() == ".a")
        require_success(
            run_line(folder, quoted(CAIRN_STRIP) + " --strip-debug " + quoted(entry.path().string())));
      CHECK_FALSE(file_has(entry.path(), CAIRN_SOURCE_DIR));
      CHECK_FALSE(file_has(entry.path(), CAIRN_BINARY_DIR));
      ++files;
    }
  }
  CHECK(files > 100);
}
#endif
