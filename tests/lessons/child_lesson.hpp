// Runs a made-up lesson in a child process, and says what came out of it.
#pragma once

#include <functional>
#include <string>

#include "lessons/kit/lesson.hpp"
#include <cairn/math/list.hpp>
#include "scratch_folder.hpp"

namespace cairn::testing {

struct Ran {
  int code = 0;
  std::string out = {};  // stdout
  std::string err = {};  // stderr
};

/// Lesson 42: two parameters, one choice, a question.
LessonInfo made_up_lesson();

/// Runs `lesson` with these flags. The child's input is empty.
Ran run_in_child(const std::function<void(Lesson&)>& lesson, const List<std::string>& flags);

/// Runs a program that was built beside the tests, or that has a path of its own.
Ran run_program(const std::string& name, const List<std::string>& flags);

/// A copy of the driver, in the folder `below` of another: it has what comes with the programs, and of the
/// lessons that were built only these beside it. Returns its path.
std::string driver_apart(const ScratchFolder& folder, const std::string& below,
                         const List<std::string>& lessons);

/// A shot that writes one word, with an alt text.
Shot word_shot(const std::string& word);

}  // namespace cairn::testing
