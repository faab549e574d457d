// Beside floor 6. Machine and compiler.
#include "study/build_info.hpp"

#include <fstream>

namespace cairn {

std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string compiler_name() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string build_flags() { return CAIRN_BUILD_FLAGS; }

void set_build(TradeRow& row) {
  row.set("schema", std::string("cairn-1"));
  row.set("cpu", cpu_name());
  row.set("compiler", compiler_name());
  row.set("flags", build_flags());
}

}  // namespace cairn
