// The texts of --help.
#include <fmt/format.h>

#include <algorithm>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {
namespace {

constexpr int help_columns = 100;

std::string spelt_flag(const Flag& flag) {
  const std::string brief = flag.name == "help" ? "-h, " : flag.name == "quiet" ? "-q, " : "";
  return brief + "--" + flag.name + (flag.takes.empty() ? "" : " " + flag.takes);
}

std::string flag_lines(const List<Flag>& flags, int width) {
  std::string text;
  for (const Flag& flag : flags) {
    text += "  " + padded(spelt_flag(flag), width) + "  " +
            wrapped(flag.help, help_columns - width - 4, width + 4) + "\n";
  }
  return text;
}

int flag_width(const Verb& verb) {
  int width = 0;
  for (const List<Flag>* flags : {&verb.flags, &shared_flags()}) {
    for (const Flag& flag : *flags) width = std::max(width, display_width(spelt_flag(flag)));
  }
  return width;
}

}  // namespace

const List<Flag>& shared_flags() {
  static const List<Flag> flags = {
      {"json", "", "the answer as JSON on stdout; what is said to people goes to stderr"},
      {"quiet", "", "no words beside the answer, and no progress bar"},
      {"plain", "", "ASCII, without colours"},
      {"color", "WHEN", "auto, always or never (auto; NO_COLOR is honoured)"},
      {"progress", "WHEN", "auto, always or never (auto: on a terminal)"},
      {"help", "", "this text"}};
  return flags;
}

std::string help_text() {
  std::string text = "cairn - your own scene, and what its solvers cost and miss\n\n";
  std::size_t width = 0;
  const auto line = [](const Verb& verb) {
    return "cairn " + verb.name + (verb.places.empty() ? "" : " " + verb.places);
  };
  for (const Verb& verb : verbs()) width = std::max(width, line(verb).size());
  for (const Verb& verb : verbs()) text += fmt::format("  {:<{}}   {}\n", line(verb), width, verb.summary);
  return text +
         "\ncairn VERB --help explains a verb and shows an example.\n"
         "Exit: 0 all well, 1 a check failed, 2 bad usage, 3 cannot draw or write, 4 diverged, 130 "
         "stopped.\n";
}

std::string help_text(const Verb& verb) {
  std::string text = "cairn " + verb.name + (verb.places.empty() ? "" : " " + verb.places) + " [flags]\n\n";
  text += wrapped(verb.idea, help_columns, 0) + "\n\n";
  const int width = flag_width(verb);
  text += flag_lines(verb.flags, width);
  text += (verb.flags.empty() ? "" : "\n") + flag_lines(shared_flags(), width);
  text += "\nFor example\n";
  for (const std::string& example : verb.examples) text += "  cairn " + example + "\n";
  return text;
}

}  // namespace cairn::sandbox
