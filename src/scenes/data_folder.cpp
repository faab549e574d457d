// Floor 8. From the running program to what came with it.
#include <cairn/scenes/data_folder.hpp>

#include <system_error>

namespace cairn {

std::filesystem::path data_folder() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path programs = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {CAIRN_INSTALLED_DATA, "../share/cairn"}) {
    const fs::path folder = fs::canonical(programs / place, error);
    if (!error) return folder;
  }
  // Who opens a file there says that there is none.
  return (programs / CAIRN_INSTALLED_DATA).lexically_normal();
}

}  // namespace cairn
