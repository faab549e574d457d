// The same bits from every build: whichever preset runs this holds its runs against the same file.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "determinism/hash_list.hpp"
#include <cairn/study/frozen/frozen_set.hpp>
#include <cairn/math/list.hpp>

using namespace cairn;

namespace {

const std::string hash_file = std::string(CAIRN_SOURCE_DIR) + "/tests/determinism/hashes.txt";

/// Without what says how the file came about.
List<std::string> kept_hashes() {
  List<std::string> lines;
  std::ifstream file(hash_file);
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  }
  return lines;
}

void renew_hashes() {
  std::ofstream file(hash_file);
  file << "# What the first build printed (cairn_hashes), not what is right: the claim is that all builds, "
          "of\n"
          "# whatever compiler and optimisation, print the same. After a change of the physics that is "
          "meant:\n"
          "# CAIRN_RENEW_HASHES=1 build/dev/bin/cairn_determinism_tests\n";
  for (const std::string& line : determinism::all_lines()) file << line << '\n';
}

/// The runs by as many threads as asked for, each taking the next one that is left.
List<std::string> runs_by(int threads) {
  List<std::string> lines(determinism::run_count());
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int run = next++; run < lines.size(); run = next++) lines[run] = determinism::run_line(run);
  };
  List<std::thread> workers;
  for (int i = 0; i < threads; ++i) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return lines;
}

}  // namespace

TEST_CASE("every build gives the bits that the first one gave") {
  if (std::getenv("CAIRN_RENEW_HASHES") != nullptr) renew_hashes();
  const List<std::string> kept = kept_hashes();
  REQUIRE(!kept.empty());
  const List<std::string> now = determinism::all_lines();
  REQUIRE(now.size() == kept.size());
  for (int i = 0; i < now.size(); ++i) CHECK(now[i] == kept[i]);
}

TEST_CASE("worlds in three threads beside each other give the bits that they give one after the other") {
  CHECK(runs_by(3) == runs_by(1));
}

TEST_CASE("a frozen problem has the same answer to the last bit once it was saved and reloaded") {
  List<FrozenProblem> reloaded;
  const List<FrozenProblem> kept = read_frozen_set(std::string(CAIRN_SOURCE_DIR) + "/tests/frozen/problems");
  for (const FrozenProblem& frozen : kept) reloaded.push_back(determinism::written_and_read(frozen));
  CHECK(determinism::frozen_lines(reloaded) == determinism::frozen_lines(kept));
}
