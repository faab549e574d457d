// Ctrl-C, obeyed within half a second of work: at the next good place for it, or else where the work stands.
#pragma once

#include <stdexcept>
#include <string_view>

namespace cairn::sandbox {

/// From now on SIGINT and SIGTERM end the program with the exit code `stopped`. interrupted() turns true, so
/// that work can come to an orderly end. What works on for 0.4 s of the processor, all threads together, such
/// as one long solve or a factorization, is ended where it is; and so is, after 4 s of the clock, what waits.
/// Files are written beside and renamed, and journals by whole lines: no file is ever half-written under its
/// own name.
void obey_interrupts();

/// What the program says from now on where it is ended in the middle of its work, such as how to go on.
void say_when_stopped(std::string_view words);

/// Whether a signal has come: to be asked between two pieces of work.
bool interrupted();

/// The work at hand was interrupted, and has cleaned up behind itself.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cairn::sandbox
