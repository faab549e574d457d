// Which lessons there are, and which of them have been passed.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "lessons/kit/card.hpp"
#include <cairn/math/list.hpp>

namespace cairn::driver {

struct Program {
  int number = 0;
  std::string name = {};            // "lesson03_sequential_impulses"
  std::filesystem::path path = {};  // may not have been built
  LessonInfo card = {};
};

/// All lessons, as they are or would be in a folder of programs.
List<Program> programs_in(const std::filesystem::path& folder);

/// The driver's exit code where it was not understood.
inline constexpr int bad_usage = 2;
/// The driver's exit code where a program has not been built.
inline constexpr int not_built = 3;
/// A lesson's exit code where it needs what this build does not have.
inline constexpr int skipped = 77;

/// Those of them that have been built.
List<Program> built(const List<Program>& programs);

/// @throws std::runtime_error that says how to build a lesson that is not built.
void require_built(const Program& program);

/// The lesson that a person means by "3", "03", "lesson03", "sequential_impulses" or the whole name; nullptr
/// if none.
const Program* find(const List<Program>& programs, std::string_view word);

/// "03".
std::string two_digits(int number);

/// The day a lesson was passed, by number, as kept in `lessons-progress.txt`: "03 passed 2026-11-20".
using ProgressNotes = std::map<int, std::string>;
ProgressNotes read_progress(const std::filesystem::path& file);
/// Notes that a lesson was passed today. False when the file cannot be written.
bool note_pass(const std::filesystem::path& file, int number);

}  // namespace cairn::driver
