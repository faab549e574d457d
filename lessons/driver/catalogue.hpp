// Which lessons there are, and which of them have been passed.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "math/list.hpp"

namespace cairn::driver {

struct Program {
  int number = 0;
  std::string name = {};  // "lesson06_sequential_impulses"
  std::filesystem::path path = {};
};

/// The lesson programs in a folder, by number.
List<Program> programs_in(const std::filesystem::path& folder);

/// The lesson that a person means by "6", "06", "lesson06", "sequential_impulses" or the whole name; nullptr
/// if none.
const Program* find(const List<Program>& programs, std::string_view word);

/// "06".
std::string two_digits(int number);

/// What a lesson program says about itself.
struct About {
  std::string title = {};
  std::string idea = {};
  std::string paper = {};  // "paper 3.2, Algorithm 1, eq (19)-(23)"
  int cover = 1;           // the frame that stands for the lesson, from 1; negative: from the end
};
About ask(const Program& program);

/// The day a lesson was passed, by number, as kept in `lessons-progress.txt`: "06 passed 2026-11-20".
using ProgressNotes = std::map<int, std::string>;
ProgressNotes read_progress(const std::filesystem::path& file);
/// Notes that a lesson was passed today. False when the file cannot be written.
bool note_pass(const std::filesystem::path& file, int number);

}  // namespace cairn::driver
