// The same targets for LLVM's libFuzzer, which changes inputs by what they reach (K. Serebryany, 2016).
#include <cstdint>

#include "fuzz/fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto target = static_cast<cairn::fuzz::Target>(CAIRN_FUZZ_TARGET);
  cairn::fuzz::feed(target, std::string(reinterpret_cast<const char*>(data), size));  // a Finding ends it
  return 0;
}
