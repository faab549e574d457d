// How the run of a lesson ends: its exit code, and what is said of a failure.
#pragma once

#include <string>

#include "lessons/kit/lesson.hpp"

namespace cairn {

/// Says on stderr what is wrong, behind the name of the lesson. Returns the code.
int complain(const std::string& name, int code, const std::string& message);

/// The code, or 3 where the output could not be written, which is said.
int finished(const LessonInfo& info, int code);

/// Says why the run ended early, inside a handler. Returns the exit code.
int explain_failure(const std::string& name);

}  // namespace cairn
