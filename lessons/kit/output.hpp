// What every program asks before it ends.
#pragma once

#include <cstdio>

namespace cairn {

/// Whether stdout took all that was printed: a full disk behind it often shows only at the end.
inline bool output_is_written() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace cairn
