// Every verb of the program has its page, and every page leads on.
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "sandbox_program.hpp"

namespace cairn::testing {

namespace {

const std::string pages_folder = CAIRN_SOURCE_DIR "/lessons/sandbox/";

std::string page_text(const std::string& name) {
  std::ifstream in(pages_folder + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The verbs that the program itself names.
std::set<std::string> known_verbs() {
  const std::string text = run_cairn({"--help"}).out;
  const std::regex line("\n  cairn ([a-z]+)");
  std::set<std::string> verbs;
  for (std::sregex_iterator found(text.begin(), text.end(), line), end; found != end; ++found)
    verbs.insert((*found)[1].str());
  return verbs;
}

}  // namespace

TEST_CASE("every verb of the program cairn has a page that the index leads to, and completion a section") {
  const std::set<std::string> verbs = known_verbs();
  CHECK(verbs.size() >= 12);
  const std::string index = page_text("README.md");
  for (const std::string& verb : verbs) {
    CAPTURE(verb);
    if (verb == "completion") {
      CHECK(text_has(index, "\n## completion\n"));
      continue;
    }
    CHECK(text_has(index, "](pages/" + verb + ".md)"));
    const std::string page = page_text("pages/" + verb + ".md");
    CHECK(text_has(page, "# cairn " + verb + ": "));
    CHECK(text_has(page, "<!-- output of: cairn " + verb));  // what it shows was printed by the verb itself
    CHECK(text_has(page, "**What can go wrong.**"));
    CHECK(text_has(page, "**Next:**"));
  }
}

TEST_CASE("every verb explains itself with an example") {
  for (const std::string& verb : known_verbs()) {
    CAPTURE(verb);
    const Ran help = run_cairn({verb, "--help"});
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    CHECK(help.out.rfind("cairn " + verb, 0) == 0);
    CHECK(text_has(help.out, "--json"));
    CHECK(text_has(help.out, "For example\n  cairn " + verb));
  }
}

TEST_CASE("every flag that a page of a verb names is known to some verb") {
  std::set<std::string> flags;
  const std::regex flag("--[a-z][a-z-]*");
  const auto flags_in = [&flag](const std::string& text) {
    return std::set<std::string>(std::sregex_token_iterator(text.begin(), text.end(), flag),
                                 std::sregex_token_iterator());
  };
  for (const std::string& verb : known_verbs()) flags.merge(flags_in(run_cairn({verb, "--help"}).out));
  for (const std::string& verb : known_verbs()) {
    if (verb == "completion") continue;
    for (const std::string& named : flags_in(page_text("pages/" + verb + ".md"))) {
      CAPTURE(verb);
      CAPTURE(named);
      CHECK(flags.count(named) == 1);
    }
  }
}

}  // namespace cairn::testing
