// What the paper says of speed, memory and code, and what features and constraints cost, and what the default
// is chosen by: twelve tables.
//   bash tests/run bench   all of them, in about two minutes
//   cairn_bench [solvers|layout|memory|blocks|lines|features|constraints|policies|searches|
//                growth|devices|default]   some of them
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "machine.hpp"
#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "tables.hpp"

namespace {

void print_how_to_read() {
  fmt::print(
      "Times are processor times of one thread in double, medians of repetitions in a shuffled order; noise "
      "is their\n"
      "interquartile range over the median, and a ratio is shown as \"noisy\" where it is above {:.0f} %.\n",
      100 * cairn::bench::largest_noise);
}

using Table = std::pair<std::string, std::function<void()>>;

/// @returns false for a name that is no table.
bool print_tables(const cairn::List<std::string>& wanted) {
  const cairn::List<Table> tables = {{"solvers", cairn::bench::print_solver_table},
                                     {"layout", cairn::bench::print_layout_table},
                                     {"memory", cairn::bench::print_memory_table},
                                     {"blocks", cairn::bench::print_block_table},
                                     {"lines", cairn::bench::print_lines_table},
                                     {"features", cairn::bench::print_feature_table},
                                     {"constraints", cairn::bench::print_constraint_table},
                                     {"policies", cairn::bench::print_policy_table},
                                     {"searches", cairn::bench::print_search_table},
                                     {"growth", cairn::bench::print_growth_table},
                                     {"devices", cairn::bench::print_device_table},
                                     {"default", cairn::bench::print_default_table}};
  const auto named = [&](const std::string& name) {
    return [&name](const Table& table) { return table.first == name; };
  };
  for (const std::string& name : wanted) {
    if (std::none_of(tables.begin(), tables.end(), named(name))) {
      fmt::print(stderr, "cairn_bench: unknown table {}; there are:", name);
      for (const Table& table : tables) fmt::print(stderr, " {}", table.first);
      fmt::print(stderr, "\n");
      return false;
    }
  }
  cairn::bench::print_machine();
  print_how_to_read();
  for (const auto& [name, print] : tables) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    print();
    std::fflush(stdout);
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  // Repetitions of different benchmarks in a shuffled order, unless the caller says otherwise.
  std::string shuffled = "--benchmark_enable_random_interleaving=true";
  cairn::List<char*> arguments = {argv[0], shuffled.data()};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = arguments.size();
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  try {
    return print_tables({arguments.begin() + 1, arguments.begin() + count}) ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
