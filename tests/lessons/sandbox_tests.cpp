// The program `cairn` as it was built: what it answers, what it refuses and how, and what it leaves behind.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

using namespace cairn::testing;
using cairn::List;

namespace {

using Words = List<std::string>;

struct BadInput {
  Words words = {};
  Words parts = {};  // of the one line that it gets: who refuses, the rule, the value
};

void check_refused(const BadInput& bad) {
  const Ran ran = run_cairn(bad.words);
  std::string line = "cairn";
  for (const std::string& word : bad.words) line += " " + word;
  CAPTURE(line);
  CAPTURE(ran.err);
  CHECK(ran.code == 2);
  CHECK(ran.out.empty());
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  CHECK(ran.err.rfind("cairn", 0) == 0);
  for (const std::string& part : bad.parts) {
    CAPTURE(part);
    CHECK(text_has(ran.err, part));
  }
}

}  // namespace

TEST_CASE("cairn explains itself") {
  CHECK(run_cairn({"--help"}).code == 0);
  CHECK(run_cairn({}).code == 2);
  CHECK(run_cairn({"--version"}).out.rfind("cairn ", 0) == 0);
}

TEST_CASE("words that no verb knows are refused in one line that helps") {
  for (const BadInput& bad : List<BadInput>{
           {{"tradeof"}, {"no verb tradeof", "did you mean tradeoff?"}},
           {{"dance"}, {"no verb dance", "freeze, tradeoff, tune, validate"}},
           {{"tune", "stack", "--penetraton", "2mm"},
            {"cairn tune", "--penetraton", "did you mean --penetration?"}},
           {{"validate", "A3"}, {"unexpected word", "A3"}},
           {{"tune"}, {"cairn tune SCENE"}},
           {{"freeze"}, {"SCENE", "--list"}},
           {{"tradeoff"}, {"SCENE", "--all"}},
           {{"freeze", "stack", "--json=no"}, {"--json takes no value", "no"}},
           {{"freeze", "stack", "--out"}, {"--out needs a value"}},
           {{"freeze", "stack", "--out", "--json"}, {"--out needs a path", "got --json", "./--json"}},
           {{"run", "stack", "--frames", "--apng", "x.png"}, {"--frames needs a path", "got --apng"}},
           {{"run", "stack", "--csv=-x"}, {"--csv needs a path", "got -x", "./-x"}},
           {{"freeze", "stack", "--step", "1", "--step", "2"}, {"--step is given twice"}},
           {{"validate", "--color", "blue"}, {"--color must be auto or always or never", "blue"}}}) {
    check_refused(bad);
  }
}

TEST_CASE("values that mean nothing are refused in one line with flag, rule and value") {
  for (const BadInput& bad : List<BadInput>{
           {{"freeze", "stak"}, {"SCENE must be", "got stak", "did you mean stack?"}},
           {{"freeze", "stack", "--step", "-1"},
            {"--step must be a whole number from 0 to 1000000", "got -1"}},
           {{"freeze", "stack", "--step", "1.5"}, {"--step must be a whole number", "got 1.5"}},
           {{"freeze", "stack", "--step", "nan"}, {"--step must be", "got nan"}},
           {{"freeze", "stack10", "--step", "3"}, {"--step means nothing", "frozen set"}},
           {{"freeze", "--set", "/dev/null/x", "stack"}, {"--set", "got stack"}},
           {{"validate", "--only", "Z99"}, {"--only must be", "--list", "got Z99"}},
           {{"validate", "--only", "A3,"}, {"--only must be words between commas", "got A3,"}},
           {{"tune", "spring-row"}, {"a wish is missing", "the scene expects nothing", "--penetration 2mm"}},
           {{"tune", "stack", "--budget", "0"}, {"--budget must be", "got 0"}},
           {{"tune", "stak", "--stands", "2s"}, {"SCENE must be", "got stak"}},
           {{"tune", "stack", "--penetration", "2kg"}, {"--penetration must be a length above 0", "got 2kg"}},
           {{"tune", "stack", "--penetration", "-2mm"}, {"--penetration must be", "got -2mm"}},
           {{"tune", "stack", "--drift", "1e400mm"}, {"--drift must be", "got 1e400mm"}},
           {{"tune", "stack", "--stands", "1e300"}, {"--stands must be", "at most 100000 s", "got 1e300"}},
           {{"tune", "stack", "--stands", "5", "--seconds", "2"}, {"--seconds must be", "--stands", "got 2"}},
           {{"tune", "stack", "--residual", "2"}, {"--residual must be a number from", "to 1", "got 2"}},
           {{"tune", "stack", "--stands", "1", "--starts", "0"},
            {"--starts must be", "from 1 to 1000", "got 0"}},
           {{"tune", "stack", "--stands", "1", "--solvers", "sii"},
            {"--solvers must be", "got sii", "mean si?"}}}) {
    check_refused(bad);
  }
}

