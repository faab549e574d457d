// cairn_fuzz: feeds a reader with bytes for some time, and keeps what did harm.
//   cairn_fuzz [--target scene|frozen|words|world] [--seconds S] [--seed N] [file or folder ...]
//   cairn_fuzz --world N
// Without files it begins from what is shipped and from tests/fuzz/corpus. With --seconds 0 it feeds the
// files alone; with --world it feeds the random world of that number alone. What did harm is written to
// fuzz-TARGET-SEED-NUMBER in the current folder; the program ends with 1.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <stdexcept>

#include "fuzz/fuzz_run.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/random_world.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/list.hpp>

namespace {

using namespace cairn;
using namespace cairn::fuzz;

double number_behind(const List<std::string>& words, int& place) {
  const std::string flag = words[place];
  const std::optional<double> number =
      ++place < words.size() ? parse_number(words[place]) : std::optional<double>();
  if (!number || !(*number >= 0 && *number <= 1e9)) {
    throw std::invalid_argument("cairn_fuzz: " + flag + " must be a number from 0 to 1e9");
  }
  return *number;
}

Run run_of(const List<std::string>& words) {
  Run run;
  List<std::string> paths;
  for (int i = 0; i < words.size(); ++i) {
    if (words[i] == "--seconds") {
      run.seconds = number_behind(words, i);
    } else if (words[i] == "--seed") {
      run.seed = static_cast<std::uint64_t>(number_behind(words, i));
    } else if (words[i] == "--target") {
      run.target = target_of(++i < words.size() ? words[i] : "nothing");
    } else if (words[i] == "--world") {
      run.seeds = {world_bytes(static_cast<std::uint64_t>(number_behind(words, i)))};
      run.target = Target::world;
      run.seconds = 0;
    } else if (words[i].rfind("--", 0) == 0) {
      throw std::invalid_argument("cairn_fuzz: the words are --target, --seconds, --seed, --world and files");
    } else {
      paths.push_back(words[i]);
    }
  }
  if (!paths.empty()) run.seeds = read_seeds(paths);
  if (run.seeds.empty()) run.seeds = usual_seeds(run.target, CAIRN_SOURCE_DIR);
  return run;
}

int fuzz_and_tell(const List<std::string>& words) {
  const Run what = run_of(words);
  const std::string target = target_names()[static_cast<int>(what.target)];
  const RunReport report = fuzz::run(what);
  for (const Harm& harm : report.harm) {
    const std::string file = fmt::format("fuzz-{}-{}-{}", target, what.seed, harm.number);
    std::ofstream(file, std::ios::binary) << input(what.seeds, what.seed, harm.number);
    fmt::print("{}: {}\n{}\n", file, harm.what, harm.log);
  }
  fmt::print("{}: {} inputs, {} accepted, {} did harm\n", target, report.inputs, report.accepted,
             report.harm.size());
  return report.harm.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return fuzz_and_tell({argv + std::min(argc, 1), argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
