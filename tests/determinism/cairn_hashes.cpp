// cairn_hashes: prints the fingerprints of runs that hash_list.hpp names, for builds.sh to compare.
#include <cstdio>
#include <exception>

#include "determinism/hash_list.hpp"

int main() {
  try {
    for (const std::string& line : cairn::determinism::all_lines()) std::puts(line.c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cairn_hashes: %s\n", error.what());
    return 1;
  }
}
