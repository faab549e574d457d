// Floor 9. Machine and compiler.
#include <cairn/study/build_info.hpp>
#include <cairn/math/list.hpp>

#include <sched.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace cairn {

namespace {

std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

/// A container or `taskset` may leave fewer than the machine has.
std::string usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? std::to_string(CPU_COUNT(&cores)) : "unknown";
}

std::string compiler_name() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

const List<std::pair<std::string, std::string>>& build_entries() {
  static const List<std::pair<std::string, std::string>> entries = {
      {"schema", "cairn-2"},         {"version", CAIRN_VERSION},
      {"git", build_commit()},       {"box2d", CAIRN_BOX2D_VERSION},
      {"compiler", compiler_name()}, {"flags", CAIRN_BUILD_FLAGS},
      {"cpu", cpu_name()},           {"cores", usable_cores()}};
  return entries;
}

std::string build_text() {
  return "cairn " CAIRN_VERSION " of commit " + build_commit() + ", Box2D " CAIRN_BOX2D_VERSION ", " +
         compiler_name() + ", " CAIRN_BUILD_FLAGS;
}

nlohmann::ordered_json build_json() {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : build_entries()) json[name] = value;
  return json;
}

void set_build(TradeRow& row) {
  for (const auto& [name, value] : build_entries()) row.set(name, value);
}

}  // namespace cairn