TEST_CASE("a study that cannot be done is refused before anything is written") {
  const ScratchFolder folder;
  for (const BadInput& bad : List<BadInput>{
           {{"stak"}, {"SCENE", "got stak"}},
           {{"stack10", "--level", "3"}, {"--level must be a whole number from 1 to 2", "got 3"}},
           {{"stack10", "--level", "2"}, {"level 2", "got stack10"}},
           {{"pendulum-45", "--level", "1"}, {"level 1", "got pendulum-45"}},
           {{"stack10", "--all"}, {"SCENE", "--all"}},
           {{"stack10", "--solvers", "box2d"}, {"--solvers must be", "got box2d"}},
           {{"stack10", "--theme", "purple"}, {"--theme must be light or dark", "got purple"}},
           {{"stack10", "--error", "drift"}, {"--error must be R_E or E_M", "got drift"}},
           {{"stack", "--error", "formula"}, {"--error must be", "no formula knows this scene"}},
           {{"spring-row", "--error", "expect"}, {"--error must be", "expects nothing"}},
           {{"stack", "chain", "--level", "2"}, {"--level means nothing", "several scenes"}},
           {{"stack", "chain", "--solvers", "si,block"}, {"--solvers must be one", "got si,block"}},
           {{"stack", "--start", "warm"}, {"--start means nothing", "level 2"}},
           {{"stack10", "--shard", "4/3"}, {"--shard must be k/n", "got 4/3"}},
           {{"stack10", "--shard", "1/2", "--merge", "x"}, {"--merge means nothing", "--shard"}}}) {
    BadInput whole = bad;
    whole.words.insert(whole.words.begin(), {"tradeoff", "--out", folder.path()});
    check_refused(whole);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("what can be asked for is listed, for people and for programs") {
  const Ran scenes = run_cairn({"tradeoff", "--list"});
  CHECK(scenes.code == 0);
  const auto lists = nlohmann::json::parse(run_cairn({"tradeoff", "--list", "--json"}).out);
  for (const char* level : {"level1", "level2"}) {
    REQUIRE(lists.at(level).size() > 0);
    for (const std::string name : lists.at(level)) CHECK(text_has(scenes.out, name));
  }
  const auto problems = nlohmann::json::parse(run_cairn({"freeze", "--list", "--json"}).out);
  CHECK(std::count(problems.begin(), problems.end(), "stack10") == 1);
  const auto cases = nlohmann::json::parse(run_cairn({"validate", "--list", "--json"}).out);
  CHECK(cases.size() >= 50);
}

TEST_CASE("a frozen problem is the same on stdout, in a file, and when it is frozen again") {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/p.json";
  CHECK(run_cairn({"freeze", "--step", "2", "--out", path, "stack"}).code == 0);  // flags may stand first
  const std::string first = folder.text("p.json");
  const Ran streamed = run_cairn({"freeze", "stack", "--step", "2", "--json"});
  CHECK(streamed.code == 0);
  CHECK(streamed.err.empty());
  CHECK(streamed.out == first);
  const auto problem = nlohmann::json::parse(first);
  CHECK(problem.at("name") == "stack-2");
  CHECK(problem.at("bodies").size() == 11);  // ten boxes and the ground
  CHECK(folder.names() == Words{"p.json"});
}

TEST_CASE("flags that contradict each other, or mean nothing alone, are refused") {
  for (const BadInput& bad : List<BadInput>{
           {{"run", "stack", "--solver", "si:10", "--sweeps", "20"}, {"--sweeps means nothing", "si:10"}},
           {{"compare", "stack", "--solvers", "si:10,pgs:5", "--sweeps", "20"}, {"--sweeps means nothing"}},
           {{"run", "stack", "--fps", "10"}, {"--fps means nothing without --frames"}},
           {{"compare", "stack", "--theme", "dark"}, {"--theme means nothing without --frames"}},
           {{"recommend", "--out", "x.json"}, {"--out means nothing without --renew"}},
           {{"recommend", "stack", "--renew"}, {"--renew must be given without a kind", "got stack"}},
           {{"recommend", "--renew", "--from", "x.json"}, {"--from means nothing beside --renew"}},
           {{"tradeoff", "--all", "--quick", "--labels"}, {"--labels means nothing beside --all"}},
           {{"extremes", "--shard", "1/2", "--merge", "x"}, {"--merge means nothing beside --shard"}}}) {
    check_refused(bad);
  }
  CHECK(run_cairn({"compare", "stack", "--solvers", "si,si:5", "--sweeps", "20", "--seconds", "0.1s"}).code ==
        0);
}

TEST_CASE("a run in which nothing would happen is refused") {
  const ScratchFolder folder;
  folder.write("empty.toml", "");
  const std::string empty = folder.path() + "/empty.toml";
  for (const BadInput& bad : List<BadInput>{
           {{"run", empty}, {empty, "bodies must be at least one, got none"}},
           {{"explain", empty}, {empty, "bodies must be at least one"}},
           {{"run", "stack", "--dt", "1e6"}, {"seconds must be at least a step of 1e+06 s, got 3"}},
           {{"run", "stack", "--seconds", "1e-9s"}, {"seconds must be at least a step", "got 1e-09"}},
           {{"compare", "stack", "--dt", "1e6"}, {"seconds must be at least a step"}},
           {{"run", folder.path() + "/none.toml"}, {"a file that can be read", "none.toml"}}}) {
    check_refused(bad);
  }
}

TEST_CASE("a place that cannot be written ends with three, and leaves nothing half-written") {
  const ScratchFolder folder;
  folder.write("stack10.csv/in_the_way", "");  // a folder where a file should be
  folder.write("p.json/in_the_way", "");
  const Words ways[] = {{"freeze", "stack", "--step", "0", "--out", "/dev/null/x.json"},
                        {"freeze", "stack", "--step", "0", "--out", folder.path() + "/p.json"},
                        {"freeze", "--set", "/dev/null/x"},
                        {"validate", "--only", "A2", "--page", "/dev/null/x"},
                        {"tradeoff", "stack10", "--quick", "--solvers", "si", "--out", "/dev/null/x"},
                        {"tradeoff", "stack10", "--quick", "--solvers", "si", "--out", folder.path()}};
  for (const Words& words : ways) {
    const Ran ran = run_cairn(words);
    CAPTURE(words.back());
    CHECK(ran.code == 3);
    CHECK(text_has(ran.err, "cairn: "));
    CHECK(text_has(ran.err, words.back() == folder.path() ? "stack10.csv" : words.back()));
  }
  // A folder that is missing is made.
  CHECK(run_cairn({"freeze", "stack", "--step", "0", "--out", folder.path() + "/a/b/p.json"}).code == 0);
  CHECK(folder.names("a/b") == Words{"p.json"});
  // What was found is kept, and nothing else is.
  CHECK(folder.names() == Words{"a", "p.json", "stack10.csv", "stack10.journal"});
}

TEST_CASE("validate compares what is asked for, and says the same to people and to programs") {
  const Ran people = run_cairn({"validate", "--only", "A3,A2"});
  CHECK(people.code == 0);
  CHECK(text_has(people.out, "2 of 2 closed forms hold"));
  const Ran programs = run_cairn({"validate", "--only", "A3,A2", "--json"});
  CHECK(programs.code == 0);
  CHECK(text_has(programs.err, "2 of 2 closed forms hold"));
  const auto json = nlohmann::json::parse(programs.out);
  CHECK(json.at("build").at("version").is_string());
  const auto& cases = json.at("cases");
  REQUIRE(cases.size() == 2);
  for (const auto& one : cases) {
    CHECK(one.at("passes") == true);
    CHECK(text_has(people.out, one.at("id").get<std::string>()));
    for (const auto& number : one.at("numbers")) {
      CHECK(number.at("error").get<double>() <= number.at("tolerance").get<double>());
      CHECK(text_has(people.out, number.at("formula").get<std::string>()));
    }
  }
}

TEST_CASE("quiet drops the narration, plain keeps to ASCII, and colours come when they are asked for") {
  const Words words = {"validate", "--only", "A3"};
  const auto with = [&](const Words& flags) {
    Words all = words;
    all.insert(all.end(), flags.begin(), flags.end());
    return run_cairn(all);
  };
  CHECK_FALSE(text_has(with({}).out, "\x1b"));
  CHECK(text_has(with({"--color", "always"}).out, "\x1b[32mok"));
  CHECK_FALSE(text_has(with({"--color", "always", "--plain"}).out, "\x1b"));
  CHECK(text_has(with({}).out, " ms"));  // what was said to people, with the time it took
  CHECK_FALSE(text_has(with({"--quiet"}).out, " ms"));
  CHECK(text_has(with({"--quiet"}).out, "closed form"));  // the answer stays
  CHECK(with({"--quiet", "--json"}).err.empty());
  const std::string plain = run_cairn({"validate", "--list", "--plain"}).out;
  CHECK(std::all_of(plain.begin(), plain.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
}

TEST_CASE("tune ends with zero and a setting, or with one when nothing meets the wish") {
  const Words words = {"tune", "double-pendulum", "--starts", "1",     "--seconds",
                       "0.1",  "--solvers",       "si",       "--json"};
  Words easy = words, hopeless = words;
  easy.insert(easy.end(), {"--drift", "1m"});
  hopeless.insert(hopeless.end(), {"--drift", "1e-30m", "--time", "50ms"});
  const Ran found = run_cairn(easy);
  CHECK(found.code == 0);
  const auto answer = nlohmann::json::parse(found.out);
  CHECK(answer.at("scene") == "double-pendulum");
  CHECK(answer.at("best").at("drift_m").get<double>() <= 1);
  CHECK(answer.at("best").at("starts") == 1);
  for (const auto& next : answer.at("runners_up")) {
    CHECK(next.at("cost_s_per_s").get<double>() >= answer.at("best").at("cost_s_per_s").get<double>());
  }
  const Ran none = run_cairn(hopeless);
  CHECK(none.code == 1);
  CHECK(nlohmann::json::parse(none.out).at("best").is_null());
}
