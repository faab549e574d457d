// The texts of --help, --about and --list-params.
#include "lessons/kit/help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/kit/words.hpp"
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {
namespace {

constexpr int help_width = 104;

constexpr const char* common_help = R"(
Pictures  -o, --out DIR             the folder ({0})
          --frames WHICH            key (at most 12), all, film, none, cover, N, A:B or A:B:STEP;
                                    film: every second of more than 64; -1 is the last (key)
          --size WHICH              small, medium, large or WIDTHxHEIGHT in px (medium)
          --theme light|dark        (light)
          --palette color|gray      gray for black-and-white print (color)
          --format png|svg|apng     apng: one film of these frames, with their captions (png)
          --fps X                   frames a second of a film, from 0.1 to 30 (each frame
                                    stays 1 s, and 1/4 s for each new word of its caption)
          --panel NAME              only the panel that has NAME in its title
          --transparent             no background; for png and svg
          --text                    svg: text that can be searched and edited, not outlines
          --dry-run                 writes no file at all
Data      --csv FILE|-              the lesson's numbers; - is stdout, and the text goes to stderr
          --json FILE|-             likewise
Learning  --predict                 asks and waits, as on a terminal, wherever the answer comes from
          --answer V[,V...]         the answer; a wrong one gives exit code 1
{1}          --check                   the checks only: no pictures, no files
          --checks                  shows every check; else one line says how many hold
          --step                    waits for Enter after every line and picture
          --about                   the idea, the equations, what to read
          --list-params             the scene flags as a table
          --expect STATE            checks that the final state is bit for bit that of an earlier run
Console   -q, --quiet               the checks only
          -v, --verbose             more lines
          --plain                   ASCII: lambda for the Greek letter, no colour
          --color WHEN              auto, always or never (auto; NO_COLOR is honoured)
          --progress WHEN           likewise
          -h, --help, --version
Exit: 0 all checks held, 1 a check failed, 2 bad usage, 3 cannot draw or write, 4 diverged, 77 skipped.
)";

std::string range_of(const Parameter& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  return fmt::format("{} to {}{}", shortest(parameter.min), shortest(parameter.max), unit);
}

/// A value that differs from the standard and is allowed, for an example.
std::string example_value(const Parameter& parameter) {
  if (parameter.flag == "dt" && parameter.min <= 1.0 / 60 && parameter.max >= 1.0 / 60) return "1/60";
  const double doubled = 2 * parameter.standard;
  const double halved = parameter.standard / 2;
  if (parameter.standard != 0 && doubled >= parameter.min && doubled <= parameter.max)
    return shortest(doubled);
  if (parameter.kind == Parameter::Kind::real && halved >= parameter.min) return shortest(halved);
  return shortest(parameter.standard == parameter.max ? parameter.min : parameter.max);
}

std::string examples(const LessonInfo& info) {
  const std::string name = typed_command(info);
  List<std::pair<std::string, std::string>> lines = {
      {name, "run it: text, and pictures in out/" + short_name(info) + "/"},
      {name + " --answer V", "with your guess"}};
  std::string scene = name;
  for (int i = 0; i < std::min(2, info.parameters.size()); ++i) {
    scene += " --" + info.parameters[i].flag + " " + example_value(info.parameters[i]);
  }
  if (scene != name) lines.push_back({scene, "another scene"});
  lines.push_back({name + " --frames all --theme dark", "every frame"});
  lines.push_back({name + " --csv - | head", "its numbers"});
  std::size_t width = 0;
  for (const auto& line : lines) width = std::max(width, line.first.size());
  std::string text;
  for (const auto& line : lines) text += fmt::format("  {:<{}}   {}\n", line.first, width, line.second);
  return text;
}

std::string scene_help(const LessonInfo& info) {
  std::string text;
  const auto add = [&text](const std::string& flag, const std::string& what) {
    text += fmt::format("{}{} {}\n", text.empty() ? "\nScene     " : "          ", padded(flag, 25), what);
  };
  for (const Parameter& parameter : info.parameters) {
    const char* letter = parameter.kind == Parameter::Kind::whole ? " N" : " X";
    add("--" + parameter.flag + letter,
        fmt::format("{}, {} ({})", parameter.what, range_of(parameter), shortest(parameter.standard)));
  }
  for (const Choice& choice : info.choices) {
    add("--" + choice.flag + " " + joined(choice.values, "|"),
        choice.what + " (" + choice.values.at(0) + ")");
  }
  return text;
}

void add_list(std::string& text, const char* title, const List<std::string>& lines) {
  if (lines.empty()) return;
  text += fmt::format("\n{}\n", title);
  for (const std::string& line : lines) text += "  " + line + "\n";
}

}  // namespace

std::string help_text(const LessonInfo& info) {
  const std::string hint =
      info.hints.empty() ? ""
                         : fmt::format("          --hint [1-{}]              a hint\n", info.hints.size());
  const std::string head = fmt::format("{} - {}   ({})\n", program_name(info), info.title, info.paper);
  return head + wrapped(info.idea, help_width, 0) + "\n\n" + examples(info) + scene_help(info) +
         fmt::format(common_help, "out/" + short_name(info), hint);
}

std::string about_text(const LessonInfo& info) {
  std::string text = fmt::format("Lesson {}  {}   ({})\n", two_digits(info.number), info.title, info.paper);
  text += wrapped(info.idea, help_width, 0) + "\n";
  add_list(text, "Equations", info.equations);
  add_list(text, "To know first", info.needs);
  add_list(text, "To read next", info.reads);
  if (!info.question.empty()) add_list(text, "To predict", {info.question});
  if (!info.next.empty()) add_list(text, "Next lesson", {info.next});
  return text;
}

std::string parameters_text(const LessonInfo& info) {
  std::string text = "flag\tstandard\tfrom\tto\tunit\twhat\n";
  for (const Parameter& parameter : info.parameters) {
    text += fmt::format("--{}\t{}\t{}\t{}\t{}\t{}\n", parameter.flag, shortest(parameter.standard),
                        shortest(parameter.min), shortest(parameter.max), parameter.unit, parameter.what);
  }
  for (const Choice& choice : info.choices) {
    text += fmt::format("--{}\t{}\t{}\t\t\t{}\n", choice.flag, choice.values.at(0),
                        joined(choice.values, "|"), choice.what);
  }
  return text;
}

std::string text_asked_for(const LessonInfo& info, const Options& options) {
  switch (options.request) {
    case Options::Request::help:
      return help_text(info);
    case Options::Request::about:
      return about_text(info);
    case Options::Request::list_params:
      return parameters_text(info);
    case Options::Request::version:
      return program_name(info) + " " CAIRN_VERSION "\n";
    case Options::Request::hint:
      return info.hints.at(options.hint - 1) + "\n";
    case Options::Request::run:
      break;
  }
  return "";
}

}  // namespace cairn
