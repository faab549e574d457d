// What was found once, and a few seconds of new inputs: readers take any bytes, or refuse them in a line.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "fuzz/fuzz_run.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/random_world.hpp"
#include <cairn/math/list.hpp>

using namespace cairn;

namespace {

const std::string fuzz_corpus = std::string(CAIRN_SOURCE_DIR) + "/tests/fuzz/corpus";

void check_unharmed(const fuzz::RunReport& report) {
  for (const fuzz::Harm& harm : report.harm) {
    FAIL_CHECK("input " << harm.number << ": " << harm.what << "\n" << harm.log);
  }
}

fuzz::Run corpus_run(fuzz::Target target, double seconds) {
  const std::string folder = fuzz_corpus + "/" + fuzz::target_names()[static_cast<int>(target)];
  return {.target = target, .seconds = seconds, .seed = 1, .seeds = fuzz::read_seeds({folder})};
}

}  // namespace

TEST_CASE("scenes from two seconds of changed files are refused in a line, or step with finite numbers") {
  const fuzz::RunReport report = fuzz::run(corpus_run(fuzz::Target::scene, 2));
  check_unharmed(report);
  CHECK(report.accepted > 0);
  CHECK(report.inputs > report.accepted);
}

TEST_CASE("problems from two seconds of changed files are refused in a line, or every solver takes them") {
  const fuzz::RunReport report = fuzz::run(corpus_run(fuzz::Target::frozen, 2));
  check_unharmed(report);
  CHECK(report.accepted > 0);
  CHECK(report.inputs > report.accepted);
}

TEST_CASE("command lines from two seconds of changed ones are refused, or run to an end") {
  const fuzz::RunReport report = fuzz::run(corpus_run(fuzz::Target::words, 2));
  check_unharmed(report);
  CHECK(report.accepted > 0);
  CHECK(report.inputs > report.accepted);
}

TEST_CASE("worlds that are stepped, edited, dragged and copied at random keep their promises") {
  fuzz::Run worlds{.target = fuzz::Target::world, .seconds = 0};
  const int count = fuzz::is_under_asan() ? 2000 : 1000;
  for (int number = 0; number < count; ++number) {
    worlds.seeds.push_back(fuzz::world_bytes(static_cast<std::uint64_t>(number)));
  }
  const fuzz::RunReport report = fuzz::run(worlds);
  for (const fuzz::Harm& harm : report.harm) {
    FAIL_CHECK(harm.what << "\nto see it again: cairn_fuzz --world " << harm.number << "\n" << harm.log);
  }
  CHECK(report.inputs == static_cast<std::uint64_t>(count));
  CHECK(report.accepted > report.inputs * 9 / 10);
}

TEST_CASE("worlds from the corpus and two seconds of changed ones keep their promises") {
  const fuzz::RunReport report = fuzz::run(corpus_run(fuzz::Target::world, 2));
  check_unharmed(report);
  CHECK(report.accepted > 0);
}

TEST_CASE("an input is the same for the same seeds, seed and number, and another for another") {
  const List<std::string> seeds = {"a = 1\nb = [2, 3]\n", "c = \"text\"\n"};
  CHECK(fuzz::input(seeds, 7, 0) == seeds[0]);
  CHECK(fuzz::input(seeds, 7, 1) == seeds[1]);
  int differing = 0;
  for (std::uint64_t number = 2; number < 100; ++number) {
    const std::string text = fuzz::input(seeds, 7, number);
    CHECK(text == fuzz::input(seeds, 7, number));
    differing += text != fuzz::input(seeds, 8, number) ? 1 : 0;
  }
  CHECK(differing > 80);  // of 98; a few changes undo each other, or change nothing
}

TEST_CASE("of the corpus is refused what has a file in refusals, and with that line") {
  for (const std::string target : {"scene", "frozen"}) {  // words would write here
    for (const auto& entry : std::filesystem::directory_iterator(fuzz_corpus + "/" + target)) {
      const std::string line = fuzz_corpus + "/refusals/" + entry.path().filename().string() + ".txt";
      const std::string expected = std::filesystem::exists(line) ? fuzz::read_seeds({line}).front() : "";
      const std::string bytes = fuzz::read_seeds({entry.path().string()}).front();
      const fuzz::Outcome outcome = fuzz::feed(fuzz::target_of(target), bytes);
      CAPTURE(entry.path().string());
      CHECK(outcome.accepted == expected.empty());
      CHECK(outcome.message + (outcome.accepted ? "" : "\n") == expected);
    }
  }
}
