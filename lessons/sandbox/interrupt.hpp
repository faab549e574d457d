// Ctrl-C, as a question to ask between two pieces of work.
#pragma once

#include <csignal>

namespace cairn::sandbox {

/// While it lives, SIGINT and SIGTERM are noted instead of ending the program; a second one ends it.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  bool came() const;
};

}  // namespace cairn::sandbox
