// Many inputs in a process of their own: what ends that process is found, named and kept.
#pragma once

#include <cstdint>
#include <string>

#include "fuzz/fuzz_target.hpp"
#include <cairn/math/list.hpp>

namespace cairn::fuzz {

struct Run {
  Target target = Target::scene;
  double seconds = 10;           // [s] of the clock, after the seeds
  std::uint64_t seed = 1;        // of the changes
  List<std::string> seeds = {};  // inputs to begin from
  int most_findings = 20;        // after which it ends
};

/// An input that did harm.
struct Harm {
  std::uint64_t number = 0;  // of the input: see input() in mutate.hpp
  std::string what = {};     // the exception, the signal, or that it took too long
  std::string log = {};      // the end of what it wrote to stderr, a sanitizer's report among it
};

struct RunReport {
  std::uint64_t inputs = 0;
  std::uint64_t accepted = 0;
  List<Harm> harm = {};
};

/// Feeds the seeds and then what they become by changes. An input that takes more than 5 s of processor time
/// is stopped, and memory is limited to 1 GB where no sanitizer needs more.
RunReport run(const Run& run);

/// Whether this program was built with the address sanitizer.
bool is_under_asan();

/// The contents of files, and of all files of folders, by their names.
/// @throws std::runtime_error for what is neither.
List<std::string> read_seeds(const List<std::string>& paths);
/// The scenes that are shipped, the frozen set, word_seeds(), or some random worlds, and what was found
/// before in tests/fuzz/corpus.
List<std::string> usual_seeds(Target target, const std::string& source_folder);

}  // namespace cairn::fuzz
