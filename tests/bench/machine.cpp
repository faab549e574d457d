// Compiler, flags, caches, processor and load.
#include "machine.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <fstream>
#include <string>

namespace cairn::bench {

namespace {

/// The value of the first line of a file of the system that begins with `key`, behind the colon.
std::string system_line(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (line.starts_with(key) && colon != std::string::npos)
      return line.substr(std::min(colon + 2, line.size()));
  }
  return "unknown";
}

}  // namespace

void print_machine() {
  std::ifstream load_file("/proc/loadavg");
  std::string load = "unknown";
  load_file >> load;
  fmt::print("compiler  {}\n", CAIRN_BENCH_COMPILER);
  fmt::print("flags     {}\n", CAIRN_BENCH_FLAGS);
  fmt::print("Eigen     {}.{}.{}, vectors by {}\n", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
             EIGEN_MINOR_VERSION, Eigen::SimdInstructionSetsInUse());
  std::string caches;
  for (const benchmark::CPUInfo::CacheInfo& cache : benchmark::CPUInfo::Get().caches) {
    if (cache.type != "Instruction") caches += fmt::format(" L{} {} kB", cache.level, cache.size / 1024);
  }
  fmt::print("caches   {}\n", caches.empty() ? " unknown" : caches);
  fmt::print("CPU       {}, load {} before we began\n", system_line("/proc/cpuinfo", "model name"), load);
#ifndef NDEBUG
  fmt::print("Assertions are on: these times are not those of a release.\n");
#endif
}

}  // namespace cairn::bench
