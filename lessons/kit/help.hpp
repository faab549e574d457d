// What a lesson says about itself before it runs.
#pragma once

#include <string>

#include "lessons/kit/arguments.hpp"
#include "lessons/kit/lesson.hpp"

namespace cairn {

/// The answer to a request that needs no run.
std::string text_asked_for(const LessonInfo& info, const Options& options);

/// --help: examples first, then only the flags that this lesson has.
std::string help_text(const LessonInfo& info);
/// --about: idea, equations, what to know first, what to read next.
std::string about_text(const LessonInfo& info);
/// --list-params: one line per scene flag, columns separated by tabs, for people and programs.
std::string parameters_text(const LessonInfo& info);

}  // namespace cairn
