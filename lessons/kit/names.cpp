// What a lesson is called, and the flags that all lessons have.
#include "lessons/kit/arguments.hpp"
#include <cairn/math/list.hpp>

namespace cairn {

std::string two_digits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }
std::string short_name(const LessonInfo& info) { return "lesson" + two_digits(info.number); }
std::string program_name(const LessonInfo& info) { return short_name(info) + "_" + info.name; }

std::string typed_command(const LessonInfo& info) {
  return "bash lessons/run " + std::to_string(info.number);
}

const List<std::string>& common_flags() {
  static const List<std::string> flags = {
      "help",   "version", "about", "list-params", "predict", "answer", "hint",  "check",
      "checks", "step",    "out",   "frames",      "dry-run", "size",   "theme", "palette",
      "format", "panel",   "fps",   "transparent", "text",    "csv",    "json",  "expect",
      "quiet",  "verbose", "plain", "color",       "progress"};
  return flags;
}

}  // namespace cairn
